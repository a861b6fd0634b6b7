"""Toilets."""

import numpy as np

from placecat_homes import palette
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.lofts import loft, plate, ring, rounded
from placecat_homes.shapes import box, cylinder, lathe, superellipsoid, tube
from placecat_homes.style import Style

WATER = Material((0.62, 0.72, 0.74), gloss=0.08, roughness=0.0)


def toilet(
    rng: np.random.Generator,
    style: Style,
    *,
    ceramic: Material | None = None,
    kind: str | None = None,
    open_lid: bool | None = None,
) -> Mesh:
    """Draw a toilet.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    ceramic
        Material of the bowl; chosen at random if None.
    kind
        "close-coupled" (cistern on the bowl), "wall-hung" (concealed cistern), "low" (cistern halfway up the
        wall) or "high" (an old cistern with a chain); chosen at random if None.
    open_lid
        Whether the lid is open; open with probability 0.4 if None.

    Returns
    -------
    Mesh
        A toilet 0.6 to 0.75 m deep.
    """
    ceramic = ceramic or palette.ceramic(rng)
    metal = style.metal
    if kind is None:
        shares = np.array([0.45, 0.25 + 0.2 * style.modern, 0.18, 0.12 * (1 - style.modern)])
        kinds = ("close-coupled", "wall-hung", "low", "high")
        kind = str(rng.choice(kinds, p=shares / shares.sum()))
    opened = rng.random() < 0.4 if open_lid is None else open_lid
    seat = ceramic
    if rng.random() < (0.6 if kind == "high" else 0.18):
        seat = palette.wood(rng)
    elif rng.random() < 0.12:
        seat = palette.plastic(rng)
    scale = rng.uniform(0.95, 1.06)
    if kind == "close-coupled":
        body = join(_standing(ceramic, 0.22, rng), _tank(rng, ceramic, metal).moved(0, 0.01, 0.395))
        parts = [body, _seat(rng, seat, metal, 0.22, 0.40, opened, 0.2)]
    elif kind == "wall-hung":
        parts = _hung(rng, ceramic, metal, seat, opened)
    elif kind == "low":
        parts = [
            _standing(ceramic, 0.16, rng),
            _tank(rng, ceramic, metal).scaled(1.05, 0.9, 0.9).moved(0, 0.005, 0.85),
            tube([(0, 0.08, 0.87), (0, 0.08, 0.45), (0, 0.17, 0.36)], 0.022, 10).of(ceramic),
            _seat(rng, seat, metal, 0.16, 0.40, opened, 0.15),
        ]
    else:
        iron = palette.paint(rng) if rng.random() < 0.5 else ceramic
        chain_x = 0.16
        parts = [
            _standing(ceramic, 0.16, rng),
            box(0.46, 0.2, 0.28, bevel=0.02).moved(0, 0.02, 1.72).of(iron),
            box(0.5, 0.24, 0.03, bevel=0.008).moved(0, 0.0, 2.0).of(iron),
            box(0.4, 0.02, 0.05, bevel=0.0).moved(0, 0.0, 1.66).of(metal),
            tube([(0, 0.09, 1.74), (0, 0.06, 1.6), (0, 0.06, 0.5), (0, 0.18, 0.36)], 0.02, 10).of(metal),
            tube([(chain_x, 0.12, 1.85), (0.25, 0.14, 1.87), (0.25, 0.14, 1.2)], 0.004, 5).of(metal),
            superellipsoid(0.03, 0.03, 0.09, 0.8, 1.0, 8).moved(0.25, 0.14, 1.11).of(seat),
            _seat(rng, seat, metal, 0.16, 0.40, opened, 0.1),
        ]
    return join(parts).scaled(scale)


