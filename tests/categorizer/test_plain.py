import json

import numpy as np
import pytest

from placecat.categorizer.plain import from_plain, to_plain
from placecat.errors import PlacecatError
from placecat.fusion.smoothing import SmoothingModel
from placecat.learning.naive_bayes import NaiveBayes
from placecat.learning.nu_svm import NuSVM
from placecat.learning.one_against_all import OneAgainstAll


def through(value):
    arrays = []
    plain = json.loads(json.dumps(to_plain(value, arrays)))
    return from_plain(plain, arrays)


@pytest.mark.parametrize(
    "value",
    [None, True, 3, 0.1, float("inf"), "text", [1, [2.5, None]], (1, (2,)), {"a": 1, 3: (4, 5)}, []],
)
def test_values_survive_a_round_trip(value):
    assert through(value) == value
    assert type(through(value)) is type(value)


def test_numbers_and_arrays_of_numpy_keep_their_types():
    value = {
        "a": np.float32(0.1),
        "b": np.arange(6, dtype=np.int16).reshape(2, 3),
        "c": np.array(["x", "yz"]),
    }
    back = through(value)
    for name in value:
        assert back[name].dtype == value[name].dtype
        np.testing.assert_array_equal(back[name], value[name])
    assert isinstance(back["a"], np.float32)
    assert np.isnan(through(float("nan")))


def test_models_survive_a_round_trip():
    rng = np.random.default_rng(0)
    codes, labels = rng.integers(0, 2, (60, 9)), np.repeat([0, 1, 2], 20)
    bayes = NaiveBayes(n_values=2).fit(codes, labels)
    np.testing.assert_array_equal(through(bayes).predict_proba(codes), bayes.predict_proba(codes))
    svm = OneAgainstAll(NuSVM(gamma=0.3, nu=0.4)).fit(codes, labels)
    np.testing.assert_array_equal(through(svm).predict_proba(codes), svm.predict_proba(codes))
    smoothing = through(SmoothingModel(np.eye(2), np.eye(2), "hard", 1.0, 0.1, 5.0))
    assert (smoothing.delay_seconds, smoothing.frame_rate) == (0.1, 5.0)


@pytest.mark.parametrize(
    "value", [object(), print, lambda: 0, {1, 2}, np.array([object()]), np.random.default_rng()]
)
def test_other_values_are_not_written(value):
    with pytest.raises(TypeError):
        to_plain(value, [])


@pytest.mark.parametrize(
    "plain",
    [
        {"$": "object", "class": "subprocess:Popen", "state": {}},
        {"$": "object", "class": "placecat.files:replacing", "state": {}},
        # Names that a module imports are not its own classes.
        {"$": "object", "class": "placecat.learning.nu_svm:KernelMachine", "state": {}},
        {"$": "object", "class": "placecat.learning.nu_svm:largest_feasible_nu", "state": {}},
        {"$": "object", "class": "placecat.learning.nu_svm:NuSVM", "state": {"__class__": 1}},
        {"$": "object", "class": "placecat.learning.nu_svm:NuSVM", "state": {"a b": 1}},
        {"$": "object", "class": "placecat.learning...os:path", "state": {}},
        {"$": "array", "index": 5},
        {"$": "call", "name": "os.system"},
        {"a": 1},
        {"$": "float", "text": "__import__('os')"},
    ],
)
def test_other_content_is_not_read(plain):
    with pytest.raises(PlacecatError):
        from_plain(plain, [])
