"""Write a prediction as CSV files."""

from pathlib import Path

import pandas as pd

from placecat.predict.prediction import Prediction
from placecat.sequences.labels import FRAME_HEADER

FRAMES = "frames.csv"
SEGMENTS = "segments.csv"
VISITS = "visits.csv"
TABLES = (FRAMES, SEGMENTS, VISITS)


def write_frames(path: Path, prediction: Prediction) -> None:
    """Write one row per frame: the smoothed decision and probabilities, and those of the frame alone.

    ``name`` is the place, or ``unknown`` if the confidence is too low. Probabilities are written with enough
    digits to be read back exactly.
    """
    classes = prediction.classes
    columns = {
        "frame": prediction.numbers,
        "seconds": [f"{seconds:.3f}" for seconds in prediction.seconds],
        # File names are stored as objects, because pandas strings must be valid UTF-8.
        **({"file": pd.Series(prediction.names, dtype=object)} if prediction.names else {}),
        "place": [classes[place] for place in prediction.decision],
        "confidence": prediction.confidence,
        "name": prediction.place_names,
        **{f"p_{name}": column for name, column in zip(classes, prediction.proba.T, strict=True)},
        "frame_place": [classes[place] for place in prediction.frame_decision],
        **{f"frame_p_{name}": column for name, column in zip(classes, prediction.integrated.T, strict=True)},
    }
    _write(path, pd.DataFrame(columns))


def write_segments(path: Path, prediction: Prediction) -> None:
    """Write one row per segment, in the format of a label file."""
    rows = [(part.start, part.end, part.label) for part in prediction.segments()]
    _write(path, pd.DataFrame(rows, columns=FRAME_HEADER))


def write_visits(path: Path, prediction: Prediction) -> None:
    """Write one row per stay: place, start and end in seconds, mean confidence and number of frames."""
    rows = [
        (visit.place, f"{visit.start:.3f}", f"{visit.end:.3f}", f"{visit.confidence:.4f}", visit.frames)
        for visit in prediction.visits()
    ]
    _write(
        path, pd.DataFrame(rows, columns=["place", "start_seconds", "end_seconds", "confidence", "frames"])
    )


def _write(path: Path, table: pd.DataFrame) -> None:
    # File names may use any encoding. Bytes that are not valid UTF-8 are written as \xNN.
    table.to_csv(path, index=False, lineterminator="\n", errors="backslashreplace")
