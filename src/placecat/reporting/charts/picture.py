"""A chart as the bytes of a PNG, in the house's style."""

import io
from collections.abc import Callable
from pathlib import Path
from typing import Any

from matplotlib import style
from matplotlib.figure import Figure

from placecat.reporting.figures import palette

# Beside the figures' modules, of which the package itself would draw in all that they use.
_STYLE = Path(palette.__file__).with_name("placecat.mplstyle")


def png_of(draw: Callable[..., Figure | None], *arguments: Any) -> bytes | None:
    """Draw a chart: the same figure gives the same bytes.

    Parameters
    ----------
    draw
        Gives the figure, or None if there is nothing to show.
    *arguments
        What it takes.
    """
    with style.context([_STYLE], after_reset=True):
        figure = draw(*arguments)
        if figure is None:
            return None
        target = io.BytesIO()
        figure.savefig(target, format="png", metadata={"Software": None})
    return target.getvalue()
