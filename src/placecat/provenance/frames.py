"""The training and test frames of results, home by home."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np

from placecat import settings
from placecat.provenance.made import Made
from placecat.training import plan as plans
from placecat.training.plan import Part, Plan

Frames = tuple[tuple[str, int], ...]


@dataclass(frozen=True)
class Trained:
    """Training and test sequences with their numbers of frames, for a test home or a whole fixed split.

    Attributes
    ----------
    training_set
        Name of the training set, from which the codebooks' seeds are derived.
    cues, integration
        Frames that the cues and the integration are trained on; `integration` is () without fusion.
    tested
        Labelled frames that are tested.
    places
        Maps each place to the number of its tested frames.
    """

    training_set: str
    cues: Frames
    integration: Frames
    tested: Frames
    places: Mapping[str, int]


def trained(made: Made, home: str, params: Mapping[str, Any]) -> Trained | None:
    """Return a result's frames for a test home or, on a split, for all its homes; None if it has no plan."""
    if not made.plan:
        return None
    if made.plan in settings.get(params, "splits"):
        plan = plans.of_split(params, made.plan)
    else:
        (plan,) = plans.of_homes(params, made.plan, [home], extra=made.extra)
    fused = (*plan.integration, *(plan.extra if made.extra else ())) if made.fuses else ()
    return Trained(plan.training_set, _counts(plan.cues), _counts(fused), _counts(plan.tested), _places(plan))


def _counts(parts: Sequence[Part]) -> Frames:
    return tuple((part.home, sum(_chosen(part))) for part in parts)


def _places(plan: Plan) -> dict[str, int]:
    totals = np.array([_chosen(part) for part in plan.tested]).sum(axis=0)
    return dict(zip(plan.classes, map(int, totals), strict=True))


@cache
def _chosen(part: Part) -> tuple[int, ...]:
    """Count the chosen frames of each class."""
    _, classes = part.chosen()
    return tuple(map(int, np.bincount(classes, minlength=max(part.numbers, default=0) + 1)))
