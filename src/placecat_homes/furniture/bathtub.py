"""Bathtubs."""

import math

import numpy as np

from placecat_homes import palette
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.fittings import hand_shower, wall_mixer
from placecat_homes.parts.hanging import curtain
from placecat_homes.parts.lofts import Outline, hung, loft, rounded
from placecat_homes.parts.toiletries import bottle
from placecat_homes.shapes import box, cylinder, lathe, superellipsoid, tube
from placecat_homes.style import Style

WATER = Material((0.7, 0.83, 0.85), gloss=0.08, roughness=0.0)


def bathtub(
    rng: np.random.Generator,
    style: Style,
    *,
    ceramic: Material | None = None,
    kind: str | None = None,
    length: float | None = None,
    tiles: Material | None = None,
    screen: str | None = None,
    wall_height: float = 1.9,
) -> Mesh:
    """Draw a bathtub along the wall, with a tap and a hand shower.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    ceramic
        Material of the tub; chosen at random if None.
    kind
        "built-in" (with a panel in front), "claw-foot" or "modern" (both free-standing);
        chosen at random if None.
    length
        Length in metres; chosen at random if None.
    tiles
        Tiles for the wall behind a built-in tub and sometimes for its panel; chosen at random if None.
    screen
        Screen in front of a built-in tub: "curtain", "glass" or "none"; chosen at random if None.
    wall_height
        Height in metres of the tiled wall behind a built-in tub; 0 for a bare wall.

    Returns
    -------
    Mesh
        A tub 1.4 to 1.8 m long.
    """
    ceramic = ceramic or palette.ceramic(rng)
    length = length or float(rng.choice((1.5, 1.6, 1.7, 1.75)))
    kind = kind or str(rng.choice(("built-in", "claw-foot", "modern"), p=(0.7, 0.17, 0.13)))
    if kind == "built-in":
        mesh = _built_in(rng, style, ceramic, length, tiles or palette.tiles(rng), screen, wall_height)
    else:
        mesh = _free(rng, style, ceramic, length, kind)
    return mesh.mirrored() if rng.random() < 0.5 else mesh


def _hollow(
    width: float, depth: float, round_: tuple[float, float], y: float, top: float, deep: float
) -> list[tuple[Outline, float]]:
    """Return the rings of the inner surface, which slopes at the +x end."""
    rings = []
    for short, narrow, down in (
        (0, 0, 0),
        (0.02, 0.02, 0.05),
        (0.14, 0.1, 0.8),
        (0.24, 0.16, 0.97),
        (0.5, 0.3, 1),
    ):
        outline = rounded(width - short, depth - narrow, round_, y=y + narrow / 2)
        outline = outline - np.array([short * 0.28, 0.0])
        rings.append((outline, top - deep * down))
    return rings


