"""When the frames of a video are shown, from the timestamps of its file."""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError

MOST_RATE = 500.0
"""Frames a second; a header with more, such as 1,000 or 90,000, gives units of time. Slow motion has 240."""
LONGEST = 3600.0
"""Seconds between two frames; timestamps with a longer gap are damaged."""

# Seconds, in a file that was copied from one with milliseconds.
_ROUNDING = 0.001


@dataclass(frozen=True, eq=False)
class Timing:
    """Times of n frames.

    Attributes
    ----------
    seconds
        (n,) float64, increasing, since the first frame.
    end
        Seconds at which the last frame ends.
    fps
        Frames a second: those of the file, or, if frames come unevenly, those that come fast.
    is_even
        Whether frame i is shown at i / `fps`.
    """

    seconds: NDArray[np.float64]
    end: float
    fps: float
    is_even: bool

    @property
    def starts(self) -> NDArray[np.float64] | None:
        """(n + 1,) seconds at which each frame starts and the last one ends; None if they come evenly."""
        return None if self.is_even else np.append(self.seconds, self.end)


def even(count: int, fps: float) -> Timing:
    """Times of frames of one rate."""
    return Timing(np.arange(count) / fps, count / fps, fps, True)


def usual(count: int, rates: Sequence[Fraction | None]) -> Timing | None:
    """Times of frames of the first plausible rate; None if no rate is plausible."""
    said = _plausible(rates)
    return even(count, float(said[0])) if said else None


def measure(
    ticks: NDArray[np.int64], tick: Fraction, last: int, rates: Sequence[Fraction | None]
) -> Timing | None:
    """Find the times and the rate of frames.

    Containers round times, some to milliseconds. Times that are multiples of a rate's period up to such
    rounding are of that rate, so that frames that come evenly get the times that their numbers give.

    Parameters
    ----------
    ticks
        (n,) timestamps, increasing.
    tick
        Seconds of one.
    last
        How long the last frame is shown, in ticks; taken if it is about as long as another frame is.
    rates
        What the file says of its rate, the best first.

    Returns
    -------
    Timing or None
        None if there is no plausible rate.
    """
    if len(ticks) == 1:
        return usual(1, rates)
    times = (ticks - ticks[0]) * float(tick)
    steps = np.diff(times)
    # Longer steps come from a phone in the dark, or a picture that stood still.
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
    """Refuse times with a gap of more than `LONGEST` between two frames.

    The PlacecatError names the frame after the gap, the file (`title`) and what sets the rate (`setting`).
    """
    steps = np.diff(found.seconds)
    if len(steps) and steps.max() > LONGEST:
        raise PlacecatError(
            f"{title}: frame {int(steps.argmax()) + 2} comes {steps.max() / 3600:.3g} hours after the one "
            f"before: its times are damaged; give the frame rate with {setting}."
        )


def _plausible(rates: Sequence[Fraction | None]) -> list[Fraction]:
    return [rate for rate in rates if rate is not None and 0 < rate <= MOST_RATE]
