"""Shared parts of figures: frames, maps, circles and arrows."""

from typing import Any

import cv2
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Circle, FancyArrowPatch
from numpy.typing import NDArray

from placecat.drawing import palette
from placecat.vision.regions import radius

DARKEST = 99.5


def show_frame(axes: Axes, frame: NDArray[np.uint8], *, width: int = 960) -> None:
    """Show a frame, (H, W, 3) uint8 BGR, without axes; data coordinates are pixels of the frame.

    The figure stores a picture at most `width` pixels wide.
    """
    height, full = frame.shape[:2]
    shown = cv2.cvtColor(frame, cv2.COLOR_BGR2RGB)
    if full > width:
        shown = cv2.resize(shown, (width, round(width * height / full)), interpolation=cv2.INTER_AREA)
    extent = (-0.5, full - 0.5, height - 0.5, -0.5)
    axes.imshow(shown, extent=extent, interpolation="lanczos")
    frame_in(axes)


def show_map(axes: Axes, plane: NDArray[np.floating], *, frame_size: tuple[int, int] | None = None) -> None:
    """Show a non-negative (h, w) map, strong responses dark; values from percentile `DARKEST` up are darkest.

    Data coordinates are pixels of a frame of `frame_size` (width, height), or of the map if that is None.
    """
    width, height = frame_size or plane.shape[::-1]
    extent = (-0.5, width - 0.5, height - 0.5, -0.5)
    # Otherwise a few high peaks would leave the rest white.
    darkest = float(np.percentile(plane, DARKEST))
    axes.imshow(plane, cmap=palette.MAP, vmin=0.0, vmax=darkest or float(plane.max()) or 1.0, extent=extent)
    frame_in(axes)


def draw_regions(
    axes: Axes, regions: NDArray[np.float32], width: int, colors: list[str], *, linewidth: float = 1.0
) -> None:
    """Draw a circle around each of (n, 4) salient regions (x, y, scale, saliency; thesis 3.1.1.3).

    `width` is the frame's width in pixels; `colors` has a colour per region.
    """
    for (x, y, scale, _), color in zip(regions.tolist(), colors, strict=True):
        size = float(radius(scale, width))
        # A pale rim keeps the circle visible on dark and light backgrounds.
        for edge, wide in (("white", linewidth + 0.9), (color, linewidth)):
            axes.add_patch(Circle((x, y), size, fill=False, edgecolor=edge, linewidth=wide))


class Sheet:
    """A figure of `width` and `height` inches, with panels positioned from its upper left corner."""

    def __init__(self, width: float, height: float) -> None:
        self.width, self.height = width, height
        self.figure = Figure(figsize=(width, height))
        self.figure.set_layout_engine("none")

    def panel(self, left: float, top: float, width: float, height: float) -> Axes:
        """Add axes; positions and sizes are in inches."""
        box = (left / self.width, 1 - (top + height) / self.height, width / self.width, height / self.height)
        return self.figure.add_axes(box)

    def arrow(self, start: tuple[float, float], end: tuple[float, float], text: str = "") -> None:
        """Draw a small arrow between two points (x, y), with a text at its middle."""
        self.figure.add_artist(
            FancyArrowPatch(
                self._at(*start),
                self._at(*end),
                transform=self.figure.transFigure,
                arrowstyle="-|>",
                mutation_scale=8,
                color=palette.MUTED,
                linewidth=0.9,
                shrinkA=0,
                shrinkB=0,
            )
        )
        if text:
            clear = {"facecolor": "white", "edgecolor": "none", "pad": 1.0}
            self.text((start[0] + end[0]) / 2, (start[1] + end[1]) / 2, text, bbox=clear)

    def text(self, x: float, y: float, text: str, **options: Any) -> None:
        """Write at a point; `options` are those of `matplotlib.figure.Figure.text`."""
        self.figure.text(*self._at(x, y), text, **{"ha": "center", "va": "center", "fontsize": 7, **options})

    def _at(self, x: float, y: float) -> tuple[float, float]:
        return x / self.width, 1 - y / self.height


def peaks(weight: float) -> int:
    """Return the number m of maxima behind a map's weight 1 / sqrt(m) (thesis 3.1.1.1); 0 for weight 0."""
    return round(weight**-2) if weight else 0


def weight_text(weight: float) -> str:
    """Format a map's weight for a figure, e.g. as "× 1/√3"."""
    return f"× 1/√{peaks(weight)}" if weight else "× 0"


def frame_in(axes: Axes, color: str = "#999999", linewidth: float = 0.5) -> None:
    """Show only a line around the axes."""
    axes.set_xticks([])
    axes.set_yticks([])
    axes.spines[:].set(visible=True, color=color, linewidth=linewidth)
