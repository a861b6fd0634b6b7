"""Objects on worktops."""

from collections.abc import Callable

import numpy as np

from placecat_homes.furniture.blocks import between
from placecat_homes.furniture.cookware import cutting_board, knife_block, pot, utensil_jar
from placecat_homes.furniture.dishes import bottle, bowl, cup, dish_rack, plates, teapot
from placecat_homes.furniture.food import (
    bread,
    bread_box,
    fruit_bowl,
    jars,
    packets,
    paper_roll,
    spice_rack,
)
from placecat_homes.furniture.microwave import microwave
from placecat_homes.furniture.small_appliances import coffee_machine, kettle, mixer, radio, toaster
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.arrange import in_a_row
from placecat_homes.parts.kitchens.design import Design
from placecat_homes.parts.kitchens.layout import Unit
from placecat_homes.style import Style

Maker = Callable[[np.random.Generator, Style], Mesh]

THINGS: tuple[tuple[Maker, float], ...] = (
    (kettle, 2.0),
    (toaster, 1.6),
    (coffee_machine, 1.5),
    (mixer, 0.7),
    (utensil_jar, 1.6),
    (knife_block, 1.3),
    (cutting_board, 1.3),
    (jars, 1.0),
    (bread_box, 0.7),
    (bread, 0.7),
    (fruit_bowl, 1.0),
    (paper_roll, 0.9),
    (spice_rack, 0.5),
    (packets, 0.7),
    (plates, 0.7),
    (bowl, 0.5),
    (cup, 0.9),
    (bottle, 1.4),
    (teapot, 0.5),
    (pot, 0.5),
    (radio, 0.4),
)


def worktop_things(
    rng: np.random.Generator, style: Style, design: Design, units: tuple[Unit, ...], *, oven: bool = True
) -> Mesh:
    """Draw objects on the free parts of a worktop.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home. Its `clutter` determines how many objects there are.
    design
        Design of the kitchen.
    units
        The cabinets below.
    oven
        Whether a microwave oven may be among the objects.

    Returns
    -------
    Mesh
        The objects, in the coordinate system of the cabinet row.
    """
    parts: list[Mesh] = []
    microwave_due = oven and rng.random() < 0.5
    rack_due = rng.random() < 0.55
    weights = np.array([weight for _, weight in THINGS])
    used: set[int] = set()
    for left, right in stretches(units):
        space = right - left - 0.06
        if space < 0.12:
            continue
        chosen: list[Mesh] = []
        filled = 0.0
        if microwave_due and space > 0.6:
            chosen.append(microwave(rng, style))
            microwave_due = False
        elif rack_due and space > 0.5:
            chosen.append(dish_rack(rng, style))
            rack_due = False
        filled = sum(float(thing.size[0]) + 0.03 for thing in chosen)
        aim = space * between(rng, 0.25, 0.55 + 0.45 * style.clutter)
        for _ in range(12):
            if filled >= aim:
                break
            p = weights.copy()
            p[list(used)] *= 0.1
            k = int(rng.choice(len(THINGS), p=p / p.sum()))
            thing = THINGS[k][0](rng, style)
            if float(thing.size[1]) < 0.46 and filled + float(thing.size[0]) + 0.03 <= space:
                chosen.append(thing)
                used.add(k)
                filled += float(thing.size[0]) + 0.03
        order = [chosen[int(k)] for k in rng.permutation(len(chosen))]
        things = in_a_row(rng, order, space, depth=0.46, gap=0.02)
        parts.append(things.moved((left + right) / 2, 0.03, design.height))
    return join(parts)


def stretches(units: tuple[Unit, ...]) -> list[tuple[float, float]]:
    """Return the left and right ends of each stretch of worktop without a sink or hob."""
    free: list[tuple[float, float]] = []
    for unit in units:
        if unit.kind == "cooker":
            continue
        left, right = unit.left, unit.right
        if unit.kind == "sink":
            continue
        if free and abs(free[-1][1] - left) < 1e-6:
            free[-1] = (free[-1][0], right)
        else:
            free.append((left, right))
    return free
