"""Robot@Home2: the database ``rh.db`` and the images in ``files/rgbd``, as unpacked from the archive.

A robot with four cameras drove through five homes. A home has one sequence per session, with the frames from
one camera in temporal order. The label of a frame is the type of its room, such as ``livingroom``. The data
set's ``aliases`` setting maps each type to a class. Recordings that span several rooms have the type
``fullhouse``.

References
----------
G. Ambrosio-Cestero, J.-R. Ruiz-Sarmiento, J. Gonzalez-Jimenez, The Robot@Home2 dataset: A new release with
improved usability tools. SoftwareX 23, 101490, 2023.
Definitions of the tables: https://github.com/goyoambrosio/RobotAtHome2 (``robotathome/transition``).
"""

from collections.abc import Iterable, Iterator, Mapping
from itertools import pairwise
from pathlib import Path
from typing import Annotated, Any, Literal, NamedTuple

import numpy as np

from placecat.errors import PlacecatError, did_you_mean
from placecat.footage.names import natural, relative
from placecat.ranges import OneOf, Positive
from placecat.sequences.base import Home, frame_table, home_of_pictures
from placecat.sequences.folders import check_listed, data_folder, frame_rate
from placecat.sequences.labels import shown
from placecat.sequences.sqlite_file import Columns, SqliteFile, opened

DATABASE, PICTURES = "rh.db", "files/rgbd"
OBSERVATIONS = {"labelled": ("rh_lblrgbd",), "all": ("rh_lblrgbd", "rh_raw")}
"""The tables for each value of `observations`. ``labelled`` selects only frames with labelled objects, and
``all`` also selects the other frames, even discarded ones."""
FILES = "rh2_old2new_rgbd_files"
COLOR = "_intensity.png"
"""Suffix of colour images. The other files contain depth and labels."""
TICKS = 10_000_000
"""Ticks per second of the clock in the database."""

_NAMED: Columns = {"id": int, "name": str}
_OBSERVED: Columns = {
    "id": int,
    "home_session_id": int,
    "room_id": int | None,
    "time_stamp": int,
    "home_id": int,
    "sensor_id": int,
}
_FILE_NAMES = dict.fromkeys(("new_file_1", "new_file_2", "new_file_3"), str | None)
_TABLES: dict[str, Columns] = {
    **dict.fromkeys(("rh_homes", "rh_home_sessions", "rh_room_types", "rh_sensors"), _NAMED),
    "rh_rooms": {"id": int, "room_type_id": int},
    FILES: {"id": int, "new_path": str, **_FILE_NAMES},
}


class _Observation(NamedTuple):
    """A frame, with its session, time, number in the database, room type ("" if none), and image."""

    session: str
    ticks: int
    number: int
    room: str
    picture: str


def read_home(
    root: Path,
    name: str,
    *,
    fps: float | None = None,
    camera: str = "RGBD_1",
    observations: Annotated[str, OneOf(OBSERVATIONS)] = "labelled",
    turn: Literal[0, 90, 180, 270] = 0,
    longest_gap: Positive = 1.0,
    database: str = DATABASE,
    pictures: str = PICTURES,
) -> Home:
    """Read the frames from one camera in one home, with one sequence per session.

    See `placecat.sequences.open_home`.

    Parameters
    ----------
    fps
        Frames per second, if frames are to be evenly spaced. With None, times come from the database, and the
        rate is computed from the median time between frames.
    camera
        ``RGBD_1`` to ``RGBD_4``.
    observations
        A key of `OBSERVATIONS`.
    turn
        Clockwise rotation of the images in degrees.
    longest_gap
        Longest time allowed between two frames of a session, in seconds. Longer gaps, which occur between
        rooms, are shortened to this length.
    database, images
        Paths of the database and the folder of colour images, relative to `root`.
    """
    relative(name, "dataset.homes")
    file = data_folder(root) / relative(database, "dataset.database")
    folder = root / relative(pictures, "dataset.pictures")
    tables = OBSERVATIONS[observations]
    with opened(file, _TABLES | dict.fromkeys(tables, _OBSERVED)) as data:
        home = _number(data.rows("rh_homes"), name, f"{file} has no home", "dataset.homes")
        sensor = _number(data.rows("rh_sensors"), camera, f"{file} has no camera", "dataset.camera")
        frames = sorted(
            (one for table in tables for one in _observations(data, file, table, home, sensor)),
            key=lambda one: (natural(one.session), one.ticks, one.number),
        )
    if not frames:
        raise PlacecatError(
            f"{file}: {name} has no frames from camera {camera} in {' or '.join(tables)}; choose another "
            "dataset.camera or dataset.observations."
        )
    sources = [f"{pictures}/{one.picture}" for one in frames]
    _check_pictures(file, root, folder, sources)
    numbers, seconds, median = _times(frames, longest_gap)
    rate = frame_rate(fps, name, median)
    sessions, rooms = [one.session for one in frames], [one.room for one in frames]
    times = seconds if fps is None else (np.array(numbers) - 1) / rate
    table = frame_table(sessions, sources, -1, numbers, times, rooms, turn)
    return home_of_pictures(name, root, rate, camera, table, {}, [0] * len(frames))


