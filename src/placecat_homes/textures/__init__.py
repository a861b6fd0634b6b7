"""Images on surfaces. Each kind has a module of the same name with a function `draw`."""

import numpy as np
from numpy.typing import NDArray

from placecat import lookup
from placecat.seeds import derive
from placecat_homes.materials import Texture


def draw(texture: Texture, pixels: int = 256) -> NDArray[np.uint8]:
    """Draw a texture.

    Parameters
    ----------
    texture
        The texture; its kind is the name of a module in this package.
    pixels
        Width and height of the image.

    Returns
    -------
    numpy.ndarray
        (pixels, pixels, 3) uint8, sRGB, top row first.
    """
    module = lookup.module(__name__, texture.kind, "the texture", "draw")
    rng = np.random.default_rng(derive("texture", texture.kind, texture.seed))
    colours = [np.asarray(colour, dtype=np.float32) for colour in texture.colours]
    picture = module.draw(rng, colours, pixels)
    return (np.clip(picture, 0, 1) * 255 + 0.5).astype(np.uint8)
