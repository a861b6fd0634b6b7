"""Thesis 3.1.1.3, Figure 7: the salient regions."""

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from placecat.drawing import palette
from placecat.ranges import Count
from placecat.report.figures.panels import Sheet, draw_regions, show_frame, show_map
from placecat.report.run import Run
from placecat.vision.regions import radius

TITLE = (
    "The saliency map of the example frame with the salient points (left), and the regions around them "
    "(right): circles of radius width/128 · 2^s pixels, where s is the scale of the strongest response."
)
WIDTH, GAP, FOOT = 3.5, 0.1, 0.3


def draw(run: Run, *, regions: Count) -> Figure:
    """Draw the figure."""
    home, index = run.example
    frame, fused = run.frame(home, index), run.saliency(home, index)
    found = run.regions(home, index)[:regions]
    rows, columns = frame.shape[:2]
    height = WIDTH * rows / columns
    sheet = Sheet(2 * WIDTH + GAP + 0.12, height + 0.06 + FOOT)
    left, right = sheet.panel(0.06, 0.06, WIDTH, height), sheet.panel(0.06 + WIDTH + GAP, 0.06, WIDTH, height)
    scales = run.params["attention"]["scales"]
    colors = dict(zip(scales, palette.steps(len(scales)), strict=True))
    of_regions = [colors[int(scale)] for scale in found[:, 2]]
    show_map(left, fused.saliency, frame_size=(columns, rows))
    left.scatter(
        found[:, 0], found[:, 1], s=14, c=of_regions, marker="o", edgecolors="white", linewidths=0.7, zorder=3
    )
    show_frame(right, frame)
    draw_regions(right, found, columns, of_regions, linewidth=1.2)
    for axes in (left, right):
        axes.set_xlim(-0.5, columns - 0.5)
        axes.set_ylim(rows - 0.5, -0.5)
    counts = np.bincount(found[:, 2].astype(int), minlength=max(scales) + 1)
    handles = [
        Line2D([], [], color=colors[scale], marker="o", markersize=5, linestyle="none") for scale in scales
    ]
    labels = [
        f"scale {scale}, radius {float(radius(scale, columns)):.0f} px: {counts[scale]}" for scale in scales
    ]
    sheet.figure.legend(handles, labels, loc="lower center", ncols=len(scales), borderaxespad=0.2)
    return sheet.figure


FIGURES = {"figure_07": (TITLE, draw)}
