"""Thesis 4.5 and 4.9, Figures 16, 17 and 20: strips of probabilities, in which darker means more probable.

Frames run from left to right, and places from top to bottom.
"""

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib import patheffects
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.image import AxesImage
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from numpy.typing import NDArray

from placecat.drawing import palette
from placecat.errors import PlacecatError
from placecat.evaluation.accuracy import confusion_matrix, home_accuracy
from placecat.ranges import Count
from placecat.report.figures.panels import stretches
from placecat.report.run import Run, home_of

# Maximum width of a strip in pixels; if there are more frames, neighbouring ones are averaged.
MAX_COLUMNS = 1000
# Percentiles of a strip's probabilities that are drawn in white and in black.
WHITE, BLACK = 1.0, 99.0
# Sizes in inches.
WIDTH = 6.5
ROW = 0.13
TITLE_LINE = 0.16
BELOW = 0.6
DASHES = (0, (3, 2))


def of_home(run: Run, *, home: Count, panels: Mapping[str, str]) -> Figure:
    """Draw the strips of one home (see :func:`figure`); `home` is its number, counted from 1."""
    return figure(run, [home_of(run, home)], panels)


def of_tests(run: Run, *, panels: Mapping[str, str]) -> Figure:
    """Draw the strips of all test homes of the first result (see :func:`figure`)."""
    return figure(run, run.source(next(iter(panels.values()))).homes, panels)


def figure(run: Run, homes: Sequence[str], panels: Mapping[str, str]) -> Figure:
    """Draw one strip per panel, from top to bottom, each with all homes side by side.

    All results must have been tested on all `homes`. `panels` maps the title of each strip to its result. The
    figure shows the first seed. Each strip's grey scale spans its range of values. Raises PlacecatError if
    a result is missing.
    """
    listed = {home: run.source(next(iter(panels.values()))).listed(home) for home in homes}
    truths = {home: run.labels(listed[home]) for home in homes}
    cuts = {home: [part.start for part in run.sequence_slices(listed[home])[1:]] for home in homes}
    rows = max(len(run.source(result).classes) for result in panels.values())
    rows += any((truth < 0).any() for truth in truths.values())
    # With several homes, titles and accuracies would overlap if they were on one line.
    lines = 1 if len(homes) == 1 else 2
    height = len(panels) * (rows * ROW + lines * TITLE_LINE + 0.1) + BELOW
    drawn = Figure(figsize=(WIDTH, height))
    grid = drawn.subplots(
        len(panels),
        len(homes),
        squeeze=False,
        sharex="col",
        sharey=True,
        gridspec_kw={"width_ratios": [max(len(truth), 1) for truth in truths.values()]},
    )
    for number, (title, result) in enumerate(panels.items()):
        probas = [run.proba(result, home) for home in homes]
        span = greys(np.concatenate(probas))
        for axes, proba, home in zip(grid[number], probas, homes, strict=True):
            image = draw(axes, proba, truths[home], run.source(result).classes, cuts=cuts[home], span=span)
        letter = f"({chr(ord('a') + number)}) " if len(panels) > 1 else ""
        grid[number, 0].set_title(letter + palette.written(title) + "\n" * (lines - 1), loc="left")
        bar = drawn.colorbar(image, ax=list(grid[number]), pad=0.01, aspect=9, shrink=0.85, ticks=span)
        bar.ax.set_yticklabels([f"{value:.2f}" for value in span])
    for axes, home in zip(grid[-1], homes, strict=True):
        axes.set_xlabel(f"frame of {palette.place_title(home)}")
    handles: list[Artist] = [
        Patch(facecolor=palette.MUTED, label="probability (scale on the right)"),
        Line2D([], [], color=palette.TRUTH, label="true place"),
    ]
    if any(cuts.values()):
        handles.append(Line2D([], [], color=palette.INK, linewidth=0.8, linestyle=DASHES, label="cut"))
    drawn.legend(handles=handles, loc="outside lower right", ncols=len(handles))
    return drawn


