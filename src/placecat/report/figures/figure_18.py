"""Thesis 4.5, Figure 18: frames that every cue gets wrong."""

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from placecat.drawing.palette import place_title
from placecat.errors import PlacecatError
from placecat.report.figures.panels import Sheet, show_frame
from placecat.report.figures.shares import place_legend, share_rows
from placecat.report.run import Run

TITLE = (
    "Frames of two places that all cues get wrong. Among the frames that the information filter accepts, "
    "these are the ones on which the cues are most certain, relative to other frames. The bars are the cues' "
    "distributions over the places in percent, with the decision on their right. First seed."
)
SHOWN = 2
WIDTH, LABELS, BARS, DECISIONS, FOOT = 2.6, 1.4, 2.25, 0.78, 0.34


class Failure(NamedTuple):
    """A frame that all cues get wrong: its home, number (from 0), place, and the cues' certainty (0 to 1)."""

    home: str
    frame: int
    place: int
    certainty: float


def draw(run: Run, *, cues: Mapping[str, str], filter: str) -> Figure:
    """Draw the figure; settings in ``figures.figure_18``."""
    least = run.threshold(filter)
    found = failures(run, list(cues.values()), least)[:SHOWN]
    if not found:
        raise PlacecatError(f"there is no informative frame that all of {', '.join(cues)} get wrong")
    facts = run.home_facts(found[0].home)
    height = WIDTH * facts["height"] / facts["width"]
    row = height + 0.45
    sheet = Sheet(WIDTH + LABELS + BARS + DECISIONS + 0.06, len(found) * row + FOOT - 0.08)
    for number, one in enumerate(found):
        top = number * row + 0.28
        truth = place_title(run.classes[one.place])
        sheet.text(
            0.06,
            top - 0.12,
            f"({chr(ord('a') + number)}) {truth}: {place_title(one.home)}, frame {one.frame + 1}",
            ha="left",
            fontsize=8,
        )
        show_frame(sheet.panel(0.06, top, WIDTH, height), run.frame(one.home, one.frame))
        axes = sheet.panel(0.06 + WIDTH + LABELS, top, BARS, height)
        probas = {cue: run.proba(result, one.home)[one.frame] for cue, result in cues.items()}
        share_rows(axes, probas, run.classes)
        for line, proba in enumerate(probas.values()):
            decision = place_title(run.classes[int(proba.argmax())])
            axes.text(1.03, -line, decision, fontsize=7, ha="left", va="center")
    place_legend(sheet.figure, run.classes, (0.3, 0.14 / sheet.height))
    return sheet.figure


def failures(run: Run, results: list[str], least: float = 0.0) -> list[Failure]:
    """For each place, find the frame that all cues get wrong with the most certainty; most certain first.

    Frames need an information measure of at least `least`; `results` are the cues' results.
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
            best.append(
                Failure(homes[home_of_row[row]], int(index_of_row[row]), place, float(certainty[row]))
            )
    return sorted(best, key=lambda one: -one.certainty)


def surety(largest: NDArray[np.float64], labelled: NDArray[np.bool_]) -> NDArray[np.float64]:
    """Return the (frames,) share of `labelled` frames where a cue is at most as certain, averaged over cues.

    `largest` are the decisions' (cues, frames) probabilities. These are not directly comparable: some cues
    always have nearly even distributions, others never.
    """
    shares = [
        np.searchsorted(np.sort(of_cue[labelled]), of_cue, side="right") / labelled.sum()
        for of_cue in largest
    ]
    return np.mean(shares, axis=0)


FIGURES = {"figure_18": (TITLE, draw)}
