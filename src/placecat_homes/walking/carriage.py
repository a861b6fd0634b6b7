"""What carries the camera and how steadily."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from placecat import settings


@dataclass(frozen=True)
class Carriage:
    """A person, a chair or a robot with a camera.

    Attributes
    ----------
    height
        Height of the camera in metres.
    height_spread
        Standard deviation of the height across walks, in metres.
    speed, top_speed
        Usual and maximum speed in metres per second.
    turn_rate
        Maximum turning rate in degrees per second.
    turn_acceleration
        Maximum turning acceleration in degrees per second squared.
    pitch
        Mean tilt in degrees; negative looks down.
    pitch_spread
        Standard deviation of the mean tilt across walks, in degrees.
    pitch_wander, roll_wander, yaw_wander
        Standard deviations of slow wandering, in degrees.
    shake
        Standard deviation of the shaking in each angle, in degrees.
    step
        Height in metres by which the camera bobs up and down with each step; 0 on wheels.
    steers
        Whether the camera faces the direction of travel and turns on the spot, like that of a robot.
        Otherwise, it looks around.
    """

    height: float
    height_spread: float
    speed: float
    top_speed: float
    turn_rate: float
    turn_acceleration: float
    pitch: float
    pitch_spread: float
    pitch_wander: float
    roll_wander: float
    yaw_wander: float
    shake: float
    step: float
    steers: bool

    @classmethod
    def of(cls, values: Mapping[str, Any], where: str = "rendering.carriage") -> "Carriage":
        """Create a carriage from settings.

        Raises
        ------
        PlacecatError
            If a setting does not exist.
        """
        settings.check(cls, values, where)
        return cls(**values)
