"""Codebooks, with one tree for all salient regions or one tree per cell of a holistic descriptor."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat import seeds, settings
from placecat.cues import cue_input, estimators
from placecat.cues.descriptors import Descriptors
from placecat.errors import PlacecatError
from placecat.learning.flat_kmeans import FlatKMeans
from placecat.learning.hierarchical_kmeans import HierarchicalKMeans


def seed_of(
    dataset: str, descriptor: Mapping[str, Any], cells: int, training_set: str, seed: int | str
) -> int:
    """Derive the seed of a codebook, in [0, 2**32), from the data that it clusters.

    The inputs are the name of the data set, the descriptor of the cue, the number of cells of a holistic
    descriptor, the name of the training set, and one of ``protocol.seeds``. The same inputs always produce
    the same seed. Raises the same errors as :func:`placecat.cues.cue_input.check`.
    """
    cue_input.check(descriptor)
    # The clustering depends on this string, so if a setting or descriptor is renamed, keep its old name here.
    content = json.dumps(dict(descriptor), sort_keys=True)
    return seeds.derive("codebook", dataset, content, cells, training_set, int(seed))


def settings_of(params: Mapping[str, Any], name: str) -> dict[str, Any]:
    """Look up the settings of a codebook. For flat k-means, add the numbers of clusters that its cues use.

    One hierarchy serves all numbers up to ``max_clusters``, but flat k-means runs once for each of the
    ``numbers`` in ``tree``. Raises PlacecatError if `name` is not one of ``codebooks``.
    """
    codebook = dict(settings.get(params, f"codebooks.{name}"))
    tree = codebook["tree"]
    if tree["name"] == "flat_kmeans" and "numbers" not in tree:
        cues = settings.get(params, "cues").values()
        numbers = {cue["classifier"]["clusters"] for cue in cues if cue["codebook"] == name}
        codebook["tree"] = {**tree, "numbers": sorted(numbers)}
    return codebook


class Codebook:
    """Trees that assign codewords for every number of clusters that a cue uses (thesis 3.3.1.1, 4.2).

    Salient regions share one tree. A holistic descriptor, which stores its cells one after another, has one
    tree per cell.
    """

    def __init__(self, trees: list[Any], *, of_sets: bool) -> None:
        self.trees = trees
        self.of_sets = of_sets

    @classmethod
    def fit(
        cls,
        train: Descriptors,
        *,
        cells: int,
        seed: int,
        tree: Mapping[str, Any],
        numbers: Sequence[int] | None = None,
    ) -> Codebook:
        """Cluster the descriptors of n training frames.

        `cells` is the number of equal parts that a holistic descriptor is split into (16 in the thesis), or 1
        for regions. The seed of each tree is derived from `seed` and the cell. `tree` contains the ``name``
        of a clustering module in `placecat.learning` and its settings. `numbers` lists the cluster counts
        that will be used. If it is None, those in the settings apply.
        """
        if train.is_set:
            parts = [train.rows()]
        else:
            if train.x.shape[1] % cells:
                raise PlacecatError(
                    f"a descriptor of {train.x.shape[1]} values cannot be split into {cells} equal cells"
                )
            parts = np.split(train.x, cells, axis=1)
        trees = []
        for number, part in enumerate(parts):
            clustering = estimators.build(tree, "codebook.tree", seed=seeds.derive("cell", seed, number))
            if numbers is not None:
                clustering.set_params(**clustering.settings_for(numbers))
            trees.append(clustering.fit(np.ascontiguousarray(part)))
        return cls(trees, of_sets=train.is_set)

    def words(self, frames: Descriptors, n_clusters: int) -> NDArray[np.int32]:
        """Return the nearest cluster of each region or cell.

        For regions, the result is (n, max_regions), padded with -1. For cells, it is (n, cells).
        """
        if self.of_sets:
            words = np.full(frames.x.shape[:2], -1, dtype=np.int32)
            words[frames.valid()] = self.trees[0].assign(frames.rows(), n_clusters)
            return words
        parts = np.split(frames.x, len(self.trees), axis=1)
        columns = [
            tree.assign(np.ascontiguousarray(part), n_clusters)
            for tree, part in zip(self.trees, parts, strict=True)
        ]
        return np.stack(columns, axis=1).astype(np.int32)

    def to_arrays(self) -> dict[str, np.ndarray]:
        """Convert the codebook to arrays, which can be stored without pickle."""
        arrays = {"of_sets": np.array(self.of_sets), "n_trees": np.array(len(self.trees))}
        for number, tree in enumerate(self.trees):
            arrays |= {f"{number:02d}/{name}": array for name, array in tree.to_arrays().items()}
        return arrays

    @classmethod
    def from_arrays(cls, arrays: Mapping[str, np.ndarray]) -> Codebook:
        """Restore a codebook from the arrays that :meth:`to_arrays` returns."""
        trees = []
        for number in range(int(arrays["n_trees"])):
            prefix = f"{number:02d}/"
            own = {name[len(prefix) :]: array for name, array in arrays.items() if name.startswith(prefix)}
            clustering = FlatKMeans if "numbers" in own else HierarchicalKMeans
            trees.append(clustering.from_arrays(own))
        return cls(trees, of_sets=bool(arrays["of_sets"]))
