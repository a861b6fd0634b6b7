"""Relevance vector machine beside fastrvm's: one place against the rest.

Both maximise the evidence by adding, re-estimating and deleting basis functions (Tipping and Faul 2003), with
the same kernel and a bias, and compute the Gram matrix themselves. fastrvm renews its statistics after each
such change, ours after many. fastrvm takes thousands of changes, for two of the five places more than 3000:
the place is the one with the fewest. The evidences do not compare, since fastrvm leaves the bias without a
prior; the shares of training frames that each decides right do. The time on 8000 frames is ours alone.
"""

from collections.abc import Iterator
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat.learning.kernels import rbf_gram
from placecat.learning.rvm import RVM
from placecat.learning.scaling import KernelScaling
from placecat_bench.comparison import Comparison, Limit, Peer
from placecat_bench.gist_like import CLASSES, draw_frames
from placecat_bench.timing import Latest, seconds

PIECE = "RVM"
PEER = Peer("fastrvm: RVC", "fastrvm")
HOMES = range(5)
GAMMA = 2.0
PLACE = 1


def entries(*, few: int = 1600, many: int = 8000, features: int = 1024) -> Iterator[Comparison | Limit]:
    """Yield time and accuracy on few frames, and the time of the slowest of five classes on many."""
    yield from _beside_fastrvm(few, features)
    yield _alone(many, features)


def _beside_fastrvm(few: int, features: int) -> Iterator[Comparison | Limit]:
    X, place = scaled_frames(few, features)
    positive, in_their_type = place == PLACE, X.astype(np.float64)
    text = f"{few} x {features}"
    models = Latest(ours=lambda: ours(X, positive), theirs=lambda: theirs(in_their_type, positive))

    def behind() -> float:
        right = {name: np.mean(models.result(name).predict(X) == positive) for name in ("ours", "theirs")}
        return 100.0 * float(right["theirs"] - right["ours"])

    parts = {"Gram matrix": lambda: rbf_gram(X, GAMMA)}
    # No warm-up: fastrvm takes a minute.
    yield Comparison(PIECE, text, PEER, *models.calls, faster=1, warm_up=False, parts=parts)
    yield Limit(PIECE, text, "points of training accuracy behind fastrvm's", behind, at_most=1, peer=PEER)


def _alone(many: int, features: int) -> Limit:
    X, place = scaled_frames(many, features)

    def slowest() -> float:
        return max(seconds(partial(ours, X, place == number)) for number in range(CLASSES))

    text, quantity = f"{many} x {features}", f"seconds, the slowest of {CLASSES} classes"
    parts = {"Gram matrix": lambda: rbf_gram(X, GAMMA)}
    return Limit(PIECE, text, quantity, slowest, at_most=60, parts=parts)


def scaled_frames(n: int, features: int) -> tuple[NDArray[np.float32], NDArray[np.int64]]:
    """Draw frames and standardise them; gives descriptors (n, features) and places (n,)."""
    drawn = draw_frames(n, features, HOMES)
    return KernelScaling("standard").fit_transform(drawn.descriptors), drawn.place


def ours(X: NDArray[np.float32], positive: NDArray[np.bool_]) -> RVM:
    """Fit ours."""
    return RVM(gamma=GAMMA).fit(X, positive)


def theirs(X: NDArray[np.float64], positive: NDArray[np.bool_]) -> Any:
    """Fit fastrvm's ``RVC``."""
    from fastrvm import RVC

    return RVC(kernel="rbf", gamma=GAMMA, fit_intercept=True).fit(X, positive.astype(np.int64))
