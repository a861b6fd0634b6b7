"""The style of every chart and figure, and writing them as PNG."""

import io
from collections.abc import Callable, Mapping
from contextlib import AbstractContextManager
from pathlib import Path
from typing import Any

from matplotlib import style
from matplotlib.figure import Figure

from placecat import files

_STYLE = Path(__file__).with_name("placecat.mplstyle")


def house_style(changes: Mapping[str, Any] | None = None) -> AbstractContextManager[None]:
    """Draw in the style of `placecat.mplstyle`, whatever the user's own settings of matplotlib are.

    Parameters
    ----------
    changes
        Settings of matplotlib that differ from the style's.
    """
    return style.context([_STYLE, dict(changes or {})], after_reset=True)


def save(figure: Figure, target: Path) -> None:
    """Write a figure as PNG at the style's resolution; the same figure gives the same bytes."""
    with files.replacing(target) as temporary:
        figure.savefig(temporary, format="png", metadata={"Software": None})


def png_of(draw: Callable[..., Figure | None], *arguments: Any) -> bytes | None:
    """A chart as PNG in the house's style: the same figure gives the same bytes.

    Parameters
    ----------
    draw
        Takes the arguments and gives the figure, or None if there is nothing to show.
    """
    with house_style():
        figure = draw(*arguments)
        if figure is None:
            return None
        target = io.BytesIO()
        figure.savefig(target, format="png", metadata={"Software": None})
    return target.getvalue()
