"""Dependency tree of one class, with its conditional probabilities, compared with three peers.

With pgmpy, this takes two steps. ``TreeSearch`` computes the mutual information of all pairs (with
scikit-learn's ``mutual_info_score``) and the maximum spanning tree from the same root (with NetworkX). Then
``DiscreteBayesianEstimator`` estimates the probabilities with the K2 prior. Like our code, this adds 1 to
every count. Both steps use a single process. Our code also checks the codes and splits them by class, while
pgmpy is given a finished table. The log-likelihoods of all samples agree, so both have learned the same
model.

deeprob-kit only learns trees of binary variables, in float32, and computes all tables in one matrix product.
pyAgrum's Chow-Liu classifier uses the first variable, the root of the same tree, as the class. It also
detects column types.
"""

import warnings
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from placecat.learning.contingency import both_ones, maximum_spanning_tree, mutual_information
from placecat.learning.dependency_tree import DependencyTree
from placecat_bench.comparison import TORCH, Comparison, Entry, Limit, Peer
from placecat_bench.timing import median_seconds

PIECE = "Dependency tree"
PEER = Peer("pgmpy: TreeSearch and DiscreteBayesianEstimator", "pgmpy")
DEEPROB = Peer("deeprob-kit: BinaryCLT", "deeprob-kit", extra=TORCH)
PYAGRUM = Peer("pyAgrum: BNClassifier, Chow-Liu", "pyagrum")


def entries(
    *, samples: int = 8000, grid: int = 16, clusters: int = 196, few: int = 124, many: int = 496
) -> Iterator[Entry]:
    """Yield comparisons for a tree of codewords in a grid of cells, and for trees of activations.

    `samples` is the number of samples, and `clusters` is the number of codewords. An activation has two
    values; pgmpy would take too long on many activations.
    """
    codes = chained_codes(samples, grid, clusters)
    text = f"{grid} variables x {clusters} values x {samples}"
    yield _comparison(codes, clusters, text, PEER, theirs, faster=25, repeats=15)
    yield Limit(
        PIECE,
        text,
        "largest difference between log-likelihoods",
        lambda: largest_difference(codes, clusters),
        at_most=1e-9,
        peer=PEER,
    )
    yield _comparison(codes, clusters, text, PYAGRUM, by_pyagrum, faster=10, repeats=5)
    yield Limit(
        PIECE,
        text,
        "edges of pyAgrum's tree that ours lacks",
        lambda: len(pyagrum_edges(codes) - edges(ours(codes, clusters))),
        at_most=0,
        peer=PYAGRUM,
    )
    few_codes, many_codes = chained_codes(samples, few, 2), chained_codes(samples, many, 2)
    few_text, many_text = (f"{number} binary variables x {samples}" for number in (few, many))
    yield _comparison(few_codes, 2, few_text, PEER, theirs, faster=500, repeats=5)
    yield _comparison(few_codes, 2, few_text, DEEPROB, by_deeprob, faster=3, repeats=15)
    yield _comparison(many_codes, 2, many_text, DEEPROB, by_deeprob, faster=3, repeats=15)
    yield Limit(
        PIECE,
        many_text,
        "largest difference between log-likelihoods",
        lambda: deeprob_difference(many_codes),
        at_most=1e-2,
        peer=DEEPROB,
    )
    yield Limit(
        PIECE,
        many_text,
        "seconds",
        lambda: median_seconds(lambda: ours(many_codes, 2), 5),
        at_most=1,
    )


def _comparison(
    codes: NDArray[np.int32],
    n_values: int,
    text: str,
    peer: Peer,
    call: Callable[[pd.DataFrame, int], Any],
    *,
    faster: float,
    repeats: int,
) -> Comparison:
    table = pd.DataFrame(codes)
    information = mutual_information(codes, n_values)
    return Comparison(
        PIECE,
        text,
        peer,
        lambda: ours(codes, n_values),
        lambda: call(table, n_values),
        faster=faster,
        repeats=repeats,
        # With two values, pgmpy takes half a minute.
        warm_up=n_values > 2,
        parts={
            **({"product": lambda: both_ones(codes)} if n_values == 2 else {}),
            "mutual information": lambda: mutual_information(codes, n_values),
            "spanning tree": lambda: maximum_spanning_tree(information, 0),
        },
    )


