import numpy as np
import pytest

from placecat.errors import NotComputable
from placecat.results.measured import NO_SEED, Measured, Results
from placecat.thesis.claims import Side
from placecat.thesis.pooling import pool

CLASSES = ("corridor", "kitchen", "attic")
# Place and number of frames of each stay.
STAYS = ((0, 10), (1, 4), (0, 30), (0, 20), (1, 6))


def by_stay(*right, stays=STAYS):
    """Make a result from the numbers of correctly named frames in each stay, one list per seed."""
    confusion = np.zeros((len(right), len(stays), 3, 3), int)
    for s, of_seed in enumerate(right):
        for n, ((place, frames), own) in enumerate(zip(stays, of_seed, strict=True)):
            confusion[s, n, place, place] = own
            confusion[s, n, place, 2] = frames - own
    seeds = (NO_SEED,) if len(right) == 1 else tuple(f"seed-{n}" for n in range(len(right)))
    return Measured(tuple(f"one/{n}" for n in range(len(stays))), seeds, CLASSES, confusion)


def results(**stays):
    return Results(("one",), CLASSES, {name: one.pooled() for name, one in stays.items()}, {}, stays)


A, B = by_stay((10, 4, 15, 5, 3)), by_stay((5, 2, 30, 10, 6), (7, 2, 30, 10, 6))


def test_accuracies_pool_the_frames():
    pooled = pool(results(a=A, b=B), [Side("left", ("a",)), Side("right", ("b",))])
    assert pooled.units == "5 stays"
    assert pooled.names == ("corridor", "kitchen")
    # 30 of 60 frames of the corridor are correct, and 7 of 10 of the kitchen; likewise for each seed of b.
    left, right = pooled.overall()
    assert left.tolist() == [[pytest.approx((50 + 70) / 2)]]
    assert right.tolist() == [[pytest.approx((46 / 60 + 0.8) * 50)]]
    assert pooled.values[1].shape == (1, 1, 2)
    for side, one in zip(pooled.overall(), (A, B), strict=True):
        assert side[0, 0] == pytest.approx(one.pooled().by_home().mean())


@pytest.mark.parametrize(
    ("options", "expected"),
    [({"plain": True}, 100 * 37 / 70), ({"place": "kitchen"}, 70), ({"place": "kitchen", "error": True}, 30)],
)
def test_accuracy_options(options, expected):
    pooled = pool(results(a=A), [Side("left", ("a",), **options)])
    assert pooled.overall()[0][0, 0] == pytest.approx(expected)


def test_the_bootstrap_resamples_stays():
    """If all stays of a place have equal values, the interval is a point, however much the places differ."""
    same = by_stay([frames * (place + 1) // 2 for place, frames in STAYS])
    pooled = pool(results(a=same), [Side("left", ("a",))])
    interval = pooled.interval(lambda sides: sides[0][0], 0, 0.95, 300)
    assert (interval.low, interval.estimate, interval.high) == pytest.approx((75, 75, 75))
    pooled = pool(results(a=A), [Side("left", ("a",))])
    interval = pooled.interval(lambda sides: sides[0][0], 0, 0.95, 300)
    assert interval.low < interval.estimate - 5
    assert interval.high > interval.estimate + 5


def test_a_place_with_a_single_stay_prevents_a_verdict():
    stays = ((0, 10), (0, 10), (0, 10), (1, 5))
    pooled = pool(results(a=by_stay((5, 5, 5, 5), stays=stays)), [Side("left", ("a",))])
    assert pooled.too_few(4) == "only one stay shows kitchen: too few for a verdict"
    assert pooled.too_few(5) == "4 stays are too few for a verdict"
    assert pool(results(a=A), [Side("left", ("a",))]).too_few(4) == ""
    single = pool(results(a=by_stay((5, 5), stays=((0, 10), (1, 5)))), [Side("left", ("a",))])
    assert single.n_units == 1


def test_missing_stays_raise_with_the_reason():
    with pytest.raises(NotComputable, match="this run has no result b"):
        pool(results(a=A), [Side("left", ("a",)), Side("right", ("b",))])
    without = Results(("one",), CLASSES, {"a": A.pooled()}, {})
    with pytest.raises(NotComputable, match="no stays of a"):
        pool(without, [Side("left", ("a",))])
    with pytest.raises(NotComputable, match="no test sequence shows the place attic"):
        pool(results(a=A), [Side("left", ("a",), place="attic")])
