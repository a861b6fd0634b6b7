"""Candidates for the smoothing, judged on training homes from what the stages left.

Only single cues: the distributions that train an integration come from cues that have seen other frames of
the same home, and so look better than they are.
"""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from placecat import files, listing
from placecat.choice.judging import Judgement
from placecat.errors import PlacecatError
from placecat.evaluation import protocol
from placecat.evaluation.smoothed_homes import TrainingHome, judge, judge_smoothing
from placecat.stages.smoothing import smooth_home


def judge_candidate(
    smoothing: Mapping[str, Any],
    source: Path,
    fold: protocol.Fold,
    frames: Mapping[str, int],
    classes: Sequence[str],
    smallest: float,
) -> list[Judgement]:
    """Smooth the homes of one fold of a cue, each with statistics of the training homes but itself.

    Parameters
    ----------
    smoothing
        Settings of :func:`placecat.fusion.smoothing.fit`.
    source
        Folder of what the cue gave for the fold.

    Raises
    ------
    PlacecatError
        If the cue was not cross-validated by home.
    """
    homes = _training_homes(source, fold.cue_homes, frames)
    judged = judge_smoothing(homes, len(classes), smoothing=smoothing, smallest=smallest)
    result = [(fold.test, home, *numbers) for home, numbers in judged.items()]
    smoothed = smooth_home(source, fold, smoothing, len(classes))["delayed"]
    labels = listing.read_labels(fold.test)
    rows = np.flatnonzero(labels >= 0)
    return [*result, (fold.test, fold.test, *judge(labels[rows], smoothed[rows], len(classes), smallest))]


def _training_homes(folder: Path, homes: Sequence[str], frames: Mapping[str, int]) -> dict[str, TrainingHome]:
    path = folder / "cross_validated.npy"
    if not path.exists():
        raise PlacecatError(
            f"{path} is missing: the smoothing is judged on results that are cross-validated, such as nu_svm"
        )
    proba, start, found = files.read_array(path, memory_map=False), 0, {}
    for home in homes:
        labels = listing.read_labels(home)
        rows = protocol.select_frames(labels, **frames)
        found[home] = TrainingHome(
            labels=labels,
            sequences=listing.sequence_slices(home),
            frame_rate=listing.frame_rate(home),
            rows=rows,
            step=frames["step"],
            proba=proba[start : start + len(rows)],
        )
        start += len(rows)
    return found
