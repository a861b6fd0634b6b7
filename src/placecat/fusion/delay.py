"""The first-order delay that follows the hidden Markov model (thesis 3.4, equations 14 to 16)."""

import math

import numpy as np
from numpy.typing import NDArray


class Delay:
    """Let the output follow the set point with a lag: p(t+1) = p(t) + h (p*(t) - p(t)), equation (16).

    The thesis sets alpha = -1 in equation (14) and leaves h open, so its lag depends on the frame rate. Here
    alpha = -1 / tau with a time constant tau, and h = 1 - exp(-dt / tau) is the exact solution of equation
    (14) for a set point that stays for dt seconds. After tau seconds the output has gone 63 % of the way to a
    new set point, at any frame rate.

    The output for frame t is p(t+1), which uses p*(t): it depends on frame t but on no later frame. The first
    output is the first set point. tau is `seconds`, 0 or more; 0 leaves the input unchanged.
    """

    def __init__(self, seconds: float) -> None:
        self._tau = float(seconds)
        self._state: NDArray[np.float64] | None = None

    def step(self, target: NDArray[np.float64], elapsed: float) -> NDArray[np.float64]:
        """Return the output for the next frame's set point (n_classes,), `elapsed` seconds after the last."""
        target = np.asarray(target, dtype=np.float64)
        if self._state is None or self._tau == 0:
            self._state = target
        else:
            self._state = self._state - math.expm1(-elapsed / self._tau) * (target - self._state)
        return self._state
