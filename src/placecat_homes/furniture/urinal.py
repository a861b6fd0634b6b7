"""Urinals."""

import numpy as np

from placecat_homes import palette
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.lofts import loft, rounded
from placecat_homes.shapes import box, cylinder, tube
from placecat_homes.style import Style


def urinal(
    rng: np.random.Generator,
    style: Style,
    *,
    count: int = 2,
    ceramic: Material | None = None,
) -> Mesh:
    """Draw a row of wall-mounted urinals with screens between them.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the building.
    count
        Number of urinals.
    ceramic
        Material of the urinals; chosen at random if None.

    Returns
    -------
    Mesh
        Urinals with their rims 0.62 m above the floor, which is at z = 0.
    """
    ceramic = ceramic or palette.ceramic(rng)
    pitch = rng.uniform(0.7, 0.85)
    screens = rng.random() < 0.7
    glass = palette.GLASS if rng.random() < 0.3 else palette.paint(rng)
    sensor = rng.random() < 0.5
    parts = []
    for k in range(count):
        x = (k - (count - 1) / 2) * pitch
        parts.append(_bowl(ceramic).moved(x))
        if sensor:
            parts.append(box(0.1, 0.012, 0.1, bevel=0.003).moved(x, 0, 1.25).of(style.metal))
            parts.append(box(0.03, 0.002, 0.03, bevel=0.0).moved(x, 0.012, 1.29).of(palette.RUBBER))
        else:
            parts.append(tube([(x, 0.05, 1.05), (x, 0.05, 1.25), (x, 0.0, 1.27)], 0.014, 8).of(style.metal))
            parts.append(cylinder(0.025, 0.05, 10).turned(-90, "x").moved(x, 0.05, 1.2).of(style.metal))
        if screens and k + 1 < count:
            parts.append(box(0.02, 0.42, 0.85, bevel=0.004).moved(x + pitch / 2, 0, 0.55).of(glass))
    return join(parts)


def _bowl(ceramic: Material) -> Mesh:
    """Draw one urinal as a shell, open at the front above its lip."""

    def ring(width: float, depth: float, z: float, inside: float = 0.0) -> tuple[np.ndarray, float]:
        w, d = width - 2 * inside, depth - 2 * inside
        return rounded(w, d, (w * 0.5, d * 0.7), 0.01, y=inside), z

    lower = loft(
        [
            ring(0.12, 0.12, 0.42),
            ring(0.24, 0.24, 0.46),
            ring(0.32, 0.33, 0.54),
            ring(0.34, 0.36, 0.61),
            ring(0.34, 0.36, 0.63),
            ring(0.34, 0.36, 0.635, 0.012),
            ring(0.34, 0.36, 0.625, 0.03),
            ring(0.30, 0.33, 0.54, 0.04),
            ring(0.16, 0.2, 0.48, 0.04),
        ]
    )
    back = box(0.34, 0.06, 0.45, bevel=0.015).moved(z=0.6)
    cheeks = [
        loft(
            [
                (rounded(0.035, deep, 0.015, 0.005, points=4), z)
                for deep, z in ((0.2, 0.6), (0.15, 0.68), (0.11, 0.8), (0.1, 0.95), (0.14, 1.03))
            ]
        ).moved(x)
        for x in (-0.152, 0.152)
    ]
    hood = [ring(0.34, 0.15, 1.0), ring(0.34, 0.17, 1.03), ring(0.33, 0.16, 1.07), ring(0.3, 0.12, 1.085)]
    return join(lower, back, cheeks, loft(hood)).of(ceramic)
