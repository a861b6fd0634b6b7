"""A home drawn from a seed, with its floor plan, furniture, lighting and walk. It is stored as plain YAML."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import yaml

from placecat import settings
from placecat.errors import PlacecatError, SettingError
from placecat.seeds import derive
from placecat_homes.building import Building, build
from placecat_homes.drawn import arrangements, plans
from placecat_homes.drawn.faults import faults, of_rooms
from placecat_homes.drawn.ranges import KINDS, LightRanges, PlanRanges, chosen
from placecat_homes.walking.carriage import Carriage
from placecat_homes.walking.walk import Walk, walk
from placecat_homes.walking.walk_statistics import Statistics

SETTINGS = Path(__file__).parents[1] / "conf"

_DRAWS = 40
_WALKS = 6
_CORRIDOR = 0.4


@dataclass(frozen=True)
class Video:
    """Size and length of the videos.

    Attributes
    ----------
    width, height
        Even numbers of pixels from 160 to 4096.
    frames
        Frames per home, from 200 to 20,000.
    fps
        Frames per second, from 1 to 60.
    """

    width: int
    height: int
    frames: int
    fps: int

    def __post_init__(self) -> None:
        """Raise SettingError if a value is out of range."""
        for name, least, most in (
            ("width", 160, 4096),
            ("height", 90, 4096),
            ("frames", 200, 20000),
            ("fps", 1, 60),
        ):
            value = getattr(self, name)
            if isinstance(value, bool) or not isinstance(value, int) or not least <= value <= most:
                raise SettingError(f"{name} must be a whole number from {least} to {most}, not {value!r}")
        if self.width % 2 or self.height % 2:
            raise SettingError(f"width and height must be even, not {self.width}x{self.height}")


@dataclass(frozen=True)
class Source:
    """Settings used to draw homes.

    Attributes
    ----------
    plan, light
        Ranges for floor plans and lighting.
    walk, carriage, camera
        Names of files in conf/.
    video
        Size and length of the videos.
    """

    plan: PlanRanges
    light: Mapping[str, LightRanges]
    walk: str
    carriage: str
    camera: str
    video: Video

    @classmethod
    def read(cls, path: Path = SETTINGS / "drawn.yaml", /, **video: int) -> "Source":
        """Read the settings. `video` overrides the video settings. Invalid settings raise SettingError."""
        content = settings.read_yaml(path)
        settings.check(cls, content, str(path))
        where = f"{path} video"
        changed = {**content["video"], **video}
        return cls(
            PlanRanges.of(content["plan"], f"{path} plan", arrangements.ALL),
            LightRanges.of(content["light"], f"{path} light"),
            str(content["walk"]),
            str(content["carriage"]),
            str(content["camera"]),
            settings.call(Video, settings=changed, where=where),
        )


@dataclass(frozen=True, eq=False)
class Home:
    """A drawn home.

    Attributes
    ----------
    content
        `plan` has the same structure as the files in conf/plan. `shot` contains the video's other settings,
        as in conf/videos.yaml.
    building
        The furnished home.
    walk
        The walk through it.
    """

    content: dict[str, Any]
    building: Building
    walk: Walk

    def text(self) -> str:
        """The content as YAML, with a comment at the top."""
        plan, shot = self.content["plan"], self.content["shot"]
        head = f"# {plan['name'].capitalize()}, drawn by placecat-homes. Rooms in metres, as in conf/plan.\n"
        rooms = {name: _flow(room) for name, room in plan["rooms"].items()}
        lines = [head + yaml.safe_dump({"shot": shot}, sort_keys=False, width=200) + "plan:"]
        lines += [f"  {key}: {plan[key]}" for key in ("name", "height", "glazing")]
        lines += ["  rooms:", *(f"    {name}: {room}" for name, room in rooms.items())]
        lines += ["  doors:", *(f"  - {_flow(door)}" for door in plan["doors"])]
        return "\n".join(lines) + "\n"


def _flow(value: Mapping[str, Any]) -> str:
    return yaml.safe_dump(dict(value), sort_keys=False, default_flow_style=True, width=1000).strip()


def name_of(number: int, seed: int) -> str:
    """Return the name of a home, such as "home 7 of seed 1". The name alone seeds everything in the home."""
    return f"home {number} of seed {seed}"


def draw(number: int, seed: int, source: Source) -> Home:
    """Draw homes until one has no faults.

    Parameters
    ----------
    number
        Number of the home, from 1.
    seed
        Seed of the set of homes.
    source
        Settings to draw from.

    Returns
    -------
    Home
        The first home drawn without faults. It depends only on its name and `source`, not on other homes.

    Raises
    ------
    PlacecatError
        If every home drawn has faults, for example because there are too few frames to show every room.
    """
    name = name_of(number, seed)
    reason = ""
    for attempt in range(1, _DRAWS + 1):
        plan = plans.draw(name, attempt, source.plan)
        rooms = _stays(name, attempt, plan["rooms"])
        try:
            building = build(plans.read(plan), attempt)
            reason = next(of_rooms(building), "")
            if reason:
                continue
            for number_of_walk in range(1, _WALKS + 1):
                of_walk = name if number_of_walk == 1 else f"{name}, walk {number_of_walk}"
                way = _walk(of_walk, building, rooms, source)
                reason = next(faults(building, way), "")
                if not reason:
                    light = _light(name, source.light)
                    shot = {"name": of_walk, "building": attempt, **light, "rooms": rooms}
                    return Home({"shot": shot, "plan": plan}, building, way)
        except PlacecatError as error:
            reason = str(error)
    raise PlacecatError(f"{name}: all {_DRAWS} plans drawn have faults; the last fault: {reason}")


def _walk(name: str, building: Building, rooms: list[str], source: Source) -> Walk:
    """Walk through a building just as `placecat_homes.film.Film` does for a video with this name."""
    return walk(
        building.ground(),
        np.random.default_rng(derive("walk", name)),
        Statistics.of(read("walk", source.walk)),
        Carriage.of(read("carriage", source.carriage)),
        source.video.frames,
        source.video.fps,
        rooms=rooms,
    )


def read(kind: str, name: str) -> dict[str, Any]:
    """Read a file from conf/."""
    return settings.read_yaml(SETTINGS / f"{kind}/{name}.yaml")


def _light(name: str, ranges: Mapping[str, LightRanges]) -> dict[str, Any]:
    rng = np.random.default_rng(derive("light", name))
    weather = chosen(rng, {key: of_one.odds for key, of_one in ranges.items()})
    drawn = ranges[weather]
    return {
        "weather": weather,
        "azimuth": round(rng.uniform(*drawn.azimuth), 1),
        "elevation": round(rng.uniform(*drawn.elevation), 1),
        "lamps": round(rng.uniform(*drawn.lamps), 2),
    }


def _stays(name: str, attempt: int, rooms: Mapping[str, Mapping[str, Any]]) -> list[str]:
    """List the rooms that the walk stays in: all rooms except some corridors."""
    rng = np.random.default_rng(derive("stays", name, attempt))
    return [room for room, of_one in rooms.items() if of_one["kind"] in KINDS or rng.random() < _CORRIDOR]
