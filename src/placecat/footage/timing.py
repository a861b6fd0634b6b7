"""When the frames of a video are shown, from the timestamps of its file."""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError

MOST_RATE = 500.0
"""Frames a second above which a rate is taken for a mistake: headers have 1,000 or 90,000, which are units of
time; slow motion is filmed at 240."""
LONGEST = 3600.0
"""Seconds between two frames above which timestamps are taken for damaged."""

# Seconds: of a file that was copied from one that has milliseconds.
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


def even(count: int, fps: float) -> Timing:
    """Times of frames of one rate."""
    return Timing(np.arange(count) / fps, count / fps, fps, True)


def measure(
    ticks: NDArray[np.int64], tick: Fraction, last: int, rates: Sequence[Fraction | None]
) -> Timing | None:
    """Find the times and the rate of frames.

    Containers round times, some to milliseconds: times that are a multiple of a rate's period up to that are
    of that rate, so that frames that come evenly have the times that their numbers have.

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
    said = [rate for rate in rates if rate is not None and 0 < rate <= MOST_RATE]
    if len(ticks) == 1:
        return even(1, float(said[0])) if said else None
    times = (ticks - ticks[0]) * float(tick)
    steps = np.diff(times)
    # Of a phone in the dark, or a picture that stood still, the rest.
    period = float(steps[steps <= 2 * np.quantile(steps, 0.25)].mean())
    if period * MOST_RATE < 1 - 1e-9:
        return None
    rounding = 1.01 * max(float(tick), min(_ROUNDING, period / 10))
    for rate in map(float, said):
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

    Parameters
    ----------
    title
        The file, for the message.
    setting
        What sets the frame rate, for the message.

    Raises
    ------
    PlacecatError
        Naming the frame after the longest gap.
    """
    steps = np.diff(found.seconds)
    if len(steps) and steps.max() > LONGEST:
        raise PlacecatError(
            f"{title}: frame {int(steps.argmax()) + 2} comes {steps.max() / 3600:.3g} hours after the one "
            f"before: its times are damaged; give the frame rate with {setting}."
        )