def chained_codes(samples: int, variables: int, n_values: int) -> NDArray[np.int32]:
    """Draw (samples, variables) int32 codes in [0, n_values) whose dependencies form a tree.

    In about half of the samples, each variable repeats the value of one earlier variable.
    """
    rng = np.random.default_rng(0)
    codes = rng.integers(n_values, size=(samples, variables), dtype=np.int32)
    for variable in range(1, variables):
        repeated = rng.random(samples) < 0.5
        codes[repeated, variable] = codes[repeated, rng.integers(variable)]
    return codes


def ours(codes: NDArray[np.int32], n_values: int) -> DependencyTree:
    """Learn the tree of one class with our code."""
    return DependencyTree(n_values=n_values).fit(codes, np.zeros(len(codes), np.int64))


def theirs(table: pd.DataFrame, n_values: int) -> Any:
    """Learn the same tree with pgmpy, as a ``pgmpy.models.DiscreteBayesianNetwork``."""
    with warnings.catch_warnings():
        # Importing pgmpy triggers warnings about its deprecated parts.
        warnings.simplefilter("ignore")
        from pgmpy.estimators import TreeSearch
        from pgmpy.models import DiscreteBayesianNetwork
        from pgmpy.parameter_estimator import DiscreteBayesianEstimator

        tree = TreeSearch(table, root_node=0, n_jobs=1).estimate(show_progress=False)
        states = {variable: list(range(n_values)) for variable in table.columns}
        estimator = DiscreteBayesianEstimator(state_names=states, prior_type="K2")
        return DiscreteBayesianNetwork(tree.edges()).fit(table, estimator)


def largest_difference(codes: NDArray[np.int32], n_values: int) -> float:
    """Return the largest difference between the log-likelihoods from pgmpy and our code."""
    found = ours(codes, n_values).predict_joint_log_likelihood(codes)[:, 0]
    expected = np.zeros(len(codes))
    for cpd in theirs(pd.DataFrame(codes), n_values).get_cpds():
        # One row per value and one column per value of the parent. The root has a single column.
        columns = codes[:, cpd.variables[1]] if len(cpd.variables) > 1 else 0
        expected += np.log(cpd.get_values()[codes[:, cpd.variables[0]], columns])
    return float(np.abs(found - expected).max())


def by_deeprob(table: pd.DataFrame, n_values: int = 2) -> Any:
    """Learn a binary tree with deeprob-kit's ``BinaryCLT``, which adds 1 to every cell, as our code does."""
    from deeprob.spn.structure.cltree import BinaryCLT

    variables = table.shape[1]
    model = BinaryCLT(list(range(variables)), root=0)
    model.fit(table.to_numpy(np.float32), [[0, 1]] * variables, alpha=1.0)
    return model


def deeprob_difference(codes: NDArray[np.int32]) -> float:
    """Return the largest difference between the log-likelihoods from deeprob-kit and our code."""
    expected = by_deeprob(pd.DataFrame(codes)).log_likelihood(codes.astype(np.float32))
    return float(np.abs(ours(codes, 2).predict_joint_log_likelihood(codes)[:, 0] - np.ravel(expected)).max())


def by_pyagrum(table: pd.DataFrame, n_values: int) -> Any:
    """Learn the tree with pyAgrum, as a ``BNClassifier`` whose class is the first variable."""
    from pyagrum.lib.discreteTypeProcessor import DiscreteTypeProcessor
    from pyagrum.skbn import BNClassifier

    codes = table.to_numpy()
    # Columns with more values than this threshold would be split into ten intervals.
    types = DiscreteTypeProcessor(discretizationThreshold=n_values + 1)
    model = BNClassifier(type_processor=types, learningMethod="Chow-Liu", prior="Smoothing", priorWeight=1)
    model.fit(codes[:, 1:], codes[:, 0])
    return model


def pyagrum_edges(codes: NDArray[np.int32]) -> set[tuple[int, int]]:
    """Return the edges of pyAgrum's tree, each as a (parent, child) pair of variable indices."""
    network = by_pyagrum(pd.DataFrame(codes), int(codes.max()) + 1).bn_
    places = {"y": 0} | {f"x{number}": number + 1 for number in range(codes.shape[1] - 1)}
    return {tuple(places[network.variable(end).name()] for end in arc) for arc in network.arcs()}  # type: ignore[misc]


def edges(model: DependencyTree) -> set[tuple[int, int]]:
    """Return the edges of our tree, each as a (parent, child) pair."""
    return {(int(parent), child) for child, parent in enumerate(model.parents_[0]) if parent >= 0}
