"""The design shared by all cabinets in a kitchen."""

from dataclasses import dataclass

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, chance, choose
from placecat_homes.materials import Material
from placecat_homes.style import Style

STEEL = Material(colour=(0.68, 0.69, 0.7), gloss=0.4, roughness=0.4)
BLACK = Material(colour=(0.05, 0.05, 0.055), gloss=0.05, roughness=0.3)
WHITE = Material(colour=(0.91, 0.91, 0.89), gloss=0.04, roughness=0.25)
SHADOW = Material(colour=(0.06, 0.055, 0.05))


@dataclass(frozen=True)
class Design:
    """The design of a kitchen.

    Attributes
    ----------
    fronts, upper_fronts, side, worktop, splash, plinth, metal, appliance, shelf
        Materials of the base cabinet fronts, the wall cabinet fronts, the cabinet sides, and so on.
    door
        ``flat``, ``frame``, ``panel`` or ``boards``.
    handle
        ``bar``, ``knob``, ``cup`` or ``none``.
    height
        Height of the worktop above the floor in metres.
    thickness
        Thickness of the worktop in metres.
    depth
        Depth of the base cabinets in metres, not counting the worktop overhang.
    overhead
        ``cabinets``, ``glass`` (doors), ``shelves`` or ``none``.
    bottom, top
        Heights of the lower and upper edges of the wall cabinets in metres.
    hood
        ``chimney``, ``slant``, ``box`` or ``flat``.
    hob
        ``glass`` or ``gas``.
    sink
        ``steel``, ``sunk`` or ``belfast``.
    cooker
        ``oven`` (built in below the hob) or ``range`` (free-standing).
    splash_height
        Height of the tiles above the worktop in metres; 0 for no tiles.
    """

    fronts: Material
    upper_fronts: Material
    side: Material
    worktop: Material
    splash: Material
    plinth: Material
    metal: Material
    appliance: Material
    shelf: Material
    door: str
    handle: str
    height: float
    thickness: float
    depth: float
    overhead: str
    bottom: float
    top: float
    hood: str
    hob: str
    sink: str
    cooker: str
    splash_height: float

    @classmethod
    def draw(cls, rng: np.random.Generator, style: Style) -> "Design":
        """Choose a design that fits the style of a home.

        Parameters
        ----------
        rng
            Random number generator.
        style
            Style of the home.

        Returns
        -------
        Design
            The design of one kitchen.
        """
        modern = style.modern
        fronts = style.fronts
        if modern > 0.55 and fronts.texture is None and chance(rng, 0.5):
            fronts = Material(fronts.colour, gloss=0.06, roughness=0.05)
        other = choose(rng, (palette.WHITE, style.wood, palette.paint(rng), palette.wood(rng)))
        upper = other if chance(rng, 0.3) else fronts
        metal = style.metal
        weights = (0.3 + modern, 0.6, 0.9 * (1 - modern), 0.5 * (1 - modern))
        door = choose(rng, ("flat", "frame", "panel", "boards"), weights)
        handle = style.handle
        if handle == "knob" and chance(rng, 0.3):
            handle = "cup"
        if handle == "none" and door != "flat":
            handle = "knob"
        worktop = palette.wood(rng) if chance(rng, 0.3) else palette.stone(rng)
        kind = rng.random()
        if kind < 0.6:
            splash = palette.tiles(rng)
        elif kind < 0.75:
            splash = worktop
        elif kind < 0.9:
            splash = Material(palette.colour(rng, 0.7), gloss=0.08, roughness=0.03)
        else:
            splash = STEEL
        bottom = between(rng, 1.4, 1.5)
        return cls(
            fronts=fronts,
            upper_fronts=upper,
            side=fronts if chance(rng, 0.7) else palette.WHITE,
            worktop=worktop,
            splash=splash,
            plinth=choose(rng, (fronts, SHADOW, STEEL), (0.5, 0.35, 0.15)),
            metal=metal,
            appliance=choose(rng, (STEEL, BLACK, WHITE), (0.45, 0.3, 0.25)),
            shelf=choose(rng, (worktop, style.wood, style.second_wood, palette.WHITE)),
            door=door,
            handle=handle,
            height=between(rng, 0.88, 0.93),
            thickness=choose(rng, (0.02, 0.03, 0.04, 0.05)),
            depth=0.58,
            overhead=choose(rng, ("cabinets", "glass", "shelves", "none"), (0.62, 0.13, 0.17, 0.08)),
            bottom=bottom,
            top=min(bottom + choose(rng, (0.6, 0.72, 0.9)), 2.3),
            hood=choose(rng, ("chimney", "slant", "box", "flat"), (0.35, 0.1 + 0.2 * modern, 0.25, 0.25)),
            hob=choose(rng, ("glass", "gas")),
            sink=choose(rng, ("steel", "sunk", "belfast"), (0.55, 0.2 + 0.2 * modern, 0.35 * (1 - modern))),
            cooker=choose(rng, ("oven", "range"), (0.7, 0.3)),
            splash_height=choose(rng, (0.0, 0.1, 0.6), (0.06, 0.14, 0.8)),
        )
