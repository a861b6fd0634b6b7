"""Figure 17: what integration and smoothing say about every frame of a home (thesis 4.5)."""

from typing import TYPE_CHECKING

from matplotlib.figure import Figure

from placecat import settings
from placecat.report.figures.strips import of_home as _draw

if TYPE_CHECKING:
    from placecat.report.run import Run

TITLE = (
    "The probability distributions after integration and after smoothing on each frame of a home, first "
    "seed: the darker, the more probable the place, in the greys at the right. The blue line is the true "
    "place."
)


def draw(run: "Run") -> Figure:
    """Two strips; settings in ``figures.figure_17``."""
    return settings.call(_draw, run, settings=run.options("figure_17"), where="figures.figure_17")
