"""The fields of each class in a trained model: their types, ranges and shapes.

An estimator's parameters have the types and ranges that its constructor declares. A class that is not listed,
such as a user's own classifier, is not checked here, because `Categorizer.load` tries out every model before
it is used.
"""

from collections.abc import Callable, Mapping
from functools import cache
from typing import Annotated, Any, Literal, get_type_hints

import numpy as np
from annotated_types import MinLen
from pydantic import AfterValidator, PlainValidator, TypeAdapter
from sklearn.base import BaseEstimator

from placecat import schema
from placecat.categorizer.field_types import array, having, side
from placecat.errors import PlacecatError
from placecat.fusion.integrate import METHODS
from placecat.ranges import Count, NonNegative, OneOf, Positive, Share, Two


def check(kind: type, state: Mapping[str, Any]) -> None:
    """Raise PlacecatError if attributes are invalid for their class or inconsistent with each other.

    The message names the class and, if possible, the attribute.
    """
    class_name = kind.__name__
    if class_name not in FIELDS:
        return
    types = _types(kind)
    different = sorted(set(types) ^ set(state))
    if different:
        raise PlacecatError(f"a {class_name} has missing or unexpected attributes ({', '.join(different)})")
    sizes: Sizes = {}
    for name, own in types.items():
        schema.check_value(state[name], own, f"{name} of a {class_name}", sizes)
    relation = RELATIONS.get(class_name)
    if relation is not None and not relation(state, sizes):
        raise PlacecatError(f"the attributes of a {class_name} do not match")


@cache
def _types(kind: type) -> dict[str, TypeAdapter[Any]]:
    """Return the checks for the fields of a class in `FIELDS` and, for an estimator, for its parameters."""
    types = dict(FIELDS[kind.__name__])
    if issubclass(kind, BaseEstimator):
        hints = get_type_hints(kind.__init__, include_extras=True)  # type: ignore[misc]
        others = {"return", *types, *getattr(kind, "TRAINING_ONLY", ())}
        types |= {name: hint for name, hint in hints.items() if name not in others}
    return {
        name: schema.of_type(Annotated[Any, own] if isinstance(own, PlainValidator) else own)
        for name, own in types.items()
    }


# Maps letters to sizes; see `placecat.categorizer.field_types`.
Sizes = dict[str, int]
_CUE = having("predict_proba")


def _probabilities(*sides: str) -> PlainValidator:
    return array("f", *sides, low=0.0, high=1.0)


def _in_order(numbers: np.ndarray) -> np.ndarray:
    """Require the class numbers 0, 1, ..., K - 1 in that order, because they index probability columns."""
    if not np.array_equal(numbers, np.arange(len(numbers))):
        raise ValueError("it must contain the numbers 0, 1, 2, ...")
    return numbers


_CLASSES = Annotated[Any, array("iu", "K"), AfterValidator(_in_order)]
_WIDTH = Annotated[Count, side("D")]
_MULTI_CLASS: dict[str, Any] = {
    "classes_": _CLASSES,
    "n_features_in_": Count,
    "scorer_": having("decisions"),
    "sigmoid_": array("f", "M", 2),
    "machine_class_": array("i", "M", low=0, below="K"),
    "flat_": array("i", "K", low=0),
    "nu_": array("f", "K", low=0, nan=True),
    "fold_nu_": Annotated[list[Annotated[Any, array("f", None, low=0, nan=True)]], side("K")],
}
_BAYES: dict[str, Any] = {
    "n_features_in_": Annotated[Count, side("V")],
    "n_values_": Annotated[Two, side("Q")],
    "classes_": _CLASSES,
    "class_count_": array("i", "K", low=0),
    "class_log_prior_": array("f", "K", high=0),
}

