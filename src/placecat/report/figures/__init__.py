"""The thesis's figures, and added ones, drawn from a run.

A module that draws some has `FIGURES`: a name, ``figure_NN`` for one of the thesis and ``figure_NAME`` for an
added one, to its caption and what draws it. That takes the run and the settings ``figures.<name>``; it gives
the figure, or raises PlacecatError where this run has not what it shows.
"""

import importlib
import pkgutil
from collections.abc import Callable
from functools import cache
from pathlib import Path

from matplotlib.figure import Figure

from placecat import settings
from placecat.drawing.style import house_style, save
from placecat.errors import PlacecatError, SettingError
from placecat.report.run import Run

_PREFIX = "figure_"


def names() -> list[str]:
    """Names of the figures, ``figure_NN`` in order, then the added ones."""
    return sorted(_all())


def number(name: str) -> int | None:
    """Number of a figure in the thesis; None for an added one."""
    rest = name.removeprefix(_PREFIX)
    return int(rest) if rest.isdigit() else None


def caption(name: str) -> str:
    """What stands below a figure."""
    return _all()[name][0]


def draw(name: str, run: Run) -> Figure:
    """Draw one figure.

    Parameters
    ----------
    name
        One of `names`.

    Raises
    ------
    PlacecatError
        If there is no such figure, or this run has not what it shows.
    """
    if name not in _all():
        raise PlacecatError(f"there is no figure {name!r}: choose one of {', '.join(names())}")
    options, where = run.options(name), f"figures.{name}"
    if "panels" in options and not options["panels"]:
        raise SettingError(f"{where}.panels names no result")
    figure: Figure = settings.call(_all()[name][1], run, settings=options, where=where)
    return figure


def render(name: str, run: Run, target: Path) -> None:
    """Draw one figure (see `draw`) in the house's style and write it as PNG; an error writes nothing."""
    with house_style():
        save(draw(name, run), target)


@cache
def _all() -> dict[str, tuple[str, Callable[..., Figure]]]:
    """Name to caption and function of every figure."""
    modules = [
        importlib.import_module(f"{__name__}.{module.name}") for module in pkgutil.iter_modules(__path__)
    ]
    return {name: one for module in modules for name, one in getattr(module, "FIGURES", {}).items()}
