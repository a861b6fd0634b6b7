"""Naive Bayes over codewords (thesis equation 12)."""

from typing import Annotated

import numpy as np
from numpy.typing import NDArray

from placecat.learning.contingency import value_counts
from placecat.learning.discrete_bayes import PRIORS, DiscreteBayes
from placecat.learning.products import row_products
from placecat.ranges import OneOf, Positive, Two

# Number of table look-ups per block.
_BLOCK = 1 << 18


class NaiveBayes(DiscreteBayes):
    """Model of p(c_1 = q_1, ..., c_V = q_V | l_i) as the product of all p(c_k = q_k | l_i) (equation 12).

    The variables are either the codewords of the 16 image cells (section 4.2) or the activations of a
    codebook's clusters (3.3.2). With activations, the *absence* of a cluster is evidence too.

    Parameters
    ----------
    alpha, n_values, prior
        See `DiscreteBayes`.

    Attributes
    ----------
    feature_log_prob_
        (n_classes, V, n_values_) float64, log p(c_k = q | l_i).
    classes_, class_count_, class_log_prior_, n_values_, n_features_in_
        See `DiscreteBayes`.

    Examples
    --------
    >>> X = np.array([[0, 1], [0, 1], [2, 1], [2, 0]])
    >>> model = NaiveBayes(n_values=3).fit(X, ["bedroom", "bedroom", "kitchen", "kitchen"])
    >>> model.predict([[0, 1], [2, 2]]).tolist()
    ['bedroom', 'kitchen']
    >>> model.predict_proba([[0, 1]]).round(3).tolist()
    [[0.818, 0.182]]
    """

    def __init__(
        self,
        alpha: Positive = 1.0,
        n_values: Two | None = None,
        prior: Annotated[str, OneOf(PRIORS)] = "uniform",
    ) -> None:
        self.alpha = alpha
        self.n_values = n_values
        self.prior = prior

    def _fit_model(self, codes: NDArray[np.integer], labels: NDArray[np.intp]) -> None:
        counts = value_counts(codes, labels, len(self.classes_), self.n_values_)
        total = self.class_count_[:, None, None] + self.alpha * self.n_values_
        self.feature_log_prob_ = np.log(counts + self.alpha) - np.log(total)

    def _log_likelihood(self, codes: NDArray[np.integer]) -> NDArray[np.float64]:
        absent = self.feature_log_prob_[:, :, 0]
        if self.n_values_ == 2:
            gain = self.feature_log_prob_[:, :, 1] - absent
            return row_products(codes, gain) + absent.sum(axis=1)
        n, n_variables = codes.shape
        # Use one row per (variable, value), so that a look-up reads all classes at once.
        table = np.ascontiguousarray(self.feature_log_prob_.reshape(len(self.classes_), -1).T)
        offsets = np.arange(n_variables) * self.n_values_
        result = np.empty((n, len(self.classes_)))
        rows = max(1, _BLOCK // n_variables)
        for start in range(0, n, rows):
            result[start : start + rows] = table[codes[start : start + rows] + offsets].sum(axis=1)
        return result
