"""Whiteboards."""

import numpy as np

from placecat_homes.furniture.blocks import between, block, chance, choose
from placecat_homes.materials import Colour, Material, Texture
from placecat_homes.mesh import Mesh, join
from placecat_homes.shapes import quad
from placecat_homes.style import Style

PENS: tuple[Colour, ...] = ((0.05, 0.06, 0.08), (0.08, 0.15, 0.55), (0.75, 0.1, 0.1), (0.05, 0.45, 0.2))


def whiteboard(rng: np.random.Generator, style: Style, width: float | None = None) -> Mesh:
    """Draw a used whiteboard with pens and an eraser on its tray. It should hang about 0.9 m above the floor.

    Parameters
    ----------
    rng, style
        Random number generator and style of the home.
    width
        Width in metres; 0.9 to 2.0 if None.
    """
    width = width or between(rng, 0.9, 2.0)
    height = min(width * between(rng, 0.62, 0.75), 1.2)
    frame = choose(rng, (Material((0.75, 0.76, 0.77), gloss=0.2, roughness=0.5), Material((0.2, 0.2, 0.22))))
    tone = between(rng, 0.9, 0.97)
    pens = tuple(PENS[k] for k in rng.permutation(4)[: int(rng.integers(1, 5))])
    text = Texture("scribbles", ((tone, tone, tone), *pens), (width, height), int(rng.integers(1000)))
    parts = [
        block(frame, (width, 0.015, height), (0, 0, 0)),
        quad(width - 0.04, height - 0.04)
        .moved(0, 0.0155, 0.02)
        .of(Material(texture=text, gloss=0.03, roughness=0.2)),
    ]
    for z in (0.0, height - 0.022):
        parts.append(block(frame, (width, 0.024, 0.022), (0, 0, z)))
    for side in (-1, 1):
        parts.append(block(frame, (0.022, 0.024, height), (side * (width / 2 - 0.011), 0, 0)))
    parts.append(block(frame, (width * 0.7, 0.07, 0.01), (0, 0.02, -0.005)))
    for k in range(int(rng.integers(2, 5))):
        colour = Material(PENS[k % 4])
        x = between(rng, -0.3, 0.3) * width
        parts.append(block(Material((0.9, 0.9, 0.9)), (0.09, 0.014, 0.014), (x, 0.045, 0.005)))
        parts.append(block(colour, (0.03, 0.015, 0.015), (x + 0.05, 0.045, 0.005)))
    if chance(rng, 0.7):
        wiper = block(
            Material((0.15, 0.2, 0.4)), (0.14, 0.045, 0.03), (between(rng, -0.2, 0.2), 0.035, 0.005), 0.006
        )
        parts.append(wiper)
    return join(parts)
