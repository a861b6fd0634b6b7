import numpy as np
import pytest
from scipy.spatial.distance import pdist
from sklearn.base import clone
from sklearn.preprocessing import MinMaxScaler, StandardScaler, normalize

from placecat.errors import PlacecatError
from placecat.learning.scaling import KINDS, KernelScaling

X = np.random.default_rng(0).normal(2.0, [1.0, 5.0, 0.1, 3.0], (30, 4)).astype(np.float32)
TEST = np.random.default_rng(1).normal(2.0, 9.0, (5, 4)).astype(np.float32)


@pytest.mark.parametrize(
    ("kind", "oracle"),
    [
        ("none", lambda: TEST),
        ("minmax", lambda: MinMaxScaler().fit(X).transform(TEST)),
        ("standard", lambda: StandardScaler().fit(X).transform(TEST) / 2.0),
        ("distance", lambda: (TEST - X.mean(0)) / np.sqrt((pdist(X.astype(float)) ** 2).mean())),
        ("unit", lambda: normalize(TEST)),
    ],
)
def test_against_scikit_learn_and_scipy(kind, oracle):
    scaled = KernelScaling(kind).fit(X).transform(TEST)
    assert scaled.dtype == np.float32
    np.testing.assert_allclose(scaled, oracle(), rtol=1e-4, atol=1e-5)


@pytest.mark.parametrize(("kind", "mean"), [("standard", 2.0 * 30 / 29), ("distance", 1.0)])
def test_mean_squared_distance_is_as_stated(kind, mean):
    scaled = KernelScaling(kind).fit_transform(X).astype(np.float64)
    assert (pdist(scaled) ** 2).mean() == pytest.approx(mean, rel=1e-5)


def test_constant_dimensions():
    constant = np.array([[1.0, 1 / 3], [3.0, 1 / 3]])
    test = np.array([[2.0, 100.0]])
    assert KernelScaling("minmax").fit(constant).transform(test).tolist() == [[0.5, 0.0]]
    assert KernelScaling("standard").fit(constant).transform(test).tolist() == [[0.0, 0.0]]
    assert np.isfinite(KernelScaling("distance").fit(constant[:1]).transform(test)).all()
    assert KernelScaling("unit").fit_transform(np.zeros((1, 2))).tolist() == [[0.0, 0.0]]


@pytest.mark.parametrize("kind", KINDS)
def test_clone(kind):
    scaling = KernelScaling(kind).fit(X)
    assert np.array_equal(clone(scaling).fit(X).transform(TEST), scaling.transform(TEST))


def test_messages():
    with pytest.raises(PlacecatError, match="kind=log: it must be 'none', 'minmax'"):
        KernelScaling("log").fit(X)
    with pytest.raises(PlacecatError, match="X has 2 features, but KernelScaling is expecting 4"):
        KernelScaling().fit(X).transform([[1.0, 2.0]])
