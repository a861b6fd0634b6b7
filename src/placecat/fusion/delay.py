"""The first-order delay that follows the hidden Markov model (thesis 3.4, equations 14 to 16)."""

import math

import numpy as np
from numpy.typing import NDArray


class Delay:
    """Let the output follow the set point with a lag: p(t+1) = p(t) + h (p*(t) - p(t)), equation (16).

    The thesis sets alpha = -1 in equation (14) and does not specify h, so its lag depends on the frame rate.
    Here alpha = -1 / tau with a time constant tau. The step h = 1 - exp(-dt / tau) solves equation (14)
    exactly if the set point stays constant for dt seconds. At any frame rate, the output has moved 63% of
    the way to a new set point after tau seconds.

    The output for frame t is p(t+1). It uses p*(t), so it depends on frame t but not on any later frame. The
    first output equals the first set point. `seconds` is the time constant tau, 0 or more. If it is 0, the
    input is returned unchanged.
    """

    def __init__(self, seconds: float) -> None:
        self._tau = float(seconds)
        self._state: NDArray[np.float64] | None = None

    def step(self, target: NDArray[np.float64], elapsed: float) -> NDArray[np.float64]:
        """Return the output for the (n_classes,) set point of the next frame, `elapsed` seconds later."""
        target = np.asarray(target, dtype=np.float64)
        if self._state is None or self._tau == 0:
            self._state = target
        else:
            self._state = self._state - math.expm1(-elapsed / self._tau) * (target - self._state)
        return self._state
