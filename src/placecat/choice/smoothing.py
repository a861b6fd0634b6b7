"""Candidates for the smoothing, judged on training homes.

Only single cues: the distributions that train an integration come from cues that have seen other frames of
the same home, and so look better than they are.
"""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat import files, listing
from placecat.choice.judging import Judgement, judge_home
from placecat.errors import PlacecatError
from placecat.evaluation import protocol
from placecat.fusion.smoothing import smooth
from placecat.stages.smoothing import smooth_home


def judge_smoothing(
    smoothing: Mapping[str, Any],
    source: Path,
    fold: protocol.Fold,
    unseen: Mapping[str, NDArray[np.float64]],
    frames: Mapping[str, int],
    smallest: float,
) -> list[Judgement]:
    """Smooth the homes of one fold of a cue.

    Parameters
    ----------
    smoothing
        Settings of :func:`placecat.fusion.smoothing.fit`.
    source
        Folder of what the stage `cues` left of the fold.
    unseen
        For each training home (frames, n_classes) distributions of its every frame by a cue that has seen
        neither it nor the test home. It is smoothed with statistics of the other training homes; the test
        home with those of all.
    frames
        ``offset`` and ``step`` of the frames that trained the cue, see
        :func:`placecat.evaluation.protocol.select_frames`.

    Raises
    ------
    PlacecatError
        If the cue was not cross-validated by home.
    """
    path = source / "cross_validated.npy"
    if not path.exists():
        raise PlacecatError(
            f"{path} is missing: smoothing is judged on cues with cross_validate on; run `dvc repro`"
        )
    held_out = files.read_array(path, memory_map=False)
    truth = files.read_array(source / "cross_validated_truth.npy", memory_map=False)
    counts = [len(protocol.select_frames(listing.read_labels(home), **frames)) for home in fold.cue_homes]
    home_of_frame = np.repeat(fold.cue_homes, counts)
    judged = []
    for home in fold.cue_homes:
        walks, frame_rates = listing.walks(other for other in fold.cue_homes if other != home)
        smoothed = smooth(
            unseen[home],
            listing.sequence_slices(home),
            frame_rate=listing.frame_rate(home),
            training_sequences=walks,
            training_frame_rates=frame_rates,
            training_proba=held_out[home_of_frame != home],
            training_truth=truth[home_of_frame != home],
            n_classes=held_out.shape[1],
            **smoothing,
        )
        judged.append((fold.test, home, *judge_home(home, smoothed["delayed"], smallest)))
    tested = smooth_home(source, fold, smoothing, held_out.shape[1])["delayed"]
    return [*judged, (fold.test, fold.test, *judge_home(fold.test, tested, smallest))]
