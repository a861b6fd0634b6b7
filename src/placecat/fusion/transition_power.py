"""Real powers of a transition matrix, used to adapt it to any frame rate."""

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import expm, logm

Float = NDArray[np.float64]


def generator(transition: Float) -> Float:
    """Return the rates Q of place changes per step, with exp(Q) equal or close to the transition matrix P.

    P is (n, n) with no negative entries, and its rows sum to 1. Q is (n, n) with no negative entries off the
    diagonal, and its rows sum to 0. Q is the logarithm of P if that is a rate matrix. Some stochastic
    matrices have no such logarithm (they are not *embeddable*), so no continuous-time chain produces P. In
    that case:

    - Negative rates of the logarithm become 0, and the diagonal is adjusted (Israel, Rosenthal and
      Wei, Finding generators for Markov chains via empirical transition matrices, 2001).
    - If P has an eigenvalue at or below 0, it has no real logarithm. Q is then P - I, so the chain makes the
      same transitions as P, but at random times, once per step on average.
    """
    identity = np.eye(len(transition))
    values = np.linalg.eigvals(transition)
    if np.any((values.real < 1e-12) & (np.abs(values.imag) < 1e-12)):
        return transition - identity
    rates = np.where(identity > 0, 0.0, np.clip(np.real(logm(transition)), 0.0, None))
    return rates - np.diag(rates.sum(axis=1))


class TransitionPower:
    """Powers P^x of an (n, n) transition matrix P, whose rows sum to 1, for any real x >= 0.

    P^x is exp(x Q), where Q comes from :func:`generator`. Rows sum to 1, and P^x P^y = P^(x + y) up to
    rounding. P^1 is exactly P.
    """

    def __init__(self, transition: Float) -> None:
        self._transition = transition
        self._generator: Float | None = None
        # Cache the last power, because most footage has a constant frame rate.
        self._last: tuple[float, Float] = (1.0, transition)

    def __call__(self, exponent: float) -> Float:
        """Return the (n, n) matrix P^exponent."""
        if exponent == 1.0:
            return self._transition
        if exponent != self._last[0]:
            if self._generator is None:
                self._generator = generator(self._transition)
            # Rounding can make entries slightly negative, and the sums slightly different from 1.
            power = np.clip(expm(exponent * self._generator), 0.0, None)
            self._last = (exponent, power / power.sum(axis=1, keepdims=True))
        return self._last[1]