def _built_in(
    rng: np.random.Generator,
    style: Style,
    ceramic: Material,
    length: float,
    tiles: Material,
    screen: str | None,
    wall_height: float,
) -> Mesh:
    depth, top = rng.uniform(0.7, 0.8), rng.uniform(0.54, 0.6)
    edge = rounded(length, depth, 0.03, 0.004)
    lip = rounded(length - 0.012, depth - 0.012, 0.03, 0.004, y=0.006)
    oval = (length * 0.28, depth * 0.4) if rng.random() < 0.4 else (0.12, 0.12)
    hollow = _hollow(length - 0.16, depth - 0.15, oval, 0.075, top, 0.4)
    rings = [(edge, top - 0.05), (edge, top - 0.006), (lip, top), *hollow]
    parts = [loft(rings, bottom=False).of(ceramic)]
    choice = rng.random()
    panel = tiles if choice < 0.45 else ceramic if choice < 0.75 else style.any_wood(rng)
    panel_y = depth - 0.04
    parts.append(box(length - 0.01, 0.02, top - 0.05, bevel=0.002).moved(0, panel_y).of(panel))
    for sign in (-1, 1):
        side = box(0.02, depth - 0.05, top - 0.05, bevel=0.0)
        parts.append(side.moved(sign * (length / 2 - 0.015)).of(panel))
    if panel is not tiles and panel is not ceramic and style.modern < 0.6:
        count = round(length / 0.4)
        frame = box(length / count - 0.08, 0.012, top - 0.17, bevel=0.01)
        parts.extend(
            frame.moved((k + 0.5) * length / count - length / 2, panel_y + 0.02, 0.06).of(panel)
            for k in range(count)
        )
    if rng.random() < 0.25:
        parts.append(loft([(hollow[2][0], top - 0.2), (hollow[2][0], top - 0.195)]).of(WATER))
    tap_x = -length / 2 + 0.35 if rng.random() < 0.7 else 0.0
    parts.append(cylinder(0.03, 0.008, 10).turned(-90, "x").moved(tap_x, 0.11, top - 0.12).of(style.metal))
    if wall_height > 0:
        parts.append(box(length, 0.012, wall_height - top, bevel=0.0).moved(z=top).of(tiles))
    parts.append(wall_mixer(style.metal).moved(tap_x, 0.012, top + 0.2))
    parts.append(hand_shower(style.metal, style.metal).moved(tap_x + 0.3, 0.012, top + 0.55))
    screen = screen or str(rng.choice(("curtain", "glass", "none"), p=(0.42, 0.25, 0.33)))
    if screen == "curtain":
        parts.append(_shower_curtain(rng, style, length, depth, top))
    elif screen == "glass":
        wide = rng.uniform(0.7, 0.9)
        pane = box(wide, 0.008, 1.4, bevel=0.0).of(palette.GLASS)
        post = box(0.02, 0.02, 1.4, bevel=0.0).of(style.metal)
        x = -length / 2 + wide / 2
        rail = box(wide, 0.02, 0.02, bevel=0.0).of(style.metal)
        parts.append(
            join(
                pane, post.moved(-wide / 2 + 0.01), post.moved(wide / 2 - 0.01), rail, rail.moved(z=1.39)
            ).moved(x, depth - 0.06, top + 0.002)
        )
    parts.append(_things(rng, style, length, depth, top, screen))
    return join(parts)


def _shower_curtain(rng: np.random.Generator, style: Style, length: float, depth: float, top: float) -> Mesh:
    """Draw a curtain on a rail above the front edge, usually pulled aside."""
    high = 2.0
    cloth = style.any_fabric(rng)
    wide = length * rng.uniform(0.2, 0.75)
    outside = rng.random() < 0.6
    low = 0.2 if outside else top - 0.2
    y = depth + 0.006 if outside else depth - 0.14
    folds = max(4, int(wide / 0.1))
    cloth_mesh = curtain(wide, high - low - 0.05, folds, 0.06).of(cloth)
    x = (length - wide) / 2 - 0.02
    parts = [
        cloth_mesh.moved(x, y, low),
        tube([(-length / 2 + 0.01, y + 0.03, high), (length / 2 - 0.01, y + 0.03, high)], 0.012, 8).of(
            style.metal
        ),
    ]
    for end in (-1, 1):
        parts.append(
            tube(
                [(end * (length / 2 - 0.01), y + 0.03, high), (end * (length / 2 - 0.01), 0, high)], 0.01, 6
            ).of(style.metal)
        )
    for k in range(folds):
        ring_x = x + (k + 0.5) / folds * wide - wide / 2
        parts.append(
            box(0.006, 0.03, 0.08, bevel=0.0).moved(ring_x, y + 0.015, high - 0.06).of(palette.WHITE)
        )
    return join(parts)


def _things(
    rng: np.random.Generator, style: Style, length: float, depth: float, top: float, screen: str
) -> Mesh:
    """Put bottles and perhaps a rubber duck on the edge, and hang a towel over it."""
    parts = []
    for k in range(int(rng.integers(1, 3 + round(4 * style.clutter)))):
        parts.append(bottle(rng).moved(length / 2 - 0.12 - 0.09 * k, 0.045, top))
    if screen == "none" and rng.random() < 0.5:
        towel = hung(rng, rng.uniform(0.4, 0.6), 0.38, 0.25, 0.035).of(palette.plain_fabric(rng))
        parts.append(towel.moved(rng.uniform(-0.1, 0.4), depth - 0.035, top - 0.025))
    if rng.random() < 0.2:
        yellow = Material((0.95, 0.78, 0.1), gloss=0.04)
        duck = join(
            superellipsoid(0.07, 0.09, 0.055, 0.9, 1.0, 12).of(yellow),
            superellipsoid(0.045, 0.045, 0.045, 1.0, 1.0, 10).moved(0, 0.025, 0.045).of(yellow),
            box(0.018, 0.02, 0.008, bevel=0.0).moved(0, 0.045, 0.06).of(Material((0.9, 0.4, 0.1))),
        )
        parts.append(duck.moved(-length / 2 + 0.06, depth - 0.06, top))
    return join(parts)


