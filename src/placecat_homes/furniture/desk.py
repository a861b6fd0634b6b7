"""Desks with drawers, trestles, steel legs or side panels."""

import numpy as np

from placecat_homes import palette
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.drawers import chest, surface
from placecat_homes.parts.forming import board
from placecat_homes.parts.outlines import sideways
from placecat_homes.shapes import box, tube
from placecat_homes.style import Style

HEIGHT = 0.74
"""Height of all desk tops in metres."""


def desk(
    rng: np.random.Generator, style: Style, width: float | None = None, depth: float | None = None
) -> Mesh:
    """Draw a desk.

    Parameters
    ----------
    rng, style
        Random number generator and style of the home.
    width, depth
        Size in metres; 1.2 to 1.8 by 0.65 to 0.85 if None.
    """
    width = width or float(rng.uniform(1.2, 1.8))
    depth = depth or float(rng.uniform(0.65, 0.85))
    top = surface(rng, style)
    names = ["chest", "trestle", "steel", "panel", "classic", "pipe"]
    weights = np.array([2.5, 1.3, 2.5, 1.5, 1.5 * (1.3 - style.modern), 1.2])
    design = _DESIGNS[str(rng.choice(names, p=weights / weights.sum()))]
    return design(rng, style, width, depth, top)


def _frame(rng: np.random.Generator, style: Style) -> Material:
    if rng.random() < 0.4:
        return style.metal
    grey = float(rng.choice([0.08, 0.25, 0.6, 0.85]))
    return Material((grey, grey, grey), gloss=0.04)


def _top(width: float, depth: float, thick: float, material: Material, radius: float) -> Mesh:
    z = HEIGHT - thick
    if radius > 0:
        return board(width, depth, thick, radius).moved(z=z).of(material)
    return box(width, depth, thick, 0.004).moved(z=z).of(material)


def _chest(rng: np.random.Generator, style: Style, width: float, depth: float, top: Material) -> Mesh:
    thick = float(rng.uniform(0.022, 0.035))
    legs = top if rng.random() < 0.5 else _frame(rng, style)
    front = top if rng.random() < 0.5 else palette.paint(rng)
    shares = [(1.0, 1.0, 1.0), (0.6, 1.0, 2.0), (0.7, 1, 1, 1)][int(rng.integers(3))]
    drawers = chest(style, 0.42, depth - 0.08, HEIGHT - thick, shares, legs, front)
    x = width / 2 - 0.23
    parts = [
        _top(width, depth, thick, top, 0.0),
        drawers.moved(x, 0.04),
        box(width - 0.5, 0.018, 0.36, 0).moved(-0.2, 0.05, HEIGHT - thick - 0.36).of(legs),
    ]
    if rng.random() < 0.35 and width > 1.45:
        parts.append(drawers.moved(-x, 0.04))
    else:
        parts.append(box(0.03, depth - 0.08, HEIGHT - thick, 0.002).moved(-x - 0.18, 0.04).of(legs))
    return _either(rng, join(parts))


def _either(rng: np.random.Generator, mesh: Mesh) -> Mesh:
    return mesh if rng.random() < 0.5 else mesh.mirrored()


def _trestle(rng: np.random.Generator, style: Style, width: float, depth: float, top: Material) -> Mesh:
    thick = float(rng.uniform(0.02, 0.04))
    material = style.second_wood if rng.random() < 0.5 else _frame(rng, style)
    z = HEIGHT - thick
    parts = [_top(width, depth, thick, top, 0.0)]
    for x in (-width / 2 + 0.25, width / 2 - 0.25):
        parts.append(box(0.05, depth - 0.1, 0.04).moved(x, 0.05, z - 0.04).of(material))
        for y in (0.08, depth - 0.08):
            for side in (-1, 1):
                line = [(x + side * 0.18, y, 0.0), (x + side * 0.02, y, z - 0.03)]
                parts.append(tube(line, 0.018, 6).of(material))
        for side in (-1, 1):
            line = [(x + side * 0.14, 0.08, 0.18), (x + side * 0.14, depth - 0.08, 0.18)]
            parts.append(tube(line, 0.012, 6).of(material))
    return join(parts)


