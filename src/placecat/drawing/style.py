"""Apply the common style to charts and figures, and write them as PNG and PDF."""

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
    """Draw in the style of `placecat.mplstyle` with `changes`, ignoring the user's Matplotlib settings."""
    return style.context([_STYLE, dict(changes or {})], after_reset=True)


def save(figure: Figure, target: Path) -> None:
    """Write a figure as PNG at the style's resolution; the same figure always produces the same bytes."""
    with files.replacing(target) as temporary:
        figure.savefig(temporary, format="png", metadata={"Software": None})


def save_pdf(figure: Figure, target: Path, *, title: str, settings: str) -> None:
    """Write a figure as PDF; call `save` first. The same figure always produces the same bytes.

    `title` and `settings` become the title and subject of the PDF.
    """
    # Imported late: this takes as long as importing the rest of matplotlib.
    from matplotlib.backends.backend_pdf import FigureCanvasPdf

    # Reuse the layout of the PNG; otherwise, `savefig` would draw everything twice to compute it.
    figure.set_layout_engine("none")
    properties = {
        "Title": title,
        "Subject": settings,
        "Creator": "placecat",
        "Producer": None,
        "CreationDate": None,
    }
    with files.replacing(target) as temporary:
        FigureCanvasPdf(figure).print_pdf(temporary, metadata=properties)


def png_of(draw: Callable[..., Figure | None], *arguments: Any) -> bytes | None:
    """Draw a figure in the common style and return it as PNG, or None if `draw` returns None.

    The same figure always produces the same bytes. Do not draw text from users: anything between two $ is
    typeset as mathematics, which axes need for powers of ten.
    """
    with house_style({"text.parse_math": True}):
        figure = draw(*arguments)
        if figure is None:
            return None
        target = io.BytesIO()
        figure.savefig(target, format="png", metadata={"Software": None})
    return target.getvalue()
