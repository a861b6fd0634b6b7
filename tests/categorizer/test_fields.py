"""The schema of trained models accepts every estimator that can be stored, and rejects invalid content."""

import json

import numpy as np
import pytest
from sklearn.base import clone

from placecat import cues
from placecat.categorizer import fields
from placecat.categorizer.plain import from_plain, to_plain
from placecat.cues import Codebook, Descriptors
from placecat.errors import PlacecatError
from placecat.fusion.integrate import Integrator
from placecat.fusion.smoothing import SmoothingModel
from placecat.learning.dependency_tree import DependencyTree
from placecat.learning.hierarchical_kmeans import HierarchicalKMeans
from placecat.learning.kernels import KernelExpansion

CLASSES = ["bedroom", "kitchen", "bathroom"]
SVM = {"name": "nu_svm", "gamma": 0.01, "nu": 0.3}
TREE = {"name": "hierarchical_kmeans", "max_clusters": 16, "branching": 16, "max_iter": 11}
SCHEME = {
    "model": "one_against_all",
    "base": SVM,
    "scheme": {"name": "one_against_all"},
    "scaling": "standard",
}
JOINT = {"model": "joint_probability", "base": {"name": "naive_bayes"}, "clusters": 16}
WAYS = {
    "svm": SCHEME,
    "svm averaged": SCHEME | {"scheme": {"name": "one_against_all", "calibration": "homes_averaged"}},
    "sequential": SCHEME | {"scheme": {"name": "sequential"}},
    "rvm": SCHEME | {"base": {"name": "rvm", "gamma": 0.01}},
    "boosting": SCHEME | {"base": {"name": "gentle_adaboost", "n_rounds": 3}},
    "reduced": SCHEME | {"reduction": {"cells": 2, "components": 2, "whiten": True}},
    "naive bayes": JOINT,
    "tree": JOINT | {"base": {"name": "dependency_tree"}},
    "knn": {"model": "knn", "base": {"name": "knn", "n_neighbors": 3}, "clusters": 16},
    "regions": {"model": "discriminative_regions", "cue": JOINT, "clusters": 16, "keep": 0.5},
}


def data():
    rng = np.random.default_rng(0)
    labels = np.tile(np.arange(3), 30).astype(np.int16)
    x = rng.random((90, 5, 6), dtype=np.float32) + labels[:, None, None] / 3
    return Descriptors(x, rng.integers(1, 6, 90)), labels, np.repeat(["a", "b", "c"], 30)


def fitted(way):
    sets, labels, homes = data()
    whole = Descriptors(np.ascontiguousarray(sets.x[:, 0]))
    frames = sets if way in ("naive bayes", "tree", "regions", "knn") else whole
    codebook = Codebook.fit(sets, cells=1, seed=1, tree=TREE)
    return cues.fit(frames, labels, homes, classifier=WAYS[way], classes=CLASSES, codebook=codebook), frames


def plain(value):
    arrays = []
    return json.loads(json.dumps(to_plain(value, arrays))), arrays


@pytest.mark.parametrize("way", WAYS)
def test_every_kind_of_model_survives_a_round_trip(way):
    model, frames = fitted(way)
    again = from_plain(*plain(model))
    np.testing.assert_array_equal(again.predict_proba(frames), model.predict_proba(frames))


def test_flat_codebooks_and_sparse_trees_survive_a_round_trip(monkeypatch):
    sets, labels, _ = data()
    flat = Codebook.fit(sets, cells=1, seed=1, tree={"name": "flat_kmeans", "numbers": [4]})
    np.testing.assert_array_equal(from_plain(*plain(flat)).words(sets, 4), flat.words(sets, 4))
    monkeypatch.setattr("placecat.learning.dependency_tree._DENSE_CELLS", 0)
    codes = np.random.default_rng(0).integers(0, 4, (90, 5))
    tree = DependencyTree(n_values=4).fit(codes, labels)
    np.testing.assert_array_equal(from_plain(*plain(tree)).predict_proba(codes), tree.predict_proba(codes))


