"""Synthetic frames of walks through homes, as hard to classify as Gist descriptors.

How long a kernel machine takes depends on the frames: with few support vectors, there is little to compute.
The constants below are therefore chosen so that 2000 synthetic frames resemble 1978 Gist descriptors from
five rendered homes (1024 standardised numbers each). The values for the rendered homes are given in brackets.
The first principal component explains 0.23 of the variance (0.22), the first 21 explain 0.74 (0.73), and the
first 101 explain 0.95 (0.94). In the nu-SVM for a class, 66% of the frames are support vectors (56%). The
RVM for a class has 63 to 82 relevance vectors (51 to 99). In an unseen home, 36% of the frames are
classified correctly (36%).
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

CLASSES = 5
# Number of independent sources of variance, decay of their standard deviations, and a factor for the first.
_SOURCES, _DECAY, _FIRST = 256, 0.6, 1.2
# Standard deviations of classes, rooms and frames; that of views is 1.
_CLASS, _ROOM, _FRAME = 0.12, 0.2, 0.5
_VIEWS = 20
_FRAMES_TO_THE_NEXT_VIEW = 5
_VISITS = 4


@dataclass(frozen=True)
class Frames:
    """Frames as (n, D) float32 descriptors, with their (n,) int64 places."""

    descriptors: NDArray[np.float32]
    place: NDArray[np.int64]


def draw_frames(n: int, features: int, homes: Sequence[int]) -> Frames:
    """Walk through homes, visiting each room four times. Each frame lies between two views of its room.

    `homes` lists the home numbers, starting at 0. Each home has about n / len(homes) frames of D =
    `features` numbers, and does not depend on the other homes.
    """
    rng = np.random.default_rng(0)
    mixing = rng.normal(size=(_SOURCES, features))
    means = _CLASS * rng.normal(size=(CLASSES, _SOURCES))
    deviations = (1.0 + np.arange(_SOURCES)) ** -_DECAY
    deviations[0] *= _FIRST
    sources, places = [], []
    for home, part in zip(homes, np.array_split(np.arange(n), len(homes)), strict=True):
        frame = np.arange(len(part))
        place = frame * CLASSES * _VISITS // len(part) % CLASSES
        sources.append(_walk(np.random.default_rng((0, 1 + home)), means, place) * deviations)
        places.append(place)
    descriptors = np.concatenate(sources) @ mixing
    return Frames(descriptors.astype(np.float32), np.concatenate(places))


def points_behind(
    ours: NDArray[np.generic], theirs: NDArray[np.generic], positive: NDArray[np.bool_]
) -> float:
    """Return the accuracy of their (n,) decisions minus the accuracy of ours, in percentage points."""
    return 100.0 * float(np.mean(theirs == positive) - np.mean(ours == positive))


def _walk(
    rng: np.random.Generator, means: NDArray[np.float64], place: NDArray[np.int64]
) -> NDArray[np.float64]:
    room = means + _ROOM * rng.normal(size=means.shape)
    views = room[:, None] + rng.normal(size=(CLASSES, _VIEWS, _SOURCES))
    turn, step = np.divmod(np.arange(len(place)), _FRAMES_TO_THE_NEXT_VIEW)
    order = rng.integers(_VIEWS, size=len(place) // _FRAMES_TO_THE_NEXT_VIEW + 2)
    ahead = step[:, None] / _FRAMES_TO_THE_NEXT_VIEW
    seen = (1.0 - ahead) * views[place, order[turn]] + ahead * views[place, order[turn + 1]]
    result: NDArray[np.float64] = seen + _FRAME * rng.normal(size=seen.shape)
    return result
