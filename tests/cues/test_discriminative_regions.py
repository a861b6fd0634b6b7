import numpy as np
import pytest

from placecat import cues
from placecat.cues import Codebook, Descriptors
from placecat.cues.discriminative_regions import only
from placecat.errors import PlacecatError

PLACES = ["bedroom", "kitchen", "bathroom"]
TREE = {"name": "hierarchical_kmeans", "max_clusters": 13, "branching": 4, "max_iter": 5}
NAIVE_BAYES = {
    "model": "joint_probability",
    "base": {"name": "naive_bayes", "alpha": 1.0, "prior": "uniform"},
    "clusters": 13,
}
KNN = {
    "model": "knn",
    "base": {"name": "knn", "n_neighbors": 1, "smoothing": 1.0, "class_weighting": "once"},
    "clusters": 13,
}


def frames(seed=0, number=120, most=6):
    """Return frames in which every second region shows the place. The others do not depend on it."""
    rng = np.random.default_rng(seed)
    labels = np.arange(number) % 3
    counts = rng.integers(0, most + 1, number)
    x = rng.normal(0, 0.3, (number, most, 4))
    x[:, ::2, 0] += 10 + 5 * labels[:, None]
    x[:, 1::2, 1] += 20 * rng.random((number, most // 2))
    homes = np.repeat(["A", "B", "C", "D"], number // 4)
    return Descriptors(x.astype(np.float32), counts), labels.astype(np.int16), homes


def discriminative(keep, cue=NAIVE_BAYES):
    return {"model": "discriminative_regions", "clusters": 13, "keep": keep, "cue": cue}


def fit(classifier, train, labels, homes):
    codebook = Codebook.fit(train, cells=1, seed=3, tree=TREE)
    return cues.fit(train, labels, homes, classifier=classifier, classes=PLACES, codebook=codebook)


@pytest.mark.parametrize("cue", [NAIVE_BAYES, KNN])
def test_keeping_all_codewords_is_equivalent_to_the_cue_itself(cue):
    data, new = frames(), frames(1)[0]
    found = fit(discriminative(1.0, cue), *data).predict_proba(new)
    np.testing.assert_array_equal(found, fit(cue, *data).predict_proba(new))


def test_regions_of_other_codewords_are_ignored():
    train, labels, homes = frames()
    model = fit(discriminative(0.3), train, labels, homes)
    new = frames(1)[0]
    words = model.codebook.words(new, 13)
    dropped = (words >= 0) & ~model.kept[words]
    assert dropped.any()
    before = model.predict_proba(new)
    # Replace each of them with a dropped region of a training frame.
    words = model.codebook.words(train, 13)
    other = train.x[(words >= 0) & ~model.kept[words]][0]
    new.x[dropped] = other
    np.testing.assert_array_equal(model.predict_proba(new), before)


def test_regions_that_show_the_place_are_kept():
    train, labels, homes = frames()
    model = fit(discriminative(0.3), train, labels, homes)
    words = model.codebook.words(train, 13)
    share = [model.kept[part[part >= 0]].mean() for part in (words[:, ::2], words[:, 1::2])]
    assert share[0] > 0.9
    assert share[1] < 0.1
    assert model.facts["kept_codewords"] == 4


def test_only_moves_the_kept_regions_to_the_front():
    x = np.arange(12, dtype=np.float32).reshape(2, 3, 2)
    words = np.array([[2, 0, 1], [0, -1, -1]], np.int32)
    found = only(Descriptors(x, np.array([3, 1])), words, np.array([False, True, True]))
    assert found.counts.tolist() == [2, 0]
    assert found.x.tolist() == [[[0, 1], [4, 5], [0, 0]], [[0, 0], [0, 0], [0, 0]]]


def test_padding_is_never_taken_for_a_region():
    # As an index, the padding -1 would be the last codeword.
    x = np.ones((1, 2, 2), np.float32)
    found = only(Descriptors(x, np.array([1])), np.array([[0, -1]], np.int32), np.array([True, True]))
    assert found.counts.tolist() == [1]


def test_whole_frames_are_rejected():
    train = Descriptors(np.zeros((6, 4), np.float32))
    with pytest.raises(PlacecatError, match="codebook of salient regions"):
        cues.fit(
            train,
            np.array([0, 1, 2] * 2, np.int16),
            np.array(["A"] * 6),
            classifier=discriminative(0.5),
            classes=PLACES,
            codebook=Codebook([], of_sets=False),
        )
