"""What carries the camera, and how steadily it does so."""

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
        Standard deviation of the height between walks in metres.
    speed, top_speed
        Usual and highest speed in metres a second.
    turn_rate
        Highest rate of turning in degrees a second.
    turn_acceleration
        Highest change of that rate in degrees a second squared.
    pitch
        Mean tilt in degrees; negative looks down.
    pitch_spread
        Standard deviation of the mean tilt between walks in degrees.
    pitch_wander, roll_wander, yaw_wander
        Standard deviations of slow wandering in degrees.
    shake
        Standard deviation of the tremor in degrees, in each angle.
    step
        Height of the bobbing with each step in metres; 0 on wheels.
    steers
        Whether the camera looks where it drives and turns on the spot, as on a robot; otherwise it looks
        around.
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
        """Make a carriage from settings.

        Raises
        ------
        PlacecatError
            If a setting does not exist.
        """
        settings.check(cls, values, where)
        return cls(**values)
