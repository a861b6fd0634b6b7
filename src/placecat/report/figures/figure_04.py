"""Thesis 3.1.1.1, Figure 4: the colour channel."""

from matplotlib.figure import Figure

from placecat.report.figures.channel import draw_channel
from placecat.report.run import Run

TITLE = (
    "The colour channel on the example frame: the feature maps C' of red, green, blue and yellow, added "
    "across scales and neighbourhoods, and the conspicuity map C, which adds these with the weights 1/√m."
    " Dark is strong; the half percent strongest of every map is black."
)


def draw(run: Run) -> Figure:
    """Draw the figure."""
    return draw_channel(run, "color", "C", ("red", "green", "blue", "yellow"))
