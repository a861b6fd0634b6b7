"""Adjust the confidence of a cue's distributions with a temperature."""

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize_scalar

# Search range for the exponent 1 / T.
_EXPONENTS = (0.01, 100.0)


def temper(proba: NDArray[np.float64], temperature: float | NDArray[np.float64]) -> NDArray[np.float64]:
    """Raise distributions to the power of 1 / T and normalise them.

    This makes them flatter if the temperature T is above 1, and sharper if it is below 1. The ranking of the
    classes does not change. `proba` and the result are (..., n_classes), and rows sum to 1. The temperature
    is a positive number, or an array of them that broadcasts against ``proba[..., 0]``. A temperature of 1
    changes nothing apart from rounding errors.

    >>> temper(np.array([[0.8, 0.2]]), 2.0).round(3).tolist()
    [[0.667, 0.333]]
    """
    exponent = 1.0 / np.asarray(temperature, dtype=np.float64)
    scaled = np.log(np.maximum(proba, np.finfo(np.float64).tiny)) * exponent[..., None]
    powers = np.exp(scaled - scaled.max(axis=-1, keepdims=True))
    return powers / powers.sum(axis=-1, keepdims=True)


def fit_temperature(proba: NDArray[np.float64], truth: NDArray[np.int16]) -> float:
    """Find the temperature with the lowest log-loss on frames that the model has not seen.

    The result lies in [0.01, 100], and is rounded to four significant digits.

    The thesis does not use temperatures. Naive Bayes multiplies probabilities as if codewords were
    independent, so it is far too confident. The parallel scheme averages them, so it is not confident enough.

    `proba` contains (n, n_classes) distributions from a model that saw neither the frame nor its home.
    `truth` contains (n,) class indices. All classes present have equal weight.

    References
    ----------
    Guo, Pleiss, Sun and Weinberger, On calibration of modern neural networks, ICML 2017.

    Examples
    --------
    >>> proba = np.array([[0.9, 0.1], [0.9, 0.1], [0.1, 0.9], [0.9, 0.1]])
    >>> fit_temperature(proba, np.array([0, 0, 1, 1], np.int16)) > 1.0
    True
    """
    index = truth.astype(np.intp)
    counts = np.bincount(index, minlength=proba.shape[1])
    weight = 1.0 / counts[index] / np.count_nonzero(counts)
    logs = np.log(np.maximum(proba, np.finfo(np.float64).tiny))
    right = logs[np.arange(len(logs)), index]

    def loss(log_exponent: float) -> float:
        scaled = np.exp(log_exponent) * logs
        top = scaled.max(axis=1)
        normaliser = top + np.log(np.exp(scaled - top[:, None]).sum(axis=1))
        return float(weight @ (normaliser - np.exp(log_exponent) * right))

    # The loss is convex in the exponent, so it has a single minimum in the log exponent too.
    found = minimize_scalar(loss, bounds=np.log(_EXPONENTS), method="bounded", options={"xatol": 1e-6})
    # The search is accurate to a millionth. Later digits vary between processors.
    return float(f"{np.exp(-found.x):.4g}")
