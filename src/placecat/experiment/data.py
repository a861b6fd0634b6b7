"""The data of an experiment: training plans and test homes."""

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from placecat import paths, settings
from placecat.errors import PlacecatError
from placecat.experiment.options import ALL, MAIN, TEST_HOME
from placecat.training import plan as planning
from placecat.training.plan import Plan


@dataclass(frozen=True)
class Data:
    """A data set with features.

    `name` is the name of the main data set or of a split, and `classes` are its place names. `by_test` maps
    each sequence that can be tested to a plan that tests it alone.
    """

    name: str
    classes: tuple[str, ...]
    by_test: Mapping[str, Plan]

    def plans(self, test: str, judge: str) -> list[Plan]:
        """Return the plans that determine the accuracy of a test home, which must be in `by_test`.

        If `judge` is ``test_home``, this is the plan of the test home. If it is ``training_homes``, each
        training home has a plan that trains on the other training homes and tests on this one. No plan uses
        the test home.
        """
        plan = self.by_test[test]
        if judge == TEST_HOME:
            return [plan]
        plans = planning.on_training_homes(plan)
        # As in the tables, cross-validation needs two homes to train a cue on.
        if len(plans) < 3:
            raise PlacecatError(
                f"judge=training_homes leaves out one training home and trains on at least two others, but "
                f"{self.name} has only {len(plans)} besides {test}: use judge={TEST_HOME}"
            )
        return plans


def find(params: Mapping[str, Any], name: str) -> Data:
    """Look up ``main`` or a split in params.yaml; raise PlacecatError for any other name."""
    if name == MAIN:
        plans = planning.of_homes(params, "5-5-1")
        return Data(plans[0].dataset, plans[0].classes, {plan.test: plan for plan in plans})
    splits = settings.get(params, "splits")
    if name not in splits:
        raise PlacecatError(f"data={name} does not exist: use one of {', '.join((MAIN, *splits))}")
    plan = planning.of_split(params, name)
    return Data(name, plan.classes, {part.sequence: replace(plan, tested=(part,)) for part in plan.tested})


def find_homes(data: Data, wanted: Any) -> tuple[str, ...]:
    """Find the test homes named in a setting, ignoring case and punctuation; ``all`` selects all of them.

    Raises PlacecatError if a name is unknown, ambiguous or repeated.
    """
    if wanted == ALL:
        return tuple(data.by_test)
    spellings: dict[str, list[str]] = {}
    for home in data.by_test:
        spellings.setdefault(_plain(home), []).append(home)
    names = list(wanted) if isinstance(wanted, Sequence) and not isinstance(wanted, str) else [wanted]
    if not names:
        raise PlacecatError(f"test_home is empty: use one of {', '.join((ALL, *data.by_test))}")
    training = {_plain(part.sequence) for plan in data.by_test.values() for part in plan.cues}
    found = []
    for name in names:
        meant = [name] if name in data.by_test else spellings.get(_plain(str(name)), [])
        if len(meant) != 1:
            why = (
                "is a training home of this split"
                if _plain(str(name)) in training
                else ("is ambiguous" if meant else "does not exist")
            )
            raise PlacecatError(
                f"test_home={name} {why}: for data set {data.name}, use {', '.join(data.by_test)} or {ALL}"
            )
        found.append(meant[0])
    if len(set(found)) != len(found):
        raise PlacecatError(f"test_home lists {max(found, key=found.count)} twice: remove one of them")
    return tuple(found)


def need_features(homes: Sequence[str]) -> None:
    """Raise PlacecatError if a sequence (see :func:`placecat.paths.sequences`) has no labels or features."""
    for home in homes:
        for path in (paths.sequences(home) / "labels.csv", paths.features(home)):
            if not path.exists():
                raise PlacecatError(f"{path} is missing: run `make repro`, which computes all features")


def _plain(name: str) -> str:
    return re.sub(r"[\W_]", "", name).lower()
