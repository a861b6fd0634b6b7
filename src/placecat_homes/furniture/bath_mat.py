"""Bath mats and bathroom scales."""

import numpy as np

from placecat_homes import palette
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.lofts import loft, plate, rounded
from placecat_homes.shapes import box, cylinder
from placecat_homes.style import Style


def bath_mat(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a thick mat with rounded corners or edges."""
    width, depth = rng.uniform(0.6, 0.9), rng.uniform(0.42, 0.6)
    radius: float | tuple[float, float] = 0.04
    if rng.random() < 0.3:
        radius = (width / 2, depth / 2)
    cloth = palette.carpet(rng) if rng.random() < 0.5 else style.any_fabric(rng)
    return plate(rounded(width, depth, radius, points=6), 0.022, 0.015).of(cloth)


def pedestal_mat(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a mat with a notch in its back edge that fits around the foot of a toilet."""
    cloth = palette.carpet(rng)
    left = rounded(0.13, 0.32, 0.03, 0.03)
    front = rounded(0.5, 0.26, 0.08, 0.02, y=0.26)
    return join(
        plate(left, 0.018, 0.01).moved(-0.185),
        plate(left, 0.018, 0.01).moved(0.185),
        plate(front, 0.02, 0.012),
    ).of(cloth)


def scales(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw bathroom scales with a dial or a display."""
    modern = rng.random() < 0.3 + 0.5 * style.modern
    outline = rounded(0.3, 0.3, 0.03)
    if modern:
        top = palette.BLACK_GLASS if rng.random() < 0.5 else Material((0.8, 0.9, 0.88), gloss=0.06)
        return join(
            plate(outline, 0.025).of(top),
            box(0.09, 0.04, 0.002, bevel=0.0).moved(0, 0.03, 0.025).of(Material((0.55, 0.62, 0.58))),
        )
    body = palette.plastic(rng)
    return join(
        loft([(outline, 0.0), (outline, 0.03), (outline * 0.97 + (0, 0.0045), 0.045)]).of(body),
        box(0.26, 0.18, 0.004, bevel=0.0).moved(0, 0.1, 0.045).of(palette.RUBBER),
        cylinder(0.05, 0.006, 16).moved(0, 0.05, 0.045).of(palette.WHITE),
    )
