"""Statistics of walks, such as the order of rooms and the length of stays."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from placecat import settings


@dataclass(frozen=True)
class LogNormal:
    """A log-normal distribution.

    Attributes
    ----------
    mean, sigma
        Mean and standard deviation of the logarithm.
    """

    mean: float
    sigma: float

    def draw(self, rng: np.random.Generator, spread: float) -> float:
        """Draw a number whose logarithm is at most `spread` sigmas from the mean."""
        return math.exp(self.mean + self.sigma * float(np.clip(rng.normal(), -spread, spread)))


@dataclass(frozen=True)
class Statistics:
    """Statistics of the order and length of stays.

    Attributes
    ----------
    classes
        Kinds of room that must occur in a walk if the building has them, each in at least `least_share` of
        the frames.
    starts
        How often walks start in each kind of room.
    follows
        How often a stay in the second kind of room follows a stay in the first kind.
    count
        Number of stays in a walk.
    stays
        Length of a stay in each kind of room, as a multiple of the walk's mean stay.
    transitions
        Length of a transition, as a multiple of the walk's mean transition.
    transition_share
        Mean, standard deviation, minimum and maximum of the share of frames that are transitions; all 0 if
        there are no transitions.
    between
        How frames between two stays are labelled: `transition` (transitions all the way) or `rooms` (only
        doorways are transitions, and rooms on the way keep their own labels).
    doorway
        Distances in metres at which a transition begins before a door and ends after it.
    least_share
        Minimum share of frames for each class.
    """

    classes: tuple[str, ...]
    starts: Mapping[str, float]
    follows: Mapping[str, Mapping[str, float]]
    count: LogNormal
    stays: Mapping[str, LogNormal]
    transitions: LogNormal
    transition_share: tuple[float, float, float, float]
    between: str
    doorway: tuple[float, float]
    least_share: float = 0.04

    @property
    def kinds(self) -> tuple[str, ...]:
        """Kinds of room that a walk can stay in."""
        return tuple(self.stays)

    @classmethod
    def of(cls, values: Mapping[str, Any], where: str = "rendering.walk") -> "Statistics":
        """Create the statistics from settings.

        Raises
        ------
        PlacecatError
            If a setting does not exist.
        """
        settings.check(cls, values, where)
        given = dict(values)
        return cls(
            **{
                **given,
                "classes": tuple(given["classes"]),
                "count": LogNormal(**given["count"]),
                "stays": {kind: LogNormal(**stay) for kind, stay in given["stays"].items()},
                "transitions": LogNormal(**given["transitions"]),
                "transition_share": tuple(given["transition_share"]),
                "doorway": tuple(given["doorway"]),
            }
        )

    def draw_transition_share(self, rng: np.random.Generator) -> float:
        """Draw the share of a walk's frames that are transitions."""
        mean, deviation, least, most = self.transition_share
        return float(np.clip(rng.normal(mean, deviation), least, most))
