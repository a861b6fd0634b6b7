"""Read the frames and labels of a home, as listed by the `sequences` stage."""

from itertools import pairwise
from typing import Any

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from placecat import files, paths


def read_labels(home: str) -> NDArray[np.int16]:
    """Return the (frames,) class indices of a home in temporal order, with -1 for unlabelled frames."""
    return files.read_table(paths.sequences(home) / "labels.csv")["class"].to_numpy(np.int16)


def read_frames(home: str) -> pd.DataFrame:
    """Read a home's frame table (see `placecat.sequences.base.Home`), without labels."""
    return pd.read_csv(
        paths.sequences(home) / "frames.csv", dtype={"sequence": str, "source": str}, keep_default_na=False
    )


def sequence_slices(home: str) -> list[slice]:
    """Return one slice of frames for each sequence of a home, such as each floor."""
    names = read_frames(home)["sequence"].to_numpy()
    cuts = np.flatnonzero(names[1:] != names[:-1]) + 1
    return [slice(start, end) for start, end in pairwise([0, *cuts.tolist(), len(names)])]


def frame_rate(home: str) -> float:
    """Return a home's frame rate in frames per second."""
    return float(_facts(home)["fps"])


def uneven_times(home: str) -> NDArray[np.float64] | None:
    """Return the time of each frame in its sequence, in seconds, or None if the frame rate is constant."""
    return None if _facts(home).get("is_even", True) else read_frames(home)["seconds"].to_numpy(np.float64)


def frame_size(home: str) -> tuple[int, int]:
    """Return the (width, height) of a home's frames, in pixels."""
    facts = _facts(home)
    return facts["width"], facts["height"]


def _facts(home: str) -> dict[str, Any]:
    return files.read_json(paths.sequences(home) / "home.json")
