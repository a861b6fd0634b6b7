"""The first-order delay behind the hidden Markov model (thesis 3.4, equations 14 to 16)."""

import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError


def delay(set_point: NDArray[np.float64], *, step: float) -> NDArray[np.float64]:
    """Let the output follow the set point with a lag: p(t+1) = p(t) + h (p*(t) - p(t)), equation (16).

    The output for frame t is p(t+1), which uses p*(t): the frame itself counts, no later one does. The first
    output is the first set point.

    Parameters
    ----------
    set_point
        (frames, n_classes), the distributions p* of the hidden Markov model.
    step
        h in (0, 1]; 1 passes the input through. The thesis does not give its value.

    Returns
    -------
    (frames, n_classes); rows sum to 1 as those of `set_point` do.
    """
    if not 0.0 < step <= 1.0:
        raise PlacecatError(f"smoothing.delay_step must lie in (0, 1], but is {step}")
    delayed = np.empty_like(set_point, dtype=np.float64)
    if len(set_point) == 0:
        return delayed
    state = np.asarray(set_point[0], dtype=np.float64)
    for t, target in enumerate(set_point):
        state = state + step * (target - state)
        delayed[t] = state
    return delayed
