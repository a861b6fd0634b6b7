import threading

import numpy as np
import pytest

from placecat.learning.calibration import CALIBRATIONS
from placecat.learning.gentle_adaboost import GentleAdaBoost
from placecat.learning.memory import content, remembered, remembering
from placecat.learning.nu_svm import NuSVM
from placecat.learning.one_against_all import OneAgainstAll
from placecat.learning.rvm import RVM


def count(calls, *key, latest=False):
    def compute():
        calls.append(key)
        return len(calls)

    return remembered("it", key, compute, latest=latest)


def test_results_are_kept_inside_the_block_only():
    calls = []
    assert [count(calls, 1), count(calls, 1)] == [1, 2]
    with remembering():
        assert [count(calls, 1), count(calls, 1)] == [3, 3]
    assert count(calls, 1) == 4


def test_arrays_are_compared_by_identity_and_stay_alive():
    calls = []
    with remembering():
        assert len({count(calls, np.zeros(100)) for _ in range(50)}) == 50
        one = np.zeros(3)
        assert count(calls, one, 2.0) == count(calls, one, 2.0) != count(calls, one, 3.0)


def test_only_the_latest_result_is_kept_if_requested():
    calls = []
    with remembering():
        for value in (1, 1, 2, 1):
            count(calls, value, latest=True)
    assert [key for (key,) in calls] == [1, 2, 1]


def test_other_threads_do_not_see_the_cache():
    calls = []
    with remembering():
        count(calls, 1)
        thread = threading.Thread(target=count, args=(calls, 1))
        thread.start()
        thread.join()
    assert len(calls) == 2


def test_checksums_depend_on_values_dtype_and_shape():
    x = np.arange(6)
    with remembering():
        assert content(x) == content(x.copy())
        others = (x + 1, x.astype(np.int32), x.reshape(2, 3), x[::-1])
        assert len({content(x), *map(content, others)}) == 5


@pytest.mark.parametrize(
    "base", [NuSVM(nu=0.3), RVM(), GentleAdaBoost(4)], ids=lambda base: type(base).__name__
)
def test_sharing_machines_does_not_change_the_results(base):
    rng = np.random.default_rng(2)
    y = np.repeat([0, 1, 2], 12)
    X = (y[:, None] + rng.normal(size=(36, 3))).astype(np.float32)
    homes = np.tile(np.arange(4), 9)
    schemes = [
        OneAgainstAll(base, calibration=kind, sigmoid="platt", exclusive=exclusive, folds=3)
        for kind in CALIBRATIONS
        for exclusive in (True, False)
    ]
    alone = [scheme.fit(X, y, homes).predict_proba(X) for scheme in schemes]
    with remembering():
        shared = [scheme.fit(X, y, homes).predict_proba(X) for scheme in schemes]
    np.testing.assert_array_equal(shared, alone)
    assert len(np.unique(np.array(alone).reshape(len(alone), -1), axis=0)) > len(CALIBRATIONS)