def smoothing(**changes):
    usual = SmoothingModel(np.full((3, 3), 1 / 3), np.full((3, 3), 1 / 3), "hard", 1.0, 2.0, 5.0)
    return SmoothingModel(**(vars(usual) | changes))


def expansion(**changes):
    usual = KernelExpansion(np.ones((4, 2), np.float32), np.ones((4, 3)), np.ones(3), 1.0)
    return KernelExpansion(**(vars(usual) | changes))


def changed(model, **changes):
    vars(model).update(changes)
    return model


def tree(**changes):
    model = HierarchicalKMeans(branching=2, max_clusters=4).fit(np.arange(12.0)[:, None])
    return changed(clone(model).fit(np.arange(12.0)[:, None]), **changes)


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        (lambda: smoothing(transition=np.ones((3, 3))), "SmoothingModel do not match"),
        (
            lambda: smoothing(transition=np.eye(2)),
            "emission of a SmoothingModel.* size 3, but another",
        ),
        (lambda: smoothing(emission=np.full((3, 3), np.nan)), "emission .*non-finite"),
        (
            lambda: smoothing(emission=np.array([[2.0, -1, 0]] * 3)),
            "emission .*from -1.0 to 2.0, .*out of range",
        ),
        (lambda: smoothing(evidence="os.system"), "evidence .*'hard' or 'soft'"),
        (lambda: smoothing(frame_rate=True), "frame_rate .*=True: it must be a valid number"),
        (lambda: smoothing(frame_rate=float("inf")), "frame_rate .*=inf: it must be"),
        (lambda: smoothing(delay_seconds=10**400), "delay_seconds .*=1000"),
        (lambda: changed(smoothing(), another=1), "has missing or unexpected attributes .another."),
        (lambda: expansion(support_vectors=np.ones(4)), "support_vectors .*2 dimensions"),
        (lambda: expansion(intercept=np.ones(2)), "intercept .*it has size 2"),
        (lambda: expansion(coef=np.ones((4, 3), np.int64)), "coef of a KernelExpansion.*must be an array"),
        (lambda: tree(split_nodes_=np.array([0, 99, 1], np.int32)), "split_nodes_ .*out of range"),
        # A node is split before it exists.
        (lambda: tree(split_nodes_=np.array([3, 0, 1], np.int32)), "HierarchicalKMeans do not match"),
        (lambda: tree(max_clusters_=10**6), "HierarchicalKMeans do not match"),
        (lambda: changed(fitted("knn")[0].estimator, n_neighbors=17), "ModifiedKNN do not match"),
        (
            lambda: changed(fitted("svm")[0].scheme, classes_=np.array([0, 2, 1])),
            "classes_ .*numbers 0, 1, 2",
        ),
        (lambda: changed(fitted("svm")[0].scheme, sigmoid_=np.ones((4, 2))), "has size"),
        (
            lambda: changed(fitted("sequential")[0].scheme, order_=np.array([0, 0, 1])),
            "Sequential do not match",
        ),
        (lambda: changed(fitted("tree")[0].estimator, root=1), "DependencyTree do not match"),
        (lambda: Integrator("das", None), "Integrator do not match"),
        (lambda: Integrator("log_pool", None), "Integrator do not match"),
        (lambda: Integrator("vote_decision", None, np.zeros(2)), "temperatures .*out of range"),
        (lambda: Integrator("log_pool", None, None, np.array([-1.0])), "weights .*out of range"),
        (lambda: Codebook([1.0], of_sets=True), "trees of a Codebook.*methods assign"),
    ],
)
def test_invalid_content_is_rejected(wrong, message):
    written = plain(wrong())
    with pytest.raises(PlacecatError, match=message):
        from_plain(*written)


def test_unlisted_classes_are_not_checked():
    fields.check(type("OneOfYours", (), {}), {"anything": object()})
