import numpy as np
import pytest

from placecat.errors import PlacecatError
from placecat.evaluation.verdict import Range
from placecat.thesis.rules import Rules, claimed_range

RULES = Rules(
    level=0.95, resamples=2000, minimum_units=4, few_homes=2, about=0.5, margin=2.0, noticeable=1.0, rare=0.05
)
INFINITE = float("inf")


@pytest.mark.parametrize(
    ("kind", "published", "claimed"),
    [
        (("better", None), np.nan, Range(0.0, INFINITE)),
        (("worse", None), np.nan, Range(-INFINITE, 0.0)),
        (("about", None), 3.26, Range(1.63, 4.89)),
        (("about", None), -5.0, Range(-7.5, -2.5)),
        (("little", None), np.nan, Range(-2.0, 2.0)),
        (("no_better", None), np.nan, Range(-INFINITE, 2.0)),
        (("within", 3.0), np.nan, Range(-3.0, 3.0)),
        (("above", 99.0), np.nan, Range(0.0, INFINITE)),
        (("both_signs", None), np.nan, None),
    ],
)
def test_claimed_ranges(kind, published, claimed):
    assert claimed_range(kind, published, RULES) == claimed


@pytest.mark.parametrize(
    ("kind", "message"),
    [
        (("bigger", None), "unknown range 'bigger'; choose one of better"),
        (("about", None), "needs a published difference"),
        (("within", None), "'within' needs a number"),
        (("better", 2.0), "'better' takes no number"),
    ],
)
def test_invalid_ranges_are_rejected(kind, message):
    with pytest.raises(PlacecatError, match=message):
        claimed_range(kind, float("nan"), RULES)
