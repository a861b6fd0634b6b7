"""Gentle AdaBoost compared with three peers: one place against the rest, with 50 stumps.

OpenCV boosts in the same way, including the omission of samples with small weights. It may split a feature
between any two values, whereas our code splits only at 255 quantiles. If a feature has more values than that,
the stumps differ but are equally good. The accuracies on the training frames are therefore compared, too.
LightGBM and XGBoost minimise a different loss, with the same number of trees (of depth 1) and bins. They use
all samples in every round and take full steps.
"""

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from placecat.learning.gentle_adaboost import GentleAdaBoost
from placecat_bench.comparison import LEAST_REPEATS, Comparison, Entry, Limit, Peer
from placecat_bench.gist_like import draw_frames, points_behind
from placecat_bench.timing import Latest

PIECE = "Gentle AdaBoost"
PEER = Peer("OpenCV: cv2.ml.Boost", "opencv-python-headless")
OTHERS = {
    "lightgbm": Peer("LightGBM: LGBMClassifier", "lightgbm"),
    "xgboost": Peer("XGBoost: XGBClassifier", "xgboost"),
}
HOMES = range(5)
# Flag that makes OpenCV return the sum of the stumps.
_SUM = 256


def entries(*, frames: int = 8000, features: int = 256, rounds: int = 50) -> Iterator[Entry]:
    """Yield comparisons of run times and of final accuracies on the training frames."""
    drawn = draw_frames(frames, features, HOMES)
    given = drawn.descriptors, drawn.place == 0, rounds
    yield from _beside(PEER, theirs, given, faster=4, repeats=LEAST_REPEATS)
    for name, peer in OTHERS.items():
        yield from _beside(peer, partial(by, name), given, faster=1, repeats=15)


def _beside(
    peer: Peer,
    call: Callable[..., Any],
    given: tuple[NDArray[np.float32], NDArray[np.bool_], int],
    *,
    faster: float,
    repeats: int,
) -> Iterator[Entry]:
    X, positive, rounds = given
    text = f"{len(X)} x {X.shape[1]}, {rounds} rounds"
    our, their = Latest(ours, *given), Latest(call, *given)
    parts = {"bins of the features": lambda: GentleAdaBoost(rounds).prepare(X)}
    yield Comparison(PIECE, text, peer, our, their, faster=faster, repeats=repeats, parts=parts)

    def behind() -> float:
        model = their.result()
        decided = model.predict(X, flags=_SUM)[1][:, 0] > 0 if peer is PEER else model.predict(X)
        return points_behind(our.result().predict(X), decided, positive)

    quantity = f"{peer.name.partition(':')[0]}'s training accuracy minus ours, in percentage points"
    yield Limit(PIECE, text, quantity, behind, at_most=1, peer=peer)


def by(name: str, X: NDArray[np.float32], positive: NDArray[np.bool_], rounds: int) -> Any:
    """Boost with LightGBM or XGBoost: stumps on 255 bins with full steps, on one thread."""
    own: dict[str, Any] = {"n_estimators": rounds, "max_depth": 1, "learning_rate": 1.0, "n_jobs": 1}
    if name == "lightgbm":
        from lightgbm import LGBMClassifier

        return LGBMClassifier(**own, num_leaves=2, max_bin=255, verbose=-1).fit(X, positive)
    from xgboost import XGBClassifier

    return XGBClassifier(**own, tree_method="hist", max_bin=255).fit(X, positive)


def ours(X: NDArray[np.float32], positive: NDArray[np.bool_], rounds: int) -> GentleAdaBoost:
    """Boost with our code."""
    return GentleAdaBoost(rounds).fit(X, positive)


def theirs(X: NDArray[np.float32], positive: NDArray[np.bool_], rounds: int) -> Any:
    """Boost with OpenCV's ``cv2.ml.Boost``."""
    boost = cv2.ml.Boost.create()
    boost.setBoostType(cv2.ml.BOOST_GENTLE)
    boost.setWeakCount(rounds)
    boost.setMaxDepth(1)
    boost.setWeightTrimRate(GentleAdaBoost().weight_trim)
    boost.train(X, cv2.ml.ROW_SAMPLE, positive.astype(np.int32))
    return boost