def toilet_brush(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a toilet brush in its holder."""
    pot = palette.plastic(rng) if rng.random() < 0.6 else style.metal
    profile = [(0, 0), (0.05, 0), (0.055, 0.03), (0.045, 0.14), (0.04, 0.14), (0.045, 0.02), (0, 0.02)]
    brush = join(
        lathe(profile, 12).of(pot),
        tube([(0, 0, 0.03), (0, 0, 0.38)], 0.008, 6).of(pot),
        superellipsoid(0.02, 0.02, 0.03, 0.8, 1.0, 8).moved(z=0.37).of(pot),
    )
    return brush.moved(0, 0.055)


def _bowl_inside(back: float, width: float, length: float, top: float) -> list[tuple[np.ndarray, float]]:
    """Return the rings of the inner surface, from the rim down to the water."""
    inner = rounded(width - 0.07, length - 0.10, (0.13, 0.2), (0.1, 0.1), y=back + 0.06)
    lower = rounded(width - 0.13, length - 0.19, (0.11, 0.15), (0.08, 0.08), y=back + 0.09)
    deep = rounded(0.13, 0.15, (0.06, 0.08), (0.06, 0.06), y=back + 0.13)
    return [(inner, top), (inner, top - 0.03), (lower, top - 0.1), (deep, top - 0.19)]


def _standing(ceramic: Material, back: float, rng: np.random.Generator) -> Mesh:
    """Draw a floor-standing bowl. Its rim is 40 cm above the floor and starts at y = `back`."""
    width, length = 0.36, 0.47
    waist = rng.uniform(0.17, 0.22)

    def oval(w: float, d: float, y: float) -> np.ndarray:
        return rounded(w, d, (w * 0.5, d * 0.62), (w * 0.38, d * 0.25), y=y)

    rings = [
        (oval(waist + 0.05, 0.42, back - 0.08), 0.0),
        (oval(waist + 0.05, 0.42, back - 0.08), 0.02),
        (oval(waist, 0.36, back - 0.05), 0.08),
        (oval(waist, 0.34, back - 0.03), 0.2),
        (oval(0.27, 0.39, back - 0.02), 0.28),
        (oval(0.34, 0.45, back), 0.35),
        (oval(width, length, back), 0.38),
        (oval(width, length, back), 0.395),
        (oval(width - 0.02, length - 0.02, back + 0.01), 0.4),
    ]
    inside = _bowl_inside(back, width, length, 0.4)
    water = plate(rounded(0.14, 0.16, (0.06, 0.08), y=back + 0.125), 0.004).moved(z=0.215)
    neck = superellipsoid(0.26, back + 0.12, 0.2, 0.3, 0.3, 16).moved(0, (back + 0.12) / 2, 0.197)
    return join(loft([*rings, *inside]).of(ceramic), water.of(WATER), neck.of(ceramic))


def _seat(
    rng: np.random.Generator,
    material: Material,
    metal: Material,
    back: float,
    height: float,
    opened: bool,
    lean: float,
) -> Mesh:
    """Draw the seat and lid on the rim. `lean` is the space behind an open lid, in metres."""
    outer = rounded(0.375, 0.455, (0.187, 0.29), (0.13, 0.1), points=8)
    inner = rounded(0.22, 0.29, (0.11, 0.17), (0.09, 0.09), y=0.09, points=8)
    seat = ring(outer, inner, 0.02, 0.006)
    lid = plate(outer * 0.985, 0.016, 0.008)
    hinge = tube([(-0.09, 0.015, 0.01), (0.09, 0.015, 0.01)], 0.012, 8)
    if opened:
        turn = 97.0 if lean < 0.14 else 95.0
        lid = lid.turned(turn, "x").moved(0, 0.012, 0.02)
        if rng.random() < 0.1:
            seat = seat.turned(90, "x").moved(0, 0.03, 0.01)
    else:
        lid = lid.moved(z=0.021)
    chrome = metal if rng.random() < 0.5 else material
    return join(seat.of(material), lid.of(material), hinge.of(chrome)).moved(0, back + 0.015, height + 0.003)


def _tank(rng: np.random.Generator, ceramic: Material, metal: Material) -> Mesh:
    """Draw a cistern standing on z = 0, with a lid and a button or lever."""
    width, height, round_ = rng.uniform(0.36, 0.42), rng.uniform(0.33, 0.38), rng.uniform(0.02, 0.07)
    wide = rounded(width, 0.18, (round_, round_), 0.012)
    low = rounded(width - rng.uniform(0.01, 0.07), 0.165, (round_, round_), 0.012)
    lid = rounded(width + 0.02, 0.195, (round_ + 0.005, round_ + 0.005), 0.012)
    parts = [
        loft([(low * 0.96, 0.0), (low, 0.015), (wide, height)]).of(ceramic),
        plate(lid, 0.03, 0.012).moved(z=height).of(ceramic),
    ]
    if rng.random() < 0.6:
        parts.append(cylinder(0.026, 0.012, 14).moved(0, 0.09, height + 0.028).of(metal))
    else:
        lever = [(-width / 2 + 0.06, 0.18, height - 0.05), (-width / 2 + 0.06, 0.205, height - 0.05)]
        parts.append(tube(lever, 0.014, 8).of(metal))
        parts.append(tube([lever[1], (-width / 2 + 0.14, 0.21, height - 0.065)], 0.007, 6).of(metal))
    return join(parts)


def _hung(
    rng: np.random.Generator, ceramic: Material, metal: Material, seat: Material, opened: bool
) -> list[Mesh]:
    """Draw a wall-hung bowl and, behind it, a boxed-in cistern with a flush plate."""
    boxed = palette.tiles(rng) if rng.random() < 0.6 else palette.paint(rng)
    width, height, depth = rng.uniform(0.6, 1.0), rng.uniform(1.05, 1.2), rng.uniform(0.12, 0.2)
    back = depth + 0.07

    def oval(w: float, d: float, y: float) -> np.ndarray:
        return rounded(w, d, (w * 0.5, d * 0.6), (w * 0.3, d * 0.15), y=y)

    rings = [
        (oval(0.2, 0.25, depth), 0.09),
        (oval(0.27, 0.36, depth), 0.15),
        (oval(0.34, 0.48, depth), 0.26),
        (oval(0.36, 0.53, depth), 0.33),
        (oval(0.36, 0.54, depth), 0.395),
        (oval(0.34, 0.52, depth + 0.01), 0.4),
    ]
    bowl = loft([*rings, *_bowl_inside(back, 0.36, 0.47, 0.4)])
    water = plate(rounded(0.14, 0.16, (0.06, 0.08), y=back + 0.125), 0.004).moved(z=0.215)
    plate_material = metal if rng.random() < 0.5 else palette.plastic(rng)
    button = box(0.24, 0.012, 0.16, bevel=0.004).moved(0, depth, height - 0.24).of(plate_material)
    halves = [
        box(w, 0.008, 0.12, bevel=0.003).moved(x, depth + 0.011, height - 0.22).of(ceramic)
        for w, x in ((0.12, 0.045), (0.06, -0.06))
    ]
    top = palette.stone(rng) if rng.random() < 0.5 else boxed
    return [
        box(width, depth, height, bevel=0.003).of(boxed),
        box(width + 0.01, depth + 0.012, 0.02, bevel=0.003).moved(z=height).of(top),
        bowl.of(ceramic),
        water.of(WATER),
        button,
        *halves,
        _seat(rng, seat, metal, back, 0.40, opened, 0.05),
    ]
