"""Building blocks of the figures: frames, maps, circles, arrows, and bars for distributions over places."""

from collections.abc import Mapping, Sequence
from typing import Any

import cv2
import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.patches import Circle, FancyArrowPatch, Patch
from numpy.typing import NDArray

from placecat.drawing import palette
from placecat.vision.regions import radius

DARKEST = 99.5
# Maximum width of a frame in a figure, in pixels.
MOST_PIXELS = 960
# Smallest share whose bar has room for its percentage.
LEAST_WRITTEN = 0.07
LEGEND_COLUMNS = 5


def show_frame(axes: Axes, frame: NDArray[np.uint8]) -> None:
    """Show a frame, (H, W, 3) uint8 BGR, without axes; data coordinates are the frame's pixels."""
    height, width = frame.shape[:2]
    shown = cv2.cvtColor(frame, cv2.COLOR_BGR2RGB)
    if width > MOST_PIXELS:
        size = (MOST_PIXELS, round(MOST_PIXELS * height / width))
        shown = cv2.resize(shown, size, interpolation=cv2.INTER_AREA)
    extent = (-0.5, width - 0.5, height - 0.5, -0.5)
    axes.imshow(shown, extent=extent, interpolation="lanczos")
    frame_in(axes)


def show_map(axes: Axes, plane: NDArray[np.floating], *, frame_size: tuple[int, int] | None = None) -> None:
    """Show a non-negative (h, w) map, with strong responses in dark shades.

    All values above the percentile `DARKEST` are equally dark. Data coordinates are the pixels of a frame of
    size `frame_size` (width, height) or, if that is None, of the map.
    """
    width, height = frame_size or plane.shape[::-1]
    extent = (-0.5, width - 0.5, height - 0.5, -0.5)
    # Without this limit, a few high peaks would leave the rest white.
    darkest = float(np.percentile(plane, DARKEST))
    axes.imshow(plane, cmap=palette.MAP, vmin=0.0, vmax=darkest or float(plane.max()) or 1.0, extent=extent)
    frame_in(axes)


def draw_regions(axes: Axes, regions: NDArray[np.float32], width: int, colors: list[str]) -> None:
    """Draw a circle around each of (n, 4) salient regions (x, y, scale, saliency; thesis 3.1.1.3).

    `width` is the frame's width in pixels, and `colors` contains one colour per region.
    """
    for (x, y, scale, _), color in zip(regions.tolist(), colors, strict=True):
        size = float(radius(scale, width))
        # A pale rim keeps the circle visible on dark and light backgrounds.
        for edge, wide in (("white", 2.1), (color, 1.2)):
            axes.add_patch(Circle((x, y), size, fill=False, edgecolor=edge, linewidth=wide))


class Sheet:
    """A figure of `width` by `height` inches, with panels positioned relative to its upper left corner."""

    def __init__(self, width: float, height: float) -> None:
        self.width, self.height = width, height
        self.figure = Figure(figsize=(width, height))
        self.figure.set_layout_engine("none")

    def panel(self, left: float, top: float, width: float, height: float) -> Axes:
        """Add axes; positions and sizes are in inches."""
        box = (left / self.width, 1 - (top + height) / self.height, width / self.width, height / self.height)
        return self.figure.add_axes(box)

    def arrow(self, start: tuple[float, float], end: tuple[float, float], text: str = "") -> None:
        """Draw a small arrow between two points (x, y), with optional text at its midpoint."""
        arrow = FancyArrowPatch(self._at(*start), self._at(*end), arrowstyle="-|>", shrinkA=0, shrinkB=0)
        arrow.set(transform=self.figure.transFigure, mutation_scale=8, color=palette.MUTED, linewidth=0.9)
        self.figure.add_artist(arrow)
        if text:
            clear = {"facecolor": "white", "edgecolor": "none", "pad": 1.0}
            self.text((start[0] + end[0]) / 2, (start[1] + end[1]) / 2, text, bbox=clear)

    def text(self, x: float, y: float, text: str, **options: Any) -> None:
        """Write text at a point; `options` are passed to `matplotlib.figure.Figure.text`."""
        self.figure.text(*self._at(x, y), text, **{"ha": "center", "va": "center", "fontsize": 7, **options})

    def _at(self, x: float, y: float) -> tuple[float, float]:
        return x / self.width, 1 - y / self.height


def weight_text(weight: float) -> str:
    """Format a map's weight 1 / sqrt(m), e.g. "× 1/√3", where m is its number of maxima (thesis 3.1.1.1)."""
    return f"× 1/√{round(weight**-2)}" if weight else "× 0"


def frame_in(axes: Axes, color: str = "#999999", linewidth: float = 0.5) -> None:
    """Hide the ticks and draw a line around the axes."""
    axes.set_xticks([])
    axes.set_yticks([])
    axes.spines[:].set(visible=True, color=color, linewidth=linewidth)


def share_bar(
    axes: Axes, y: float, shares: NDArray[np.floating], classes: Sequence[str], *, height: float = 0.7
) -> None:
    """Draw (classes,) shares (0 to 1) as a horizontal bar centred on `y`, with percentages where they fit."""
    left = 0.0
    for share, color in zip(shares.tolist(), palette.place_colors(classes).values(), strict=True):
        axes.barh(y, share, height, left, color=color, edgecolor="white", linewidth=0.6)
        if share >= LEAST_WRITTEN:
            ink = "white" if np.dot(to_rgb(color), (0.299, 0.587, 0.114)) < 0.55 else palette.INK
            text = f"{100 * share:.0f}"
            axes.text(left + share / 2, y, text, color=ink, fontsize=7, ha="center", va="center")
        left += share


def share_rows(
    axes: Axes, rows: Mapping[str, NDArray[np.floating]], classes: Sequence[str], *, height: float = 0.7
) -> None:
    """Draw one (classes,) distribution per row, with its name to the left; rows are at y = 0, -1, ..."""
    for row, shares in enumerate(rows.values()):
        share_bar(axes, -row, shares, classes, height=height)
    axes.set_yticks([-row for row in range(len(rows))], list(rows))
    axes.set_xlim(0, 1)
    axes.set_ylim(-len(rows) + 0.5, 0.5)
    axes.set_xticks([])
    axes.tick_params(length=0)
    axes.spines[:].set_visible(False)


def place_legend(figure: Figure, classes: Sequence[str], at: tuple[float, float]) -> None:
    """Draw a legend of the places and their colours.

    `at` is the midpoint of the legend's left edge, as fractions of the figure's size.
    """
    handles = [Patch(color=color) for color in palette.place_colors(classes).values()]
    titles = [palette.place_title(place) for place in classes]
    where: dict[str, Any] = {"loc": "center left", "bbox_to_anchor": at, "borderaxespad": 0}
    where |= {"handlelength": 1.0, "handleheight": 0.8, "columnspacing": 1.0}
    figure.legend(handles, titles, ncols=min(len(handles), LEGEND_COLUMNS), **where)


def stretches(places: NDArray[np.integer]) -> list[slice]:
    """Split (n,) places into stretches of a single place."""
    if not len(places):
        return []
    starts = np.flatnonzero(np.r_[True, places[1:] != places[:-1]]).tolist()
    return [slice(start, stop) for start, stop in zip(starts, [*starts[1:], len(places)], strict=True)]
