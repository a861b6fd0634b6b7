"""One-vs-rest nu-SVMs for five classes, with probabilities, compared with three variants in scikit-learn.

For each class, our code and scikit-learn fit one nu-SVM on all frames, and another per fold on the frames
outside that fold. A sigmoid is then fitted to the decisions for the frames that were left out.
``CalibratedClassifierCV`` does this if ``ensemble`` is False and it is given our folds, which are random
subsets of the frames. (By default, it would skip the first nu-SVM and average the predictions over the folds.
This needs fewer fits, but prediction takes five times as much work, and the probabilities differ.)

``OneVsRestClassifier`` divides the probabilities of a frame by their sum, as our ``certainty`` combination
does. The combination used in the thesis, ``parallel``, needs one more small matrix product. gamma, nu, the
tolerance, the scaling and the cache of libsvm are the same; the cache can hold the full kernel matrix.
scikit-learn is given float64 data, because it would otherwise convert the data for every fit.

The ratios depend on the number of support vectors and on how many of them are shared by several classes. For
a shared vector, our code computes one kernel value, but scikit-learn computes one per class. The frames are
as hard to classify as Gist descriptors (:mod:`placecat_bench.gist_like`).

The same scheme is also measured with a Gram matrix that is computed once (``kernel="precomputed"``), and with
the ``NuSVC`` of scikit-learn-intelex, which is given float32 data.
"""

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat.learning.calibration import SAMPLES, make_folds
from placecat.learning.kernels import rbf_gram
from placecat.learning.nu_svm import NuSVM
from placecat.learning.one_against_all import OneAgainstAll
from placecat.learning.scaling import KernelScaling
from placecat_bench.comparison import Absent, Comparison, Entry, Limit, Peer
from placecat_bench.gist_like import CLASSES, Frames, draw_frames
from placecat_bench.timing import Latest

PIECE = f"nu-SVM, {CLASSES} classes, probabilities"
PEER = Peer("OneVsRestClassifier(CalibratedClassifierCV(NuSVC))", "scikit-learn")
PRECOMPUTED = Peer("scikit-learn on a Gram matrix: NuSVC", "scikit-learn")
ONEDAL = Peer("scikit-learn-intelex: NuSVC", "scikit-learn-intelex")
THUNDERSVM = Absent(
    PIECE,
    "",
    "thundersvm 0.3.12",
    "its wheel needs libcusparse.so.9.0 from CUDA 9, even without a GPU",
)
BASE = NuSVM(gamma=2.0, nu=0.2)

# Maps (n, D) descriptors to (n, classes) probabilities.
Predict = Callable[[NDArray[np.float32]], NDArray[np.floating]]


def entries(*, frames: int = 8000, features: int = 1024, homes: int = 5, new: int = 2000) -> Iterator[Entry]:
    """Yield comparisons of fitting times, prediction times and probabilities.

    `new` is the number of frames to predict, all from another home.
    """
    train, test = draw_frames(frames, features, range(homes)), draw_frames(new, features, [homes])
    scaling = KernelScaling("standard").fit(train.descriptors)
    known, unknown = scaling.transform(train.descriptors), scaling.transform(test.descriptors)
    texts = f"fit {frames} x {features}, {homes} homes", f"predict {new} x {features} from {frames}"
    yield from _beside(PEER, theirs, train, known, unknown, texts, faster=(16, 25), at_most=1e-3)
    yield from _beside(PRECOMPUTED, on_gram, train, known, unknown, texts)
    yield from _beside(ONEDAL, by_onedal, train, known, unknown, texts)
    yield THUNDERSVM


def _beside(
    peer: Peer,
    fit: Callable[[NDArray[np.float32], Frames], Predict],
    train: Frames,
    known: NDArray[np.float32],
    unknown: NDArray[np.float32],
    texts: tuple[str, str],
    *,
    faster: tuple[float, float] = (3, 5),
    at_most: float = 5e-3,
) -> Iterator[Entry]:
    our, their = Latest(ours, known, train), Latest(fit, known, train)

    yield Comparison(
        PIECE,
        texts[0],
        peer,
        our,
        their,
        faster=faster[0],
        warm_up=False,
        parts={"Gram matrix": lambda: rbf_gram(known, BASE.gamma, BASE.gram_dtype)},
    )

    def found() -> Any:
        return our.result().predict_proba(unknown)

    def expected() -> Any:
        return their.result()(unknown)

    yield Comparison(PIECE, texts[1], peer, found, expected, faster=faster[1])

    def largest_difference() -> float:
        return float(np.abs(found() - expected()).max())

    quantity = "largest difference between probabilities"
    yield Limit(PIECE, texts[1], quantity, largest_difference, at_most=at_most, peer=peer)


def ours(X: NDArray[np.float32], frames: Frames) -> OneAgainstAll:
    """Fit our scheme. Its folds are random subsets of the frames."""
    return OneAgainstAll(BASE, combination="certainty").fit(X, frames.place)


def theirs(X: NDArray[np.float32], frames: Frames) -> Predict:
    """Fit scikit-learn's ``OneVsRestClassifier`` on the same folds and return its prediction function."""
    from sklearn.svm import NuSVC

    model = _one_against_all(NuSVC, X.astype(np.float64), frames)
    return lambda new: np.asarray(model.predict_proba(new.astype(np.float64)))


def on_gram(X: NDArray[np.float32], frames: Frames) -> Predict:
    """Fit the same scheme on a Gram matrix and return a function that predicts from descriptors."""
    from sklearn.metrics.pairwise import rbf_kernel
    from sklearn.svm import NuSVC

    known = X.astype(np.float64)
    model = _one_against_all(NuSVC, rbf_kernel(known, gamma=BASE.gamma), frames, kernel="precomputed")
    return lambda new: np.asarray(
        model.predict_proba(rbf_kernel(new.astype(np.float64), known, gamma=BASE.gamma))
    )


def by_onedal(X: NDArray[np.float32], frames: Frames) -> Predict:
    """Fit the same scheme with the ``NuSVC`` of scikit-learn-intelex and return its ``predict_proba``."""
    from sklearnex.svm import NuSVC

    predict: Predict = _one_against_all(NuSVC, X, frames).predict_proba
    return predict


def _one_against_all(kind: Any, X: NDArray[np.floating], frames: Frames, kernel: str = "rbf") -> Any:
    from sklearn.calibration import CalibratedClassifierCV
    from sklearn.multiclass import OneVsRestClassifier

    machine = kind(kernel=kernel, gamma=BASE.gamma, nu=BASE.nu, tol=BASE.tol, cache_size=BASE.cache_mb)
    folds = make_folds(frames.place, None, SAMPLES, 5)
    calibrated = CalibratedClassifierCV(machine, method="sigmoid", ensemble=False, cv=folds)
    return OneVsRestClassifier(calibrated).fit(X, frames.place)