def draw(
    axes: Axes,
    proba: NDArray[np.float64],
    truth: NDArray[np.int16],
    classes: Sequence[str],
    *,
    cuts: Sequence[int],
    span: tuple[float, float],
) -> AxesImage:
    """Draw one strip: a row per place, a blue line for the true place, and the accuracy (thesis 4.2) above.

    Where frames are unlabelled, the line runs through an additional row. `proba` is (frames, len(classes)).
    `truth` contains the (frames,) class indices, with -1 for unlabelled frames. `cuts` lists the first frame
    after each cut in the video. `span` contains the probabilities that are drawn in white and in black.
    """
    frames, n_classes = proba.shape
    if len(truth) != frames:
        raise PlacecatError(f"there are {frames} distributions, but {len(truth)} labels: run `dvc repro`")
    image = axes.imshow(
        columns(proba, MAX_COLUMNS).T,
        cmap=palette.AMOUNT,
        vmin=span[0],
        vmax=span[1],
        aspect="auto",
        interpolation="nearest",
        extent=(0, frames, n_classes - 0.5, -0.5),
    )
    names = [palette.place_title(place) for place in classes]
    if (truth < 0).any():
        axes.axhspan(n_classes - 0.5, n_classes + 0.5, color="#f1f1f1", linewidth=0)
        names.append("no label")
    axes.set_yticks(range(len(names)), names)
    axes.set_ylim(len(names) - 0.5, -0.5)
    axes.tick_params(axis="y", length=0)
    for boundary in range(1, len(names)):
        axes.axhline(boundary - 0.5, color="#cccccc", linewidth=0.4)
    for cut in cuts:
        axes.axvline(cut, color=palette.INK, linewidth=0.8, linestyle=DASHES)
    draw_truth(axes, truth, n_classes)
    accuracy = home_accuracy(confusion_matrix(truth, proba.argmax(axis=1), n_classes))
    if np.isfinite(accuracy):
        axes.set_title(f"accuracy {accuracy:.1f}%", loc="right", fontsize=7)
    return image


def draw_truth(axes: Axes, truth: NDArray[np.int16], n_classes: int) -> None:
    """Draw the (frames,) true places as a line that is thick within rows and thin between them.

    Unlabelled frames (-1) are in row `n_classes`.
    """
    row = np.where(truth < 0, n_classes, truth)
    parts = stretches(row)
    starts = [part.start for part in parts]
    levels = row[starts]
    # A white rim separates the line from dark rows, even when printed in black and white.
    rim = [patheffects.withStroke(linewidth=2.6, foreground="white")]
    axes.hlines(
        levels, starts, [part.stop for part in parts], color=palette.TRUTH, linewidth=1.4, path_effects=rim
    )
    axes.vlines(starts[1:], levels[:-1], levels[1:], color=palette.TRUTH, linewidth=0.5)


def greys(proba: NDArray[np.float64]) -> tuple[float, float]:
    """Return the probabilities that are drawn in white and in black.

    These are the percentiles `WHITE` and `BLACK`, or 0 and 1 if the percentiles are equal. If every strip
    used 0 and 1, the nearly uniform distributions of some classifiers would all look the same.
    """
    low, high = (float(value) for value in np.percentile(proba, [WHITE, BLACK]))
    return (low, high) if high - low > 1e-6 else (0.0, 1.0)


def columns(proba: NDArray[np.float64], limit: int) -> NDArray[np.float64]:
    """Average neighbouring rows of (frames, classes) with equal weights so that at most `limit` remain."""
    if len(proba) <= limit:
        return proba
    edges = np.arange(limit + 1) * len(proba) // limit
    return np.add.reduceat(proba, edges[:-1]) / np.diff(edges)[:, None]


FIGURES = {
    "figure_16": (
        "Each classifier's probability distributions for the frames of a home, first seed. Darker means "
        "more probable; the scale is on the right. The blue line shows the true place.",
        of_home,
    ),
    "figure_17": (
        "The probability distributions after integration and after smoothing for the frames of a home, first "
        "seed. Darker means more probable; the scale is on the right. The blue line shows the true place.",
        of_home,
    ),
    "figure_20": (
        "The probability distributions after integration and after smoothing for the frames of the "
        "university's test sequences, first seed. Darker means more probable; the scale is on the right. The "
        "blue line shows the true place. The thesis's figure shows the COLD database.",
        of_tests,
    ),
}
