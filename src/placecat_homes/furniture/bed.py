"""Beds."""

import math

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.laundry_basket import heap
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.bedding import bedding
from placecat_homes.parts.fittings import FRONTS, fronts
from placecat_homes.parts.hanging import curtain
from placecat_homes.shapes import box, lathe, superellipsoid, tube
from placecat_homes.style import Style

KINDS = ("wood", "upholstered", "box spring", "metal", "four-poster", "platform")

_STICKS_OUT = {"wood": 0.03, "upholstered": 0.065, "box spring": 0.01, "metal": 0.03}


def bed(
    rng: np.random.Generator,
    style: Style,
    *,
    width: float | None = None,
    kind: str | None = None,
    bedclothes: str | None = None,
) -> Mesh:
    """Draw a bed, including the bedclothes, with its head against the wall.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    width
        Width of the mattress in metres: 0.9 to 1.2 for one person, 1.4 to 1.8 for two; a double bed if None.
    kind
        One of `KINDS`; chosen at random if None.
    bedclothes
        How the bed is made (see `bedding`); chosen at random if None.

    Returns
    -------
    Mesh
        A bed 2.05 to 2.2 m deep.
    """
    width = width or float(rng.choice((1.4, 1.6, 1.6, 1.8)))
    length = float(rng.choice((1.95, 2.0, 2.0)))
    if kind is None:
        old, new = 1 - style.modern, style.modern
        shares = np.array(
            [0.34, 0.2, 0.08 + 0.14 * new, 0.08 + 0.08 * old, 0.03 + 0.05 * old, 0.06 + 0.1 * new]
        )
        kind = str(rng.choice(KINDS, p=shares / shares.sum()))
    low = 0.3 if kind != "platform" else 0.22
    thick = rng.uniform(0.18, 0.24)
    free = True
    if kind == "wood":
        frame, y = _wooden(rng, style, width, length, low)
        free = rng.random() < 0.7
    elif kind == "upholstered":
        frame, y = _upholstered(rng, style, width, length, low)
    elif kind == "box spring":
        frame, y = _box_spring(rng, style, width, length, low + 0.06)
        low += 0.06
    elif kind == "metal":
        frame, y = _metal(rng, style, width, length, low)
    elif kind == "four-poster":
        frame, y = _four_poster(rng, style, width, length, low)
        free = False
    else:
        frame, y = _platform(rng, style, width, length, low)
        free = False
    clothes = bedding(
        rng,
        style,
        width,
        length,
        low + thick,
        thick=thick,
        free=free,
        footboard=kind in ("wood", "metal"),
        clear=_STICKS_OUT.get(kind, 0.0) if free else 0.0,
        kind=bedclothes,
    )
    parts = [frame, clothes.moved(0, y)]
    if rng.random() < 0.3 * style.clutter + 0.05:
        cloth = style.any_fabric(rng)
        thing = heap(rng, cloth, rng.uniform(0.35, 0.55), 0.09)
        x, along = rng.uniform(-0.3, 0.3) * width, y + length * rng.uniform(0.55, 0.8)
        top = parts[1].vertices
        near = np.hypot(top[:, 0] - x, top[:, 1] - along) < 0.2
        lift = float(top[near, 2].max()) if near.any() else low + thick
        parts.append(thing.moved(x, along, lift - 0.01))
    mesh = join(parts)
    return mesh.moved(0, -min(0.0, float(mesh.low[1])))


def _rails(
    width: float, length: float, y: float, low: float, material: Material, high: float = 0.2
) -> list[Mesh]:
    """Draw the side rails and the slatted base between them."""
    side = box(0.03, length, high, bevel=0.004)
    return [
        side.moved(-width / 2 - 0.02, y, low + 0.06 - high).of(material),
        side.moved(width / 2 + 0.02, y, low + 0.06 - high).of(material),
        box(width, length, 0.03, bevel=0.0).moved(0, y, low - 0.03).of(material),
    ]


