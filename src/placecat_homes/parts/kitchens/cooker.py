"""Hobs and oven fronts."""

import numpy as np

from placecat_homes.furniture.blocks import between, block, chance
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.kitchens.design import BLACK, STEEL, WHITE
from placecat_homes.parts.lofts import hung
from placecat_homes.shapes import box, cylinder, lathe, tube
from placecat_homes.style import Style

GLASS = Material(colour=(0.02, 0.02, 0.025), gloss=0.08, roughness=0.04)
RING = Material(colour=(0.42, 0.42, 0.44), gloss=0.03)
IRON = Material(colour=(0.07, 0.07, 0.07), gloss=0.02, roughness=0.6)
INSIDE = Material(colour=(0.13, 0.12, 0.12), gloss=0.06, roughness=0.08)
DISPLAY = Material(colour=(0.2, 0.85, 0.75), emission=0.7)


def _plates(width: float, depth: float) -> list[tuple[float, float, float]]:
    """Return the centres and radii of the cooking zones."""
    x, near, far = width * 0.24, depth * 0.72, depth * 0.28
    plates = [(-x, far, 0.075), (x, far, 0.095), (-x, near, 0.095), (x, near, 0.075)]
    if width > 0.8:
        plates = [(1.35 * a, b, c) for a, b, c in plates]
        plates.append((0.0, depth / 2, 0.115))
    return plates


def hob(rng: np.random.Generator, kind: str, width: float, depth: float, *, knobs: bool = True) -> Mesh:
    """Draw a hob lying on z = 0, with its back at y = 0.

    Parameters
    ----------
    rng
        Random number generator.
    kind
        "glass", "gas" or "iron" (hotplates).
    width, depth
        Size in metres.
    knobs
        Whether the hob has knobs at the front.

    Returns
    -------
    Mesh
        A hob about 6 cm high.
    """
    parts: list[Mesh] = []
    if kind == "glass":
        parts.append(box(width, depth, 0.008, 0.003).of(GLASS))
        for x, y, r in _plates(width, depth):
            parts.append(lathe([(r, 0.0085), (r - 0.004, 0.0085)], 24).of(RING).moved(x, y))
            parts.append(lathe([(0.6 * r, 0.0085), (0.6 * r - 0.002, 0.0085)], 20).of(RING).moved(x, y))
        for k in range(5):
            parts.append(block(RING, (0.016, 0.016, 0.001), (-0.08 + 0.04 * k, depth - 0.045, 0.008)))
        return join(parts)
    base = STEEL if kind == "gas" and chance(rng, 0.6) else (GLASS if kind == "gas" else STEEL)
    parts.append(box(width, depth, 0.01, 0.003).of(base))
    for x, y, r in _plates(width, depth):
        if kind == "iron":
            disc = [(r + 0.006, 0.01), (r, 0.022), (0.3 * r, 0.022), (0.28 * r, 0.018), (0, 0.018)]
            parts.append(lathe(disc, 20).of(IRON).moved(x, y))
            continue
        size = 0.5 * r
        burner = [
            (size * 1.3, 0.01),
            (size * 1.2, 0.022),
            (size, 0.024),
            (size, 0.034),
            (0.8 * size, 0.038),
            (0, 0.038),
        ]
        parts.append(lathe(burner, 14).of(IRON).moved(x, y))
        for turn in range(4):
            arm = block(IRON, (0.011, r + 0.02 - 0.4 * size, 0.012), (0, 0.4 * size, 0.045))
            foot = block(IRON, (0.011, 0.011, 0.05), (0, r + 0.01, 0.006))
            parts.append(join(arm, foot).turned(90 * turn).moved(x, y))
        rim = r + 0.014
        corners = [(-rim, 0, 0.05), (0, rim, 0.05), (rim, 0, 0.05), (0, -rim, 0.05), (-rim, 0, 0.05)]
        square = tube([(1.0 * a, 1.0 * b, c) for a, b, c in corners], 0.005, 4).turned(45)
        parts.append(square.of(IRON).moved(x, y))
    if knobs:
        for k in range(4):
            knob = cylinder(0.019, 0.025, 12, 0.004).of(BLACK)
            parts.append(knob.moved(-0.09 + 0.06 * k, depth - 0.04, 0.01))
    return join(parts)


def oven_front(
    rng: np.random.Generator, style: Style, body: Material, width: float, height: float, *, knobs: int = 5
) -> Mesh:
    """Draw the front of an oven: controls above a glass door with a bar handle.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    body
        Material of the front: steel, black or white.
    width, height
        Size in metres.
    knobs
        Number of knobs.

    Returns
    -------
    Mesh
        An oven front with its back at y = 0 and its lower edge at z = 0.
    """
    controls = 0.11 if height > 0.5 else 0.09
    door = height - controls - 0.006
    knob_metal = STEEL if body == BLACK else BLACK
    if body == WHITE and chance(rng, 0.5):
        knob_metal = WHITE
    parts = [
        box(width - 0.004, 0.022, controls, 0.003).moved(z=height - controls).of(body),
        box(width - 0.004, 0.03, door, 0.004).of(body),
    ]
    window_w, window_h = width * 0.8, door * between(rng, 0.5, 0.62)
    low = door * 0.14
    if chance(rng, 0.5):
        full = box(width - 0.02, 0.003, door * 0.97, 0).moved(0, 0.03, 0.01)
        parts.append(full.of(GLASS))
    else:
        parts.append(box(window_w + 0.03, 0.002, window_h + 0.03, 0).moved(0, 0.03, low - 0.015).of(GLASS))
    parts.append(box(window_w, 0.002, window_h, 0).moved(0, 0.0325, low).of(INSIDE))
    for k in range(3):
        wire = box(window_w - 0.02, 0.001, 0.005, 0).moved(0, 0.0345, low + window_h * (0.25 + 0.25 * k))
        parts.append(wire.of(RING))
    z = door - 0.045
    half = width * 0.4
    bar = tube([(-half, 0.07, z), (half, 0.07, z)], 0.01, 8)
    feet = [tube([(x, 0.028, z), (x, 0.07, z)], 0.008, 6) for x in (-0.9 * half, 0.9 * half)]
    parts.append(join(bar, feet).of(STEEL))
    middle = height - controls / 2
    places = np.linspace(-width * 0.38, width * 0.38, knobs)
    clock = chance(rng, 0.7) and knobs >= 2
    for x in places:
        if clock and abs(x) < 0.055:
            continue
        knob = cylinder(0.021, 0.026, 12, 0.005).turned(-90, "x")
        mark = block(WHITE if knob_metal == BLACK else BLACK, (0.004, 0.002, 0.018), (0, 0.026, 0))
        parts.append(join(knob.of(knob_metal), mark).moved(float(x), 0.022, middle))
    if clock:
        parts.append(block(GLASS, (0.1, 0.003, 0.045), (0, 0.022, middle - 0.022)))
        parts.append(block(DISPLAY, (0.055, 0.002, 0.018), (0, 0.0245, middle - 0.009)))
    if chance(rng, 0.4):
        towel = hung(rng, between(rng, 0.2, 0.32), between(rng, 0.22, 0.36), between(rng, 0.1, 0.25), 0.014)
        cloth = towel.moved(between(rng, -0.6, 0.6) * (half - 0.14), 0.07, z)
        parts.append(cloth.of(style.any_fabric(rng)))
    return join(parts)
