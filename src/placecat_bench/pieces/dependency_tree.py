"""Dependency tree beside pgmpy's: one class's tree and its conditional probabilities, learned from codes.

pgmpy takes two steps. ``TreeSearch`` computes the mutual information of all pairs (by scikit-learn's
``mutual_info_score``) and the maximum spanning tree from the same root (by NetworkX); then
``DiscreteBayesianEstimator`` with the prior K2, which adds 1 to every count as we do, estimates the
probabilities. Both have one process. Ours also checks the codes and splits them by class; pgmpy gets a table
that is ready. The log-likelihoods of all samples show that both learn the same.
"""

import warnings
from collections.abc import Iterator
from functools import partial
from typing import Any

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from placecat.learning.contingency import maximum_spanning_tree, mutual_information
from placecat.learning.dependency_tree import DependencyTree
from placecat_bench.comparison import Comparison, Limit, Peer
from placecat_bench.timing import median_seconds

PIECE = "Dependency tree"
PEER = Peer("pgmpy: TreeSearch and DiscreteBayesianEstimator", "pgmpy")


def entries(
    *, samples: int = 8000, grid: int = 16, clusters: int = 196, few: int = 124, many: int = 496
) -> Iterator[Comparison | Limit]:
    """Yield the tree of the codewords of a grid of cells, and the trees of few and of many activations.

    `samples` are those of the class, `clusters` the values of a cell's codeword. An activation has two
    values; with many of them only ours is timed.
    """
    codes = chained_codes(samples, grid, clusters)
    text = f"{grid} variables x {clusters} values x {samples}"
    yield _comparison(codes, clusters, text, faster=25, repeats=15)
    quantity = "largest difference of a log-likelihood from pgmpy's"
    difference = partial(largest_difference, codes, clusters)
    yield Limit(PIECE, text, quantity, difference, at_most=1e-9, peer=PEER)
    few_codes = chained_codes(samples, few, 2)
    yield _comparison(few_codes, 2, f"{few} binary variables x {samples}", faster=500, repeats=5)
    many_codes = chained_codes(samples, many, 2)
    text, seconds = (
        f"{many} binary variables x {samples}",
        partial(median_seconds, partial(ours, many_codes, 2), 5),
    )
    yield Limit(PIECE, text, "seconds", seconds, at_most=1)


def _comparison(
    codes: NDArray[np.int32], n_values: int, text: str, *, faster: float, repeats: int
) -> Comparison:
    table = pd.DataFrame(codes)
    information = mutual_information(codes, n_values)
    calls = partial(ours, codes, n_values), partial(theirs, table, n_values)
    parts = {
        "mutual information": lambda: mutual_information(codes, n_values),
        "spanning tree": lambda: maximum_spanning_tree(information, 0),
    }
    # With two values pgmpy takes half a minute.
    options: dict[str, Any] = {"faster": faster, "repeats": repeats, "warm_up": n_values > 2}
    return Comparison(PIECE, text, PEER, *calls, **options, parts=parts)


def chained_codes(samples: int, variables: int, n_values: int, seed: int = 0) -> NDArray[np.int32]:
    """Draw codes, (samples, variables) int32 in [0, n_values), half of which repeat an earlier variable's."""
    rng = np.random.default_rng(seed)
    codes = rng.integers(n_values, size=(samples, variables), dtype=np.int32)
    for variable in range(1, variables):
        repeated = rng.random(samples) < 0.5
        codes[repeated, variable] = codes[repeated, rng.integers(variable)]
    return codes


def ours(codes: NDArray[np.int32], n_values: int) -> DependencyTree:
    """Learn the tree of one class."""
    return DependencyTree(n_values=n_values).fit(codes, np.zeros(len(codes), np.int64))


def theirs(table: pd.DataFrame, n_values: int) -> Any:
    """Learn the same by pgmpy: a ``pgmpy.models.DiscreteBayesianNetwork``."""
    with warnings.catch_warnings():
        # It warns of its own deprecated parts on import.
        warnings.simplefilter("ignore")
        from pgmpy.estimators import TreeSearch
        from pgmpy.models import DiscreteBayesianNetwork
        from pgmpy.parameter_estimator import DiscreteBayesianEstimator

        tree = TreeSearch(table, root_node=0, n_jobs=1).estimate(show_progress=False)
        states = {variable: list(range(n_values)) for variable in table.columns}
        estimator = DiscreteBayesianEstimator(state_names=states, prior_type="K2")
        return DiscreteBayesianNetwork(tree.edges()).fit(table, estimator)


def largest_difference(codes: NDArray[np.int32], n_values: int) -> float:
    """Learn by both, and compare the log-likelihoods of the samples."""
    found = ours(codes, n_values).predict_joint_log_likelihood(codes)[:, 0]
    expected = np.zeros(len(codes))
    for cpd in theirs(pd.DataFrame(codes), n_values).get_cpds():
        # One row per value; one column per value of the parent, a single column for the root.
        columns = codes[:, cpd.variables[1]] if len(cpd.variables) > 1 else 0
        expected += np.log(cpd.get_values()[codes[:, cpd.variables[0]], columns])
    return float(np.abs(found - expected).max())
