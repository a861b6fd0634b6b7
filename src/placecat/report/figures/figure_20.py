"""Figure 20: what integration and smoothing say about every frame of the university (thesis 4.9)."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from matplotlib.figure import Figure

from placecat import settings
from placecat.errors import SettingError
from placecat.report.figures import strips

if TYPE_CHECKING:
    from placecat.report.run import Run

TITLE = (
    "The probability distributions after integration and after smoothing on each frame of the university's "
    "test sequences, first seed: the darker, the more probable the place, in the greys at the right. The "
    "blue line is the true place. The thesis shows the COLD database."
)


def draw(run: "Run") -> Figure:
    """Two strips, the test sequences beside each other; settings in ``figures.figure_20``."""
    return settings.call(_draw, run, settings=run.options("figure_20"), where="figures.figure_20")


def _draw(run: "Run", *, panels: Mapping[str, str]) -> Figure:
    if not panels:
        raise SettingError("figures.figure_20.panels names no result")
    homes = run.source(next(iter(panels.values()))).homes
    return strips.figure(run, homes, panels)
