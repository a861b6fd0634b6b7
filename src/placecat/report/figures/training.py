"""Salient regions that trained one fold's codebooks and cues, one row per region."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from placecat.report.run import Run


@dataclass(frozen=True)
class TrainingRegions:
    """Salient regions of training frames.

    Attributes
    ----------
    x
        (n, D) float32 descriptors.
    labels
        (n,) class of each region's frame.
    homes
        Names of the homes.
    home
        (n,) index of each region's home in `homes`.
    frame
        (n,) index of each region's frame in the home.
    number
        (n,) rank of each region in its frame, 0 for the most salient.
    """

    x: NDArray[np.float32]
    labels: NDArray[np.int16]
    homes: tuple[str, ...]
    home: NDArray[np.int64]
    frame: NDArray[np.int64]
    number: NDArray[np.int64]


def training_regions(run: Run, codebook: str, test_home: str) -> TrainingRegions:
    """Read the training regions of a codebook, e.g. ``hog_y``, in the 5-5-1 fold that tests `test_home`."""
    homes = run.fold(test_home).cue_homes
    parts = []
    for position, home in enumerate(homes):
        rows = run.training_frames(home)
        found = run.descriptors(home, codebook, rows)
        of_row, number = np.nonzero(found.valid())
        frame = rows[of_row]
        parts.append((found.rows(), run.labels(home)[frame], np.full(len(frame), position), frame, number))
    x, labels, home_of_row, frames, numbers = (np.concatenate(column) for column in zip(*parts, strict=True))
    return TrainingRegions(x, labels, homes, home_of_row, frames, numbers)
