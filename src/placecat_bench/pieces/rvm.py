"""Relevance vector machine for one place against the rest, compared with fastrvm and sklearn-rvm.

fastrvm and our code maximise the evidence by adding, re-estimating and deleting basis functions (Tipping and
Faul 2003). Both use the same kernel and a bias, and both compute the Gram matrix. fastrvm updates its
statistics after every change, but our code only after many changes. fastrvm needs thousands of changes, and
more than 3000 for two of the five places. We therefore use the place that needs the fewest. The evidence
values cannot be compared, since fastrvm has no prior on the bias. The accuracies on the training frames are
compared instead. Only our code is timed on 8000 frames.

sklearn-rvm starts with all basis functions and prunes them (Tipping 2001). Its run time is cubic in the
number of frames, so it is given fewer frames.
"""

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat.learning.kernels import rbf_gram
from placecat.learning.rvm import RVM
from placecat.learning.scaling import KernelScaling
from placecat_bench.comparison import Comparison, Limit, Peer
from placecat_bench.gist_like import CLASSES, draw_frames, points_behind
from placecat_bench.timing import Latest, seconds

PIECE = "RVM"
PEER = Peer("fastrvm: RVC", "fastrvm")
PRUNING = Peer("sklearn-rvm: EMRVC", "sklearn-rvm")
HOMES = range(5)
GAMMA = 2.0
PLACE = 1


def entries(
    *, fewest: int = 400, few: int = 1600, many: int = 8000, features: int = 1024
) -> Iterator[Comparison | Limit]:
    """Yield comparisons of run time and accuracy on few frames, and our time for the slowest class on many.

    `fewest` is the number of frames for sklearn-rvm, `few` for fastrvm, and `many` for our code alone.
    `features` is the length of a descriptor.
    """
    for peer, call, number, faster in ((PRUNING, by_pruning, fewest, 10), (PEER, theirs, few, 1)):
        yield from _beside(peer, call, *scaled_frames(number, features), faster)
    X, place = scaled_frames(many, features)
    yield Limit(
        PIECE,
        f"{many} x {features}",
        f"seconds for the slowest of {CLASSES} classes",
        lambda: max(seconds(partial(ours, X, place == number)) for number in range(CLASSES)),
        at_most=60,
        parts={"Gram matrix": lambda: rbf_gram(X, GAMMA)},
    )


def _beside(
    peer: Peer,
    call: Callable[[NDArray[np.float64], NDArray[np.bool_]], Any],
    X: NDArray[np.float32],
    place: NDArray[np.int64],
    faster: float,
) -> Iterator[Comparison | Limit]:
    positive, text = place == PLACE, f"{len(X)} x {X.shape[1]}"
    our, their = Latest(ours, X, positive), Latest(call, X.astype(np.float64), positive)
    parts = {"Gram matrix": lambda: rbf_gram(X, GAMMA)}
    # The peer takes a minute.
    yield Comparison(PIECE, text, peer, our, their, faster=faster, warm_up=False, parts=parts)
    quantity = f"{peer.package}'s training accuracy minus ours, in percentage points"

    def behind() -> float:
        return points_behind(our.result().predict(X), their.result().predict(X), positive)

    yield Limit(PIECE, text, quantity, behind, at_most=1, peer=peer)


def scaled_frames(n: int, features: int) -> tuple[NDArray[np.float32], NDArray[np.int64]]:
    """Draw and standardise frames, and return their (n, features) descriptors and (n,) places."""
    drawn = draw_frames(n, features, HOMES)
    return KernelScaling("standard").fit_transform(drawn.descriptors), drawn.place


def ours(X: NDArray[np.float32], positive: NDArray[np.bool_]) -> RVM:
    """Fit our RVM."""
    return RVM(gamma=GAMMA).fit(X, positive)


def theirs(X: NDArray[np.float64], positive: NDArray[np.bool_]) -> Any:
    """Fit fastrvm's ``RVC``."""
    from fastrvm import RVC

    return RVC(kernel="rbf", gamma=GAMMA, fit_intercept=True).fit(X, positive.astype(np.int64))


def by_pruning(X: NDArray[np.float64], positive: NDArray[np.bool_]) -> Any:
    """Fit sklearn-rvm's ``EMRVC``."""
    from sklearn_rvm import EMRVC

    return EMRVC(kernel="rbf", gamma=GAMMA).fit(X, positive.astype(np.int64))
