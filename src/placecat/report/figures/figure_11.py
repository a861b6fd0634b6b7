"""Thesis 3.4, Figure 11: a classifier's output before and after the hidden Markov model and the delay."""

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from placecat.drawing import palette
from placecat.errors import SettingError
from placecat.ranges import Count, Index, Two
from placecat.report.figures.panels import stretches
from placecat.report.run import Run, home_of

TITLE = (
    "Probabilities of the places over time: after integration, and after the hidden Markov model without and "
    "with its delay. The window is the one in which the model removes the most decision changes (first "
    "seed). "
    "The bar below each panel shows the decision; the bar at the top shows the true place."
)

# Line styles distinguish the places when printed in black and white.
LINES = ("-", "--", "-.", ":", (0, (5, 1, 1, 1, 1, 1)), (0, (8, 2)), (0, (1, 2)), (0, (3, 3)))
# Bottom and top of the decision bar below the curves.
BAR = (-0.22, -0.09)
# A stretch shorter than this share of the window has no room for its place's name.
NAMED = 0.12
LUMINANCE = np.array([0.299, 0.587, 0.114])


def draw(
    run: Run, *, home: Count | None, start: Index | None, frames: Two, classifier: str, hmm: str, delayed: str
) -> Figure:
    """Draw three panels, one below the other, using the settings in ``figures.figure_11``."""
    chosen, window = choose(run, classifier, hmm, home=home, start=start, frames=frames)
    titles = ("Integration", "Hidden Markov model", "Hidden Markov model with delay")
    results = zip(titles, (classifier, hmm, delayed), strict=True)
    outputs = {title: run.proba(result, chosen)[window] for title, result in results}
    return figure(outputs, run.labels(chosen)[window], run.source(classifier).classes, chosen, window.start)


def choose(
    run: Run, classifier: str, hmm: str, *, home: int | None, start: int | None, frames: int
) -> tuple[str, slice]:
    """Choose the home and the frames in which smoothing removes the most decision changes.

    `home` is a home's number, counted from 1. None selects the best home (the first if tied), or the first
    home if `start` is set. `start` is the index of the first frame. None selects the best window that
    contains no cut. `frames` is the maximum length of the window, which never extends beyond the home.
    """
    homes = run.source(classifier).homes if home is None else (home_of(run, home),)
    if start is not None:
        length = len(run.labels(homes[0]))
        if start >= length - 1:
            raise SettingError(f"figures.figure_11.start must be 0 to {length - 2}, not {start}")
        return homes[0], slice(start, min(start + frames, length))
    found = []
    for one in homes:
        before, after = (run.proba(result, one) for result in (classifier, hmm))
        found.append(most_smoothed(before, after, run.labels(one), run.sequence_slices(one), frames=frames))
    best = int(np.argmax([removed for removed, _ in found]))
    return homes[best], found[best][1]


def most_smoothed(
    before: NDArray[np.float64],
    after: NDArray[np.float64],
    truth: NDArray[np.int16],
    sequences: Sequence[slice],
    *,
    frames: int,
) -> tuple[int, slice]:
    """Find the first window in which smoothing removes the most decision changes.

    Returns the number of changes that smoothing removes (before minus after), and the window. A change counts
    only if both frames are labelled and there is no cut between them. `before` and `after` are (n, classes)
    distributions for the same frames. `truth` contains their (n,) class indices, -1 if unlabelled.
    `sequences` lists the stretches without cuts. A window has `frames` frames and lies within one stretch; a
    shorter stretch is a window of its own.
    """
    removed = changes(before, truth) - changes(after, truth)
    best: tuple[int, slice] | None = None
    for part in sequences:
        # `removed[i]` is for the step from frame i to frame i + 1.
        total = np.r_[0, np.cumsum(removed[part.start : part.stop - 1])]
        length = min(frames, part.stop - part.start)
        sums = total[length - 1 :] - total[: len(total) - length + 1]
        start = int(np.argmax(sums))
        if best is None or sums[start] > best[0]:
            best = int(sums[start]), slice(part.start + start, part.start + start + length)
    return best or (0, slice(0, 0))


