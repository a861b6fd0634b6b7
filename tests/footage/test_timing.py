from fractions import Fraction

import numpy as np
import pytest

from placecat.footage import timing

MILLI, FINE = Fraction(1, 1000), Fraction(1, 90000)


def measured(times, tick=FINE, last=0.0, rates=()):
    ticks = np.rint(np.asarray(times) / float(tick)).astype(np.int64)
    return timing.measure(ticks, tick, round(last / float(tick)), [Fraction(rate) for rate in rates])


@pytest.mark.parametrize("rate", [Fraction(5), Fraction(25), Fraction(30000, 1001), Fraction(240)])
@pytest.mark.parametrize("tick", [MILLI, FINE])
def test_rounded_times_of_one_rate_equal_the_exact_times_to_the_bit(rate, tick):
    numbers = np.arange(500)
    found = measured(numbers / float(rate) + 0.007, tick, rates=[rate])
    assert np.array_equal(found.seconds, numbers / float(rate))
    assert (found.fps, found.is_even) == (float(rate), True)
    assert found.end == pytest.approx(500 / float(rate))


def test_a_pause_leaves_the_rate():
    times = [*np.arange(45) / 30, *(100 + np.arange(45) / 30)]
    found = measured(times, MILLI, rates=[30])
    assert (found.fps, found.is_even) == (30.0, False)
    assert np.allclose(found.seconds, times, atol=1e-9)
    # The average rate in the header is not the rate of any frame.
    assert measured(times, MILLI, rates=[Fraction(90, 101), 30]).fps == 30.0


def test_uneven_times_are_kept_and_the_last_frame_lasts_as_the_file_says():
    times = [*np.arange(45) / 30, *(1.5 + np.arange(45) / 3.01)]
    found = measured(times, last=1 / 30, rates=[Fraction(75, 13)])
    assert np.allclose(found.seconds, times, atol=1e-5)
    assert found.fps == pytest.approx(30.0, rel=1e-3)
    assert not found.is_even
    assert found.end == pytest.approx(times[-1] + 1 / 30, abs=1e-4)
    # An implausible duration is ignored.
    assert measured(times, last=0.001).end == pytest.approx(times[-1] + 1 / 30, abs=1e-4)


def test_a_unit_of_time_is_no_rate():
    times = [0, 0.040, 0.069, 0.109, 0.138, 0.178, 0.200, 0.235]
    for said in (1000, 90000):
        assert measured(times, MILLI, rates=[said]).fps == pytest.approx(29.8, abs=0.1)
    assert measured(np.arange(9) / 1000, MILLI, rates=[1000]) is None
    assert measured([0], rates=[1000]) is None


def test_one_frame_has_the_rate_of_the_file():
    assert measured([3.0], rates=[25]).end == 1 / 25
