"""The prediction as CSV."""

import csv
from collections.abc import Iterable, Sequence
from pathlib import Path

from placecat.predict.prediction import Prediction
from placecat.sequences.labels import FRAME_HEADER

FRAMES = "frames.csv"
SEGMENTS = "segments.csv"


def write_frames(path: Path, prediction: Prediction) -> None:
    """Write a row a frame: the decision and its confidence, all probabilities, those of the frame alone.

    Probabilities have as many digits as it takes to read back the same number, to the bit.
    """
    named = ["file"] if prediction.names else []
    header = [
        *("frame", "seconds", *named, "place", "confidence"),
        *(f"p_{name}" for name in prediction.classes),
        "frame_place",
        *(f"frame_p_{name}" for name in prediction.classes),
    ]
    rows = zip(
        prediction.numbers.tolist(),
        (f"{seconds:.3f}" for seconds in prediction.seconds),
        *([prediction.names] if named else []),
        (prediction.classes[place] for place in prediction.decision),
        prediction.confidence.tolist(),
        *prediction.proba.T.tolist(),
        (prediction.classes[place] for place in prediction.frame_decision),
        *prediction.integrated.T.tolist(),
        strict=True,
    )
    _write(path, header, rows)


def write_segments(path: Path, prediction: Prediction) -> None:
    """Write a row a stretch of one place, as a label file of the project: correct it, and it is one."""
    _write(path, FRAME_HEADER, ((part.start, part.end, part.label) for part in prediction.segments()))


def _write(path: Path, header: Sequence[str], rows: Iterable[Sequence[object]]) -> None:
    # File names may be in any coding: what is no UTF-8 is shown as \xNN.
    with path.open("w", encoding="utf-8", errors="backslashreplace", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(header)
        writer.writerows(rows)
