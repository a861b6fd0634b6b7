"""Materials and textures of surfaces."""

from dataclasses import dataclass

Colour = tuple[float, float, float]
"""Red, green and blue in [0, 1], in sRGB."""


@dataclass(frozen=True)
class Texture:
    """An image that repeats over a surface, drawn by the module `kind` in `placecat_homes.textures`.

    Attributes
    ----------
    kind
        Name of the module that draws it.
    colours
        Colours to draw with, in sRGB.
    size
        Width and height of one repetition in metres.
    seed
        Seed for random details.
    """

    kind: str
    colours: tuple[Colour, ...]
    size: tuple[float, float] = (1.0, 1.0)
    seed: int = 0


@dataclass(frozen=True)
class Material:
    """The appearance of a surface.

    Attributes
    ----------
    colour
        In sRGB; multiplied by the texture if there is one.
    texture
        Image that repeats over the texture coordinates of the mesh, which are in metres.
    gloss
        Mirror reflection at normal incidence, from 0 (matt) to 1 (a mirror); it increases towards grazing
        angles. Typical values are 0 for paint, 0.03 to 0.06 for varnish and tiles, 0.5 to 0.8 for metal, and
        0.9 for mirrors.
    roughness
        From 0 for a sharp mirror image to 1 for a mere hint of one.
    emission
        Emitted light as a multiple of the colour; 0 for everything except lamps, screens and the sky.
    opacity
        1 hides everything behind the surface. Typical values are 0.1 to 0.3 for glass and 0.5 for net
        curtains.
    """

    colour: Colour = (1.0, 1.0, 1.0)
    texture: Texture | None = None
    gloss: float = 0.0
    roughness: float = 0.3
    emission: float = 0.0
    opacity: float = 1.0
