"""Thesis 4.4.4, Figure 12: what the largest cluster of salient regions holds."""

from matplotlib.figure import Figure

from placecat.report.figures.clusters import draw_cluster
from placecat.report.run import Run

TITLE = (
    "Salient regions in the largest cluster of the localized HOG descriptor, on the training frames of "
    "one fold; their edges have the colour of their frame's place. The bar gives the places of all its "
    "regions in percent. Patches (a) nearest to its centre; the rest at random from the thirds of all its"
    " patches with (b) most and (c) least contrast, the standard deviation of the grey levels."
)


def draw(run: Run) -> Figure:
    """Draw the figure; settings in ``figures.clusters``."""
    return draw_cluster(run, 1, by_contrast=True)
