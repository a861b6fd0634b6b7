"""The thesis's figures, and added ones, drawn from a run: one module a figure, found by name.

A module, ``figure_NN`` for a figure of the thesis and ``figure_NAME`` for an added one, has ``TITLE``, its
caption, and ``draw(run)``, which gives the figure or raises PlacecatError where this run has not what it
shows.
"""

from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING

from placecat import lookup
from placecat.drawing.style import house_style, save

if TYPE_CHECKING:
    from placecat.report.run import Run

PREFIX = "figure_"


def names() -> list[str]:
    """Names of the figures, ``figure_NN`` in order, then the added ones."""
    return [name for name in lookup.names(__name__, "TITLE", "draw") if name.startswith(PREFIX)]


def load(name: str) -> ModuleType:
    """Import a figure's module."""
    return lookup.module(__name__, name, "the figure", "TITLE", "draw")


def number(name: str) -> int | None:
    """Number of a figure in the thesis; None for an added one."""
    own = name.removeprefix(PREFIX)
    return int(own) if own.isdigit() else None


def render(name: str, run: "Run", target: Path) -> None:
    """Draw one figure in the house's style and write it.

    Parameters
    ----------
    name
        One of `names`.
    run
        What to draw from.
    target
        A PNG.

    Raises
    ------
    PlacecatError
        If this run has not what the figure shows; nothing is written.
    """
    with house_style():
        save(load(name).draw(run), target)
