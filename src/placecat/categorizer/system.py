"""A trained system: everything needed to name a frame's place."""

from dataclasses import dataclass
from typing import Any

from placecat.cues import CueModel
from placecat.fusion.integrate import Integrator
from placecat.fusion.smoothing import SmoothingModel


@dataclass(frozen=True)
class TrainedCue:
    """A cue: its name in conf/cue, its descriptor (:func:`placecat.cues.cue_input.check`), and its model."""

    name: str
    descriptor: dict[str, Any]
    model: CueModel


@dataclass(frozen=True)
class TrainedSystem:
    """The cues, their integration, and the smoothing.

    Attributes
    ----------
    card
        Facts about the system, in JSON types only; see :mod:`placecat.categorizer.card`.
    vision
        Settings of :func:`placecat.vision.frame.describe_frame` for regions that are not tracked.
    tracking
        Settings of :class:`placecat.vision.tracking.RegionTracker`; None if no cue follows regions.
    cues, integrator, smoothing
        The parts, in order of use.
    """

    card: dict[str, Any]
    vision: dict[str, Any]
    tracking: dict[str, Any] | None
    cues: tuple[TrainedCue, ...]
    integrator: Integrator
    smoothing: SmoothingModel
