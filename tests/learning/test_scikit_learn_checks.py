"""Every public estimator passes scikit-learn's checks. Exceptions are listed with their reasons."""

import ast
from pathlib import Path

import numpy as np
import pytest
from sklearn.utils.estimator_checks import parametrize_with_checks
from sklearn.utils.validation import check_array

from placecat import learning, lookup
from placecat.errors import PlacecatError
from placecat.learning.dependency_tree import DependencyTree
from placecat.learning.flat_kmeans import FlatKMeans
from placecat.learning.gentle_adaboost import GentleAdaBoost
from placecat.learning.hierarchical_kmeans import HierarchicalKMeans
from placecat.learning.knn import ModifiedKNN
from placecat.learning.naive_bayes import NaiveBayes
from placecat.learning.nu_svm import NuSVM
from placecat.learning.one_against_all import OneAgainstAll
from placecat.learning.rvm import RVM
from placecat.learning.scaling import KernelScaling
from placecat.learning.sequential import Sequential
from placecat.learning.spatial_pca import SpatialPCA

FLOAT32 = {"check_transformer_preserve_dtypes": "descriptors are converted to float32"}
CLUSTERS = "16 clusters need at least 16 distinct points, which these data lack"
NOT_PASSED = {
    "RVM": {"check_non_transformer_estimators_n_iter": "the number of rounds is not kept"},
    "KernelScaling": FLOAT32,
    "SpatialPCA": FLOAT32,
    "ModifiedKNN": {
        "check_n_features_in_after_fitting": CLUSTERS,
        "check_estimators_nan_inf": CLUSTERS,
        "check_classifier_data_not_an_array": CLUSTERS,
        "check_classifiers_one_label": CLUSTERS,
        "check_methods_sample_order_invariance": "it needs 2 clusters, but the tree has 1, 16 or 31",
    },
}


class OfNumbers:
    """An estimator for codes that accepts the arbitrary numbers of the checks, binned into 8 codes."""

    def __sklearn_tags__(self):
        tags = super().__sklearn_tags__()
        tags.input_tags.positive_only = tags.input_tags.categorical = False
        return tags

    def _read_codes(self, X):
        numbers = check_array(X, dtype=np.float64, estimator=self)
        return super()._read_codes(np.clip(np.floor(numbers), -3, 4).astype(int) + 3)


class BinnedNaiveBayes(OfNumbers, NaiveBayes):
    pass


class BinnedDependencyTree(OfNumbers, DependencyTree):
    pass


ESTIMATORS = [
    BinnedNaiveBayes(n_values=8),
    BinnedDependencyTree(n_values=8),
    FlatKMeans(numbers=(2,)),
    HierarchicalKMeans(branching=2, max_clusters=3),
    GentleAdaBoost(n_rounds=5),
    NuSVM(),
    RVM(max_iter=20),
    ModifiedKNN(n_clusters=16),
    KernelScaling(),
    SpatialPCA(cells=1, components=1),
    OneAgainstAll(folds=2, n_jobs=1),
    Sequential(folds=2, n_jobs=1),
]


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore")
@parametrize_with_checks(
    ESTIMATORS, expected_failed_checks=lambda estimator: NOT_PASSED.get(type(estimator).__name__, {})
)
def test_scikit_learn_checks_pass(estimator, check):
    check(estimator)


def test_every_estimator_is_checked():
    tested = {type(one).__name__.removeprefix("Binned") for one in ESTIMATORS}
    there = set()
    for name in lookup.names(learning.__name__):
        tree = ast.parse((Path(learning.__path__[0]) / f"{name}.py").read_text())
        for node in (node for node in tree.body if isinstance(node, ast.ClassDef)):
            if "BaseEstimator" in {getattr(base, "id", None) for base in node.bases}:
                there.add(node.name)
    assert there - {"DiscreteBayes"} <= tested


@pytest.mark.parametrize("estimator", [one for one in ESTIMATORS if hasattr(one, "predict")])
@pytest.mark.parametrize(
    ("samples", "labels", "message"),
    [
        (np.ones((8, 2)) * 1j, [0, 1] * 4, "Complex data not supported"),
        (np.ones((8, 2)), [0, 1, np.nan, 1] * 2, "NaN"),
        (np.ones((8, 2)), [0.5, 1.5] * 4, "Unknown label type"),
        (np.ones((8, 2)), None, "y"),
    ],
)
def test_complex_samples_and_missing_labels_are_rejected(estimator, samples, labels, message):
    from sklearn.base import clone

    if not hasattr(estimator, "classes_") and type(estimator).__name__.endswith("KMeans"):
        pytest.skip("clustering ignores labels")
    with pytest.raises(ValueError, match=message):
        clone(estimator).fit(samples, labels)


def test_a_decision_list_chooses_its_largest_output():
    """This is true by default. With other settings, `predict` may choose another class."""
    X = np.random.default_rng(0).normal(size=(300, 2))
    y = (X[:, 0] > 0).astype(int) + (X[:, 1] > 0)
    scheme = Sequential(folds=2, n_jobs=1).fit(X, y)
    np.testing.assert_array_equal(scheme.predict(X), scheme.classes_[scheme.predict_proba(X).argmax(axis=1)])


def test_two_class_estimators_declare_that_they_are_binary():
    for machine in (NuSVM(), RVM(), GentleAdaBoost()):
        assert not machine.__sklearn_tags__().classifier_tags.multi_class
        with pytest.raises(PlacecatError, match=r"Only binary classification is supported.* 3 classes"):
            machine.fit(np.eye(6), [0, 1, 2] * 2)
    assert NaiveBayes().__sklearn_tags__().input_tags.categorical
