import numpy as np
import pytest
from sklearn.naive_bayes import BernoulliNB, CategoricalNB

from placecat import cues
from placecat.cues import Codebook, Descriptors, estimators
from placecat.errors import PlacecatError

PLACES = ["bedroom", "kitchen", "bathroom"]
TREE = {"name": "hierarchical_kmeans", "max_clusters": 13, "branching": 4, "max_iter": 5}


def regions(seed=0, frames=120, most=5):
    rng = np.random.default_rng(seed)
    labels = np.arange(frames) % 3
    counts = rng.integers(1, most + 1, frames)
    x = (rng.normal(size=(frames, most, 4)) + labels[:, None, None]).astype(np.float32)
    homes = np.repeat(["A", "B", "C", "D"], frames // 4)
    return Descriptors(x, counts), labels.astype(np.int16), homes


def whole(seed=0, frames=120):
    rng = np.random.default_rng(seed)
    labels = np.arange(frames) % 3
    x = (rng.normal(size=(frames, 16)) + labels[:, None]).astype(np.float32)
    return Descriptors(x), labels.astype(np.int16), np.repeat(["A", "B", "C", "D"], frames // 4)


def naive_bayes(clusters):
    return {
        "model": "joint_probability",
        "base": {"name": "naive_bayes", "alpha": 1.0, "prior": "uniform"},
        "clusters": clusters,
    }


def test_activations_of_regions_reach_naive_bayes():
    """The result equals that of scikit-learn's BernoulliNB on activations from a loop."""
    train, labels, homes = regions()
    codebook = Codebook.fit(train, cells=1, seed=3, tree=TREE)
    model = cues.fit(train, labels, homes, classifier=naive_bayes(13), classes=PLACES, codebook=codebook)
    active = np.zeros((len(train), 13), int)
    centers = codebook.trees[0].centers(13)
    for frame in range(len(train)):
        for region in range(train.counts[frame]):
            distance = ((train.x[frame, region] - centers) ** 2).sum(axis=1)
            active[frame, distance.argmin()] = 1
    expected = BernoulliNB(alpha=1.0, fit_prior=False).fit(active, labels).predict_proba(active)
    np.testing.assert_allclose(model.predict_proba(train), expected, atol=1e-9)


def test_codewords_of_cells_reach_naive_bayes():
    train, labels, homes = whole()
    codebook = Codebook.fit(train, cells=4, seed=3, tree=TREE)
    model = cues.fit(train, labels, homes, classifier=naive_bayes(7), classes=PLACES, codebook=codebook)
    words = codebook.words(train, 7)
    assert words.shape == (120, 4)
    expected = CategoricalNB(alpha=1.0, fit_prior=False, min_categories=7).fit(words, labels)
    np.testing.assert_allclose(model.predict_proba(train), expected.predict_proba(words), atol=1e-9)


def test_a_codebook_survives_conversion_to_arrays():
    train, _, _ = whole()
    codebook = Codebook.fit(train, cells=4, seed=1, tree=TREE)
    arrays = codebook.to_arrays()
    assert not any(array.dtype.hasobject for array in arrays.values())
    again = Codebook.from_arrays(arrays)
    np.testing.assert_array_equal(again.words(train, 10), codebook.words(train, 10))


def test_boosting_on_regions_multiplies_their_distributions():
    train, labels, homes = regions()
    classifier = {
        "model": "one_against_all",
        "base": {"name": "gentle_adaboost", "n_rounds": 5},
        "scheme": {"name": "one_against_all"},
        "scaling": "none",
    }
    model = cues.fit(train, labels, homes, classifier=classifier, classes=PLACES)
    proba = model.predict_proba(train)
    single = model.scheme.predict_proba(train.x[7, : train.counts[7]])
    expected = single.prod(axis=0)
    np.testing.assert_allclose(proba[7], expected / expected.sum(), rtol=1e-9)
    assert (proba.argmax(axis=1) == labels).mean() > 0.8


def test_nearest_neighbours_take_regions_and_whole_frames():
    for (train, labels, homes), cells in ((regions(), 1), (whole(), 1)):
        codebook = Codebook.fit(train, cells=cells, seed=0, tree=TREE)
        classifier = {"model": "knn", "base": {"name": "knn", "n_neighbors": 1}, "clusters": 13}
        model = cues.fit(train, labels, homes, classifier=classifier, classes=PLACES, codebook=codebook)
        assert (model.predict_proba(train).argmax(axis=1) == labels).mean() > 0.6


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (
            {"model": "magic"},
            "'magic' does not exist: use one of discriminative_regions, joint_probability, knn",
        ),
        ({"model": "joint_probability", "cluster": 3}, "no setting 'cluster'; did you mean 'clusters'"),
        ({**naive_bayes(13), "base": {"name": "nave_bayes"}}, r"base\.name 'nave_bayes' does not exist"),
        ({**naive_bayes(13), "base": {"name": "kernels"}}, "'kernels' is not an estimator"),
        ({**naive_bayes(13), "base": {"name": "naive_bayes", "beta": 1}}, "no setting 'beta'"),
        (naive_bayes(13), "needs a codebook"),
    ],
)
def test_invalid_classifiers_are_rejected(change, message):
    train, labels, homes = regions()
    codebook = None if "codebook" in message else Codebook.fit(train, cells=1, seed=0, tree=TREE)
    with pytest.raises(PlacecatError, match=message):
        cues.fit(train, labels, homes, classifier=change, classes=PLACES, codebook=codebook)


