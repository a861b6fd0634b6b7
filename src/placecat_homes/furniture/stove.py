"""Free-standing ranges with a hob, an oven and controls."""

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, block, chance, choose
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.kitchens.cooker import hob, oven_front
from placecat_homes.parts.kitchens.design import BLACK, SHADOW, STEEL, WHITE
from placecat_homes.shapes import box, tube
from placecat_homes.style import Style


def stove(
    rng: np.random.Generator,
    style: Style,
    *,
    width: float | None = None,
    height: float = 0.9,
    body: Material | None = None,
) -> Mesh:
    """Draw a free-standing range.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    width
        Width in metres; 0.5, 0.6 or 0.9 if None.
    height
        Height of the hob above the floor in metres.
    body
        Material of the body; steel, white, black or coloured if None.

    Returns
    -------
    Mesh
        A range with burners or hotplates on top, and an oven above a drawer at the front.
    """
    w = width or choose(rng, (0.5, 0.6, 0.9), (0.3, 0.5, 0.2))
    depth = 0.6
    if body is None:
        colours = (STEEL, WHITE, BLACK, Material(palette.colour(rng, 0.8), gloss=0.05, roughness=0.15))
        body = choose(rng, colours, (0.35, 0.3, 0.15, 0.2))
    kind = choose(rng, ("gas", "glass", "iron"), (0.5, 0.3, 0.2))
    drawer = between(rng, 0.12, 0.18)
    low = 0.08
    front = height - 0.03 - low - drawer
    parts = [
        block(SHADOW, (w - 0.04, depth - 0.06, low)),
        box(w, depth - 0.02, height - low - 0.01, 0.004).moved(z=low).of(body),
        box(w, depth + 0.02, 0.03, 0.005).moved(z=height - 0.03).of(STEEL if chance(rng, 0.5) else body),
        hob(rng, kind, w - 0.03, depth - 0.07, knobs=False).moved(0, 0.045, height),
        box(w - 0.006, 0.024, drawer - 0.008, 0.004).moved(0, depth - 0.02, low).of(body),
    ]
    if w > 0.8:
        for side, part in ((-1, 0.36), (1, 0.6)):
            x = side * (w / 2 - part * w / 2) if part < 0.5 else (w / 2 - part * w / 2 - 0.005)
            x = -w / 2 + 0.19 * w if part < 0.5 else w / 2 - 0.31 * w
            size = (0.36 if part < 0.5 else 0.6) * w
            face = oven_front(rng, style, body, size, front, knobs=2 if part < 0.5 else 5)
            parts.append(face.moved(x, depth - 0.02, low + drawer))
    else:
        face = oven_front(rng, style, body, w, front, knobs=6 if chance(rng, 0.5) else 5)
        parts.append(face.moved(0, depth - 0.02, low + drawer))
    if chance(rng, 0.5):
        parts.append(box(w, 0.035, between(rng, 0.08, 0.2), 0.005).moved(z=height).of(body))
    grip = tube(
        [(-0.12, depth + 0.02, low + drawer * 0.6), (0.12, depth + 0.02, low + drawer * 0.6)], 0.008, 6
    )
    parts.append(grip.of(STEEL))
    return join(parts)
