"""Materials drawn at random from distributions that are the same for every kind of room.

A room must be recognizable only by what is in it. No function here knows the kind of room, so no colour or
pattern can reveal it.
"""

import colorsys

import numpy as np

from placecat_homes.materials import Colour, Material, Texture

Rng = np.random.Generator

GLASS = Material(colour=(0.85, 0.93, 0.92), gloss=0.08, roughness=0.0, opacity=0.14)
BLACK_GLASS = Material(colour=(0.03, 0.03, 0.035), gloss=0.08, roughness=0.05)
MIRROR = Material(colour=(0.9, 0.92, 0.92), gloss=0.92, roughness=0.0)
WHITE = Material(colour=(0.9, 0.9, 0.88), gloss=0.02, roughness=0.5)
RUBBER = Material(colour=(0.09, 0.09, 0.1))


def _seed(rng: Rng) -> int:
    return int(rng.integers(1 << 30))


def colour(rng: Rng, saturation: float = 0.5, low: float = 0.15, high: float = 0.95) -> Colour:
    """Draw a random colour.

    Parameters
    ----------
    rng
        Random number generator.
    saturation
        Maximum saturation.
    low, high
        Range of the brightest component, from minimum to maximum.

    Returns
    -------
    tuple of float
        sRGB.
    """
    hue, s = rng.uniform(), saturation * rng.beta(1.2, 1.6)
    return colorsys.hsv_to_rgb(hue, s, rng.uniform(low, high))


def shade(base: Colour, factor: float) -> Colour:
    """Lighten or darken a colour.

    Parameters
    ----------
    base
        sRGB.
    factor
        Factor for each component.

    Returns
    -------
    tuple of float
        sRGB, clipped.
    """
    return tuple(float(np.clip(c * factor, 0, 1)) for c in base)  # type: ignore[return-value]


def paint(rng: Rng) -> Material:
    """Draw wall or furniture paint, usually pale or greyish but sometimes in a strong colour."""
    kind = rng.uniform()
    if kind < 0.45:
        base = colour(rng, 0.12, 0.75, 0.95)
    elif kind < 0.88:
        base = colour(rng, 0.35, 0.5, 0.92)
    else:
        base = colour(rng, 0.6, 0.3, 0.8)
    gloss = float(rng.choice([0.0, 0.0, 0.03]))
    return Material(base, gloss=gloss, roughness=0.4)


WOODS: tuple[Colour, ...] = (
    (0.80, 0.66, 0.47),
    (0.72, 0.54, 0.34),
    (0.62, 0.42, 0.25),
    (0.50, 0.32, 0.18),
    (0.36, 0.22, 0.14),
    (0.24, 0.16, 0.12),
    (0.66, 0.60, 0.52),
    (0.82, 0.76, 0.66),
    (0.55, 0.29, 0.17),
    (0.44, 0.40, 0.37),
)
"""Birch, oak, teak, walnut, mahogany, wenge, driftwood, limed oak, cherry, grey oak."""


def wood(rng: Rng) -> Material:
    """Draw a kind of wood, slightly lighter or darker than usual."""
    base = WOODS[int(rng.integers(len(WOODS)))]
    base = shade(base, rng.uniform(0.85, 1.12))
    texture = Texture("wood", (base, shade(base, rng.uniform(0.62, 0.85))), (1.2, 0.4), _seed(rng))
    return Material(texture=texture, gloss=float(rng.choice([0.0, 0.02, 0.04])), roughness=0.35)


def fabric(rng: Rng) -> Material:
    """Draw a fabric: plain, woven, striped, checked, floral or damask."""
    first = colour(rng, 0.65, 0.25, 0.92)
    second = colour(rng, 0.65, 0.2, 0.95)
    third = colour(rng, 0.7, 0.15, 0.95)
    kind = rng.uniform()
    if kind < 0.35:
        texture = Texture("weave", (first, shade(first, 0.8)), (0.12, 0.12), _seed(rng))
    elif kind < 0.7:
        texture = Texture("carpet", (first, shade(first, 0.88)), (0.3, 0.3), _seed(rng))
    elif kind < 0.78:
        texture = Texture("stripes", (first, second, third), (float(rng.uniform(0.15, 0.5)),) * 2, _seed(rng))
    elif kind < 0.86:
        texture = Texture("checks", (first, second), (float(rng.uniform(0.15, 0.4)),) * 2, _seed(rng))
    elif kind < 0.93:
        texture = Texture("floral", (first, second, third), (float(rng.uniform(0.3, 0.7)),) * 2, _seed(rng))
    else:
        texture = Texture(
            "damask", (first, shade(first, 0.8)), (float(rng.uniform(0.2, 0.5)),) * 2, _seed(rng)
        )
    return Material(texture=texture)


