"""Washbasins and the objects on them."""

import numpy as np

from placecat_homes import palette
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.fittings import FRONTS, fronts, tap
from placecat_homes.parts.lofts import Outline, hung, loft, rounded
from placecat_homes.parts.toiletries import bottle, cosmetic, soap, soap_dispenser, tooth_brushes
from placecat_homes.shapes import box, cylinder, lathe, tube
from placecat_homes.style import Style

RIM = 0.86
"""Height of the basin rim in metres."""


def washbasin(
    rng: np.random.Generator,
    style: Style,
    *,
    ceramic: Material | None = None,
    kind: str | None = None,
    width: float | None = None,
    clutter: float | None = None,
) -> Mesh:
    """Draw a washbasin with a tap and the objects usually kept there.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    ceramic
        Material of the basin; chosen at random if None.
    kind
        "pedestal", "wall" (with an exposed drain), "vanity" (a cabinet with the basin as its top), "vessel"
        (a bowl on a counter) or "stand" (a bowl on a table); chosen at random if None.
    width
        Width in metres; chosen at random if None. A vanity of 1.1 m or more has two basins.
    clutter
        Amount of clutter, from 0 (only a bar of soap) to 1 (many bottles); taken from the style if None.

    Returns
    -------
    Mesh
        A washbasin whose rim is 0.86 m high.
    """
    ceramic = ceramic or palette.ceramic(rng)
    clutter = style.clutter if clutter is None else clutter
    if kind is None:
        shares = np.array([0.3 - 0.15 * style.modern, 0.17, 0.35, 0.1 + 0.12 * style.modern, 0.06])
        kinds = ("pedestal", "wall", "vanity", "vessel", "stand")
        kind = str(rng.choice(kinds, p=shares / shares.sum()))
    if kind in ("pedestal", "wall"):
        mesh = _plain(rng, style, ceramic, kind, width or rng.uniform(0.5, 0.65), clutter)
    elif kind == "vanity":
        mesh = _vanity(rng, style, ceramic, width or float(rng.choice((0.6, 0.7, 0.8, 0.9, 1.2))), clutter)
    else:
        mesh = _vessel(rng, style, ceramic, kind, width or rng.uniform(0.7, 1.1), clutter)
    return mesh


def hollow(
    width: float, depth: float, radius: tuple[float, float], y: float, top: float, deep: float
) -> list[tuple[Outline, float]]:
    """Return the rings of a hollow, from the edge to the bottom."""
    rings = []
    for share, down in ((1.0, 0.0), (0.97, 0.02), (0.86, 0.75), (0.7, 0.95), (0.4, 1.0)):
        outline = rounded(width, depth, radius, y=y)
        middle = outline.mean(axis=0)
        rings.append((middle + (outline - middle) * share, top - deep * down))
    return rings


def _drain(metal: Material, y: float, z: float) -> Mesh:
    return cylinder(0.022, 0.006, 10).moved(0, y, z).of(metal)


def _plain(
    rng: np.random.Generator, style: Style, ceramic: Material, kind: str, width: float, clutter: float
) -> Mesh:
    depth = width * rng.uniform(0.75, 0.82)
    square = rng.random() < 0.3 + 0.3 * style.modern
    front = (0.05, 0.05) if square else (width * 0.5, depth * rng.uniform(0.5, 0.75))
    inner = (0.06, 0.06) if square else ((width - 0.09) * 0.5, (depth - 0.15) * 0.5)

    def outline(share: float, back: float = 0.0) -> Outline:
        return rounded(width * share, depth * share - back, (front[0] * share, front[1] * share), 0.03, y=0.0)

    rings = [
        (outline(0.45), RIM - 0.2),
        (outline(0.7), RIM - 0.17),
        (outline(0.92), RIM - 0.1),
        (outline(0.98), RIM - 0.05),
        (outline(1.0), RIM - 0.02),
        (outline(0.985), RIM),
        *hollow(width - 0.09, depth - 0.15, inner, 0.105, RIM, 0.13),
    ]
    parts = [
        loft(rings).of(ceramic),
        _drain(style.metal, 0.105 + (depth - 0.15) / 2, RIM - 0.13),
        tap(rng, style.metal).moved(0, 0.05, RIM),
    ]
    if kind == "pedestal":
        profile = ((0.2, 0.0), (0.2, 0.03), (0.15, 0.12), (0.14, 0.45), (0.19, RIM - 0.19))
        foot = [(rounded(w, w, w * (0.2 if square else 0.5), w * 0.3, y=0.1), z) for w, z in profile]
        parts.append(loft(foot, top=False).of(ceramic))
    else:
        bend = [(0, 0.2, RIM - 0.2), (0, 0.2, 0.5), (0, 0.15, 0.46), (0, 0.12, 0.52), (0, 0.0, 0.52)]
        parts.append(tube(bend, 0.016, 8).of(style.metal))
        parts.append(cylinder(0.03, 0.1, 10).moved(0, 0.2, 0.52).of(style.metal))
        parts.extend(
            tube([(x, 0.01, 0.55), (x, 0.06, 0.56), (x * 0.3, 0.06, RIM - 0.1)], 0.006, 6).of(style.metal)
            for x in (-0.09, 0.09)
        )
        if rng.random() < 0.3:
            parts.append(_towel_bar(rng, style, width, depth))
    parts.append(_things(rng, style, width, 0.06, RIM, clutter))
    return join(parts)