def test_invalid_cluster_numbers_raise_an_error_with_the_nearest():
    train, labels, homes = regions()
    codebook = Codebook.fit(train, cells=1, seed=0, tree=TREE)
    with pytest.raises(PlacecatError, match=r"\b10\b.*\b13\b"):
        cues.fit(train, labels, homes, classifier=naive_bayes(12), classes=PLACES, codebook=codebook)


def test_a_class_without_training_frames_is_rejected():
    train, labels, homes = regions()
    with pytest.raises(PlacecatError, match="no training frames of attic"):
        cues.fit(train, labels, homes, classifier=naive_bayes(13), classes=[*PLACES, "attic"])


def test_a_descriptor_that_cannot_be_cut_is_rejected():
    train, _, _ = whole()
    with pytest.raises(PlacecatError, match="16 values cannot be split into 5 equal cells"):
        Codebook.fit(train, cells=5, seed=0, tree=TREE)


def test_estimators_are_found_by_their_module():
    made = estimators.build({"name": "nu_svm", "gamma": 1.0}, "base", nu=0.1)
    assert (made.gamma, made.nu) == (1.0, 0.1)


def test_cross_validation_does_not_use_the_labels_of_the_held_out_home():
    """The distributions of a home come from a cue fitted on the other homes, whatever its labels are."""
    train, labels, homes = whole()
    classifier = {
        "model": "one_against_all",
        "base": {"name": "nu_svm", "gamma": 2.0, "nu": 0.2},
        "scheme": {"name": "one_against_all"},
        "scaling": "standard",
    }
    proba = cues.cross_validate(train, labels, homes, classifier=classifier, classes=PLACES)
    others = homes != "B"
    model = cues.fit(
        train.take(np.flatnonzero(others)),
        labels[others],
        homes[others],
        classifier=classifier,
        classes=PLACES,
    )
    own = np.flatnonzero(~others)
    np.testing.assert_array_equal(proba[own], model.predict_proba(train.take(own)))
    marked = np.where(others, labels, (labels + 1) % 3)
    again = cues.cross_validate(train, marked, homes, classifier=classifier, classes=PLACES)
    np.testing.assert_array_equal(again[own], proba[own])
    assert (again[homes == "A"] != proba[homes == "A"]).any()


def test_cross_validation_without_homes_to_leave_out(caplog):
    train, labels, homes = regions()
    codebook = Codebook.fit(train, cells=1, seed=3, tree=TREE)
    # Only one home has bathrooms.
    homes = np.where(labels == 2, "A", homes)
    proba = cues.cross_validate(
        train, labels, homes, classifier=naive_bayes(13), classes=PLACES, codebook=codebook
    )
    assert "consecutive frames are left out instead" in caplog.text
    assert proba.shape == (120, 3)
    assert 0.5 < (proba.argmax(axis=1) == labels).mean() < 1.0
