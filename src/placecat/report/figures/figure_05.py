"""Thesis 3.1.1.1, Figure 5: the orientation channel."""

from matplotlib.figure import Figure

from placecat.report.figures.channel import draw_channel
from placecat.report.run import Run
from placecat.vision.orientation import ANGLES

TITLE = (
    "The orientation channel on the example frame: the feature maps O' at 0°, 45°, 90° and 135° (the "
    "direction that the Gabor filter's wave runs in: 0° answers to vertical edges), added across scales, "
    "and the conspicuity map O, which adds these with the weights 1/√m. Dark is strong; the half percent "
    "strongest of every map is black."
)


def draw(run: Run) -> Figure:
    """Draw the figure."""
    return draw_channel(run, "orientation", "O", [f"{angle:.0f}°" for angle in ANGLES])
