"""The optimal first-order dependency tree over codewords (thesis equation 11)."""

from typing import Annotated

import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError
from placecat.learning.contingency import (
    binary_information,
    both_ones,
    maximum_spanning_tree,
    mutual_information,
    value_counts,
)
from placecat.learning.discrete_bayes import PRIORS, DiscreteBayes
from placecat.ranges import Index, OneOf, Positive, Two

# Tables of pair counts with at most this many cells (32 MB) are stored in full. Larger tables store only the
# pairs that occur.
_DENSE_CELLS = 1 << 22
# Number of table look-ups per block.
_BLOCK = 1 << 18


class DependencyTree(DiscreteBayes):
    """Model of p(c_1, ..., c_V | l_i) with an optimal dependency tree per class (equation 11).

    The model is the product of p(c_r | l_i) for the root r and p(c_k | c_parent(k), l_i) for all other
    variables. Each class's tree is the maximum spanning tree of the mutual information within that class. Of
    all trees, it is the one that maximises the likelihood of the class's samples (Chow and Liu). The mutual
    information is computed from relative frequencies. Only the conditional probabilities are smoothed.

    Parameters
    ----------
    alpha, n_values, prior
        See `DiscreteBayes`. `alpha` is added to the count of each combination of a variable's value and its
        parent's value.
    root
        The root variable r. Without smoothing, the choice would make no difference. The thesis does not
        specify it.

    Attributes
    ----------
    parents_
        (n_classes, V) int32, the parent of each variable in each class's tree, with -1 for the root.
    classes_, class_count_, class_log_prior_, n_values_, n_features_in_
        See `DiscreteBayes`.

    References
    ----------
    Chow and Liu, "Approximating discrete probability distributions with dependence trees", IEEE
    Transactions on Information Theory 14(3), 1968.

    Examples
    --------
    >>> import numpy as np
    >>> X = np.array([[0, 0, 0], [1, 1, 0], [0, 0, 1], [1, 1, 1]])
    >>> model = DependencyTree(n_values=2).fit(X, ["kitchen"] * 4)
    >>> model.parents_.tolist()
    [[-1, 0, 0]]
    >>> np.exp(model.predict_joint_log_likelihood([[0, 0, 0], [0, 1, 0]])).round(4).ravel().tolist()
    [0.1875, 0.0625]
    """

    def __init__(
        self,
        alpha: Positive = 1.0,
        n_values: Two | None = None,
        prior: Annotated[str, OneOf(PRIORS)] = "uniform",
        root: Index = 0,
    ) -> None:
        self.alpha = alpha
        self.n_values = n_values
        self.prior = prior
        self.root = root

    def _fit_model(self, codes: NDArray[np.integer], labels: NDArray[np.intp]) -> None:
        if self.root >= self.n_features_in_:
            raise PlacecatError(f"root={self.root} is not a variable: use 0 to {self.n_features_in_ - 1}")
        n_classes, n_values = len(self.classes_), self.n_values_
        self._is_dense = n_classes * self.n_features_in_ * n_values**2 <= _DENSE_CELLS
        self._pair_keys: list[NDArray[np.integer]] = []
        self._pair_logs: list[NDArray[np.float64]] = []
        members = [codes[labels == label] for label in range(n_classes)]
        if n_values == 2 and self._is_dense:
            counts = self._fit_binary(members)
        else:
            self.parents_ = np.array(
                [maximum_spanning_tree(mutual_information(part, n_values), self.root) for part in members]
            )
            counts = value_counts(codes, labels, n_classes, n_values)
            self._fit_pairs(members)
        parent_counts = np.take_along_axis(counts, self.parents_[:, :, None].astype(np.intp), axis=1)
        # The root is treated as if it had a parent whose value is always 0.
        parent_counts[:, self.root, 0] = self.class_count_
        self._log_parents = np.log(parent_counts + self.alpha * n_values)

    def _fit_binary(self, members: list[NDArray[np.integer]]) -> NDArray[np.int64]:
        """Fit trees and tables with one matrix product per class. Return (n_classes, V, 2) value counts."""
        parents, counts = [], []
        for part in members:
            both, n = both_ones(part), len(part)
            tree = maximum_spanning_tree(binary_information(both, n), self.root)
            ones = np.diagonal(both)
            with_parent = both[np.arange(len(tree)), tree]
            parent_ones = ones[tree]
            with_parent[self.root] = parent_ones[self.root] = 0
            only, parent_only = ones - with_parent, parent_ones - with_parent
            cells = np.stack([n - ones - parent_only, only, parent_only, with_parent], axis=1)
            self._pair_logs.append(np.log(np.arange(n + 1) + self.alpha)[cells.ravel()])
            parents.append(tree)
            counts.append(np.stack([n - ones, ones], axis=1))
        self.parents_ = np.array(parents)
        return np.array(counts)

    def _fit_pairs(self, members: list[NDArray[np.integer]]) -> None:
        """Store log(count + alpha) for each (variable, parent value, value), in full or sparsely."""
        n_cells = self.n_features_in_ * self.n_values_**2
        for label, part in enumerate(members):
            pairs = self._pairs(part, label)[0]
            if self._is_dense:
                counts = np.bincount(pairs.ravel(), minlength=n_cells)
            else:
                keys, counts = np.unique(pairs, return_counts=True)
                self._pair_keys.append(keys)
            self._pair_logs.append(np.log(np.arange(len(part) + 1) + self.alpha)[counts])

    def _pairs(
        self, codes: NDArray[np.integer], label: int
    ) -> tuple[NDArray[np.integer], NDArray[np.integer]]:
        """Return the cells of all (variable, parent value, value) and (variable, parent value) tuples."""
        narrow = self.n_features_in_ * self.n_values_**2 < 2**31
        wide_codes: NDArray[np.integer] = codes.astype(np.int32 if narrow else np.int64)
        # Indexing with a list would return a column-ordered array, and numpy would sum its rows in a
        # different order.
        parent_cells = np.take(wide_codes, self.parents_[label], axis=1)
        parent_cells[:, self.root] = 0
        parent_cells += np.arange(self.n_features_in_, dtype=wide_codes.dtype) * self.n_values_
        return parent_cells * self.n_values_ + wide_codes, parent_cells

    def _log_pairs(self, pairs: NDArray[np.integer], label: int) -> NDArray[np.float64]:
        if self._is_dense:
            return self._pair_logs[label][pairs]
        keys = self._pair_keys[label]
        places = np.minimum(np.searchsorted(keys, pairs), len(keys) - 1)
        return np.where(keys[places] == pairs, self._pair_logs[label][places], np.log(self.alpha))

    def _log_likelihood(self, codes: NDArray[np.integer]) -> NDArray[np.float64]:
        result = np.empty((len(codes), len(self.classes_)))
        rows = max(1, _BLOCK // self.n_features_in_)
        for label in range(len(self.classes_)):
            log_parents = self._log_parents[label].ravel()
            for start in range(0, len(codes), rows):
                pairs, parent_cells = self._pairs(codes[start : start + rows], label)
                logs = self._log_pairs(pairs, label) - log_parents[parent_cells]
                result[start : start + rows, label] = logs.sum(axis=1)
        return result
