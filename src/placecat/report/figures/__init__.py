"""The thesis's figures and additional ones, drawn from a run.

Each module that draws figures has a dict `FIGURES`, which maps the name of each figure to its caption and
function. A figure from the thesis is named ``figure_NN``, and an additional one ``figure_NAME``. The function
takes the run and the settings ``figures.<name>``. It returns the figure, or raises PlacecatError if the run
lacks the data for it.
"""

import importlib
import pkgutil
from collections.abc import Callable
from functools import cache
from pathlib import Path

from matplotlib.figure import Figure

from placecat import settings
from placecat.drawing.style import house_style, save, save_pdf
from placecat.errors import PlacecatError, SettingError
from placecat.report.run import Run

# Settings that do not affect results.
_WITHOUT_EFFECT = ("compute", "reproducibility")


def names() -> list[str]:
    """Return the names of all figures: first those of the thesis, in order, then the additional ones."""
    return sorted(_all())


def number(name: str) -> int | None:
    """Return a figure's number in the thesis, or None for an additional figure."""
    rest = name.removeprefix("figure_")
    return int(rest) if rest.isdigit() else None


def caption(name: str) -> str:
    """Return a figure's caption."""
    return _all()[name][0]


def draw(name: str, run: Run) -> Figure:
    """Draw the figure with a given name (see `names`).

    Raises PlacecatError if there is no such figure, or if the run lacks the data for it.
    """
    if name not in _all():
        raise PlacecatError(f"there is no figure {name!r}: choose one of {', '.join(names())}")
    options = run.options(name)
    if "panels" in options and not options["panels"]:
        raise SettingError(f"figures.{name}.panels is empty: name at least one result")
    return _all()[name][1](run, **options)


def render(name: str, run: Run, target: Path) -> None:
    """Draw one figure (see `draw`) in the project's style and write it to a PNG.

    Also writes a PDF of the same name, with the figure's settings in its document properties. If drawing
    fails, nothing is written.
    """
    with house_style():
        figure = draw(name, run)
        save(figure, target)
        save_pdf(figure, target.with_suffix(".pdf"), title=caption(name), settings=_made_by(name, run))


def _made_by(name: str, run: Run) -> str:
    """List the settings that may affect a figure: its own, then all but those of other figures."""
    of_all = {key: value for key, value in run.params.items() if key not in _WITHOUT_EFFECT}
    flat = settings.flatten(of_all | {"figures": {"example": run.options("example")}})
    own = settings.flatten(run.options(name), f"figures.{name}.")
    return "; ".join(f"{key}={value}" for key, value in (own | flat).items())


@cache
def _all() -> dict[str, tuple[str, Callable[..., Figure]]]:
    """Map each figure's name to its caption and function."""
    found: dict[str, tuple[str, Callable[..., Figure]]] = {}
    for module in pkgutil.iter_modules(__path__):
        found |= getattr(importlib.import_module(f"{__name__}.{module.name}"), "FIGURES", {})
    return found
