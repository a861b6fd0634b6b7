"""Radiators with flat panels, grooved panels or columns of pipes."""

import numpy as np

from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.shapes import box, cylinder, tube
from placecat_homes.style import Style


def radiator(
    rng: np.random.Generator, style: Style, width: float | None = None, height: float | None = None
) -> Mesh:
    """Build a radiator to be mounted about 0.12 m above the floor.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the building.
    width, height
        Size in metres; chosen at random if None.

    Returns
    -------
    Mesh
        A radiator at most 0.13 m deep, with its back against the wall.
    """
    wide = float(rng.uniform(0.6, 1.3)) if width is None else width
    tall = float(rng.uniform(0.5, 0.62)) if height is None else height
    columns = rng.random() < 0.6 - 0.5 * style.modern
    return _columns(wide, tall) if columns else _panel(rng, wide, tall)


def _enamel(value: float) -> Material:
    return Material((value, value * 0.99, value * 0.965), gloss=0.03, roughness=0.3)


def _panel(rng: np.random.Generator, width: float, height: float) -> Mesh:
    front = box(width, 0.02, height, 0.006).moved(0, 0.085)
    back = box(width - 0.02, 0.015, height - 0.03, 0.0).moved(0, 0.03, 0.015)
    top = box(width, 0.085, 0.012, 0.003).moved(0, 0.02, height - 0.004)
    parts = [front, back, top]
    for sign in (-1, 1):
        parts.append(box(0.006, 0.075, height - 0.02, 0.0).moved(sign * (width / 2 - 0.003), 0.02, 0.01))
    if rng.random() < 0.75:
        pitch = 0.05
        for k in range(int((width - 0.06) / pitch)):
            x = -width / 2 + 0.055 + k * pitch
            parts.append(box(0.022, 0.012, height - 0.08, 0.005).moved(x, 0.1, 0.04))
    slots = [
        box(0.02, 0.06, 0.004, 0.0).moved(x, 0.032, height + 0.008)
        for x in np.arange(-width / 2 + 0.05, width / 2 - 0.04, 0.04)
    ]
    body = join(parts).of(_enamel(float(rng.uniform(0.84, 0.92))))
    return join(body, join(slots).of(Material((0.2, 0.2, 0.2))), _valve(width, height))


def _columns(width: float, height: float) -> Mesh:
    pitch = 0.055
    count = max(4, int(width / pitch))
    parts = []
    for k in range(count):
        x = (k - (count - 1) / 2) * pitch
        for y in (0.045, 0.105):
            parts.append(cylinder(0.017, height - 0.04, 7, 0.0).moved(x, y, 0.02))
        for z in (0.0, height - 0.05):
            parts.append(box(0.042, 0.1, 0.05, 0.0).moved(x, 0.025, z))
    body = join(parts).of(_enamel(0.88))
    return join(body, _valve((count - 1) * pitch, height))


def _valve(width: float, height: float) -> Mesh:
    x = width / 2 + 0.02
    pipe = tube([(x, 0.06, -0.11), (x, 0.06, 0.06), (x - 0.03, 0.06, 0.06)], 0.008, 6)
    stub = tube([(x - 0.03, 0.06, height - 0.06), (x, 0.06, height - 0.06)], 0.01, 6)
    knob = cylinder(0.022, 0.06, 10).turned(90, "y").moved(x, 0.06, height - 0.06)
    return join(pipe.of(_enamel(0.85)), stub.of(_enamel(0.85)), knob.of(_enamel(0.9)))
