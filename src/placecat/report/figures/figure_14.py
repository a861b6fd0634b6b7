"""Thesis 4.4.4, Figure 14: what the third largest cluster of salient regions holds."""

from matplotlib.figure import Figure

from placecat.report.figures.clusters import draw_cluster
from placecat.report.run import Run

TITLE = (
    "Salient regions in the third largest cluster of the localized HOG descriptor, on the training frames"
    " of one fold; their edges have the colour of their frame's place. The bar gives the places of all "
    "its regions in percent. Patches (a) nearest to its centre and (b) at random."
)


def draw(run: Run) -> Figure:
    """Draw the figure; settings in ``figures.clusters``."""
    return draw_cluster(run, 3, by_contrast=False)