def _wooden(
    rng: np.random.Generator, style: Style, width: float, length: float, low: float
) -> tuple[Mesh, float]:
    wood = style.any_wood(rng)
    outer, post, y = width + 0.1, 0.07, 0.06
    high = rng.uniform(0.85, 1.15)
    foot_high = rng.uniform(0.42, 0.62) if rng.random() < 0.6 else low + 0.06
    design = str(rng.choice(("slats", "panel", "boards", "rounded", "rails")))
    parts = _rails(width, length, y, low, wood)
    parts += [
        _board(rng, wood, outer, high, post, design),
        _board(rng, wood, outer, foot_high, post, design).moved(0, y + length),
    ]
    if rng.random() < 0.3:
        finial = superellipsoid(post, post, post * 1.2, 0.9, 1.0, 10).of(wood)
        parts += [finial.moved(x, post / 2, high - 0.005) for x in (-(outer - post) / 2, (outer - post) / 2)]
    return join(parts), y


def _board(
    rng: np.random.Generator, wood: Material, outer: float, high: float, post: float, design: str
) -> Mesh:
    """Draw a headboard or footboard between two posts."""
    inner = outer - 2 * post
    x = (outer - post) / 2
    low = 0.16
    parts = [box(post, post, high, bevel=0.006).moved(side) for side in (-x, x)]
    if high < 0.45:
        parts.append(box(inner + 0.02, 0.03, high - low, bevel=0.004).moved(0, 0.015, low))
    elif design == "slats":
        parts.append(box(inner, 0.04, 0.08, bevel=0.004).moved(0, 0.01, high - 0.1))
        parts.append(box(inner, 0.03, 0.16, bevel=0.004).moved(0, 0.015, low))
        count = round(inner / 0.11)
        slat = box(0.04, 0.02, high - 0.1 - low - 0.15, bevel=0.0)
        parts += [slat.moved((k + 0.5) / count * inner - inner / 2, 0.02, low + 0.155) for k in range(count)]
    elif design == "panel":
        parts.append(box(inner, 0.02, high - low - 0.02, bevel=0.0).moved(0, 0.015, low))
        parts.append(box(inner, 0.04, 0.09, bevel=0.006).moved(0, 0.01, high - 0.1))
        count = 3 if inner > 1.2 else 2
        raised = box(inner / count - 0.12, 0.014, high - low - 0.3, bevel=0.012)
        parts += [
            raised.moved((k + 0.5) / count * inner - inner / 2, 0.034, low + 0.16) for k in range(count)
        ]
    elif design == "boards":
        count = round((high - low) / 0.16)
        plank = box(inner + 0.02, 0.025, (high - low) / count - 0.012, bevel=0.005)
        parts += [plank.moved(0, 0.02, low + (high - low) * k / count) for k in range(count)]
    elif design == "rounded":
        angle = np.linspace(0, math.pi, 17)
        for k in range(16):
            left, right = -math.cos(angle[k]) * inner / 2, -math.cos(angle[k + 1]) * inner / 2
            top = high - 0.05 + 0.16 * math.sin((angle[k] + angle[k + 1]) / 2)
            parts.append(box(right - left, 0.03, top - low, bevel=0.0).moved((left + right) / 2, 0.02, low))
    else:
        bars = 3 if high > 0.7 else 2
        for k in range(bars):
            z = low + 0.12 + (high - low - 0.22) * k / (bars - 1)
            parts.append(box(inner + 0.02, 0.03, 0.1, bevel=0.01).moved(0, 0.02, z))
    return join(parts).of(wood)


def _cloth(rng: np.random.Generator) -> Material:
    return palette.leather(rng) if rng.random() < 0.25 else palette.plain_fabric(rng)


