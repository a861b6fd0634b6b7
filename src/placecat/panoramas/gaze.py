"""Turn the view in a panorama smoothly from one direction to the next.

References
----------
T. Flash, N. Hogan, The Coordination of Arm Movements: An Experimentally Confirmed Mathematical Model. Journal
of Neuroscience 5(7), 1985 (the minimum-jerk movement).
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray


def gaze(
    frames: int,
    *,
    fps: float,
    fov: Sequence[float],
    tilt: Sequence[float],
    turn: Sequence[float],
    speed: Sequence[float],
    rest: Sequence[float],
    rng: np.random.Generator,
) -> NDArray[np.float64]:
    """Generate the view direction of each frame.

    Returns (frames, 3) float64: pan, tilt and field of view in degrees. The pan may exceed 360.

    Parameters
    ----------
    fps
        Frames per second. This does not affect the turns, only the times at which they are sampled.
    fov, tilt
        Ranges of the horizontal field of view, which stays constant, and the tilt, in degrees.
    turn, speed
        Ranges of the angle of a turn to either side, in degrees, and its mean speed, in degrees/s.
    rest
        Range of the pause between turns, in seconds.
    rng
        Source of all random choices.

    Examples
    --------
    >>> path = gaze(3, fps=2.0, fov=[60, 60], tilt=[0, 0], turn=[90, 90], speed=[90, 90], rest=[9, 9],
    ...     rng=np.random.default_rng(0))
    >>> np.abs(path[1:, 0] - path[0, 0]).round(6).tolist()
    [45.0, 90.0]
    """
    times = np.arange(frames) / fps
    path = np.empty((frames, 3))
    path[:, 2] = _within(fov, rng)
    at = np.array([rng.uniform(0, 360), _within(tilt, rng)])
    now = 0.0
    while True:
        by = _within(turn, rng) * (1 if rng.random() < 0.5 else -1)
        target = np.array([at[0] + by, _within(tilt, rng)])
        turning = abs(by) / _within(speed, rng)
        done = np.clip((times - now) / turning, 0, 1)
        is_here = times >= now
        path[is_here, :2] = at + (target - at) * least_jerk(done[is_here])[:, None]
        now += turning + _within(rest, rng)
        if now > times[-1]:
            return path
        at = target


def least_jerk(done: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the fraction of a movement that is complete after a fraction of its duration.

    Both fractions are between 0 and 1. The movement starts and ends at rest (Flash and Hogan 1985).

    Examples
    --------
    >>> least_jerk(np.array([0.0, 0.5, 1.0])).tolist()
    [0.0, 0.5, 1.0]
    """
    return done**3 * (10 - 15 * done + 6 * done**2)


def _within(limits: Sequence[float], rng: np.random.Generator) -> float:
    return float(rng.uniform(limits[0], limits[1]))