def plain_fabric(rng: Rng) -> Material:
    """Draw a fabric in a single colour, for upholstery, towels or sheets."""
    first = colour(rng, 0.6, 0.2, 0.95)
    kind = str(rng.choice(["weave", "carpet"]))
    size = 0.1 if kind == "weave" else 0.3
    return Material(texture=Texture(kind, (first, shade(first, 0.85)), (size, size), _seed(rng)))


def leather(rng: Rng) -> Material:
    """Draw leather in black, brown, tan, cream or another colour."""
    choices: list[Colour] = [(0.08, 0.08, 0.08), (0.3, 0.18, 0.11), (0.5, 0.31, 0.17), (0.82, 0.77, 0.68)]
    base = choices[int(rng.integers(4))] if rng.uniform() < 0.8 else colour(rng, 0.7, 0.2, 0.7)
    return Material(texture=Texture("plaster", (base,), (0.4, 0.4), _seed(rng)), gloss=0.04, roughness=0.6)


METALS: tuple[Material, ...] = (
    Material((0.82, 0.84, 0.86), gloss=0.7, roughness=0.08),
    Material((0.62, 0.63, 0.64), gloss=0.4, roughness=0.6),
    Material((0.78, 0.62, 0.32), gloss=0.55, roughness=0.3),
    Material((0.07, 0.07, 0.075), gloss=0.05, roughness=0.4),
)
"""Chrome, brushed steel, brass, black iron."""


def metal(rng: Rng) -> Material:
    """Draw a metal."""
    return METALS[int(rng.choice(4, p=[0.4, 0.3, 0.12, 0.18]))]


def ceramic(rng: Rng) -> Material:
    """Draw glazed ceramic, usually white but sometimes coloured."""
    base: Colour = (0.92, 0.92, 0.9)
    if rng.uniform() < 0.3:
        base = colour(rng, 0.45, 0.35, 0.9)
    return Material(base, gloss=0.06, roughness=0.08)


def stone(rng: Rng) -> Material:
    """Draw a worktop material: granite, marble, or something plain such as concrete or laminate."""
    base = colour(rng, 0.2, 0.12, 0.92)
    seed = _seed(rng)
    kind = rng.uniform()
    if kind < 0.4:
        texture = Texture("granite", (base, shade(base, 0.55), shade(base, 1.5)), (0.5, 0.5), seed)
    elif kind < 0.65:
        texture = Texture("marble", (base, shade(base, 0.55 if sum(base) > 1.2 else 2.5)), (1.4, 1.4), seed)
    else:
        texture = Texture("plaster", (base,), (0.9, 0.9), seed)
    return Material(texture=texture, gloss=float(rng.uniform(0.02, 0.06)), roughness=0.25)


def plastic(rng: Rng) -> Material:
    """Draw plastic in any colour, often black, grey or white."""
    if rng.uniform() < 0.5:
        v = float(rng.choice([0.06, 0.2, 0.55, 0.88]))
        return Material((v, v, v), gloss=0.04, roughness=0.35)
    return Material(colour(rng, 0.85, 0.3, 0.95), gloss=0.04, roughness=0.35)


def tiles(rng: Rng) -> Material:
    """Draw wall tiles in any colour and size."""
    base = colour(rng, 0.3, 0.3, 0.95)
    joint = shade(base, float(rng.choice([0.6, 0.8, 1.25])))
    seed = _seed(rng)
    if rng.uniform() < 0.4:
        width = float(rng.uniform(0.4, 0.9))
        texture = Texture("brick_tiles", (base, joint), (width, width), seed)
    else:
        width = float(rng.choice([0.4, 0.6, 0.8, 1.2]))
        colours = (base, joint) if rng.uniform() < 0.85 else (base, joint, colour(rng, 0.6, 0.2, 0.95))
        texture = Texture("tiles", colours, (width, width), seed)
    return Material(texture=texture, gloss=0.05, roughness=0.12)


def wallpaper(rng: Rng) -> Material:
    """Draw wallpaper with stripes, flowers, damask or a plain texture."""
    first = colour(rng, 0.35, 0.55, 0.93)
    second = shade(first, float(rng.choice([0.86, 0.92, 1.08])))
    third = shade(first, 0.8)
    kind = rng.uniform()
    size = float(rng.uniform(0.35, 0.9))
    if kind < 0.3:
        texture = Texture("stripes", (first, second), (size, size), _seed(rng))
    elif kind < 0.6:
        texture = Texture("damask", (first, second), (size, size), _seed(rng))
    elif kind < 0.8:
        texture = Texture("floral", (first, second, third), (size, size), _seed(rng))
    else:
        texture = Texture("carpet", (first, second), (0.8, 0.8), _seed(rng))
    return Material(texture=texture)


