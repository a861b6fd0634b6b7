"""A household's taste, shared by all rooms of its home."""

from dataclasses import dataclass

import numpy as np

from placecat_homes import palette
from placecat_homes.materials import Colour, Material


@dataclass(frozen=True)
class Style:
    """The style shared by all rooms of a home.

    Attributes
    ----------
    wood, second_wood
        Woods used for most of the furniture.
    metal
        Material of taps, handles and lamps.
    trim
        Material of doors, skirting boards and window frames.
    fronts
        Material of kitchen cabinet fronts and wardrobe fronts.
    handle
        ``bar``, ``knob`` or ``none``.
    modern
        How modern the style is, from old-fashioned (0) to modern (1).
    clutter
        How cluttered the home is, from 0 to 1.
    fabrics
        Fabrics used in several rooms.
    """

    wood: Material
    second_wood: Material
    metal: Material
    trim: Material
    fronts: Material
    handle: str
    modern: float
    clutter: float
    fabrics: tuple[Material, ...]

    @classmethod
    def draw(cls, rng: np.random.Generator) -> "Style":
        """Draw a style.

        Parameters
        ----------
        rng
            Random number generator.

        Returns
        -------
        Style
            The style of a household.
        """
        white: Colour = (0.9, 0.89, 0.86)
        trim = (
            Material(white, gloss=0.02, roughness=0.5)
            if rng.uniform() < 0.5
            else [palette.wood, palette.paint][int(rng.integers(2))](rng)
        )
        fronts = [palette.wood, palette.paint, palette.paint, palette.plastic][int(rng.integers(4))](rng)
        return cls(
            wood=palette.wood(rng),
            second_wood=palette.wood(rng),
            metal=palette.metal(rng),
            trim=trim,
            fronts=fronts,
            handle=str(rng.choice(["bar", "knob", "none"], p=[0.5, 0.35, 0.15])),
            modern=float(rng.uniform()),
            clutter=float(rng.uniform(0.2, 1.0)),
            fabrics=tuple(palette.fabric(rng) for _ in range(4)),
        )

    def any_fabric(self, rng: np.random.Generator) -> Material:
        """Pick one of the household's fabrics, or draw a new one.

        Parameters
        ----------
        rng
            Random number generator.

        Returns
        -------
        Material
            The fabric.
        """
        if rng.uniform() < 0.4:
            return self.fabrics[int(rng.integers(len(self.fabrics)))]
        return palette.fabric(rng)

    def any_wood(self, rng: np.random.Generator) -> Material:
        """Pick one of the household's woods, or draw a new wood or paint.

        Parameters
        ----------
        rng
            Random number generator.

        Returns
        -------
        Material
            The material, for use on furniture.
        """
        kind = rng.uniform()
        if kind < 0.4:
            return self.wood
        if kind < 0.65:
            return self.second_wood
        return palette.wood(rng) if kind < 0.85 else palette.paint(rng)