def changes(proba: NDArray[np.float64], truth: NDArray[np.int16]) -> NDArray[np.int64]:
    """Return an (n - 1,) array: 1 where the decision changes between two labelled frames, 0 elsewhere."""
    decision = proba.argmax(axis=1)
    labelled = truth >= 0
    return ((decision[1:] != decision[:-1]) & labelled[1:] & labelled[:-1]).astype(np.int64)


def figure(
    outputs: Mapping[str, NDArray[np.float64]],
    truth: NDArray[np.int16],
    classes: Sequence[str],
    home: str,
    start: int,
) -> Figure:
    """Draw one panel per title in `outputs`, which maps titles to (frames, classes) distributions.

    `truth` contains the (frames,) true classes, -1 if unlabelled. `start` is the first frame's index in its
    home.
    """
    colors = list(palette.place_colors(classes).values())
    decided = [proba.argmax(axis=1) for proba in outputs.values()]
    shown = np.unique(np.concatenate([truth[truth >= 0], *decided])).tolist()
    styles = {
        place: {"color": colors[place], "linestyle": LINES[i % len(LINES)]} for i, place in enumerate(shown)
    }
    drawn = Figure(figsize=(6.5, 0.9 + 1.25 * len(outputs)))
    ratios = [0.15, *[1.0] * len(outputs)]
    grid = drawn.subplots(len(ratios), 1, sharex=True, gridspec_kw={"height_ratios": ratios})
    _bar(grid[0], truth, start, (0.0, 1.0), colors)
    grid[0].set_yticks([0.5], ["true place"])
    for part in stretches(truth):
        _name(grid[0], truth, part, start, classes, colors)
    grid[0].tick_params(length=0, labelbottom=False)
    grid[0].spines[:].set_visible(False)
    time = start + np.arange(len(truth)) + 0.5
    for number, (axes, title) in enumerate(zip(grid[1:], outputs, strict=True)):
        for place, style in styles.items():
            axes.plot(time, outputs[title][:, place], **style)
        for part in stretches(truth)[1:]:
            axes.axvline(start + part.start, color=palette.MUTED, linewidth=0.6)
        _bar(axes, decided[number], start, BAR, colors)
        axes.set_ylim(BAR[0] - 0.02, 1.02)
        axes.set_yticks([sum(BAR) / 2, 0.0, 0.5, 1.0], ["decision", "0", "0.5", "1"])
        axes.set_ylabel("probability")
        axes.set_title(f"({chr(ord('a') + number)}) {title}", loc="left")
    grid[-1].set_xlim(start, start + len(truth))
    grid[-1].set_xlabel(f"frame of {palette.place_title(home)}")
    handles = [
        Line2D([], [], label=palette.place_title(classes[place]), **style) for place, style in styles.items()
    ]
    drawn.legend(handles=handles, loc="outside upper center", ncols=min(len(handles), 5), handlelength=2.6)
    return drawn


def _bar(
    axes: Axes, places: NDArray[np.integer], start: int, span: tuple[float, float], colors: Sequence[str]
) -> None:
    """Draw the places over time as a bar in the places' colours; unlabelled frames stay white."""
    for part in stretches(places):
        if places[part.start] >= 0:
            axes.fill_between(
                [start + part.start, start + part.stop],
                *span,
                facecolor=colors[places[part.start]],
                linewidth=0,
            )


def _name(
    axes: Axes,
    truth: NDArray[np.int16],
    part: slice,
    start: int,
    classes: Sequence[str],
    colors: Sequence[str],
) -> None:
    """Label a stretch of the bar with the name of its place, if there is room."""
    if part.stop - part.start < NAMED * len(truth):
        return
    place = truth[part.start]
    name, color = ("no label", "white") if place < 0 else (palette.place_title(classes[place]), colors[place])
    ink = "white" if np.dot(to_rgb(color), LUMINANCE) < 0.5 else palette.INK
    middle = start + (part.start + part.stop) / 2
    axes.text(middle, 0.5, name, ha="center", va="center_baseline", fontsize=7, color=ink)


FIGURES = {"figure_11": (TITLE, draw)}
