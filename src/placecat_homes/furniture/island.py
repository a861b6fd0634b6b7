"""Kitchen islands with breakfast bars."""

import numpy as np

from placecat_homes.furniture.blocks import block, chance, choose
from placecat_homes.furniture.cookware import cutting_board, knife_block
from placecat_homes.furniture.dishes import bottle, bowl, cup, glass, plates
from placecat_homes.furniture.food import bread, fruit_bowl
from placecat_homes.furniture.vase import vase
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.arrange import scattered
from placecat_homes.parts.kitchens.base import base
from placecat_homes.parts.kitchens.design import Design
from placecat_homes.parts.kitchens.layout import row
from placecat_homes.parts.outlines import textured
from placecat_homes.shapes import box
from placecat_homes.style import Style


def island(
    rng: np.random.Generator,
    style: Style,
    *,
    width: float = 1.4,
    bar: bool = True,
    design: Design | None = None,
) -> Mesh:
    """Draw a free-standing block of cabinets with fruit and dishes on its worktop.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    width
        Width in metres.
    bar
        Whether the worktop overhangs at the back to leave space for stools (at y < 0.3).
    design
        Design of the kitchen; chosen at random if None.

    Returns
    -------
    Mesh
        An island whose cabinet doors face +y.
    """
    looks = design or Design.draw(rng, style)
    units = row(rng, width, [])
    overhang = 0.28 if bar else 0.02
    body = base(rng, style, looks, units, cook=False).moved(y=overhang)
    top = box(width + 0.06, looks.depth + overhang + 0.05, looks.thickness + 0.004, 0.003)
    back = textured(block(looks.fronts, (width, 0.015, looks.height - looks.thickness)), quarter=True)
    plate = top.moved(z=looks.height - looks.thickness).of(looks.worktop)
    parts = [body, back.moved(y=overhang - 0.015), plate]
    makers = (fruit_bowl, bread, bowl, cup, glass, bottle, plates, knife_block, cutting_board)
    things = [vase(rng, style, True)] if chance(rng, 0.4) else [fruit_bowl(rng, style)]
    things += [choose(rng, makers)(rng, style) for _ in range(int(rng.integers(1, 5)))]
    spread = scattered(rng, things, width - 0.1, 0.5)
    parts.append(spread.moved(0, overhang + 0.3, looks.height + 0.004))
    return join(parts)
