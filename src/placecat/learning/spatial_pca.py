"""A separate PCA for each image cell, or plain PCA if there is only one cell."""

from typing import Self

import numpy as np
from numpy.typing import ArrayLike, NDArray
from sklearn.base import BaseEstimator, TransformerMixin
from sklearn.utils.validation import check_is_fitted

from placecat.errors import NotComputable, PlacecatError
from placecat.learning.checks import check_samples, check_width
from placecat.learning.products import row_products
from placecat.learning.single_thread import single_blas_thread
from placecat.ranges import AtLeastOne, Count
from placecat.schema.signatures import check_parameters


class SpatialPCA(TransformerMixin, BaseEstimator):
    """Reduce each cell's part of a descriptor with a separate PCA (spatial PACT, thesis 4.3).

    With 16 cells, 4096 Centrist dimensions become 16 x 64 = 1024. With one cell and a factor, this is the PCA
    reduction of thesis 4.2 (Table 2). Fit it only on training homes.

    Parameters
    ----------
    cells
        Number of equal, consecutive parts that the D dimensions are divided into.
    components
        Number of dimensions to keep per cell. The thesis keeps 64 of 256.
    factor
        Alternative to `components`: keep 1 / factor of each cell's dimensions, rounded to an integer.
    whiten
        Whether to divide each component by its standard deviation. The thesis does not specify this.

    Attributes
    ----------
    mean_
        (cells, D / cells) float64.
    components_
        (cells, components, D / cells) float64, orthonormal rows in order of decreasing variance. In each row,
        the entry with the largest magnitude is positive.
    explained_variance_
        (cells, components) float64.
    explained_variance_ratio_
        (cells, components) float64, share of the cell's variance that each component explains.
    n_features_in_
        D.

    References
    ----------
    Wu, Christensen and Rehg, Visual place categorization, ICRA 2009 (thesis [80]).

    Examples
    --------
    >>> X = np.array([[1.0, 1, 5, 0], [2, 2, 5, 1], [3, 3, 5, 2]])
    >>> SpatialPCA(cells=2, components=1).fit_transform(X)[:, 1].tolist()
    [-1.0, 0.0, 1.0]
    """

    def __init__(
        self,
        cells: Count = 16,
        components: Count | None = 64,
        factor: AtLeastOne | None = None,
        whiten: bool = False,
    ) -> None:
        self.cells = cells
        self.components = components
        self.factor = factor
        self.whiten = whiten

    def _kept(self, width: int) -> int:
        if (self.components is None) == (self.factor is None):
            raise PlacecatError("set either `components` or `factor` of the PCA; the other must be None")
        kept = round(width / self.factor) if self.factor is not None else int(self.components or 0)
        if not 1 <= kept <= width:
            raise PlacecatError(
                f"the PCA cannot keep {kept} components: use 1 to {width}, the number of dimensions per cell"
            )
        return kept

    def fit(self, X: ArrayLike, y: object = None) -> Self:
        """Fit one PCA per cell to real (n, D) samples X. `y` is ignored.

        Raises PlacecatError if D is not divisible by `cells`, or if the number of components is invalid or
        not less than n.
        """
        check_parameters(self)
        samples = check_samples(X)
        n, total = samples.shape
        if total % self.cells:
            raise PlacecatError(
                f"{total} dimensions cannot be divided into {self.cells} equal cells: change `cells`"
            )
        width = total // self.cells
        kept = self._kept(width)
        if n <= kept:
            raise NotComputable(
                f"PCA with {kept} components needs more than {kept} training samples, but n_samples = {n}"
            )
        self.n_features_in_ = total
        self.mean_ = np.empty((self.cells, width))
        self.components_ = np.empty((self.cells, kept, width))
        self.explained_variance_ = np.empty((self.cells, kept))
        self.explained_variance_ratio_ = np.empty((self.cells, kept))
        with single_blas_thread():
            for cell in range(self.cells):
                part = samples[:, cell * width : (cell + 1) * width].astype(np.float64)
                self.mean_[cell] = part.mean(axis=0)
                part -= self.mean_[cell]
                values, vectors = np.linalg.eigh(part.T @ part / (n - 1))
                rows = vectors.T[::-1][:kept]
                largest = np.abs(rows).argmax(axis=1)
                self.components_[cell] = rows * np.sign(rows[np.arange(kept), largest])[:, None]
                variance = np.maximum(values[::-1][:kept], 0.0)
                self.explained_variance_[cell] = variance
                total_variance = max(float(np.maximum(values, 0.0).sum()), np.finfo(float).tiny)
                self.explained_variance_ratio_[cell] = variance / total_variance
        return self

    def transform(self, X: ArrayLike) -> NDArray[np.float32]:
        """Project finite (n, D) samples to (n, cells * components) float32, ordered by cell.

        Raises PlacecatError for any other input.
        """
        check_is_fitted(self)
        samples = check_samples(X)
        check_width(samples, self)
        cells, kept, width = self.components_.shape
        result = np.empty((len(samples), cells * kept), dtype=np.float32)
        for cell in range(cells):
            axes = self.components_[cell]
            if self.whiten:
                deviation = np.sqrt(self.explained_variance_[cell])
                axes = axes * np.divide(1.0, deviation, out=np.zeros(kept), where=deviation > 1e-12)[:, None]
            part = samples[:, cell * width : (cell + 1) * width] - self.mean_[cell].astype(np.float32)
            result[:, cell * kept : (cell + 1) * kept] = row_products(part, axes.astype(np.float32))
        return result
