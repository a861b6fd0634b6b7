"""The data of an experiment: which homes are tested, and which frames of which homes train for each."""

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat import listing, paths, settings
from placecat.errors import PlacecatError
from placecat.evaluation import protocol
from placecat.experiment.options import ALL, MAIN, TEST_HOME


@dataclass(frozen=True)
class Data:
    """A data set with features.

    Attributes
    ----------
    name
        The main data set's name, or that of the split; seeds are derived from it.
    is_split
        Whether training and test sequences are fixed; otherwise every home is tested, all others train.
    classes
        Names of the places.
    tested
        Names of the homes that can be the test home.
    parts
        Of a split: training sequence to the places that count, None for all. Otherwise every home.
    """

    name: str
    is_split: bool
    classes: tuple[str, ...]
    tested: tuple[str, ...]
    parts: Mapping[str, tuple[str, ...] | None]

    def path(self, home: str) -> str:
        """Name of a home as `placecat.paths` takes it."""
        return f"{self.name}/{home}" if self.is_split else home

    def labels(self, home: str, *, training: bool) -> NDArray[np.int16]:
        """(frames,) class indices, -1 without one or, in `training`, where the place does not count."""
        labels = listing.read_labels(self.path(home))
        places = self.parts.get(home) if training else None
        if places is None:
            return labels
        counted = [number for number, place in enumerate(self.classes) if place in places]
        return np.where(np.isin(labels, counted), labels, -1).astype(np.int16)

    def folds(self, test: str, judge: str) -> list[protocol.Fold]:
        """What an accuracy for one test home is measured on.

        Parameters
        ----------
        test
            One of `tested`.
        judge
            ``test_home``: the fold of this home. ``training_homes``: a fold for each of its training homes,
            in which this one is tested, the others train, and the test home has no part.
        """
        if judge == TEST_HOME:
            if not self.is_split:
                return [fold for fold in protocol.folds(self.tested, "5-5-1") if fold.test == test]
            training = tuple(self.parts)
            return [protocol.Fold("5-5-1", test, training, training)]
        training = tuple(home for home in self.parts if home != test)
        # As for the tables: what trains a cue must be two homes at least, for its cross-validation.
        if len(training) < 3:
            raise PlacecatError(
                f"judge=training_homes leaves one training home out and needs two others, but {self.name} "
                f"has {len(training)} beside {test}: use judge={TEST_HOME}"
            )
        folds = []
        for left_out in training:
            rest = tuple(home for home in training if home != left_out)
            # The test home as one of the integration's, so that the training set's name leaves both out.
            folds.append(protocol.Fold("5-5-1", left_out, rest, (*rest, test)))
        return folds


def find(params: Mapping[str, Any], name: str) -> Data:
    """Look up the data: ``main``, or a split of params.yaml.

    Raises
    ------
    PlacecatError
        Naming those that there are.
    """
    if name == MAIN:
        homes = tuple(settings.get(params, "dataset.homes"))
        classes = tuple(settings.get(params, "dataset.classes"))
        dataset = str(settings.get(params, "dataset.name"))
        return Data(dataset, False, classes, homes, dict.fromkeys(homes))
    found = settings.get(params, "splits")
    if name not in found:
        raise PlacecatError(f"data={name} does not exist: use one of {', '.join((MAIN, *found))}")
    own = found[name]
    parts = {
        part["sequence"]: None if part["places"] is None else tuple(part["places"])
        for part in own["cue_parts"]
    }
    return Data(name, True, tuple(own["dataset"]["classes"]), tuple(own["test"]), parts)


def find_homes(data: Data, wanted: Any) -> tuple[str, ...]:
    """Test homes, whichever way they are spelled: only letters and digits count.

    Parameters
    ----------
    wanted
        ``all``, a name or a list of names.

    Raises
    ------
    PlacecatError
        Naming those that there are.
    """
    if wanted == ALL:
        return data.tested
    spellings: dict[str, list[str]] = {}
    for home in data.tested:
        spellings.setdefault(_plain(home), []).append(home)
    names = list(wanted) if isinstance(wanted, Sequence) and not isinstance(wanted, str) else [wanted]
    if not names:
        raise PlacecatError(f"test_home is empty: use one of {', '.join((ALL, *data.tested))}")
    found = []
    for name in names:
        meant = [name] if name in data.tested else spellings.get(_plain(str(name)), [])
        if len(meant) != 1:
            why = (
                "is trained on in this split"
                if _plain(str(name)) in map(_plain, data.parts)
                else ("could be several" if meant else "does not exist")
            )
            raise PlacecatError(
                f"test_home={name} {why}: data set {data.name} is tested on {', '.join(data.tested)} "
                f"(or {ALL})"
            )
        found.append(meant[0])
    if len(set(found)) != len(found):
        raise PlacecatError(f"test_home names {max(found, key=found.count)} twice")
    return tuple(found)


def need_features(data: Data, homes: Sequence[str]) -> None:
    """Refuse data whose features are not there."""
    for home in homes:
        for path in (paths.sequences(data.path(home)) / "labels.csv", paths.features(data.path(home))):
            if not path.exists():
                raise PlacecatError(f"{path} is missing: run `make repro`, which computes all features")


def _plain(name: str) -> str:
    return re.sub(r"[\W_]", "", name).lower()
