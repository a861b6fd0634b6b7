"""nu-SVM beside scikit-learn's: each of five classes against the rest, with probabilities.

Both fit for each class one nu-SVM on all frames, and one per home on the frames of the other homes; a sigmoid
is fitted to their decisions for the frames of the homes left out. ``CalibratedClassifierCV`` does so with
``ensemble=False`` and our folds. (By default it would skip the first and predict by the mean over folds:
fewer fits, but five times the work to predict, and other probabilities, which would not compare.)
``OneVsRestClassifier`` divides the probabilities of a frame by their sum, as our combination ``certainty``
does; the thesis's, ``parallel``, takes one small matrix product more. gamma, nu, the tolerance, the scaling
and libsvm's cache, which holds the whole kernel matrix, are the same. Theirs gets float64, to which it would
convert for every fit.

The ratios depend on how many frames are support vectors, and how many of these serve several classes, which
costs us one kernel value and scikit-learn one per class. The frames are as hard as Gist's
(:mod:`placecat_bench.gist_like`).
"""

from collections.abc import Iterator
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat.learning.calibration import SAMPLES, make_folds
from placecat.learning.kernels import rbf_cross, rbf_gram
from placecat.learning.nu_svm import NuSVM
from placecat.learning.one_against_all import OneAgainstAll
from placecat.learning.scaling import KernelScaling
from placecat_bench.comparison import Comparison, Limit, Peer
from placecat_bench.gist_like import CLASSES, Frames, draw_frames
from placecat_bench.timing import Latest

PIECE = f"nu-SVM, {CLASSES} classes, probabilities"
PEER = Peer("OneVsRestClassifier(CalibratedClassifierCV(NuSVC))", "scikit-learn")
BASE = NuSVM(gamma=2.0, nu=0.2)


def entries(
    *, frames: int = 8000, features: int = 1024, homes: int = 5, new: int = 2000
) -> Iterator[Comparison | Limit]:
    """Yield the times of fit and prediction, and how far the probabilities of `new` frames are apart."""
    train, test = draw_frames(frames, features, range(homes)), draw_frames(new, features, [homes])
    scaling = KernelScaling("standard").fit(train.descriptors)
    known, unknown = scaling.transform(train.descriptors), scaling.transform(test.descriptors)
    known_by_them, unknown_by_them = known.astype(np.float64), unknown.astype(np.float64)
    models = Latest(ours=lambda: ours(known, train), theirs=lambda: theirs(known_by_them, train))

    @cache
    def gram() -> NDArray[Any]:
        return rbf_gram(known, BASE.gamma, BASE.gram_dtype)

    parts = {
        "Gram matrix": lambda: rbf_gram(known, BASE.gamma, BASE.gram_dtype),
        "fits on it": lambda: ours(known, train, gram()),
    }
    text = f"fit {frames} x {features}, {homes} homes"
    yield Comparison(PIECE, text, PEER, *models.calls, faster=16, warm_up=False, parts=parts)
    gram.cache_clear()

    def by_ours() -> NDArray[Any]:
        return models.result("ours").predict_proba(unknown)

    def by_theirs() -> NDArray[Any]:
        return models.result("theirs").predict_proba(unknown_by_them)

    def kernel_values() -> NDArray[Any]:
        scorer = models.result("ours").scorer_
        return rbf_cross(unknown, scorer.support_vectors, scorer.gamma)

    def largest_difference() -> float:
        return float(np.abs(by_ours() - by_theirs()).max())

    text = f"predict {new} x {features} from {frames}"
    yield Comparison(PIECE, text, PEER, by_ours, by_theirs, faster=25, parts={"kernel values": kernel_values})

    quantity = "largest difference of a probability"
    yield Limit(PIECE, text, quantity, largest_difference, at_most=1e-3, peer=PEER)


def ours(X: NDArray[np.float32], frames: Frames, gram: NDArray[Any] | None = None) -> OneAgainstAll:
    """Fit our scheme, which holds out random parts of the frames."""
    model = OneAgainstAll(BASE, combination="certainty")
    return model.fit(X, frames.place, gram=gram)


def theirs(X: NDArray[np.float64], frames: Frames) -> Any:
    """Fit scikit-learn's ``OneVsRestClassifier``, with the same folds."""
    from sklearn.calibration import CalibratedClassifierCV
    from sklearn.multiclass import OneVsRestClassifier
    from sklearn.svm import NuSVC

    machine = NuSVC(gamma=BASE.gamma, nu=BASE.nu, tol=BASE.tol, cache_size=BASE.cache_mb)
    folds = make_folds(frames.place, None, SAMPLES, 5)
    calibrated = CalibratedClassifierCV(machine, method="sigmoid", ensemble=False, cv=folds)
    return OneVsRestClassifier(calibrated).fit(X, frames.place)
