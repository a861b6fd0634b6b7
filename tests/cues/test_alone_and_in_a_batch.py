"""Every cue returns bit-identical results for a frame alone and in a batch."""

import numpy as np
import pytest

from placecat import cues, lookup
from placecat.cues import Codebook, Descriptors
from placecat.fusion import integrate, votes

PLACES = ["bedroom", "kitchen", "bathroom", "hallway"]
TREE = {"name": "hierarchical_kmeans", "max_clusters": 31, "branching": 4, "max_iter": 5}
SVM = {"name": "nu_svm", "gamma": 2.0, "nu": 0.2}
BOOSTING = {"name": "gentle_adaboost", "n_rounds": 12}
# Classifiers by model name. Add the classifiers of a new model here.
CLASSIFIERS = {
    "discriminative_regions": [
        {"cue": {"model": "joint_probability", "base": {"name": "naive_bayes"}}, "clusters": 31, "keep": 0.5},
    ],
    "joint_probability": [
        {"base": {"name": "naive_bayes"}, "clusters": 31},
        {"base": {"name": "dependency_tree"}, "clusters": 31},
    ],
    "knn": [{"base": {"name": "knn", "n_neighbors": neighbors}, "clusters": 31} for neighbors in (1, 4)],
    "one_against_all": [
        {"base": SVM, "scheme": {"name": "one_against_all"}, "scaling": "standard"},
        {"base": SVM, "scheme": {"name": "sequential"}, "scaling": "unit"},
        {"base": BOOSTING, "scheme": {"name": "one_against_all"}, "scaling": "none"},
        {
            "base": SVM,
            "scheme": {"name": "one_against_all"},
            "scaling": "distance",
            "reduction": {"cells": 2, "components": 5},
        },
    ],
}


def frames(kind, n, seed):
    """Return descriptors of length 26, and labels. Frames have between 0 and 25 regions."""
    rng = np.random.default_rng(seed)
    labels = (np.arange(n) % len(PLACES)).astype(np.int16)
    if kind == "whole":
        return Descriptors((rng.normal(size=(n, 26)) + labels[:, None] / 3).astype(np.float32)), labels
    counts = np.resize([3, 0, 1, 25, 2, 7], n)
    x = (rng.normal(size=(n, 25, 26)) + labels[:, None, None] / 3).astype(np.float32)
    return Descriptors(x, counts), labels


def some_of(of, some):
    return Descriptors(of.x[some], None if of.counts is None else of.counts[some])


def assert_alone_as_in_a_batch(ask, n):
    batch = ask(np.arange(n))
    some = np.random.default_rng(1).permutation(n)
    assert np.array_equal(ask(some), batch[some])
    assert np.array_equal(ask(some[: n // 4]), batch[some[: n // 4]])
    for place in range(n):
        assert np.array_equal(ask(np.array([place])), batch[place : place + 1]), place


@pytest.mark.parametrize("kind", ["whole", "regions"])
@pytest.mark.parametrize("model", lookup.names("placecat.cues", "fit"))
def test_a_frame_does_not_depend_on_its_batch(model, kind):
    if kind == "whole" and cues.of_regions_only(model):
        return
    train, labels = frames(kind, 96, seed=0)
    asked, _ = frames(kind, 260 if kind == "whole" else 60, seed=1)
    homes = np.repeat(["A", "B", "C"], 32)
    codebook = Codebook.fit(
        train, cells=2 if (kind, model) == ("whole", "joint_probability") else 1, seed=3, tree=TREE
    )
    assert_alone_as_in_a_batch(lambda some: codebook.words(some_of(asked, some), 31), len(asked))
    for settings in CLASSIFIERS[model]:
        classifier = {"model": model, **settings}
        if kind == "regions" and "scheme" in settings:
            classifier["max_rows"] = 200
        cue = cues.fit(train, labels, homes, classifier=classifier, classes=PLACES, codebook=codebook)
        assert_alone_as_in_a_batch(lambda some, cue=cue: cue.predict_proba(some_of(asked, some)), len(asked))


def test_a_single_frame_without_regions_is_uniform():
    train, labels = frames("regions", 96, seed=0)
    classifier = {"model": "one_against_all", **CLASSIFIERS["one_against_all"][2]}
    cue = cues.fit(train, labels, np.repeat(["A", "B"], 48), classifier=classifier, classes=PLACES)
    nothing = Descriptors(np.zeros((1, 25, 26), np.float32), np.array([0]))
    assert cue.predict_proba(nothing).tolist() == [[0.25] * 4]


def test_integrated_frames():
    rng = np.random.default_rng(0)
    proba = rng.dirichlet(np.ones(4), (300, 9))
    labels = (np.arange(300) % 4).astype(np.int16)
    classifier = {"model": "one_against_all", **CLASSIFIERS["one_against_all"][0]}
    homes = {name: proba[100 * k : 100 * k + 100] for k, name in enumerate("ABC")}
    truth = {name: labels[100 * k : 100 * k + 100] for k, name in enumerate("ABC")}
    for temperatures in (None, np.linspace(0.3, 3.0, 9)):
        model = integrate.fit(
            homes,
            truth,
            PLACES,
            method="das",
            classifier=classifier,
            temperatures=temperatures,
            cross_validated=False,
        ).integrator
        assert_alone_as_in_a_batch(lambda some, model=model: model.predict_proba(proba[some]), 300)
    for vote in (votes.vote_decision, votes.vote_distribution):
        assert_alone_as_in_a_batch(lambda some, vote=vote: vote(proba[some]), 300)
