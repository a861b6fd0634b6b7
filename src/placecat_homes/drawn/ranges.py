"""Validated ranges for drawing floor plans and lighting."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from placecat import settings
from placecat.errors import SettingError

KINDS = ("bedroom", "bathroom", "kitchen", "living_room", "dining_room")
"""Kinds of room that every home has."""
WEATHERS = ("sunny", "cloudy", "dusk", "night")

Range = tuple[float, float]


@dataclass(frozen=True)
class PlanRanges:
    """Ranges for floor plans, as (minimum, maximum) in metres or square metres.

    Attributes
    ----------
    arrangements
        Maps names of functions in :mod:`placecat_homes.drawn.arrangements` to odds.
    bedrooms, bathrooms
        Map room counts to odds, for 1 to 3 bedrooms and 1 or 2 bathrooms.
    height
        Ceiling height, from 2.3 to 4 m.
    glazing
        Share of the outer walls that is glazed (see `FloorPlan`), from 0.1 to 0.9.
    depth
        Depth of a row of rooms, from 2.8 to 8 m.
    corridor
        Width of corridors, from 1.1 to 3 m.
    areas, sides
        Floor area and shorter side of each kind of room.
    door, opening
        Widths of doors (0.75 to 1.1 m) and of openings without a leaf (0.9 to 2.5 m).
    """

    arrangements: Mapping[str, float]
    bedrooms: Mapping[int, float]
    bathrooms: Mapping[int, float]
    height: Range
    glazing: Range
    depth: Range
    corridor: Range
    areas: Mapping[str, Range]
    sides: Mapping[str, Range]
    door: Range
    opening: Range

    @classmethod
    def of(cls, values: Mapping[str, Any], where: str, arrangements: Collection[str]) -> "PlanRanges":
        """Create the ranges from settings. Missing, unknown or invalid settings raise SettingError.

        `where` names the settings in messages. `arrangements` contains the valid arrangement names.
        """
        pairs: dict[str, Any] = {
            name: _range(values, name, where, least, most)
            for name, least, most in (
                ("height", 2.3, 4.0),
                ("glazing", 0.1, 0.9),
                ("depth", 2.8, 8.0),
                ("corridor", 1.1, 3.0),
                ("door", 0.75, 1.1),
                ("opening", 0.9, 2.5),
            )
            if name in values
        }
        for name, least, most in (("areas", 3.0, 60.0), ("sides", 1.6, 8.0)):
            of_kind = values.get(name, {})
            settings.refuse_unknown(of_kind, list(KINDS), f"{where} {name}")
            pairs[name] = {kind: _range(of_kind, kind, f"{where} {name}", least, most) for kind in KINDS}
        for name, valid in (
            ("arrangements", tuple(arrangements)),
            ("bedrooms", (1, 2, 3)),
            ("bathrooms", (1, 2)),
        ):
            if name in values:
                _check_odds(values[name], valid, f"{where} {name}")
        made: PlanRanges = settings.call(cls, settings={**values, **pairs}, where=where)
        return made


@dataclass(frozen=True)
class LightRanges:
    """Ranges for the lighting in one kind of weather.

    Attributes
    ----------
    odds
        Odds of this kind of weather.
    azimuth, elevation
        Position of the sun, in degrees.
    lamps
        Share of rooms with the lights on, from 0 to 1.
    """

    odds: float
    azimuth: Range
    elevation: Range
    lamps: Range

    @classmethod
    def of(cls, values: Mapping[str, Any], where: str) -> dict[str, "LightRanges"]:
        """Create ranges for each kind of weather. Missing, unknown or invalid settings raise SettingError."""
        settings.refuse_unknown(values, list(WEATHERS), where)
        _check_odds({name: one.get("odds", -1) for name, one in values.items()}, WEATHERS, f"{where} odds")
        made = {}
        for weather, one in values.items():
            of_one = f"{where} {weather}"
            pairs = {
                name: _range(one, name, of_one, 0.0, most)
                for name, most in (("azimuth", 360.0), ("elevation", 90.0), ("lamps", 1.0))
            }
            made[weather] = settings.call(cls, settings={**one, **pairs}, where=of_one)
        return made


def _range(values: Mapping[Any, Any], name: str, where: str, least: float, most: float) -> Range:
    given: Any = values.get(name)
    try:
        low, high = (float(value) for value in given)
    except (TypeError, ValueError):
        raise SettingError(f"{where} {name} must be [minimum, maximum], not {given!r}") from None
    if not least <= low <= high <= most:
        raise SettingError(
            f"{where} {name} must be [minimum, maximum] between {least:g} and {most:g}, "
            f"not [{low:g}, {high:g}]"
        )
    return low, high


def _check_odds(odds: Mapping[Any, Any], valid: tuple[Any, ...], where: str) -> None:
    unknown = [name for name in odds if name not in valid]
    numbers = [value for value in odds.values() if isinstance(value, (int, float)) and 0 <= value < 1e6]
    if unknown or len(numbers) != len(odds) or not sum(numbers) > 0:
        raise SettingError(
            f"{where} needs odds for some of {', '.join(map(str, valid))}: non-negative numbers, not all 0"
        )


def chosen(rng: np.random.Generator, odds: Mapping[Any, float]) -> Any:
    """Draw a name with a probability proportional to its odds."""
    names = list(odds)
    shares = np.array([odds[name] for name in names], dtype=np.float64)
    return names[int(rng.choice(len(names), p=shares / shares.sum()))]
