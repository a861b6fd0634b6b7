import numpy as np
import pytest
from sklearn.decomposition import PCA

from placecat.errors import PlacecatError
from placecat.learning.spatial_pca import SpatialPCA

X = (np.random.default_rng(0).normal(size=(40, 12)) * np.arange(1, 13)).astype(np.float32)
TEST = np.random.default_rng(1).normal(size=(5, 12)).astype(np.float32)


@pytest.mark.parametrize("whiten", [False, True])
def test_against_one_scikit_learn_pca_per_cell(whiten):
    ours = SpatialPCA(cells=3, components=2, whiten=whiten).fit(X)
    result = ours.transform(TEST)
    for cell in range(3):
        part = slice(4 * cell, 4 * cell + 4)
        theirs = PCA(2, svd_solver="full", whiten=whiten).fit(X[:, part].astype(float))
        sign = np.sign((theirs.components_ * ours.components_[cell]).sum(axis=1))
        np.testing.assert_allclose(
            result[:, 2 * cell : 2 * cell + 2],
            theirs.transform(TEST[:, part].astype(float)) * sign,
            atol=1e-4,
        )
        np.testing.assert_allclose(ours.explained_variance_[cell], theirs.explained_variance_, rtol=1e-5)
        np.testing.assert_allclose(
            ours.explained_variance_ratio_[cell], theirs.explained_variance_ratio_, rtol=1e-5
        )


def test_largest_entry_of_each_axis_is_positive():
    axes = SpatialPCA(cells=2, components=3).fit(-X).components_
    assert (np.take_along_axis(axes, np.abs(axes).argmax(-1)[..., None], -1) > 0).all()


@pytest.mark.parametrize(("factor", "width"), [(2.0, 6), (4.0, 3), (8.0, 2)])
def test_plain_reduction_by_a_factor(factor, width):
    pca = SpatialPCA(cells=1, components=None, factor=factor)
    assert pca.fit_transform(X).shape == (40, width)


@pytest.mark.parametrize(
    ("pca", "message"),
    [
        (SpatialPCA(cells=5), "12 dimensions cannot be divided into 5 equal cells"),
        (SpatialPCA(cells=3, components=5), "the PCA cannot keep 5 components: use 1 to 4"),
        (SpatialPCA(cells=3, components=2, factor=2.0), "set either `components` or `factor`"),
        (
            SpatialPCA(cells=1, components=None, factor=0.5),
            "factor=0.5: it must be greater than or equal to 1",
        ),
    ],
)
def test_messages(pca, message):
    with pytest.raises(PlacecatError, match=message):
        pca.fit(X)
    with pytest.raises(PlacecatError, match="needs more than 4 training samples, but n_samples = 4"):
        SpatialPCA(cells=3, components=4).fit(X[:4])
