"""The variance that homes in a group have in common."""

import numpy as np
import pytest

from placecat.replication.shared import shared_variance

# In the example of Shrout and Fleiss, four judges rate each of six targets; its ICC(1, 1) is 0.17.
RATINGS = [[9, 2, 5, 8], [6, 1, 3, 2], [8, 4, 6, 8], [7, 1, 2, 6], [10, 5, 6, 9], [6, 2, 4, 7]]


def test_the_example_of_the_paper():
    assert shared_variance(np.ravel(RATINGS), np.repeat(range(6), 4)) == pytest.approx(0.17, abs=0.005)


def test_the_share_is_estimated_from_values():
    rng = np.random.default_rng(1)
    groups = np.repeat(range(4000), 6)
    values = np.sqrt(0.2) * rng.standard_normal(4000)[groups] + np.sqrt(0.8) * rng.standard_normal(24000)
    assert shared_variance(values, groups) == pytest.approx(0.2, abs=0.02)
    # Groups may differ in size and come in any order.
    some = rng.permutation(24000)[:9000]
    assert shared_variance(values[some], groups[some]) == pytest.approx(0.2, abs=0.03)


@pytest.mark.parametrize(
    ("values", "groups"), [([1.0, 2.0], [0, 0]), ([1.0, 2.0], [0, 1]), ([3.0, 3.0, 3.0, 3.0], [0, 0, 1, 1])]
)
def test_an_undefined_share_is_nan(values, groups):
    assert np.isnan(shared_variance(values, groups))
