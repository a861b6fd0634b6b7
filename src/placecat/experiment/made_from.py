"""The origin of an experiment's result; a sweep uses it to tell whether a job is finished."""

import hashlib
from pathlib import Path
from typing import Any

from placecat import paths
from placecat.compute.fingerprint import PACKAGES, fingerprint
from placecat.errors import PlacecatError
from placecat.experiment import output
from placecat.experiment.combination import Experiment
from placecat.runs import items
from placecat.training import store

_OF_CODE = ("placecat", "Python", *PACKAGES, "OpenCV")


def made_from(experiment: Experiment) -> dict[str, Any]:
    """Describe a result's inputs as JSON types, for result.json.

    The keys are ``settings``; ``plans``, a checksum of the training and test plans; ``data``, a checksum of
    each sequence's labels and descriptors; and ``code``, the versions of placecat, Python and the libraries.
    """
    plans = [plan for of_home in experiment.plans().values() for plan in of_home]
    sequences = sorted({part.home for plan in plans for part in (*plan.cues, *plan.tested)})
    versions = fingerprint()
    return {
        "settings": experiment.described(),
        "plans": _short(repr(plans)),
        "data": {name: _data(name, experiment.settings["descriptor"]) for name in sequences},
        "code": {name: versions[name] for name in _OF_CODE},
    }


def made_from_of(result: dict[str, Any]) -> dict[str, Any]:
    """Extract the origin from a result; it is incomplete if the job failed early."""
    return {name: result[name] for name in ("settings", "plans", "data", "code") if name in result}


def is_finished(folder: Path, wanted: dict[str, Any]) -> bool:
    """Whether a job's folder holds a result, an accuracy or a reason, with the wanted origin."""
    try:
        found = output.read(folder)
    except PlacecatError:
        return False
    return output.FAILED not in found and made_from_of(found) == wanted


def _data(sequence: str, descriptor: dict[str, Any]) -> str:
    read = [paths.sequences(sequence) / "labels.csv", *store.files_of(sequence, descriptor)]
    return _short("\n".join(items.checksum(path) for path in read))


def _short(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()[:16]
