"""Training and test frames of results, home by home."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np

from placecat import settings
from placecat.explain.made import Made
from placecat.training import plan as plans
from placecat.training.plan import Part, Plan

Frames = tuple[tuple[str, int], ...]


@dataclass(frozen=True)
class Trained:
    """Sequences and their numbers of frames, for one test home or, on a fixed split, for all test sequences.

    Attributes
    ----------
    training_set
        Name that determines the seeds of codebooks.
    cues, integration
        Frames that train the cues and the integration; `integration` is () without fusion.
    tested
        Labelled frames that are tested.
    places
        Place to the number of its tested frames.
    """

    training_set: str
    cues: Frames
    integration: Frames
    tested: Frames
    places: Mapping[str, int]


def trained(made: Made, home: str, params: Mapping[str, Any]) -> Trained | None:
    """Frames of a result in a test home (of a split, in all its homes); None for a result without a plan."""
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
    """Number of chosen frames of each class."""
    _, classes = part.chosen()
    return tuple(map(int, np.bincount(classes, minlength=max(part.numbers, default=0) + 1)))