def _headboard(rng: np.random.Generator, cloth: Material, width: float, high: float) -> Mesh:
    """Draw a padded headboard, 0.1 m deep: plain, winged, or divided into squares or channels."""
    design = str(rng.choice(("plain", "squares", "channels", "wings")))
    parts = [box(width, 0.07, high - 0.1, bevel=0.02).moved(0, 0, 0.1)]
    if design == "squares":
        columns = round(width / 0.28)
        cell_width, cell_height = width / columns, (high - 0.42) / 2
        pad = box(cell_width, 0.04, cell_height, bevel=0.019)
        parts += [
            pad.moved((column + 0.5) * cell_width - width / 2, 0.065, 0.41 + row * cell_height)
            for row in range(2)
            for column in range(columns)
        ]
    elif design == "channels":
        columns = round(width / 0.16)
        cell_width = width / columns
        pad = superellipsoid(cell_width, 0.07, high - 0.42, 0.25, 0.35, 10)
        parts += [pad.moved((k + 0.5) * cell_width - width / 2, 0.07, 0.41) for k in range(columns)]
    elif design == "wings":
        parts += [box(0.06, 0.2, high - 0.12, bevel=0.02).moved(x, 0, 0.1) for x in (-width / 2, width / 2)]
        parts += [
            superellipsoid(0.022, 0.02, 0.022, 1.0, 1.0, 6).moved(x, 0.072, z)
            for z in np.arange(high - 0.35, high - 0.05, 0.14)
            for x in np.linspace(-width / 2 + 0.15, width / 2 - 0.15, 6)
        ]
    else:
        parts.append(box(width - 0.12, 0.03, high - 0.5, bevel=0.015).moved(0, 0.06, 0.44))
    return join(parts).of(cloth)


def _upholstered(
    rng: np.random.Generator, style: Style, width: float, length: float, low: float
) -> tuple[Mesh, float]:
    cloth, y = _cloth(rng), 0.1
    leg = lathe([(0, 0), (0.02, 0), (0.028, 0.1), (0, 0.1)], 8).of(style.any_wood(rng))
    parts = [_headboard(rng, cloth, width + 0.12, rng.uniform(0.95, 1.25))]
    side = box(0.06, length + 0.06, 0.28, bevel=0.02)
    parts += [side.moved(x, y, 0.09).of(cloth) for x in (-width / 2 - 0.03, width / 2 + 0.03)]
    parts.append(box(width + 0.12, 0.06, 0.28, bevel=0.02).moved(0, y + length, 0.09).of(cloth))
    parts.append(box(width, length, 0.03, bevel=0.0).moved(0, y, low - 0.03).of(palette.WHITE))
    parts += [leg.moved(x, depth) for x in (-width / 2, width / 2) for depth in (0.1, y + length)]
    return join(parts), y


def _box_spring(
    rng: np.random.Generator, style: Style, width: float, length: float, low: float
) -> tuple[Mesh, float]:
    cloth, y = _cloth(rng), 0.1
    parts = [_headboard(rng, cloth, width + rng.uniform(0.0, 0.3), rng.uniform(1.0, 1.3))]
    halves = 2 if width > 1.5 else 1
    base = box(width / halves - 0.004, length, low - 0.08, bevel=0.025)
    foot = lathe([(0, 0), (0.025, 0), (0.03, 0.09), (0, 0.09)], 8).of(style.metal)
    for k in range(halves):
        x = (k - (halves - 1) / 2) * width / halves
        parts.append(base.moved(x, y, 0.08).of(cloth))
    parts += [
        foot.moved(x, d) for x in (-width / 2 + 0.08, width / 2 - 0.08) for d in (y + 0.08, y + length - 0.08)
    ]
    return join(parts), y