def _towel_bar(rng: np.random.Generator, style: Style, width: float, depth: float) -> Mesh:
    bar_y = depth + 0.03
    bar = tube(
        [
            (-width * 0.4, depth * 0.6, RIM - 0.09),
            (-width * 0.4, bar_y, RIM - 0.09),
            (width * 0.4, bar_y, RIM - 0.09),
            (width * 0.4, depth * 0.6, RIM - 0.09),
        ],
        0.007,
        6,
    )
    towel = hung(rng, width * 0.55, 0.35, 0.3, 0.014).of(palette.plain_fabric(rng))
    return join(bar.of(style.metal), towel.moved(0, bar_y, RIM - 0.09))


def _things(rng: np.random.Generator, style: Style, width: float, y: float, z: float, clutter: float) -> Mesh:
    """Put soap, toothbrushes and other objects beside the tap. A higher `clutter` means more of them."""
    things = [soap_dispenser(rng, style.metal) if rng.random() < 0.6 else soap(rng)]
    if rng.random() < 0.35 + 0.6 * clutter:
        things.append(tooth_brushes(rng))
    if width > 0.75:
        count = int(rng.integers(0, 2 + round(4 * clutter)))
        things.extend(cosmetic(rng) for _ in range(count))
    elif rng.random() < clutter * 0.6:
        things.append(bottle(rng))
    reach = width / 2 - 0.06
    near = 0.15 if width < 0.75 else 0.17
    places = list(np.arange(near, reach + 0.02, 0.085)) or [reach]
    spots = [sign * min(float(place), reach) for place in places for sign in (-1, 1)]
    order = [int(k) for k in rng.permutation(len(spots))]
    return join(
        thing.moved(spots[k], y + rng.uniform(-0.01, 0.01), z)
        for thing, k in zip(things, order, strict=False)
    )


def _cabinet(rng: np.random.Generator, style: Style, width: float, depth: float, top: float) -> Mesh:
    """Draw the cabinet under a basin, up to a height of `top`."""
    colour = rng.choice(4)
    material = (style.fronts, style.wood, palette.paint(rng), palette.wood(rng))[int(colour)]
    floating = rng.random() < 0.3 + 0.5 * style.modern
    low = float(rng.uniform(0.3, 0.42)) if floating else 0.1
    design = "flat" if style.modern > 0.55 else str(rng.choice(FRONTS))
    height = top - low
    drawers = rng.random() < 0.5
    columns = 1 if drawers and width < 1.0 else max(2, round(width / 0.42))
    rows = 2 if drawers else 1
    parts = [
        box(width, depth - 0.02, height, bevel=0.003).moved(z=low).of(material),
        fronts(
            width,
            height,
            material,
            style.metal,
            rows=rows,
            columns=columns,
            design=design,
            grip=style.handle,
            doors=not drawers,
        ).moved(0, depth - 0.02, low),
    ]
    if not floating:
        if rng.random() < 0.5:
            parts.append(box(width - 0.02, depth - 0.06, low, bevel=0.0).of(material))
        else:
            parts.extend(
                box(0.04, 0.04, low, bevel=0.003).moved(x, y).of(material)
                for x in (-width / 2 + 0.03, width / 2 - 0.03)
                for y in (0.01, depth - 0.08)
            )
    return join(parts)


