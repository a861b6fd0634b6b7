"""The fields of each class in a trained model: their types, ranges and shapes.

An estimator's parameters have the types and ranges that its constructor declares. A class that is not listed,
such as an added classifier, is accepted unchecked, since `Categorizer.load` tries every model before use.
"""

from collections.abc import Callable, Mapping
from functools import cache
from typing import Any, get_type_hints

import numpy as np
from pydantic import TypeAdapter
from sklearn.base import BaseEstimator

from placecat import schema
from placecat.categorizer.field_kinds import (
    Field,
    Sizes,
    array,
    by_number,
    having,
    mapping,
    number,
    one_of,
    optional,
    several,
    truth,
    whole,
)
from placecat.errors import PlacecatError
from placecat.fusion.integrate import METHODS


def check(kind: type, state: Mapping[str, Any]) -> None:
    """Refuse attributes that do not fit their class, such as :class:`NuSVM`, or do not fit each other.

    The PlacecatError names the class and, if possible, the attribute.
    """
    class_name = kind.__name__
    fields = FIELDS.get(class_name)
    if fields is None:
        return
    parameters = _parameters(kind)
    different = sorted({*fields, *parameters} ^ set(state))
    if different:
        raise PlacecatError(f"a {class_name} has wrong attributes ({', '.join(different)})")
    sizes: Sizes = {}
    for name, field in fields.items():
        try:
            field(state[name], sizes)
        except ValueError as error:
            raise PlacecatError(f"{name} of a {class_name} {error}") from None
    for name, adapter in parameters.items():
        schema.check_value(state[name], adapter, f"{name} of a {class_name}")
    relation = RELATIONS.get(class_name)
    if relation is not None and not relation(state, sizes):
        raise PlacecatError(f"the attributes of a {class_name} do not match")


@cache
def _parameters(kind: type) -> dict[str, TypeAdapter[Any]]:
    """Return the checks of those stored parameters of an estimator that are not in `FIELDS`."""
    if not issubclass(kind, BaseEstimator):
        return {}
    hints = get_type_hints(kind.__init__, include_extras=True)  # type: ignore[misc]
    others = {"return", *FIELDS[kind.__name__], *getattr(kind, "TRAINING_ONLY", ())}
    return {name: schema.of_type(hint) for name, hint in hints.items() if name not in others}


_CUE = having("predict_proba")


def _probabilities(*sides: str) -> Field:
    return array("f", *sides, low=0.0, high=1.0)


def _classes(value: Any, sizes: Sizes) -> None:
    """Require the class numbers 0, 1, ..., K - 1, since they index columns of probabilities."""
    array("iu", "K")(value, sizes)
    if not np.array_equal(value, np.arange(len(value))):
        raise ValueError("are not the numbers 0, 1, 2, ...")


_MULTI_CLASS: dict[str, Field] = {
    "classes_": _classes,
    "n_features_in_": whole(1),
    "scorer_": having("decisions"),
    "sigmoid_": array("f", "M", 2),
    "machine_class_": array("i", "M", low=0, below="K"),
    "flat_": array("i", "K", low=0),
    "nu_": array("f", "K", low=0, nan=True),
    "fold_nu_": several(array("f", None, low=0, nan=True), side="K"),
}
_BAYES: dict[str, Field] = {
    "n_features_in_": whole(1, side="V"),
    "n_values_": whole(2, side="Q"),
    "classes_": _classes,
    "class_count_": array("i", "K", low=0),
    "class_log_prior_": array("f", "K", high=0),
}

FIELDS: dict[str, dict[str, Field]] = {
    "SmoothingModel": {
        "transition": _probabilities("K", "K"),
        "emission": _probabilities("K", "K"),
        "evidence": one_of("hard", "soft"),
        "evidence_seconds": number(above=0),
        "delay_seconds": number(0),
        "frame_rate": number(above=0),
    },
    "Integrator": {
        "method": one_of(*METHODS),
        "model": optional(_CUE),
        "temperatures": optional(array("f", "C", low=1e-6)),
        "weights": optional(array("f", "C", low=0)),
        "smallest": optional(number(0, 1)),
    },
    "JointProbabilityCue": {
        "codebook": having("words"),
        "clusters": whole(2),
        "estimator": _CUE,
        "facts": mapping,
    },
    "NearestNeighboursCue": {"estimator": having("predict_proba", "predict_proba_sets"), "facts": mapping},
    "OneAgainstAllCue": {
        "steps": several(having("transform"), least=1),
        "scheme": _CUE,
        "facts": mapping,
    },
    "DiscriminativeRegionsCue": {
        "codebook": having("words"),
        "kept": array("b", "N"),
        "cue": _CUE,
        "facts": mapping,
    },
    "Codebook": {"trees": several(having("assign", "centers"), least=1), "of_sets": truth},
    "HierarchicalKMeans": {
        "n_features_in_": whole(1, side="D"),
        "node_centers_": array("f", "N", "D"),
        "node_sizes_": array("i", "N", low=0),
        "node_sse_": array("f", "N", low=0),
        "split_nodes_": array("i", "S", low=0, below="N"),
        "max_clusters_": whole(1),
    },
    "FlatKMeans": {
        "n_features_in_": whole(1, side="D"),
        "n_points_": whole(1),
        "centers_": by_number(lambda value, sizes: array("f", len(value), "D")(value, sizes)),
    },
    "NaiveBayes": _BAYES | {"feature_log_prob_": array("f", "K", "V", "Q", high=0)},
    "DependencyTree": _BAYES
    | {
        "parents_": array("i", "K", "V", low=-1, below="V"),
        "_log_parents": array("f", "K", "V", "Q"),
        "_is_dense": truth,
        "_pair_keys": several(array("iu", None, low=0)),
        "_pair_logs": several(array("f", None), side="K"),
    },
    "ModifiedKNN": {
        "n_clusters": whole(1, side="N"),
        "classes_": _classes,
        "frequencies_": array("i", "N", "K", low=0),
        "centers_": array("f", "N", "D"),
        "n_features_in_": whole(1, side="D"),
    },
    "KernelScaling": {
        "n_features_in_": whole(1, side="D"),
        "offset_": array("f", "D"),
        "factor_": array("f", "D", low=0),
    },
    "SpatialPCA": {
        "cells": whole(1, side="C"),
        "n_features_in_": whole(1),
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
        "gamma": number(above=0),
    },
    "StumpEnsembles": {
        "width": whole(1, side="D"),
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
        # A node can be split only once, and only after it was created.
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


# Relations between attributes, apart from equal sides.
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
