"""Square tiles, with joints in the second colour and accents in the third, if there is one."""

import numpy as np

from placecat_homes.noise import Field, cells, smooth


def draw(rng: np.random.Generator, colours: list[Field], pixels: int) -> Field:
    """Draw a grid of four by four tiles in slightly different tones."""
    number, du, dv = cells(pixels, 4, 4)
    tone = rng.uniform(-0.035, 0.035, 16)[number]
    tile = (
        np.broadcast_to(colours[0], (pixels, pixels, 3))
        * (1 + tone + 0.02 * smooth(rng, pixels, 1.2))[..., None]
    )
    if len(colours) > 2:
        accent = (number // 4 + number % 4) % 2 == 0
        tile = np.where(accent[..., None], colours[2] * (1 + tone[..., None]), tile)
    joint = np.minimum(du, dv) < 0.022
    return np.where(joint[..., None], colours[1], tile).astype(np.float32)
