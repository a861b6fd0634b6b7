"""Colours that mean the same in all figures, and are distinct for colour-blind readers and in greyscale."""

from collections.abc import Sequence

import numpy as np
from matplotlib import colormaps
from matplotlib.colors import to_hex

from placecat.errors import printable

# Based on the palettes by Okabe and Ito and by Tol. Places in the same data set differ in lightness.
PLACES = {
    "bedroom": "#332288",
    "bathroom": "#7cc0ee",
    "kitchen": "#b8430f",
    "living_room": "#3aac7f",
    "dining_room": "#f6dc5c",
    "corridor": "#8c8c8c",
    "office": "#882255",
    "printer_area": "#c7d98a",
    "closet": "#cc79a7",
}
OTHERS = ("#0072b2", "#661100", "#b3b3b3", "#117733", "#e69f00", "#aa4499", "#000000", "#c8e0f0")

INK = "#222222"
MUTED = "#8a8a8a"
# Maximum number of characters in a line.
_LONGEST = 120
TRUTH = "#0033cc"
MAP = "Greys"
AMOUNT = "Greys"


def place_colors(classes: Sequence[str]) -> dict[str, str]:
    """Map each place to "#rrggbb"; places without a fixed colour take the spare colours in order."""
    unknown = [place for place in classes if place not in PLACES]
    spare = {place: OTHERS[number % len(OTHERS)] for number, place in enumerate(unknown)}
    return {place: PLACES.get(place) or spare[place] for place in classes}


def written(text: str) -> str:
    """Make user text drawable in a figure: one line of limited length, without invalid characters.

    Matplotlib fails on invalid characters (file names may have any encoding), and takes minutes to draw a
    long line.
    """
    line = printable(text).replace("\n", " ").replace("\t", " ")
    return line if len(line) <= _LONGEST else f"{line[: _LONGEST // 2]}…{line[-_LONGEST // 2 :]}"


def place_title(place: str) -> str:
    """Return the name of a place or home as shown in figures, such as "living room"."""
    return written(place.replace("_", " "))


def steps(count: int) -> list[str]:
    """Return `count` colours for an ordered series, from light to dark."""
    chosen = ("#f0c93a", "#56b4e9", "#d55e00", "#332288")
    if count <= len(chosen):
        return list(chosen[len(chosen) - count :])
    return [to_hex(color) for color in colormaps["viridis_r"](np.linspace(0.05, 1.0, count))]
