"""Report a prediction as text and JSON, with notes for the user."""

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import pandas as pd

from placecat.categorizer import Categorizer
from placecat.predict.frame import Source, clock
from placecat.predict.home import DataSetHome
from placecat.predict.prediction import Prediction
from placecat.predict.run import Speed

SLOW = 0.95
"""A frame rate is considered slow below this fraction of the model's frame rate. For example, 4.995 frames/s
is not slow for a model at 5 frames/s. Our choice."""


def notes(source: Source, prediction: Prediction, categorizer: Categorizer) -> list[str]:
    """List warnings for the user, one line each. Call this after all frames of the source have been read."""
    found = [source.damage().note]
    if prediction.turned:
        found.append(
            f"from frame {prediction.turned[0]} on, {len(prediction.turned)} frames differ in size from the "
            "first frame (was the phone rotated?): only their centre is used"
        )
    data = categorizer.card["data"]
    # Data sets with the same title are considered identical.
    is_same = isinstance(source, DataSetHome) and source.title == data.get("title")
    if is_same and source.name in map(str, data["homes"]):
        found.append(
            f"the model was trained on {source.name}, so this accuracy says nothing about new homes; "
            f"`placecat train --without {source.name}` trains a model without it"
        )
    if len(prediction.seconds) > 1 and 0 < categorizer.threshold < math.inf:
        period = float(np.median(np.diff(prediction.seconds)))
        if period * categorizer.frame_rate * SLOW > 1:
            found.append(
                f"only {1 / period:.3g} frames/s are used, but the threshold for `unknown` was chosen at "
                f"{categorizer.frame_rate:.3g} frames/s: each frame now carries more weight, so "
                "`unknown` is too rare"
            )
    return [note for note in found if note]


def facts(prediction: Prediction, agreement: Mapping[str, Any] | None) -> dict[str, Any]:
    """Return the facts for the summary, which are reproducible because run times are left out.

    `agreement` comes from `placecat.predict.truth.agreement`, or is None if there are no labels.
    """
    return {
        "frames": len(prediction.numbers),
        "frames_of_footage": prediction.length,
        "fps": prediction.fps,
        "seconds": round(float(prediction.ends[-1]), 3),
        "share_of_time": {name: round(value, 4) for name, value in _share_of_time(prediction).items()},
        "segments": len(prediction.segments()),
        "share_unknown": round(_share_unknown(prediction), 4),
        "visits": len(prediction.visits()),
        "mean_confidence": round(float(prediction.confidence.mean()), 4),
        "changes": _changes(prediction.decision),
        "changes_of_frame_alone": _changes(prediction.frame_decision),
        "agreement": agreement,
    }


def shares(prediction: Prediction) -> list[str]:
    """Return one line for each place seen, with its share of the time. The largest share comes first.

    If the place is unknown for part of the time, a final line states how much.
    """
    longest_first = sorted(_share_of_time(prediction).items(), key=lambda one: -one[1])
    width = max(map(len, prediction.classes))
    lines = [f"  {name:{width}}  {value:6.1%}" for name, value in longest_first if value > 0]
    unknown = _share_unknown(prediction)
    return [*lines, f"  The place is unknown {unknown:.1%} of the time."] if unknown else lines


def confusions(classes: Sequence[str], agreement: Mapping[str, Any]) -> list[str]:
    """Return lines with the accuracy, the share of named frames, and a confusion table (rows are labels)."""
    if agreement["accuracy"] is None:
        return ["No categorized frame is labelled with one of the model's places, so nothing is scored."]
    table = pd.DataFrame(agreement["confusion"], list(classes), pd.Index(classes, name="label"))
    percents = [agreement["by_place"][name] for name in classes]
    correct = ["-" if percent is None else f"{percent:.1f}%" for percent in percents]
    # One of the places may itself be called "correct".
    table.insert(len(classes), "correct", correct, allow_duplicates=True)
    lines = [
        f"Accuracy (mean over the labelled places): {agreement['accuracy']:.2f}%; "
        f"each frame alone: {agreement['frame_accuracy']:.2f}%",
        *(f"  {line}" for line in table.to_string().splitlines()),
    ]
    if agreement["named"] < 100:
        wrong = agreement["named_wrongly"]
        wrongly = "" if wrong is None else f", of which {wrong:.2f}% are wrong"
        lines.append(
            f"Named (mean over the labelled places): {agreement['named']:.2f}%{wrongly}; the rest is unknown"
        )
    return lines


def speed_text(speed: Speed, every: int, fps: float, *, dropped: int | None = None) -> str:
    """Compare the speed of a prediction with the frame rate of the footage.

    The footage has `fps` frames per second, and one in `every` frames is used. `dropped` is the number of
    camera frames that were not used.
    """
    footage = "footage's" if every == 1 else f"{speed.wanted:.4g} frames/s used out of the footage's"
    text = (
        f"{speed.rate:.1f} frames/s ({speed.categorizer_rate:.1f} for the categorizer alone), "
        f"{speed.rate / speed.wanted:.2f} times the {footage} {fps:.4g}"
    )
    return text if dropped is None else f"{text}; {dropped} frames arrived in between and were dropped"


def segment_lines(prediction: Prediction, most: int) -> list[str]:
    """Return lines with the first `most` segments and their times."""
    parts = prediction.segments()
    lines = []
    for part in parts[:most]:
        start, end = _time(prediction, part.start), _time(prediction, part.end + 1)
        lines.append(f"  {clock(start):>8} - {clock(end):<8} {part.label}")
    if len(parts) > most:
        lines.append(f"  ... and {len(parts) - most} more")
    return lines


def _time(prediction: Prediction, frame: int) -> float:
    row = int(np.searchsorted(prediction.numbers, frame))
    return float(prediction.seconds[row] if row < len(prediction.seconds) else prediction.ends[-1])


def _share_of_time(prediction: Prediction) -> dict[str, float]:
    lengths = prediction.ends - prediction.seconds
    total = np.bincount(prediction.decision, weights=lengths, minlength=len(prediction.classes))
    return dict(zip(prediction.classes, (total / total.sum()).tolist(), strict=True))


def _share_unknown(prediction: Prediction) -> float:
    lengths = prediction.ends - prediction.seconds
    return float(lengths[~prediction.is_known].sum() / lengths.sum())


def _changes(decision: np.ndarray) -> int:
    return int((decision[1:] != decision[:-1]).sum())
