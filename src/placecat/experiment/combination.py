"""Resolve a combination of settings, and check that it can be computed."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from placecat import cues, files, schema, settings
from placecat.cues import estimators
from placecat.errors import NotComputable, PlacecatError
from placecat.experiment import data as data_sets
from placecat.experiment.data import Data
from placecat.experiment.options import TEST_HOME, classifiers
from placecat.learning.hierarchical_kmeans import check_cluster_number
from placecat.learning.kernel_machine import KernelMachine
from placecat.learning.spatial_pca import SpatialPCA
from placecat.schema import signatures
from placecat.training import protocol, store
from placecat.training.plan import Plan


@dataclass(frozen=True)
class Experiment:
    """A checked experiment, with its data, test homes and settings.

    `judge` is ``test_home`` or ``training_homes``; see :meth:`~placecat.experiment.data.Data.plans`.
    `settings` has the keys ``descriptor``, ``classifier`` and, for classifiers on clusters, ``codebook``,
    like a trial in a table. `frames` has the ``offset`` and ``step`` of the training frames. `seeds` are the
    seeds for clustering, or a single None if nothing is random. `probabilities` are the settings of the same
    name in params.yaml, which are the arguments of :func:`placecat.evaluation.quality.probability_quality`.
    """

    data: Data
    homes: tuple[str, ...]
    judge: str
    settings: dict[str, Any]
    frames: dict[str, int]
    seeds: tuple[int | None, ...]
    probabilities: dict[str, Any]

    def plans(self) -> dict[str, list[Plan]]:
        """Map each test home to its plans. The accuracy of the home is the mean over these plans."""
        return {
            home: [plan.with_cue_frames(self.frames) for plan in self.data.plans(home, self.judge)]
            for home in self.homes
        }

    def described(self) -> dict[str, Any]:
        """Return every setting that affects the numbers, in JSON types."""
        return {
            "data": self.data.name,
            "judge": self.judge,
            "test_home": list(self.homes),
            "frames": self.frames,
            "seeds": list(self.seeds),
            "probabilities": self.probabilities,
            **self.settings,
        }


def resolve(config: Mapping[str, Any], params: Mapping[str, Any]) -> Experiment:
    """Resolve a combination of settings. This reads labels and array sizes, but no features.

    `config` is the composed conf/experiment.yaml as plain containers. `params` holds the contents of the
    params.yaml with which the features were computed. Raises PlacecatError if the combination is invalid; its
    message says what is wrong and how to fix it.
    """
    schema.check(config, schema.Experiment)
    # Check these too, since params.yaml may have been edited.
    schema.check({name: settings.get(params, name) for name in ("protocol", "probabilities")})
    data = data_sets.find(params, config["data"])
    homes = data_sets.find_homes(data, config["test_home"])
    frames = _frames(config["frames"], settings.get(params, "protocol.cue_frames"))
    descriptor = _descriptor(config["descriptor"])
    classifier = dict(config["classifier"])
    own: dict[str, Any] = {"descriptor": descriptor, "classifier": classifier}
    signatures.check_part(classifier, "classifier")
    seeds: list[int | None] = [None]
    if "clusters" in classifier:
        own["codebook"] = _codebook(config, descriptor, classifier)
        wanted = settings.get(params, "protocol.seeds") if config["seeds"] is None else config["seeds"]
        seeds = [wanted] if isinstance(wanted, int) else wanted
    elif config["codebook"]["cells"] is not None:
        raise PlacecatError(
            f"codebook.cells is for classifiers on clusters, not for {_name(classifier)}: leave it out"
        )
    probabilities = dict(settings.get(params, "probabilities"))
    experiment = Experiment(data, homes, config["judge"], own, frames, tuple(seeds), probabilities)
    _check_data(experiment, config["limits"]["kernel_rows"])
    return experiment


def _name(classifier: Mapping[str, Any]) -> str:
    base = classifier.get("base")
    return str(base.get("name", base)) if isinstance(base, Mapping) else str(classifier.get("model"))


def _frames(wanted: Mapping[str, Any], default: Mapping[str, int]) -> dict[str, int]:
    frames = {name: default[name] if wanted[name] is None else wanted[name] for name in ("offset", "step")}
    protocol.select_frames(np.empty(0, np.int16), **frames)
    return frames


def _descriptor(wanted: Mapping[str, Any]) -> dict[str, Any]:
    """Write the descriptor exactly as the tables do, because seeds are derived from this text."""
    own = dict(wanted)
    if own["kind"] == "holistic":
        settings.refuse_unknown(own, ["kind", "name"], f"descriptor {own['name']} (of whole frames)")
        return own
    if own["color"] == own["name"]:
        raise PlacecatError(f"descriptor.color={own['color']} appends the descriptor to itself: use null")
    for name in ("max_regions", "y_weight"):
        if own[name] is None:
            raise PlacecatError(
                f"descriptor.{name} is missing: set it to a number for descriptor {own['name']}"
            )
    own["y_weight"] = float(own["y_weight"])
    if not own["tracked"]:
        del own["tracked"]
    return own


def _base(classifier: Mapping[str, Any]) -> Any:
    """Build the untrained estimator of a classifier; return None if it has none."""
    return estimators.build(classifier["base"], "classifier.base") if "base" in classifier else None


def _codebook(
    config: Mapping[str, Any], descriptor: Mapping[str, Any], classifier: Mapping[str, Any]
) -> dict[str, Any]:
    tree, cells = dict(config["codebook"]["tree"]), config["codebook"]["cells"]
    clustering = estimators.build(tree, "codebook.tree")
    if hasattr(clustering, "branching"):
        check_cluster_number(classifier["clusters"], clustering.branching)
    model = str(settings.get(classifier, "model"))
    if descriptor["kind"] != "local" and cues.of_regions_only(model):
        raise PlacecatError(
            f"{_name(classifier)} needs salient regions, but descriptor {descriptor['name']} describes whole "
            "frames: use a descriptor of regions, or another classifier"
        )
    usual, whose = 1, "salient regions"
    if descriptor["kind"] == "holistic" and model in config["cells_of_frames"]:
        usual, whose = config["cells_of_frames"][model], "whole frames"
    if cells is None:
        cells = usual
    if cells != 1 and (descriptor["kind"] == "local" or model == "knn"):
        raise PlacecatError(
            f"codebook.cells={cells}: {_name(classifier)} cannot split descriptor {descriptor['name']} of "
            f"{whose}: use 1"
        )
    return {"cells": cells, "tree": tree}


def _check_data(experiment: Experiment, kernel_rows: int) -> None:
    """Check that the experiment fits the labels and features in data/, including the feature sizes."""
    plans = [plan for of_home in experiment.plans().values() for plan in of_home]
    training = {part.home: part.chosen() for plan in plans for part in plan.cues}
    every = sorted({plan.test for plan in plans} | set(training))
    data = experiment.data
    data_sets.need_features(every)
    lengths = {_length(data, home, experiment.settings["descriptor"]) for home in every}
    if len(lengths) > 1:
        raise PlacecatError(
            "the descriptors of the homes differ in length: run `make repro` to recompute them"
        )
    _check_length(experiment.settings, lengths.pop())
    present = {home: set(truth.tolist()) for home, (_, truth) in training.items()}
    for plan in plans:
        (tested,) = plan.tested
        seen = set().union(*(present[part.home] for part in plan.cues))
        missing = [place for number, place in enumerate(data.classes) if number not in seen]
        if missing:
            raise PlacecatError(
                f"testing on {tested.sequence} needs training frames of {missing[0]}, but "
                f"{', '.join(part.sequence for part in plan.cues)} have none: "
                "use other data" + ("" if experiment.judge == TEST_HOME else f" or judge={TEST_HOME}")
            )
        if not len(tested.chosen()[0]):
            raise PlacecatError(f"{tested.sequence} has no labelled frames to test on: use another test home")
    classifier, descriptor = experiment.settings["classifier"], experiment.settings["descriptor"]
    is_kernel = isinstance(_base(classifier), KernelMachine)
    if is_kernel and descriptor["kind"] == "local":
        counts = {home: _counts(home, descriptor)[rows].sum() for home, (rows, _) in training.items()}
        most = int(max(sum(counts[part.home] for part in plan.cues) for plan in plans))
        most = min(most, classifier.get("max_rows") or most)
        if most > kernel_rows:
            known = classifiers().items()
            without = [name for name, own in known if not isinstance(_base(own), KernelMachine)]
            raise PlacecatError(
                f"classifier {_name(classifier)} would train on {most} salient regions, and its Gram matrix "
                "grows with the square of this number: set classifier.max_rows=1000, use a classifier "
                f"without a kernel ({', '.join(without)}), or raise limits.kernel_rows={kernel_rows}"
            )


def _counts(home: str, descriptor: Mapping[str, Any]) -> np.ndarray:
    counts = files.read_array(store.folder_of(home, descriptor) / "count.npy", memory_map=False)
    return np.minimum(counts, descriptor["max_regions"]).astype(np.int64)


def _length(data: Data, home: str, descriptor: Mapping[str, Any]) -> int:
    """Return the length of the joined descriptor; raise PlacecatError if parts or regions are missing."""
    folder, kind = store.folder_of(home, descriptor), descriptor["kind"]
    computed = sorted(path.stem.removeprefix(f"{kind}_") for path in folder.glob(f"{kind}_*.npy"))
    length = int(bool(descriptor.get("y_pos", False)))
    for setting in ("name", "color"):
        name = descriptor.get(setting)
        if name is None:
            continue
        if name not in computed:
            tracked = "tracked " if descriptor.get("tracked", False) else ""
            whose = f"{tracked}salient regions" if kind == "local" else "whole frames"
            raise PlacecatError(
                f"descriptor {name} of {whose} was not computed for the data {data.name}: "
                f"use one of {', '.join(computed) or 'none'}"
            )
        shape = files.read_array(folder / f"{kind}_{name}.npy").shape
        if kind == "local" and descriptor["max_regions"] > shape[1]:
            raise PlacecatError(
                f"descriptor.max_regions={descriptor['max_regions']}, but at most {shape[1]} regions "
                f"per frame were described (regions.max_regions in params.yaml): use {shape[1]} or less"
            )
        length += shape[-1]
    return length


def _check_length(own: Mapping[str, Any], length: int) -> None:
    cells = own["codebook"]["cells"] if "codebook" in own else 1
    if length % cells:
        divisors = [number for number in (1, 2, 4, 8, 16, 32, 64) if length % number == 0]
        raise PlacecatError(
            f"codebook.cells={cells}: descriptor {own['descriptor']['name']} of {length} values cannot be "
            f"split into that many parts: use one of {', '.join(map(str, divisors))}"
        )
    reduction = own["classifier"].get("reduction")
    if reduction is None:
        return
    try:
        # The reduction checks its settings before it rejects a single sample.
        SpatialPCA(**reduction).fit(np.zeros((1, length), np.float32))
    except NotComputable:
        pass
    except PlacecatError as error:
        raise PlacecatError(
            f"classifier.reduction with descriptor {own['descriptor']['name']}: {error}"
        ) from None