def _metal(
    rng: np.random.Generator, style: Style, width: float, length: float, low: float
) -> tuple[Mesh, float]:
    iron = palette.paint(rng) if rng.random() < 0.35 else palette.metal(rng)
    y, outer = 0.04, width + 0.06
    parts = _rails(width, length, y, low, iron, 0.06)
    curved = rng.random() < 0.6
    for place, high in ((0.02, rng.uniform(1.0, 1.25)), (y + length + 0.02, rng.uniform(0.6, 0.8))):
        posts = [tube([(x, place, 0), (x, place, high)], 0.018, 8) for x in (-outer / 2, outer / 2)]
        knobs = [
            superellipsoid(0.06, 0.06, 0.06, 1.0, 1.0, 10).moved(x, place, high)
            for x in (-outer / 2, outer / 2)
        ]
        arch = 0.18 if curved else 0.0
        across = np.linspace(-1, 1, 15)
        bow = [(outer / 2 * u, place, high - 0.04 + arch * (1 - u * u)) for u in across]
        parts.append(join(posts, knobs, tube(bow, 0.014, 8)).of(iron))
        parts.append(tube([(-outer / 2, place, low), (outer / 2, place, low)], 0.012, 6).of(iron))
        count = max(5, round(outer / 0.15))
        for k in range(1, count):
            u = 2 * k / count - 1
            top = high - 0.04 + arch * (1 - u * u)
            parts.append(tube([(outer / 2 * u, place, low), (outer / 2 * u, place, top)], 0.007, 6).of(iron))
    return join(parts), y


def _four_poster(
    rng: np.random.Generator, style: Style, width: float, length: float, low: float
) -> tuple[Mesh, float]:
    wood = style.any_wood(rng) if rng.random() < 0.7 else palette.metal(rng)
    y, outer, high, post = 0.07, width + 0.12, 2.05, 0.06
    parts = _rails(width, length, y, low, wood)
    for x in (-(outer - post) / 2, (outer - post) / 2):
        parts += [box(post, post, high, bevel=0.006).moved(x, d).of(wood) for d in (0.0, y + length)]
        parts.append(box(0.04, length + y, 0.05, bevel=0.0).moved(x, 0.03, high - 0.06).of(wood))
    for d in (0.01, y + length + 0.01):
        parts.append(box(outer - post, 0.04, 0.05, bevel=0.0).moved(0, d, high - 0.06).of(wood))
    parts.append(box(outer - post, 0.03, 0.75, bevel=0.004).moved(0, 0.015, 0.3).of(wood))
    parts.append(box(outer - post, 0.03, 0.2, bevel=0.004).moved(0, y + length + 0.01, 0.17).of(wood))
    if rng.random() < 0.6:
        cloth = palette.plain_fabric(rng) if rng.random() < 0.7 else style.any_fabric(rng)
        drape = curtain(0.3, high - 0.12, 4, 0.05).of(cloth)
        parts += [
            drape.turned(90).moved(x, d, 0.06)
            for x in (-outer / 2, outer / 2 + 0.05)
            for d in (0.22, y + length - 0.12)
        ]
        roof = box(outer, length + 0.12, 0.01, bevel=0.0).moved(0, 0.0, high)
        parts.append(roof.of(cloth))
    return join(parts), y


def _platform(
    rng: np.random.Generator, style: Style, width: float, length: float, low: float
) -> tuple[Mesh, float]:
    wood, y = style.any_wood(rng), 0.05
    edge = rng.uniform(0.04, 0.22)
    drawers = rng.random() < 0.4
    base_low = 0.0 if drawers else 0.08
    outer = width + 2 * edge
    parts = [
        box(outer, length + edge, 0.05, bevel=0.005).moved(0, y, low - 0.05).of(wood),
        box(
            width + 0.02 - (0 if drawers else 0.3), length - (0.0 if drawers else 0.25), low - 0.05, bevel=0.0
        )
        .moved(0, y)
        .of(wood),
    ]
    if drawers:
        boards = fronts(
            length - 0.1,
            low - 0.07,
            wood,
            style.metal,
            columns=2,
            design=str(rng.choice(FRONTS[:2])),
            grip=style.handle,
        )
        parts.append(boards.turned(-90).moved(width / 2 + 0.01, y + length / 2, base_low + 0.01))
        parts.append(boards.turned(90).moved(-width / 2 - 0.01, y + length / 2, base_low + 0.01))
    high = rng.uniform(0.6, 0.95)
    wide = outer + (rng.uniform(0.2, 0.6) if rng.random() < 0.3 else 0.0)
    parts.append(box(wide, y, high, bevel=0.005).of(wood))
    return join(parts), y
