"""Straight fitted kitchens."""

from collections.abc import Sequence

import numpy as np

from placecat_homes.furniture.blocks import chance
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.kitchens.base import base
from placecat_homes.parts.kitchens.clutter import worktop_things
from placecat_homes.parts.kitchens.design import Design
from placecat_homes.parts.kitchens.layout import row, sink_width
from placecat_homes.parts.kitchens.overhead import Window, overhead
from placecat_homes.style import Style


def kitchen_run(
    rng: np.random.Generator,
    style: Style,
    *,
    length: float = 3.0,
    design: Design | None = None,
    ceiling: float = 2.45,
    wall_cabinets: bool = True,
    windows: Sequence[Window] = (),
    dishwasher: bool | None = None,
    cooker: bool = True,
) -> Mesh:
    """Draw a straight fitted kitchen with a sink, a hob, an oven, wall cabinets and objects on the worktop.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    length
        Length in metres, at least about 1.2.
    design
        Design of the kitchen; chosen at random if None.
    ceiling
        Height of the ceiling in metres.
    wall_cabinets
        Whether to draw anything on the wall above the worktop.
    windows
        Left edge, right edge and sill height of each window, in metres. Nothing hangs in front of a window.
    dishwasher
        Whether there is a dishwasher; if None, chosen at random where there is space.
    cooker
        Whether there is a hob and an oven.

    Returns
    -------
    Mesh
        A kitchen 0.6 m deep.
    """
    looks = design or Design.draw(rng, style)
    fixed: list[tuple[str, float]] = [("sink", sink_width(rng, length))]
    if cooker:
        fixed.append(
            ("cooker", 0.9 if length > 3.2 and looks.cooker == "range" and chance(rng, 0.4) else 0.6)
        )
    if dishwasher or (dishwasher is None and length > 2.3 and chance(rng, 0.6)):
        fixed.append(("dishwasher", 0.6 if length > 2.6 else 0.45))
    sink_at = (windows[0][0] + windows[0][1]) / 2 if windows else None
    units = row(rng, length, fixed, sink_at=sink_at)
    parts = [base(rng, style, looks, units), worktop_things(rng, style, looks, units)]
    if wall_cabinets:
        parts.append(overhead(rng, style, looks, units, windows=windows, ceiling=ceiling))
    return join(parts)
