"""Thesis 3.1.1.1, Figure 6: from conspicuity maps to the saliency map."""

from matplotlib.figure import Figure

from placecat.report.figures.panels import Sheet, show_map, weight_text
from placecat.report.run import Run

TITLE = (
    "The saliency map S of the example frame is the sum of the conspicuity maps of intensity, colour, "
    "orientation and spectral residual with the weights 1/√m; m counts a map's local maxima above their "
    "median. The range of each map is given below it. Dark is strong; the strongest half percent of every"
    " map is black."
)
NAMES = {
    "intensity": "I intensity",
    "color": "C colour",
    "orientation": "O orientation",
    "residual": "R residual",
}
SMALL, LARGE, GAP, HEAD, FOOT, ARROW = 1.55, 2.7, 0.16, 0.2, 0.17, 0.62


def draw(run: Run) -> Figure:
    """Draw the figure."""
    home, index = run.example
    fused = run.saliency(home, index)
    aspect = fused.saliency.shape[0] / fused.saliency.shape[1]
    count = len(fused.channels)
    row = count * SMALL + (count - 1) * GAP
    width = row + 0.12
    small, large = SMALL * aspect, LARGE * aspect
    bottom = HEAD + small + FOOT + ARROW + HEAD
    sheet = Sheet(width, bottom + large + FOOT)
    for number, (channel, one) in enumerate(fused.channels.items()):
        plane = one.conspicuity
        left = 0.06 + number * (SMALL + GAP)
        show_map(sheet.panel(left, HEAD, SMALL, small), plane)
        sheet.text(left + SMALL / 2, HEAD - 0.09, NAMES[channel])
        sheet.text(left + SMALL / 2, HEAD + small + 0.09, f"0 to {plane.max():.2f}")
        target = width / 2 + (number - (count - 1) / 2) * LARGE / (count + 1)
        sheet.arrow(
            (left + SMALL / 2, HEAD + small + FOOT + 0.02),
            (target, bottom - HEAD - 0.02),
            weight_text(one.weight),
        )
    show_map(sheet.panel((width - LARGE) / 2, bottom, LARGE, large), fused.saliency)
    sheet.text(width / 2, bottom - 0.09, "S saliency map")
    sheet.text(width / 2, bottom + large + 0.09, f"0 to {fused.saliency.max():.2f}")
    return sheet.figure


FIGURES = {"figure_06": (TITLE, draw)}
