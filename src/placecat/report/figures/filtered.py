"""Thesis 4.5 and 4.6, Figures 18 and 19: frames that the information filter accepts or rejects."""

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from placecat.drawing.palette import place_title
from placecat.errors import PlacecatError
from placecat.report.figures.panels import Sheet, place_legend, share_rows, show_frame
from placecat.report.run import Run


class Failure(NamedTuple):
    """A frame (counted from 0) that all cues get wrong, and the cues' mean certainty, from 0 to 1."""

    home: str
    frame: int
    place: int
    certainty: float


def draw_mistakes(run: Run, *, cues: Mapping[str, str], filter: str) -> Figure:
    """Draw the most certain mistakes for two places, using the settings in ``figures.figure_18``."""
    # Inches.
    width, labels, bars, decisions, foot = 2.6, 1.4, 2.25, 0.78, 0.34
    found = failures(run, list(cues.values()), run.threshold(filter))[:2]
    if not found:
        raise PlacecatError(f"no informative frame is misclassified by all of {', '.join(cues)}")
    facts = run.home_facts(found[0].home)
    height = width * facts["height"] / facts["width"]
    row = height + 0.45
    sheet = Sheet(width + labels + bars + decisions + 0.06, len(found) * row + foot - 0.08)
    for number, one in enumerate(found):
        top = number * row + 0.28
        truth = place_title(run.classes[one.place])
        where = f"({chr(ord('a') + number)}) {truth}: {place_title(one.home)}, frame {one.frame + 1}"
        sheet.text(0.06, top - 0.12, where, ha="left", fontsize=8)
        show_frame(sheet.panel(0.06, top, width, height), run.frame(one.home, one.frame))
        axes = sheet.panel(0.06 + width + labels, top, bars, height)
        probas = {cue: run.proba(result, one.home)[one.frame] for cue, result in cues.items()}
        share_rows(axes, probas, run.classes)
        for line, proba in enumerate(probas.values()):
            decision = place_title(run.classes[int(proba.argmax())])
            axes.text(1.03, -line, decision, fontsize=7, ha="left", va="center")
    place_legend(sheet.figure, run.classes, (0.3, 0.14 / sheet.height))
    return sheet.figure


def failures(run: Run, results: list[str], least: float) -> list[Failure]:
    """For each place, find the frame that all cues get wrong with the greatest certainty.

    The most certain mistake comes first. Only frames whose information measure is at least `least` are
    considered. `results` lists the names of the cues' results.
    """
    homes = run.source(results[0]).homes
    labels = [run.labels(home) for home in homes]
    probas = [np.stack([run.proba(result, home) for result in results]) for home in homes]
    pooled = np.concatenate(labels)
    proba = np.concatenate(probas, axis=1)
    home_of_row = np.repeat(np.arange(len(homes)), [len(of_home) for of_home in labels])
    index_of_row = np.concatenate([np.arange(len(of_home)) for of_home in labels])
    shown = np.concatenate([run.information(home) for home in homes]) >= least
    wrong = (proba.argmax(axis=2) != pooled).all(axis=0) & shown
    certainty = surety(proba.max(axis=2), pooled >= 0)
    best = []
    for place in range(len(run.classes)):
        able = np.flatnonzero(wrong & (pooled == place))
        if able.size:
            row = able[certainty[able].argmax()]
            frame = int(index_of_row[row])
            best.append(Failure(homes[home_of_row[row]], frame, place, float(certainty[row])))
    return sorted(best, key=lambda one: -one.certainty)


def surety(largest: NDArray[np.float64], labelled: NDArray[np.bool_]) -> NDArray[np.float64]:
    """Return the (frames,) certainties, averaged over cues.

    A cue's certainty about a frame is the share of `labelled` frames about which it is no more certain.
    `largest` contains the (cues, frames) probabilities of the decisions. These are not comparable across
    cues, because the distributions of some cues are always nearly uniform, and those of others never are.
    """
    shares = [
        np.searchsorted(np.sort(of_cue[labelled]), of_cue, side="right") / labelled.sum()
        for of_cue in largest
    ]
    return np.mean(shares, axis=0)


def draw_rejected(run: Run, *, filter: str) -> Figure:
    """Draw the most and least informative rejected frames, using the settings in ``figures.figure_19``."""
    # Inches.
    width, gap = 3.2, 0.15
    threshold = run.threshold(filter)
    rejected = [
        (float(value), home, index)
        for home in run.homes
        for index, (value, label) in enumerate(zip(run.information(home), run.labels(home), strict=True))
        if label >= 0 and value < threshold
    ]
    if not rejected:
        raise PlacecatError(f"the filter {filter} (threshold {threshold}) rejects no labelled frame")
    chosen = list(dict.fromkeys([max(rejected), min(rejected)]))
    facts = run.home_facts(chosen[0][1])
    height = width * facts["height"] / facts["width"]
    sheet = Sheet(0.12 + len(chosen) * (width + gap) - gap, height + 0.48)
    for number, (value, home, index) in enumerate(chosen):
        left = 0.06 + number * (width + gap)
        show_frame(sheet.panel(left, 0.06, width, height), run.frame(home, index))
        place = place_title(run.classes[run.labels(home)[index]])
        where = f"({chr(ord('a') + number)}) {place}: {place_title(home)}, frame {index + 1}"
        measure = f"information measure {value:.5f}, threshold {threshold:.5f}"
        sheet.text(left + width / 2, height + 0.27, f"{where}\n{measure}", linespacing=1.3)
    return sheet.figure


FIGURES = {
    "figure_18": (
        "Frames of two places that all cues get wrong. Among the frames that the information filter accepts, "
        "these are the ones the cues are most certain about, relative to other frames. The bars show "
        "the cues' distributions over the places in percent, with the decisions to their right. First seed.",
        draw_mistakes,
    ),
    "figure_19": (
        "Uninformative views: among the labelled frames that the information filter rejects, the frame with "
        "the highest information measure, just below the threshold, and the frame with the lowest.",
        draw_rejected,
    ),
}