def _vanity(rng: np.random.Generator, style: Style, ceramic: Material, width: float, clutter: float) -> Mesh:
    depth = rng.uniform(0.44, 0.5)
    double = width >= 1.1
    thick = rng.uniform(0.025, 0.06)
    basin = min(0.5, width - 0.12)
    deep = depth - 0.16
    oval = rng.random() < 0.45
    parts = [_cabinet(rng, style, width, depth - 0.01, RIM - thick)]
    metal_tap = tap(rng, style.metal)
    material = ceramic if rng.random() < 0.65 else palette.stone(rng)
    share = width / 2 if double else width
    for x in (-width / 4, width / 4) if double else (0.0,):
        edge = rounded(share, depth, 0.012 if not double else 0.002)
        inner = (basin / 2, deep / 2) if oval else (0.06, 0.06)
        rings = hollow(basin, deep, inner, 0.115, RIM, 0.12)
        top = [(edge, RIM - thick), (edge, RIM - 0.004), (edge * (0.994, 0.994), RIM), rings[0]]
        parts.append(loft(top, bottom=False, top=False).of(material).moved(x))
        parts.append(loft(rings, bottom=False).of(ceramic).moved(x))
        parts.append(_drain(style.metal, 0.115 + deep / 2, RIM - 0.12).moved(x))
        parts.append(metal_tap.moved(x, 0.055, RIM))
        parts.append(_things(rng, style, share, 0.055, RIM, clutter).moved(x))
    if rng.random() < 0.4:
        parts.append(box(width, 0.015, 0.06, bevel=0.002).moved(z=RIM).of(material))
    return join(parts)


def _vessel(
    rng: np.random.Generator, style: Style, ceramic: Material, kind: str, width: float, clutter: float
) -> Mesh:
    depth = rng.uniform(0.45, 0.52)
    counter = RIM - 0.12
    top = palette.stone(rng) if rng.random() < 0.5 else style.any_wood(rng)
    thick = 0.04
    if kind == "vessel":
        parts = [_cabinet(rng, style, width - 0.02, depth - 0.01, counter - thick)]
    else:
        wood = style.any_wood(rng)
        leg = box(0.05, 0.05, counter - thick, bevel=0.004).of(wood)
        parts = [leg.moved(x, y) for x in (-width / 2 + 0.03, width / 2 - 0.03) for y in (0.01, depth - 0.06)]
        parts.append(box(width - 0.04, depth - 0.04, 0.03, bevel=0.003).moved(0, 0.02, 0.22).of(wood))
        parts.append(
            box(width - 0.06, 0.02, 0.1, bevel=0.0).moved(0, depth - 0.05, counter - thick - 0.1).of(wood)
        )
    parts.append(box(width, depth, thick, bevel=0.004).moved(z=counter - thick).of(top))
    middle = depth * 0.55
    if rng.random() < 0.55:
        radius = rng.uniform(0.18, 0.21)
        bowl = lathe(
            [
                (0, 0),
                (radius * 0.5, 0),
                (radius * 0.85, 0.05),
                (radius, 0.14),
                (radius - 0.012, 0.14),
                (radius * 0.8, 0.06),
                (radius * 0.45, 0.015),
                (0, 0.015),
            ],
            24,
        )
    else:
        w, d = rng.uniform(0.4, 0.52), 0.34
        outer = rounded(w, d, 0.06, y=-d / 2)
        rings = [(outer * 0.85, 0.0), (outer, 0.02), (outer, 0.14)]
        bowl = loft([*rings, *hollow(w - 0.03, d - 0.03, (0.05, 0.05), -d / 2 + 0.015, 0.14, 0.11)])
    parts.append(bowl.moved(0, middle, counter).of(ceramic))
    parts.append(_drain(style.metal, middle, counter + 0.016))
    parts.append(tap(rng, style.metal, "tall", 1.15).moved(0, 0.05, counter))
    parts.append(_things(rng, style, width + 0.1, 0.08, counter, clutter))
    return join(parts)
