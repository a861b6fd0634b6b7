"""The number of frames from each home on which a result is trained and tested."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

from placecat import settings
from placecat.training import plan as plans
from placecat.training.plan import Part

Frames = tuple[tuple[str, int], ...]


@dataclass(frozen=True)
class Trained:
    """The training and test sequences of one test home or of an entire fixed split, with their frame counts.

    Attributes
    ----------
    training_set
        Name of the training set, from which codebook seeds are derived.
    cues, integration
        Frames on which the cues and the integration are trained; `integration` is () without fusion.
    tested
        Labelled frames of the test sequences.
    """

    training_set: str
    cues: Frames
    integration: Frames
    tested: Frames


def trained(params: Mapping[str, Any], name: str, home: str, fuses: bool, extra: bool) -> Trained | None:
    """Return the frames of a result for a test home, or for all homes of a split; None if it has no plan.

    `name` is the name of the plan. `fuses` and `extra` are explained in
    :class:`placecat.provenance.made.Made`.
    """
    if not name:
        return None
    if name in settings.get(params, "splits"):
        plan = plans.of_split(params, name)
    else:
        (plan,) = plans.of_homes(params, name, [home], extra=extra)
    fused = (*plan.integration, *(plan.extra if extra else ())) if fuses else ()
    return Trained(plan.training_set, _counts(plan.cues), _counts(fused), _counts(plan.tested))


def _counts(parts: Sequence[Part]) -> Frames:
    return tuple((part.home, _chosen(part)) for part in parts)


@cache
def _chosen(part: Part) -> int:
    frames, _ = part.chosen()
    return len(frames)
