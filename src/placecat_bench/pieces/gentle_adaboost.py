"""Gentle AdaBoost beside OpenCV's: one place against the rest, 50 stumps.

The same boosting with the same trimming of light samples. OpenCV cuts a feature between any two of its
values, ours at 255 quantiles. With more values the stumps differ but are as good: the shares of training
frames that they decide right are compared too.
"""

from collections.abc import Iterator
from functools import partial
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from placecat.learning.gentle_adaboost import GentleAdaBoost
from placecat_bench.comparison import Comparison, Limit, Peer
from placecat_bench.gist_like import draw_frames

PIECE = "Gentle AdaBoost"
PEER = Peer("OpenCV: cv2.ml.Boost", "opencv-python-headless")
HOMES = range(5)
# OpenCV's flag for the sum of the stumps.
_SUM = 256


def entries(*, frames: int = 8000, features: int = 256, rounds: int = 50) -> Iterator[Comparison | Limit]:
    """Yield time, and how well both know their training frames after so many stumps."""
    drawn = draw_frames(frames, features, HOMES)
    X, positive = drawn.descriptors, drawn.place == 0
    text = f"{frames} x {features}, {rounds} rounds"
    base = GentleAdaBoost(rounds)
    calls = partial(ours, X, positive, rounds), partial(theirs, X, positive, rounds)
    parts = {"bins of the features": partial(base.prepare, X)}
    yield Comparison(PIECE, text, PEER, *calls, faster=4, parts=parts)

    def behind() -> float:
        decisions = theirs(X, positive, rounds).predict(X, flags=_SUM)[1][:, 0]
        found = np.mean(ours(X, positive, rounds).predict(X) == positive)
        return 100.0 * float(np.mean((decisions > 0) == positive) - found)

    yield Limit(PIECE, text, "points of training accuracy behind OpenCV's", behind, at_most=1, peer=PEER)


def ours(X: NDArray[np.float32], positive: NDArray[np.bool_], rounds: int) -> GentleAdaBoost:
    """Boost by ours."""
    return GentleAdaBoost(rounds).fit(X, positive)


def theirs(X: NDArray[np.float32], positive: NDArray[np.bool_], rounds: int) -> Any:
    """Boost by OpenCV's: a ``cv2.ml.Boost``."""
    boost = cv2.ml.Boost.create()
    boost.setBoostType(cv2.ml.BOOST_GENTLE)
    boost.setWeakCount(rounds)
    boost.setMaxDepth(1)
    boost.setWeightTrimRate(GentleAdaBoost().weight_trim)
    boost.train(X, cv2.ml.ROW_SAMPLE, positive.astype(np.int32))
    return boost
