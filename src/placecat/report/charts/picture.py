"""A chart as the bytes of a PNG, in the house's style."""

import io
from collections.abc import Callable
from typing import Any

from matplotlib.figure import Figure

from placecat.drawing.style import house_style


def png_of(draw: Callable[..., Figure | None], *arguments: Any) -> bytes | None:
    """Draw a chart: the same figure gives the same bytes.

    Parameters
    ----------
    draw
        Gives the figure, or None if there is nothing to show.
    *arguments
        What it takes.
    """
    with house_style():
        figure = draw(*arguments)
        if figure is None:
            return None
        target = io.BytesIO()
        figure.savefig(target, format="png", metadata={"Software": None})
    return target.getvalue()
