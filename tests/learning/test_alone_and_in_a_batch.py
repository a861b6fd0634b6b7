"""Every estimator returns bit-identical results for a sample alone, in a batch, and after a restart."""

import importlib
import inspect
import pkgutil

import numpy as np
import pytest
from sklearn.base import BaseEstimator

from placecat import learning
from placecat.learning.discrete_bayes import DiscreteBayes
from placecat.learning.gentle_adaboost import GentleAdaBoost
from placecat.learning.kernels import KernelExpansion
from placecat.learning.scaling import KINDS

# Hundreds of rows, but not a multiple of the tile size.
N, WIDTH, CLASSES = 257, 37, 11
# Settings to test, where {} stands for the defaults. Other estimators are tested only with their defaults.
SETTINGS = {
    "DependencyTree": [{"n_values": 2}, {"n_values": 9}],
    "FlatKMeans": [{"numbers": (46,)}],
    "HierarchicalKMeans": [{"max_clusters": 46}],
    "KernelScaling": [{"kind": kind} for kind in KINDS],
    "ModifiedKNN": [
        {"n_clusters": 46, "n_neighbors": k, "class_weighting": weighting}
        for k, weighting in ((1, "once"), (5, "per_region"))
    ],
    "NaiveBayes": [{"n_values": 2}, {"n_values": 9}],
    "OneAgainstAll": [
        {},
        {"combination": "certainty", "uncertainty": 0.3},
        {"base": GentleAdaBoost(10), "exclusive": False},
    ],
    "Sequential": [{}, {"output": "decision"}],
    "SpatialPCA": [{"cells": 1, "components": 9, "whiten": whiten} for whiten in (False, True)],
}
METHODS = ("predict_proba", "predict_log_proba", "decision_function", "outputs", "predict", "transform")


def is_abstract(kind):
    return any(getattr(member, "__isabstractmethod__", False) for _, member in inspect.getmembers(kind))


def found():
    """Yield every estimator that a module of placecat.learning defines, with each of its settings."""
    for module in pkgutil.iter_modules(learning.__path__):
        members = inspect.getmembers(importlib.import_module(f"{learning.__name__}.{module.name}"))
        for name, kind in members:
            own = inspect.isclass(kind) and kind.__module__ == f"{learning.__name__}.{module.name}"
            if own and issubclass(kind, BaseEstimator) and not is_abstract(kind) and hasattr(kind, "fit"):
                for settings in SETTINGS.get(name, [{}]):
                    yield pytest.param(kind, settings, id=f"{name}-{settings}")


def samples(kind, settings, seed):
    rng = np.random.default_rng(seed)
    labels = np.arange(N) % CLASSES
    if issubclass(kind, DiscreteBayes):
        return rng.integers(0, settings["n_values"], (N, WIDTH)), labels
    x = (rng.normal(size=(N, WIDTH)) + labels[:, None] * 0.3).astype(np.float32)
    return x / np.float32(np.sqrt(WIDTH)), labels


def questions(model, x):
    """Return the methods that take samples, as functions of row indices into `x`."""
    asked = {name: getattr(model, name) for name in METHODS if hasattr(model, name)}
    answers = {name: lambda some, ask=ask: ask(x[some]) for name, ask in asked.items()}
    if hasattr(model, "assign"):
        answers["assign"] = lambda some: model.assign(x[some], 46)
    if hasattr(model, "predict_proba_sets"):
        sets = np.random.default_rng(5).normal(size=(len(x), 6, WIDTH)).astype(np.float32)
        counts = np.arange(len(x)) % 7
        answers["sets"] = lambda some: model.predict_proba_sets(sets[some], counts[some])
    assert answers, f"{type(model).__name__} has no method that this test can call: add its method here"
    return answers


def restored(value):
    """Return a copy without the attributes that prediction does not need."""
    if isinstance(value, list | tuple):
        return type(value)(restored(item) for item in value)
    if isinstance(value, dict):
        return {key: restored(item) for key, item in value.items()}
    if not type(value).__module__.startswith("placecat"):
        return value
    again = object.__new__(type(value))
    left_out = getattr(type(value), "TRAINING_ONLY", ())
    again.__dict__.update(
        {name: restored(item) for name, item in vars(value).items() if name not in left_out}
    )
    return again


def assert_alone_as_in_a_batch(ask, n):
    rng = np.random.default_rng(1)
    batch = ask(np.arange(n))
    for some in (rng.permutation(n), rng.permutation(n)[: n // 3], np.arange(n)[5:18]):
        assert np.array_equal(ask(some), batch[some])
    for place in range(n):
        assert np.array_equal(ask(np.array([place])), batch[place : place + 1]), place
    return batch


@pytest.mark.parametrize(("kind", "settings"), list(found()))
def test_a_sample_does_not_depend_on_its_batch(kind, settings):
    x, labels = samples(kind, settings, seed=0)
    try:
        model = kind(**settings).fit(x, labels)
    except Exception as error:
        if "2 classes" not in str(error):
            raise
        model = kind(**settings).fit(x, labels > 4)
    asked, _ = samples(kind, settings, seed=1)
    again = questions(restored(model), asked)
    for name, ask in questions(model, asked).items():
        batch = assert_alone_as_in_a_batch(ask, N)
        assert np.array_equal(again[name](np.arange(N)), batch), name


def test_discovery_finds_the_estimators():
    names = {parameters.values[0].__name__ for parameters in found()}
    assert {"NuSVM", "RVM", "GentleAdaBoost", "OneAgainstAll", "ModifiedKNN", "NaiveBayes"} <= names


def test_many_support_vectors():
    """The vectors do not fit into one product, and the samples do not fit into one block."""
    rng = np.random.default_rng(2)
    vectors = rng.normal(size=(950, 70)).astype(np.float32) / 8
    expansion = KernelExpansion(vectors, rng.normal(size=(950, 5)), np.zeros(5), 0.5)
    x = rng.normal(size=(490, 70)).astype(np.float32) / 8
    assert_alone_as_in_a_batch(lambda some: expansion.decisions(x[some]), 490)