def _number(rows: Iterable[tuple[int, str]], name: str, missing: str, setting: str) -> int:
    """Look up the number that belongs to a name in the rows of a table."""
    numbers = {named: number for number, named in rows}
    if name not in numbers:
        question, there = did_you_mean(name, numbers), shown(", ".join(numbers))
        raise PlacecatError(f"{missing} {name!r}{question} (it has {there}); correct {setting}.")
    return numbers[name]


def _observations(data: SqliteFile, file: Path, table: str, home: int, sensor: int) -> Iterator[_Observation]:
    types, sessions = dict(data.rows("rh_room_types")), dict(data.rows("rh_home_sessions"))
    rooms = dict(data.rows("rh_rooms"))
    pictures = {
        number: f"{path}/{picture}"
        for number, path, *names in data.rows(FILES)
        for picture in names
        if picture is not None and picture.endswith(COLOR)
    }
    for number, session, room, ticks, *_ in data.rows(table, home_id=home, sensor_id=sensor):
        where = f"{file}: observation {number} of {table}"
        if number not in pictures:
            # rh_raw repeats the labelled observations, but FILES lists their images under the numbers from
            # rh_lblrgbd.
            if table == "rh_raw":
                continue
            raise PlacecatError(f"{where} has no image *{COLOR} in {FILES}; restore the file.")
        kind = "" if room is None else _known(types, _known(rooms, room, where, "rooms"), where, "room_types")
        yield _Observation(
            _known(sessions, session, where, "home_sessions"),
            ticks,
            number,
            kind,
            relative(pictures[number], where).as_posix(),
        )


def _known(named: Mapping[int, Any], number: int, where: str, table: str) -> Any:
    if number not in named:
        raise PlacecatError(f"{where} refers to {number}, which is not in rh_{table}; restore the file.")
    return named[number]


def _times(frames: list[_Observation], longest_gap: float) -> tuple[list[int], list[float], float | None]:
    """Return each frame's number and time in its session, and the frame rate from the median step.

    Times are in seconds. The rate is None if there are no steps.
    """
    # Whole ticks are exact; seconds since 1601 are not.
    longest = round(longest_gap * TICKS)
    numbers, ticks, steps = [1], [0], []
    for before, one in pairwise(frames):
        is_same = one.session == before.session
        step = one.ticks - before.ticks
        numbers.append(numbers[-1] + 1 if is_same else 1)
        ticks.append(ticks[-1] + min(step, longest) if is_same else 0)
        if is_same and step > 0:
            steps.append(step)
    rate = TICKS / float(np.median(steps)) if steps else None
    return numbers, [tick / TICKS for tick in ticks], rate


def _check_pictures(file: Path, root: Path, folder: Path, sources: list[str]) -> None:
    if not folder.is_dir():
        raise PlacecatError(
            f"{folder}: the image folder is missing; unpack the images there, or correct dataset.pictures."
        )
    wanted: dict[Path, dict[str, str]] = {}
    for path in (root / source for source in sources):
        wanted.setdefault(path.parent, {})[path.name] = f"{file} lists it"
    for place, listed in wanted.items():
        check_listed(place, folder, str(file), listed, "restore it")
