"""Compute the times of video frames from the timestamps in the file."""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError

MOST_RATE = 500.0
"""Highest plausible number of frames per second. Slow-motion video is shot at 240. A value of 1,000 or more
in a header is a clock rate."""
LONGEST = 3600.0
"""Longest plausible gap between two frames, in seconds. If a gap is longer, the timestamps are damaged."""

# Rounding error, in seconds, in a file converted from a format with millisecond timestamps.
_ROUNDING = 0.001


@dataclass(frozen=True, eq=False)
class Timing:
    """Times of n frames, in seconds.

    `seconds`, (n,) float64, are the times since the first frame, and `end` is the time at which the last
    frame ends. `fps` is the frame rate in the file or, if the times do not match it, the rate computed
    without long gaps. If `is_even` is true, frame i, counted from 0, is displayed at time i / `fps`.
    """

    seconds: NDArray[np.float64]
    end: float
    fps: float
    is_even: bool

    @property
    def starts(self) -> NDArray[np.float64]:
        """The start of each frame and the end of the last frame in seconds, (n + 1,) float64."""
        return np.append(self.seconds, self.end)


def even(count: int, fps: float) -> Timing:
    """Return the times of frames at a constant rate."""
    return Timing(np.arange(count) / fps, count / fps, fps, True)


def usual(count: int, rates: Sequence[Fraction | None]) -> Timing | None:
    """Return the times of frames at the first plausible rate; None if no rate is plausible."""
    said = _plausible(rates)
    return even(count, float(said[0])) if said else None


def measure(
    ticks: NDArray[np.int64], tick: Fraction, last: int, rates: Sequence[Fraction | None]
) -> Timing | None:
    """Determine the frame times and the frame rate.

    Container formats round times, some of them to milliseconds. If every time could be a rounded multiple of
    one frame period, the times are replaced by the exact multiples. Returns None if no rate is plausible.

    Parameters
    ----------
    ticks
        (n,) timestamps in increasing order.
    tick
        Length of a tick in seconds.
    last
        The duration of the last frame in ticks. It is used only if it is plausible compared with the
        durations of the other frames.
    rates
        Frame rates stored in the file, most reliable first.
    """
    if len(ticks) == 1:
        return usual(1, rates)
    times = (ticks - ticks[0]) * float(tick)
    steps = np.diff(times)
    # Ignore longer steps: phones record more slowly in the dark, and recorders drop frames of static scenes.
    period = float(steps[steps <= 2 * np.quantile(steps, 0.25)].mean())
    if period * MOST_RATE < 1 - 1e-9:
        return None
    rounding = 1.01 * max(float(tick), min(_ROUNDING, period / 10))
    for rate in map(float, _plausible(rates)):
        numbers = np.rint(times * rate)
        is_grid = (np.diff(numbers) >= 1).all() and abs(period * rate - 1) < 0.2
        if is_grid and (np.abs(times - numbers / rate) <= rounding).all():
            is_even = numbers[-1] == len(ticks) - 1
            return Timing(numbers / rate, float(numbers[-1] + 1) / rate, rate, bool(is_even))
    shown = last * float(tick)
    end = float(times[-1]) + (shown if shown >= 0.5 * float(steps.min()) else float(np.median(steps)))
    return Timing(times, end, 1 / period, False)


def check_gaps(found: Timing, title: str, setting: str) -> None:
    """Raise an error if the gap between two frames is longer than `LONGEST`.

    The PlacecatError names the frame after the gap, the file (`title`), and the `setting` for the frame rate.
    """
    steps = np.diff(found.seconds)
    if len(steps) and steps.max() > LONGEST:
        raise PlacecatError(
            f"{title}: frame {int(steps.argmax()) + 2} comes {steps.max() / 3600:.3g} hours after the "
            f"previous one, so the times are damaged; set the frame rate with {setting}."
        )


def _plausible(rates: Sequence[Fraction | None]) -> list[Fraction]:
    return [rate for rate in rates if rate is not None and 0 < rate <= MOST_RATE]
