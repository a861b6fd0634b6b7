"""Draw a prediction as a timeline, with strips of places and the confidence below them."""

import textwrap
from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from matplotlib.ticker import FuncFormatter, MaxNLocator
from numpy.typing import NDArray

from placecat.drawing import palette
from placecat.predict.frame import clock
from placecat.predict.prediction import Prediction

COLUMNS = 2000
"""Number of points in time per strip, about one per pixel."""
UNLABELLED = "#ffffff"
WIDTH, HEIGHT, ROW = 6.5, 1.75, 0.3
LINE = 96
"""Characters per line in the title. Most titles fit on one line."""


def draw(prediction: Prediction, title: str, truth: NDArray[np.int16] | None = None) -> Figure:
    """Draw the timeline of a prediction, which must have at least one frame.

    `truth` contains (n,) int16 class indices, with -1 for unlabelled frames. If it is None, the label strip
    is left out.
    """
    colors = palette.place_colors(prediction.classes)
    strips: dict[str, NDArray[np.integer]] = {} if truth is None else {"label": truth}
    strips |= {"decision": prediction.decision, "frame alone": prediction.frame_decision}
    figure = Figure(figsize=(WIDTH, HEIGHT + ROW * len(strips)))
    ratios = [*[ROW] * len(strips), 0.85]
    axes = figure.subplots(len(ratios), 1, sharex=True, gridspec_kw={"height_ratios": ratios})
    end = float(prediction.ends[-1])
    moments = (np.arange(COLUMNS) + 0.5) * end / COLUMNS
    shown = np.clip(np.searchsorted(prediction.seconds, moments, side="right") - 1, 0, None)
    for own, (name, places) in zip(axes, strips.items(), strict=False):
        _strip(own, name, places[shown], list(colors.values()), end)
    _confidence(axes[-1], prediction, end)
    lines = [palette.written(line) for line in textwrap.wrap(title, LINE)]
    figure.suptitle("\n".join(lines), x=0.01, ha="left")
    seen = np.unique(np.concatenate(list(strips.values())))
    handles = [
        Patch(
            facecolor=colors[prediction.classes[place]], label=palette.place_title(prediction.classes[place])
        )
        for place in seen[seen >= 0]
    ]
    if truth is not None and (truth < 0).any():
        handles.append(Patch(facecolor=UNLABELLED, edgecolor=palette.MUTED, label="not scored"))
    figure.legend(handles=handles, loc="outside lower center", ncols=min(len(handles), 6))
    return figure


def _strip(axes: Axes, name: str, places: NDArray[np.integer], colors: Sequence[str], end: float) -> None:
    # Index -1 selects the last colour, UNLABELLED.
    table = np.array([to_rgb(color) for color in (*colors, UNLABELLED)])
    axes.imshow(
        table[places][None],
        aspect="auto",
        interpolation="nearest",
        extent=(0.0, end, 0.0, 1.0),
        origin="lower",
    )
    axes.set_yticks([0.5], [name])
    axes.tick_params(length=0, labelbottom=False)
    axes.spines[:].set_visible(name == "label")
    axes.spines[:].set_color(palette.MUTED)


def _confidence(axes: Axes, prediction: Prediction, end: float) -> None:
    chance = 1 / len(prediction.classes)
    # Hold the last value until the end.
    times, values = np.append(prediction.seconds, end), prediction.confidence
    values = np.append(values, values[-1])
    axes.fill_between(times, 0.0, values, step="post", color="#e3e3e3", linewidth=0)
    axes.step(times, values, where="post", color=palette.INK, linewidth=0.8)
    axes.axhline(chance, color=palette.MUTED, linewidth=0.6, linestyle=(0, (3, 2)))
    lines = "dashed: chance"
    if 0.0 < prediction.threshold <= 1.0:
        axes.axhline(prediction.threshold, color=palette.INK, linewidth=0.6, linestyle=(0, (1, 2)))
        lines += "; dotted: unknown below"
    axes.set_ylim(0.0, 1.02)
    axes.set_yticks([0.0, 0.5, 1.0], ["0", "0.5", "1"])
    axes.set_ylabel("confidence")
    axes.set_xlim(0.0, end)
    # These steps are round numbers on a clock.
    steps = [1, 1.5, 2, 3, 6, 10] if end > 60 else [1, 2, 5, 10]
    axes.xaxis.set_major_locator(MaxNLocator(8, steps=steps, integer=end > 8))
    axes.xaxis.set_major_formatter(
        FuncFormatter(lambda value, _: clock(value) if end > 8 else f"{value:g} s")
    )
    axes.set_xlabel(f"time ({lines})" if end <= 60 else f"time, min:s ({lines})")
