"""Dining tables with chairs around them and objects on top."""

import math

import numpy as np

from placecat_homes.furniture.blocks import backed, between, chance, choose
from placecat_homes.furniture.chair import bench, chair
from placecat_homes.furniture.dining_table import HEIGHT, dining_table, folding_table
from placecat_homes.furniture.stool import stool
from placecat_homes.furniture.table_setting import Tableware, centrepiece, place_setting, runner
from placecat_homes.mesh import Mesh, join
from placecat_homes.style import Style

TOP = HEIGHT + 0.0035


def dining_set(
    rng: np.random.Generator,
    style: Style,
    *,
    seats: int | None = None,
    width: float | None = None,
    depth: float | None = None,
    shape: str | None = None,
    laid: float = 0.5,
) -> Mesh:
    """Draw a dining table with four to eight chairs, laid for a meal or with a centrepiece.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    seats
        Approximate number of chairs; chosen at random if None.
    width, depth
        Width and depth of the table top in metres; if None, chosen to suit the number of seats.
    shape
        "rectangle", "round" or "oval"; chosen at random if None.
    laid
        Probability that the table is laid.

    Returns
    -------
    Mesh
        The set, centred on x = 0, with its back at y = 0.
    """
    number = seats or int(rng.choice([4, 6, 6, 8]))
    form = shape or choose(
        rng, ("rectangle", "round", "oval"), (0.65, 0.2, 0.15) if number < 7 else (0.8, 0, 0.2)
    )
    if form == "round":
        w = width or (between(rng, 0.95, 1.1) if number <= 4 else between(rng, 1.2, 1.4))
        d = w
    else:
        long = {4: (1.25, 1.5), 6: (1.5, 1.9)}.get(number, (1.9, 2.2)) if number > 2 else (0.75, 0.95)
        w, d = width or between(rng, *long), depth or between(rng, 0.85, 1.0)
    table = dining_table(rng, style, shape=form, width=w, depth=d)
    middle = float(table.low[1] + table.high[1]) / 2
    parts = [table.moved(y=-middle)]
    one = chair(rng, style)
    other = chair(rng, style, armrests=True) if chance(rng, 0.1) else one
    ware = Tableware.draw(rng, style)
    meal = chance(rng, laid)
    places = _around(w, number) if form == "round" else _beside(rng, form, w, d, number)
    benched = form == "rectangle" and number >= 4 and chance(rng, 0.08)
    if benched:
        seat = bench(rng, style, width=w - 0.3)
        parts.append(seat.moved(0, -d / 2 - 0.2))
    for x, y, turn in places:
        if not (benched and turn == 0):
            model = other if abs(turn) == 90 else one
            parts.append(_seated(rng, model, x, y, turn))
        if meal and chance(rng, 0.92):
            setting = place_setting(rng, style, ware=ware)
            parts.append(_at(setting, x, y, turn, 0.025).moved(z=TOP))
    along = w - 0.5 if form == "rectangle" else 0.6 * w
    if chance(rng, 0.2):
        parts.append(runner(rng, style, length=along, width=0.3).moved(0, -0.15, TOP))
    if chance(rng, 0.92 if meal else 0.8):
        inner = 0.26 if meal else 0.5
        things = centrepiece(rng, style, width=along if form != "round" else 0.45, depth=inner, festive=meal)
        parts.append(things.moved(z=TOP + 0.003))
    return backed(join(parts))


def _at(mesh: Mesh, x: float, y: float, turn: float, inwards: float) -> Mesh:
    """Put an object at the point (x, y) on the edge of a table, facing inwards."""
    a = math.radians(turn)
    return mesh.turned(turn).moved(x - inwards * math.sin(a), y + inwards * math.cos(a))


def _seated(rng: np.random.Generator, model: Mesh, x: float, y: float, turn: float) -> Mesh:
    """Put a chair at the edge of a table, usually pushed in slightly."""
    deep = float(model.size[1])
    inwards = between(rng, 0.1, 0.24) if chance(rng, 0.85) else between(rng, -0.15, 0.05)
    askew = float(rng.normal(0, 3)) if chance(rng, 0.75) else float(rng.normal(0, 13))
    centre = model.moved(y=-deep / 2).turned(askew)
    return _at(centre, x, y, turn, inwards - deep / 2)


def _around(diameter: float, number: int) -> list[tuple[float, float, float]]:
    places = []
    for k in range(number):
        turn = 360.0 * k / number
        a = math.radians(turn)
        places.append((diameter / 2 * math.sin(a), -diameter / 2 * math.cos(a), turn))
    return places


def _beside(
    rng: np.random.Generator, form: str, w: float, d: float, number: int
) -> list[tuple[float, float, float]]:
    heads = number % 2 or number >= 8 or (number == 6 and w < 1.75) or (number == 4 and chance(rng, 0.15))
    side = max((number - (2 if heads else 0)) // 2, 1)
    side = min(side, max(int((w - 0.1) / 0.52), 1))
    places = []
    for k in range(side):
        x = (k - (side - 1) / 2) * min((w - 0.15) / side, 0.7)
        edge = d / 2 if form != "oval" else d / 2 * math.sqrt(max(1 - (2 * x / w) ** 2, 0.0))
        places += [(x, -edge, 0.0), (x, edge, 180.0)]
    if heads:
        places += [(-w / 2, 0.0, -90.0), (w / 2, 0.0, 90.0)]
    return places


def breakfast_set(rng: np.random.Generator, style: Style, *, seats: int | None = None) -> Mesh:
    """Draw a small table against the wall, with two or three chairs or stools.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    seats
        Number of chairs, two or three; chosen at random if None.

    Returns
    -------
    Mesh
        A set with its back against the wall.
    """
    number = seats or choose(rng, (2, 2, 3))
    if chance(rng, 0.2):
        table = folding_table(rng, style)
    else:
        w, d = between(rng, 0.7, 1.0), between(rng, 0.6, 0.75)
        table = dining_table(rng, style, shape="rectangle", width=w, depth=d, cloth=chance(rng, 0.25))
    w, d = float(table.size[0]), float(table.size[1])
    one = stool(rng, style) if chance(rng, 0.2) else chair(rng, style)
    parts = [table]
    places = [(-w / 2, d / 2, -90.0), (w / 2, d / 2, 90.0), (0.0, d, 180.0)][:number]
    ware = Tableware.draw(rng, style)
    for x, y, turn in places:
        parts.append(_seated(rng, one, x, y, turn))
        if chance(rng, 0.4) and w > 0.8:
            parts.append(_at(place_setting(rng, style, ware=ware), x, y, turn, 0.02).moved(z=TOP))
    things = centrepiece(rng, style, width=w * 0.6, depth=d * 0.4, festive=False)
    parts.append(things.moved(0, min(d / 2, 0.3), TOP))
    return join(parts)
