"""Figure 16: what each cue says about every frame of a home (thesis 4.5)."""

from typing import TYPE_CHECKING

from matplotlib.figure import Figure

from placecat import settings
from placecat.report.figures.strips import of_home as _draw

if TYPE_CHECKING:
    from placecat.report.run import Run

TITLE = (
    "The probability distributions of each classifier on each frame of a home, first seed: the darker, the "
    "more probable the place, in the greys at the right. The blue line is the true place."
)


def draw(run: "Run") -> Figure:
    """One strip a cue; settings in ``figures.figure_16``."""
    return settings.call(_draw, run, settings=run.options("figure_16"), where="figures.figure_16")
