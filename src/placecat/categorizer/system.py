"""A trained system: everything needed to name the place in a frame."""

from dataclasses import dataclass
from typing import Any

from placecat.cues import CueModel
from placecat.fusion.integrate import Integrator
from placecat.fusion.smoothing import SmoothingModel


@dataclass(frozen=True)
class TrainedCue:
    """A trained cue: its name in conf/cue, its descriptor, and its model.

    :func:`placecat.cues.cue_input.check` describes the keys of a descriptor.
    """

    name: str
    descriptor: dict[str, Any]
    model: CueModel

    @property
    def is_tracked(self) -> bool:
        """Whether the cue tracks regions."""
        return bool(self.descriptor.get("tracked", False))


@dataclass(frozen=True)
class TrainedSystem:
    """The cues, their integration, and smoothing, in order of use.

    `card` contains facts about the system, in JSON types only; see :mod:`placecat.categorizer.card`.
    `vision` contains the settings of :func:`placecat.vision.frame.describe_frame` for regions that are not
    tracked. `tracking` contains the settings of :class:`placecat.vision.tracking.RegionTracker`, or is None
    if no cue tracks regions.
    """

    card: dict[str, Any]
    vision: dict[str, Any]
    tracking: dict[str, Any] | None
    cues: tuple[TrainedCue, ...]
    integrator: Integrator
    smoothing: SmoothingModel