def _free(rng: np.random.Generator, style: Style, ceramic: Material, length: float, kind: str) -> Mesh:
    """Draw a free-standing tub slightly away from the wall, with a floor-standing mixer tap."""
    depth, gap = rng.uniform(0.72, 0.8), 0.12
    top = 0.58
    outer_paint = palette.paint(rng) if rng.random() < 0.4 else ceramic
    claw = kind == "claw-foot"
    low = 0.14 if claw else 0.0

    def oval(short: float, narrow: float) -> Outline:
        w, d = length - short, depth - narrow
        return rounded(
            w, d, (min(d * 0.5, w / 2) if claw else w * 0.45, d * 0.5), y=gap + narrow / 2, points=7
        )

    if claw:
        shell = [
            (0.7, 0.45, 0.0),
            (0.42, 0.25, 0.03),
            (0.2, 0.12, 0.2),
            (0.1, 0.07, 0.34),
            (0.06, 0.05, top - low),
        ]
    else:
        shell = [
            (0.3, 0.2, 0.0),
            (0.28, 0.18, 0.03),
            (0.14, 0.08, 0.3),
            (0.03, 0.02, top - 0.03),
            (0.0, 0.0, top),
        ]
    body = loft([(oval(a, b), low + z) for a, b, z in shell], top=False).of(outer_paint)
    inside = [
        (0.05, 0.05, top),
        (0.14, 0.11, top - 0.05),
        (0.24, 0.17, top - 0.2),
        (0.42, 0.26, low + 0.12),
        (0.8, 0.5, low + 0.08),
    ]
    if claw:
        lip = [
            (0.06, 0.05, top - 0.02),
            (0.0, 0.0, top - 0.01),
            (0.0, 0.0, top + 0.015),
            (0.05, 0.05, top + 0.02),
        ]
        inside = [*lip, *inside[1:]]
    else:
        inside = [(0.0, 0.0, top), *inside]
    parts = [body, loft([(oval(a, b), z) for a, b, z in inside], bottom=False).of(ceramic)]
    metal = style.metal
    if claw:
        for x in (-length / 2 + 0.38, length / 2 - 0.38):
            for y in (gap + 0.16, gap + depth - 0.16):
                ball = superellipsoid(0.07, 0.07, 0.06, 1.0, 1.0, 10)
                knee = superellipsoid(0.08, 0.08, 0.16, 0.9, 1.0, 10).moved(0, 0, 0.04)
                parts.append(join(ball, knee).moved(x, y).of(metal))
    x = rng.uniform(-0.2, 0.2)
    for side in (-0.06, 0.06):
        parts.append(tube([(x + side, 0.06, 0), (x + side, 0.06, 0.8)], 0.013, 8).of(metal))
    parts.append(wall_mixer(metal).moved(x, 0.02, 0.82))
    cradle = tube([(x, 0.07, 0.85), (x, 0.09, 0.98), (x - 0.1, 0.14, 1.02)], 0.012, 8)
    parts.append(cradle.of(metal))
    turn = np.linspace(0, math.pi, 9)
    hose = [(x - 0.1 + 0.05 * math.cos(a), 0.12, 0.95 - 0.35 * math.sin(a)) for a in turn]
    parts.append(tube(hose, 0.007, 6).of(metal))
    if rng.random() < 0.6:
        tray = box(0.16, depth + 0.02, 0.02, bevel=0.004).of(style.any_wood(rng))
        tray_x = rng.uniform(-0.2, 0.25)
        parts.append(tray.moved(tray_x, gap - 0.01, top + 0.022))
        parts.append(bottle(rng).moved(tray_x, gap + depth * 0.6, top + 0.042))
        soap_dish = lathe([(0, 0), (0.05, 0), (0.06, 0.015), (0, 0.01)], 10).of(ceramic)
        parts.append(soap_dish.moved(tray_x, gap + depth * 0.35, top + 0.042))
    return join(parts)