FIELDS: dict[str, dict[str, Any]] = {
    "SmoothingModel": {
        "transition": _probabilities("K", "K"),
        "emission": _probabilities("K", "K"),
        "evidence": Literal["hard", "soft"],
        "evidence_seconds": Positive,
        "delay_seconds": NonNegative,
        "frame_rate": Positive,
    },
    "Integrator": {
        "method": Annotated[str, OneOf(METHODS)],
        "model": Annotated[Any, _CUE] | None,
        "temperatures": Annotated[Any, array("f", "C", low=1e-6)] | None,
        "weights": Annotated[Any, array("f", "C", low=0)] | None,
        "smallest": Share | None,
    },
    "JointProbabilityCue": {
        "codebook": having("words"),
        "clusters": Two,
        "estimator": _CUE,
        "facts": dict[Any, Any],
    },
    "NearestNeighboursCue": {
        "estimator": having("predict_proba", "predict_proba_sets"),
        "facts": dict[Any, Any],
    },
    "OneAgainstAllCue": {
        "steps": Annotated[list[Annotated[Any, having("transform")]], MinLen(1)],
        "scheme": _CUE,
        "facts": dict[Any, Any],
    },
    "DiscriminativeRegionsCue": {
        "codebook": having("words"),
        "kept": array("b", "N"),
        "cue": _CUE,
        "facts": dict[Any, Any],
    },
    "Codebook": {
        "trees": Annotated[list[Annotated[Any, having("assign", "centers")]], MinLen(1)],
        "of_sets": bool,
    },
    "HierarchicalKMeans": {
        "n_features_in_": _WIDTH,
        "node_centers_": array("f", "N", "D"),
        "node_sizes_": array("i", "N", low=0),
        "node_sse_": array("f", "N", low=0),
        "split_nodes_": array("i", "S", low=0, below="N"),
        "max_clusters_": Count,
    },
    "FlatKMeans": {
        "n_features_in_": _WIDTH,
        "n_points_": Count,
        "centers_": dict[int, Annotated[Any, array("f", None, "D")]],
    },
    "NaiveBayes": _BAYES | {"feature_log_prob_": array("f", "K", "V", "Q", high=0)},
    "DependencyTree": _BAYES
    | {
        "parents_": array("i", "K", "V", low=-1, below="V"),
        "_log_parents": array("f", "K", "V", "Q"),
        "_is_dense": bool,
        "_pair_keys": list[Annotated[Any, array("iu", None, low=0)]],
        "_pair_logs": Annotated[list[Annotated[Any, array("f", None)]], side("K")],
    },
    "ModifiedKNN": {
        "n_clusters": Annotated[Count, side("N")],
        "classes_": _CLASSES,
        "frequencies_": array("i", "N", "K", low=0),
        "centers_": array("f", "N", "D"),
        "n_features_in_": _WIDTH,
    },
    "KernelScaling": {
        "n_features_in_": _WIDTH,
        "offset_": array("f", "D"),
        "factor_": array("f", "D", low=0),
    },
    "SpatialPCA": {
        "cells": Annotated[Count, side("C")],
        "n_features_in_": Count,
        "mean_": array("f", "C", "W"),
        "components_": array("f", "C", "P", "W"),
        "explained_variance_": array("f", "C", "P", low=0),
        "explained_variance_ratio_": array("f", "C", "P", low=0),
    },
    "OneAgainstAll": _MULTI_CLASS
    | {
        "prior_": _probabilities("K"),
        "reliability_": _probabilities("K", "K"),
        "posterior_": _probabilities("K", "K"),
    },
    "Sequential": _MULTI_CLASS
    | {
        "strength_": _probabilities("K"),
        "order_": array("i", "K", low=0, below="K"),
    },
    "NuSVM": {},
    "RVM": {},
    "GentleAdaBoost": {},
    "KernelExpansion": {
        "support_vectors": array("f", "S", "D"),
        "coef": array("f", "S", "M"),
        "intercept": array("f", "M"),
        "gamma": Positive,
    },
    "StumpEnsembles": {
        "width": _WIDTH,
        "feature": array("i", "M", "T", low=0, below="D"),
        "threshold": array("f", "M", "T"),
        "low": array("f", "M", "T"),
        "high": array("f", "M", "T"),
    },
}


def _fit_smoothing(state: Mapping[str, Any], sizes: Sizes) -> bool:
    rows = np.stack([state["transition"], state["emission"]])
    return bool(np.allclose(rows.sum(axis=-1), 1.0, atol=1e-6))


def _fit_tree(state: Mapping[str, Any], sizes: Sizes) -> bool:
    branching, splits, nodes = state["branching"], sizes["S"], np.arange(sizes["S"])
    return bool(
        sizes["N"] == 1 + branching * splits
        and state["max_clusters_"] == 1 + (branching - 1) * splits
        # A node can be split only once, and only after it has been created.
        and (state["split_nodes_"] < 1 + branching * nodes).all()
        and len(np.unique(state["split_nodes_"])) == splits
    )


def _fit_machines(state: Mapping[str, Any], sizes: Sizes) -> bool:
    machines = state["machine_class_"]
    every_class = np.array_equal(np.unique(machines), np.arange(sizes["K"]))
    scorer = state["scorer_"]
    count = len(getattr(scorer, "intercept", getattr(scorer, "feature", machines)))
    return bool(every_class and (np.diff(machines) >= 0).all() and count == len(machines))


def _fit_pairs(state: Mapping[str, Any], sizes: Sizes) -> bool:
    cells = sizes["V"] * sizes["Q"] ** 2
    keys, logs = state["_pair_keys"], state["_pair_logs"]
    roots = state["parents_"] < 0
    if state["root"] >= sizes["V"] or not (roots.sum(axis=1) == 1).all() or not roots[:, state["root"]].all():
        return False
    if state["_is_dense"]:
        return all(len(own) == cells for own in logs)
    return [len(own) for own in keys] == [len(own) for own in logs] and all(
        len(own) and (np.diff(own) > 0).all() and own[-1] < cells for own in keys
    )


# Constraints between the attributes of a class, other than equal sizes.
RELATIONS: dict[str, Callable[[Mapping[str, Any], Sizes], bool]] = {
    "SmoothingModel": _fit_smoothing,
    "Integrator": lambda state, _: (
        (state["model"] is None) == (state["method"] != "das")
        and (state["weights"] is None) == (state["method"] != "log_pool")
    ),
    "HierarchicalKMeans": _fit_tree,
    "FlatKMeans": lambda state, _: all(len(own) == key for key, own in state["centers_"].items()),
    "DependencyTree": _fit_pairs,
    "ModifiedKNN": lambda state, sizes: state["n_neighbors"] <= sizes["N"],
    "SpatialPCA": lambda state, sizes: state["n_features_in_"] == sizes["C"] * sizes["W"],
    "OneAgainstAll": lambda state, sizes: _fit_machines(state, sizes) and bool(state["sigmoid_"].size),
    "Sequential": lambda state, sizes: (
        _fit_machines(state, sizes) and len(np.unique(state["order_"])) == sizes["K"]
    ),
}
