"""An additional figure: reliability diagrams, which compare confidence with accuracy."""

from collections.abc import Mapping

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from placecat import settings
from placecat.drawing import palette
from placecat.errors import PlacecatError
from placecat.evaluation.probabilities import Reliability, pooled, reliability
from placecat.report.run import Run

TITLE = (
    "Reliability diagrams: frames are sorted into bins by the probability of the decided place. Each point "
    "is a bin; the more frames it contains, the larger the point (bins with less than 0.5% of the frames "
    "are not drawn). On the dashed line, decisions are correct as often as their probability predicts; below "
    "it, they are overconfident, and above it, underconfident. The bars below each diagram show each bin's "
    "share of the frames. Places, test homes and seeds have equal weight. Log loss and calibration error "
    "(the mean gap) are means over homes and seeds, from the additional table. The diagrams pool all homes "
    "and so show a smaller error, because overconfidence in one home offsets underconfidence in another."
)

COLUMNS = 3
# Sizes in inches.
WIDTH, ROW, LEGEND = 6.5, 2.65, 0.25
POINT, GAP = "#0072b2", "#d55e00"
# Bins with a smaller share of the frames are not drawn, because they contain too few frames to be meaningful.
LEAST = 0.005
# Marker areas, in square points, for a bin that contains all frames and for the smallest bins.
LARGEST, SMALLEST = 150.0, 5.0


def draw(run: Run, *, panels: Mapping[str, str]) -> Figure:
    """Draw one diagram per result, using the settings in ``figures.figure_reliability``."""
    rows = -(-len(panels) // COLUMNS)
    drawn = Figure(figsize=(WIDTH, rows * ROW + LEGEND))
    heights = [4.0, 1.0] * rows
    grid = drawn.subplots(
        2 * rows, COLUMNS, squeeze=False, sharex=True, gridspec_kw={"height_ratios": heights}
    )
    for number, (title, result) in enumerate(panels.items()):
        diagram = diagram_of(run, result)
        row, column = divmod(number, COLUMNS)
        above, below = grid[2 * row, column], grid[2 * row + 1, column]
        points(above, diagram)
        bars(below, diagram)
        shown = f"({chr(ord('a') + number)}) {palette.written(title)}"
        above.set_title(f"{shown}\n{numbers(run, result)}", loc="left")
        below.set_xlabel("probability of the decided place")
        below.tick_params(labelbottom=True)
        if column == 0:
            above.set_ylabel("share of correct decisions")
            below.set_ylabel("frames, %")
        else:
            above.tick_params(labelleft=False)
    for number in range(len(panels), rows * COLUMNS):
        row, column = divmod(number, COLUMNS)
        for axes in grid[2 * row : 2 * row + 2, column]:
            axes.remove()
    handles = [
        Line2D([], [], color=POINT, marker="o", label="bin of frames"),
        Line2D([], [], color=GAP, linewidth=2.0, alpha=0.5, label="calibration gap"),
        Line2D([], [], color=palette.MUTED, linewidth=0.8, linestyle="--", label="perfect calibration"),
    ]
    drawn.legend(handles=handles, loc="outside lower right", ncols=len(handles))
    return drawn


def diagram_of(run: Run, result: str) -> Reliability:
    """Pool a result's diagrams over all test homes and seeds, with equal weights.

    Raises PlacecatError if no frame has a label.
    """
    source = run.source(result)
    bins = settings.get(run.params, "probabilities.bins")
    found = [
        reliability(run.labels(source.listed(home)), run.proba(result, home, seed), bins=bins)
        for home in source.homes
        # If there are no seeds, `proba` raises an error saying that the result was not computed.
        for seed in source.seeds() or (None,)
    ]
    there = [one for one in found if one.weight.any()]
    if not there:
        raise PlacecatError(f"none of the frames on which {result} was tested has a label")
    return pooled(there)


def numbers(run: Run, result: str) -> str:
    """Format a result's log loss and calibration error, averaged as in the additional table."""
    averages = run.results.quality[result].averages()
    return f"log loss {averages['log_loss']:.2f}, error {averages['calibration_error']:.1f}%"


def points(axes: Axes, diagram: Reliability) -> None:
    """Draw the diagonal, a diagram's bins, and their gaps from the diagonal."""
    axes.plot([0, 1], [0, 1], color=palette.MUTED, linewidth=0.8, linestyle="--")
    there = diagram.weight >= LEAST
    confidence, accuracy, weight = (part[there] for part in diagram)
    axes.vlines(confidence, confidence, accuracy, color=GAP, linewidth=2.0, alpha=0.5)
    axes.plot(confidence, accuracy, color=POINT, linewidth=0.8)
    axes.scatter(confidence, accuracy, np.maximum(LARGEST * weight, SMALLEST), color=POINT, zorder=3)
    axes.set_xlim(0, 1)
    axes.set_ylim(0, 1)
    axes.set_yticks([0, 0.5, 1], ["0", "0.5", "1"])
    axes.set_xticks([0, 0.5, 1], ["0", "0.5", "1"])


def bars(axes: Axes, diagram: Reliability) -> None:
    """Draw each bin's share of the frames."""
    count = len(diagram.weight)
    axes.bar((np.arange(count) + 0.5) / count, 100.0 * diagram.weight, 0.9 / count, color=palette.MUTED)
    axes.set_yticks([0, round(100.0 * float(diagram.weight.max()))])


FIGURES = {"figure_reliability": (TITLE, draw)}
