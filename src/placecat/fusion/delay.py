"""The first-order delay behind the hidden Markov model (thesis 3.4, equations 14 to 16)."""

import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError


class Delay:
    """Let the output follow the set point with a lag: p(t+1) = p(t) + h (p*(t) - p(t)), equation (16).

    The output for frame t is p(t+1), which uses p*(t): the frame itself counts, no later one does. The first
    output is the first set point.

    Parameters
    ----------
    step
        h in (0, 1]; 1 passes the input through. The thesis does not give its value.

    Raises
    ------
    PlacecatError
        If h is outside.
    """

    def __init__(self, step: float) -> None:
        if not 0.0 < step <= 1.0:
            raise PlacecatError(f"smoothing.delay_step must lie in (0, 1], but is {step}")
        self._h = step
        self._state: NDArray[np.float64] | None = None

    def step(self, target: NDArray[np.float64]) -> NDArray[np.float64]:
        """Take the next frame's set point (n_classes,); give the output."""
        state = np.asarray(target, dtype=np.float64) if self._state is None else self._state
        self._state = state + self._h * (target - state)
        return self._state


def delay(set_point: NDArray[np.float64], *, step: float) -> NDArray[np.float64]:
    """Delay one whole sequence, see :class:`Delay`.

    Parameters
    ----------
    set_point
        (frames, n_classes), the distributions p* of the hidden Markov model.
    step
        h of equation (16).

    Returns
    -------
    (frames, n_classes); rows sum to 1 as those of `set_point` do.

    Raises
    ------
    PlacecatError
        As :class:`Delay`.
    """
    follower = Delay(step)
    return np.array([follower.step(target) for target in set_point]).reshape(set_point.shape)