def wall(rng: Rng) -> Material:
    """Draw a wall finish: usually light paint on plaster, otherwise wallpaper, boards or bricks."""
    kind = rng.uniform()
    if kind < 0.84:
        base = colour(rng, 0.28, 0.68, 0.95)
        return Material(texture=Texture("plaster", (base,), (1.7, 1.7), _seed(rng)))
    if kind < 0.94:
        return wallpaper(rng)
    if kind < 0.97:
        base = colour(rng, 0.3, 0.6, 0.9)
        return Material(texture=Texture("brick_tiles", (base, shade(base, 1.1)), (0.9, 0.6), _seed(rng)))
    return wood(rng)


def flooring(rng: Rng) -> Material:
    """Draw a floor: boards, parquet, herringbone, tiles, stone or carpet."""
    kind = rng.uniform()
    base = shade(WOODS[int(rng.integers(len(WOODS)))], rng.uniform(0.85, 1.15))
    dark = shade(base, rng.uniform(0.65, 0.85))
    gloss = float(rng.uniform(0.015, 0.05))
    if kind < 0.3:
        return Material(
            texture=Texture("planks", (base, dark), (1.6, 1.0), _seed(rng)), gloss=gloss, roughness=0.3
        )
    if kind < 0.4:
        return Material(
            texture=Texture("parquet", (base, dark), (1.2, 1.2), _seed(rng)), gloss=gloss, roughness=0.3
        )
    if kind < 0.5:
        return Material(
            texture=Texture("herringbone", (base, dark), (0.9, 0.9), _seed(rng)), gloss=gloss, roughness=0.3
        )
    if kind < 0.72:
        plain = colour(rng, 0.3, 0.3, 0.92)
        joint = shade(plain, float(rng.choice([0.6, 0.8])))
        colours = (plain, joint) if rng.uniform() < 0.9 else (plain, joint, shade(plain, 0.75))
        width = float(rng.choice([1.2, 1.8, 2.4]))
        return Material(
            texture=Texture("tiles", colours, (width, width), _seed(rng)), gloss=gloss, roughness=0.15
        )
    if kind < 0.82:
        return stone(rng)
    return carpet(rng)


def carpet(rng: Rng) -> Material:
    """Draw a fitted carpet in a single colour."""
    base = colour(rng, 0.45, 0.2, 0.85)
    return Material(texture=Texture("carpet", (base, shade(base, 0.8)), (0.9, 0.9), _seed(rng)))


def paper(rng: Rng) -> Material:
    """Draw a printed page, 21 cm wide and 30 cm high."""
    white: Colour = (0.93, 0.92, 0.88)
    base = white if rng.uniform() < 0.75 else colour(rng, 0.4, 0.75, 0.95)
    return Material(
        texture=Texture("text", (base, (0.15, 0.15, 0.2), colour(rng, 0.8)), (0.21, 0.3), _seed(rng))
    )


def rug(rng: Rng, width: float, depth: float) -> Material:
    """Draw the pattern of a rug. The size is in metres."""
    colours = tuple(colour(rng, 0.75, 0.15, 0.9) for _ in range(4))
    return Material(texture=Texture("rug", colours, (width, depth), _seed(rng)))


def art(rng: Rng, width: float, height: float) -> Material:
    """Draw an abstract picture, a landscape or a portrait. The size is in metres."""
    colours = tuple(colour(rng, 0.8, 0.2, 0.98) for _ in range(4))
    kind = str(rng.choice(["abstract", "landscape", "portrait"], p=[0.4, 0.4, 0.2]))
    return Material(texture=Texture(kind, colours, (width, height), _seed(rng)), gloss=0.02, roughness=0.1)


def poster(rng: Rng, width: float, height: float) -> Material:
    """Draw a printed sheet, such as a notice, calendar or poster. The size is in metres."""
    base = colour(rng, 0.4, 0.75, 0.97)
    texture = Texture(
        "text", (base, colour(rng, 0.3, 0.05, 0.3), colour(rng, 0.8)), (width, height), _seed(rng)
    )
    return Material(texture=texture)


def foliage(rng: Rng) -> Material:
    """Draw leaf green."""
    base = colorsys.hsv_to_rgb(rng.uniform(0.2, 0.4), rng.uniform(0.35, 0.75), rng.uniform(0.3, 0.6))
    texture = Texture("foliage", (base, shade(base, rng.uniform(1.1, 1.5))), (0.08, 0.16), _seed(rng))
    return Material(texture=texture, gloss=0.03, roughness=0.5)


def soil(rng: Rng) -> Material:
    """Draw soil or gravel."""
    base = colour(rng, 0.4, 0.15, 0.4)
    return Material(texture=Texture("granules", (base, shade(base, 0.5)), (0.2, 0.2), _seed(rng)))