def _steel(rng: np.random.Generator, style: Style, width: float, depth: float, top: Material) -> Mesh:
    thick = 0.025
    z = HEIGHT - thick
    material = _frame(rng, style)
    parts = [_top(width, depth, thick, top, float(rng.choice([0.0, 0.03, 0.08])))]
    closed = rng.random() < 0.5
    for x in (-width / 2 + 0.12, width / 2 - 0.12):
        parts.append(box(0.06, depth - 0.08, 0.035).moved(x, 0.04).of(material))
        parts.append(box(0.05, depth - 0.2, 0.03, 0).moved(x, 0.1, z - 0.03).of(material))
        if closed:
            parts.append(box(0.03, depth * 0.4, z, 0.002).moved(x, depth * 0.2).of(material))
        else:
            parts.append(box(0.07, 0.1, z, 0.01).moved(x, depth * 0.3).of(material))
    parts.append(box(width - 0.3, 0.03, 0.05, 0).moved(0, depth * 0.3, z - 0.06).of(material))
    if rng.random() < 0.6:
        tall = float(rng.uniform(0.25, 0.4))
        cover = top if rng.random() < 0.5 else material
        parts.append(box(width - 0.3, 0.015, tall, 0).moved(0, 0.08, z - tall - 0.02).of(cover))
    if rng.random() < 0.6:
        case = palette.paint(rng) if rng.random() < 0.5 else material
        rolling = chest(style, 0.42, 0.55, 0.56, (0.5, 1, 1, 1), case, case, plinth=0.05)
        parts.append(rolling.moved(width / 2 - 0.4, depth - 0.62))
    return _either(rng, join(parts))


def _pipe(rng: np.random.Generator, style: Style, width: float, depth: float, top: Material) -> Mesh:
    thick = float(rng.uniform(0.02, 0.035))
    z = HEIGHT - thick
    material = _frame(rng, style)
    radius = float(rng.uniform(0.016, 0.03))
    parts = [_top(width, depth, thick, top, 0.0)]
    for x in (-width / 2 + 0.06, width / 2 - 0.06):
        for y in (0.06, depth - 0.06):
            parts.append(tube([(x, y, 0), (x, y, z)], radius, 10).of(material))
        parts.append(box(0.03, depth - 0.12, 0.05, 0).moved(x, 0.06, z - 0.05).of(material))
    for y in (0.05, depth - 0.08):
        parts.append(box(width - 0.12, 0.03, 0.05, 0).moved(0, y, z - 0.05).of(material))
    if rng.random() < 0.5:
        front = palette.paint(rng) if rng.random() < 0.4 else top
        drawer = chest(style, 0.45, depth - 0.16, 0.13, (1.0,), front, front, plinth=0.0)
        parts.append(drawer.moved(float(rng.choice([-1, 1])) * (width / 2 - 0.35), 0.1, z - 0.13))
    return join(parts)


def _panel(rng: np.random.Generator, style: Style, width: float, depth: float, top: Material) -> Mesh:
    thick = float(rng.uniform(0.025, 0.045))
    z = HEIGHT - thick
    side = top if rng.random() < 0.7 else palette.paint(rng)
    parts = [_top(width, depth, thick, top, 0.0)]
    for x in (-width / 2 + thick / 2, width / 2 - thick / 2):
        parts.append(box(thick, depth, z, 0.003).moved(x).of(side))
    parts.append(box(width - 2 * thick, 0.018, 0.4, 0).moved(0, 0.06, z - 0.4).of(side))
    if rng.random() < 0.5:
        wide = 0.45
        x = width / 2 - thick - wide / 2
        drawers = chest(style, wide, depth - 0.06, 0.32, (1, 1), side, side, plinth=0.0)
        parts.append(drawers.moved(x, 0.04, z - 0.32))
    return _either(rng, join(parts))


def _classic(rng: np.random.Generator, style: Style, width: float, depth: float, top: Material) -> Mesh:
    wood = style.wood if rng.random() < 0.6 else palette.wood(rng)
    thick = 0.035
    z = HEIGHT - thick
    parts = [_top(width, depth, thick, wood, 0.0)]
    if rng.random() < 0.5:
        leather = palette.leather(rng)
        parts.append(box(width - 0.2, depth - 0.2, 0.002, 0).moved(0, 0.1, HEIGHT - 0.0005).of(leather))
    wide = min(0.4, width * 0.29)
    for side in (-1, 1):
        drawers = chest(style, wide, depth - 0.08, z, (0.8, 1, 1), wood, wood, plinth=0.07, handle="knob")
        parts.append(drawers.moved(side * (width / 2 - wide / 2 - 0.03), 0.04))
    middle = width - 2 * wide - 0.08
    parts.append(box(middle, depth - 0.1, 0.1, 0.002).moved(0, 0.04, z - 0.1).of(wood))
    parts.append(box(middle, 0.02, z - 0.1, 0).moved(0, 0.06, 0.06).of(wood))
    arch = [(0.0, 0.0), (0.03, 0.0), (0.05, 0.05), (0.0, 0.05)]
    parts.append(sideways(arch, width - 0.1).moved(0, depth - 0.1, z - 0.05).of(wood))
    return join(parts)


_DESIGNS = {
    "chest": _chest,
    "trestle": _trestle,
    "steel": _steel,
    "panel": _panel,
    "classic": _classic,
    "pipe": _pipe,
}
