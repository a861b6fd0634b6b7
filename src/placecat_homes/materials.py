"""What surfaces are made of."""

from dataclasses import dataclass

Colour = tuple[float, float, float]
"""sRGB red, green, blue in [0, 1], as seen on a screen."""


@dataclass(frozen=True)
class Texture:
    """A picture that repeats over a surface, drawn by the module `kind` of `placecat_homes.textures`.

    Attributes
    ----------
    kind
        Name of the module that draws it.
    colours
        Colours to draw with, sRGB.
    size
        Width and height of one repetition in metres.
    seed
        Seed of the random details.
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
        sRGB; multiplied with the texture if there is one.
    texture
        Picture that repeats over the texture coordinates of the mesh, which are in metres.
    gloss
        Mirror reflection at normal incidence, 0 (matt) to 1 (a mirror); it grows towards grazing angles.
        Paint has 0, varnish and tiles 0.03 to 0.06, metal 0.5 to 0.8, mirrors 0.9.
    roughness
        0 for a sharp mirror image, 1 for only a hint of one.
    emission
        Emitted light as a multiple of the colour; 0 for everything except lamps, screens and the sky.
    opacity
        1 hides everything behind the surface. Glass has 0.1 to 0.3, and net curtains have 0.5.
    """

    colour: Colour = (1.0, 1.0, 1.0)
    texture: Texture | None = None
    gloss: float = 0.0
    roughness: float = 0.3
    emission: float = 0.0
    opacity: float = 1.0
