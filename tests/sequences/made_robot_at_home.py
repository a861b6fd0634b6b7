"""Make a small data set with the tables and images of Robot@Home2."""

import sqlite3
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import NamedTuple

import cv2
import numpy as np
from numpy.typing import NDArray

HOMES = {
    "alma": ["bathroom1", "bedroom1", "fullhouse1", "kitchen1", "livingroom1", "masterroom1"],
    "anto": ["corridor1", "bathroom1", "bedroom1", "dressingroom1", "kitchen1", "livingroom1"],
    "pare": ["hall1", "kitchen1", "livingroom1", "masterroom1", "bathroom1", "bathroom2"],
    "rx2": ["livingroom1", "kitchen1", "bedroom1", "bathroom1"],
    "sarmis": ["bedroom1", "bathroom1", "kitchen1", "livingroom1"],
}
SESSIONS = ["alma-s1", "anto-s1", "pare-s1", "rx2-s1", "sarmis-s1", "sarmis-s2", "sarmis-s3"]
TYPES = [
    *("bathroom", "bedroom", "fullhouse", "kitchen", "livingroom"),
    *("masterroom", "corridor", "dressingroom", "hall"),
]
SENSORS = ["HOKUYO1", "RGBD_1", "RGBD_2", "RGBD_3", "RGBD_4"]
START, STEP, PAUSE, DAY = 130488627193178472, 936_000, 600_000_000, 864_000_000_000
_OBSERVED = """id integer NOT NULL UNIQUE, room_id integer, home_session_id integer,
    home_subsession_id integer, home_id integer, name text, sensor_id integer, sensor_pose_x real,
    sensor_pose_y real, sensor_pose_z real, sensor_pose_yaw real, sensor_pose_pitch real,
    sensor_pose_roll real, laser_aperture real, laser_max_range real, laser_num_of_scans integer,
    time_stamp integer, sensor_type integer, sensor_file_1 text, sensor_file_2 text, sensor_file_3 text,
    files_path text, PRIMARY KEY(id)"""
_NAMED = "id integer NOT NULL UNIQUE, name text, PRIMARY KEY(id)"
_DEFINITIONS = f"""
CREATE TABLE rh_homes ({_NAMED});
CREATE TABLE rh_room_types ({_NAMED});
CREATE TABLE rh_home_sessions (id integer NOT NULL UNIQUE, home_id integer, name text, PRIMARY KEY(id));
CREATE TABLE rh_rooms (id integer NOT NULL UNIQUE, home_id integer, name text, room_type_id integer);
CREATE TABLE rh_sensors (id integer NOT NULL UNIQUE, sensor_type_id integer, name text, PRIMARY KEY(id));
CREATE TABLE rh_raw ({_OBSERVED});
CREATE TABLE rh_rgbd ({_OBSERVED});
CREATE TABLE rh_lblrgbd ({_OBSERVED});
CREATE TABLE rh2_old2new_rgbd_files (id INT, old_path TEXT, old_file_1 TEXT, old_file_2 TEXT, old_file_3 TEXT,
    new_path TEXT, new_file_1 TEXT, new_file_2 TEXT, new_file_3 TEXT);
"""


class Seen(NamedTuple):
    """One observation of a camera."""

    home: str
    session: str
    room: str
    kind: str
    camera: str
    ticks: int
    is_labelled: bool
    source: str


Picture = Callable[[str, str, int], NDArray[np.uint8]]


def make(root: Path, picture: Picture, *, cameras: Sequence[int] = (1, 2), frames: int = 4) -> list[Seen]:
    """Write ``rh.db`` and ``files/rgbd`` to a new folder.

    Parameters
    ----------
    image
        Function that makes an image from the home, the room, and the frame number in the data set, from 0.
    cameras
        Numbers of the cameras, from 1 to 4.
    frames
        Number of frames per room, camera and sub-session. The last one is discarded, as is every frame of
        ``fullhouse1``.

    Returns
    -------
    The observations in time order.
    """
    root.mkdir(parents=True)
    raw, labelled, files, seen = [], [], [], []
    for session, name in enumerate(SESSIONS):
        home, ticks = name.split("-")[0], START + session * DAY
        parts = range(2 if home == "sarmis" else 1)
        for part, room in ((part, room) for part in parts for room in HOMES[home]):
            ticks += PAUSE
            for frame in range(frames):
                # No two steps are equal, as with a real camera.
                ticks += STEP + frame
                raw.append(_row(len(raw) + 1, home, session, part, room, 0, ticks, "scan.txt"))
                for camera in cameras:
                    is_labelled = frame < frames - 1 and room != "fullhouse1"
                    moment, number = ticks + camera, len(raw) + 1
                    raw.append(_row(number, home, session, part, room, camera, moment, "intensity.png"))
                    if is_labelled:
                        number = 100_000 + len(labelled)
                        labelled.append(
                            _row(number, home, session, part, room, camera, moment, "intensity.png")
                        )
                    path = f"session_{session + 1}/{home}/{room}/subsession_{part + 1}"
                    names = [f"{number}_depth.png", f"{number}_intensity.png"]
                    own = [*names, f"{number}_labels.txt" if is_labelled else ""]
                    files.append((number, f"old/{number}", *own, path, *own))
                    source = f"files/rgbd/{path}/{names[1]}"
                    (root / source).parent.mkdir(parents=True, exist_ok=True)
                    cv2.imwrite(str(root / source), picture(home, room, len(seen)))
                    kind = room[:-1]
                    seen.append(Seen(home, name, room, kind, SENSORS[camera], moment, is_labelled, source))
    with sqlite3.connect(root / "rh.db") as connection:
        connection.executescript(_DEFINITIONS)
        _fill(connection, "rh_homes", enumerate(HOMES))
        _fill(connection, "rh_room_types", enumerate(TYPES))
        _fill(
            connection,
            "rh_home_sessions",
            [(number, _home(name.split("-")[0]), name) for number, name in enumerate(SESSIONS)],
        )
        rooms = [(_home(home), f"{home}_{room}", TYPES.index(room[:-1])) for home, room in _rooms()]
        _fill(connection, "rh_rooms", [(number, *room) for number, room in enumerate(rooms)])
        _fill(connection, "rh_sensors", [(number, number > 0, name) for number, name in enumerate(SENSORS)])
        # Rows are not in time order.
        _fill(connection, "rh_raw", raw[::-1])
        _fill(connection, "rh_rgbd", [row for row in raw if row[6] > 0])
        _fill(connection, "rh_lblrgbd", labelled[::-1])
        _fill(connection, "rh2_old2new_rgbd_files", files[::-1])
    connection.close()
    return seen


def change(root: Path, statements: str) -> None:
    """Run SQL statements on the database."""
    connection = sqlite3.connect(root / "rh.db")
    connection.executescript(statements)
    connection.close()


def _rooms() -> list[tuple[str, str]]:
    return [(home, room) for home, rooms in HOMES.items() for room in rooms]


def _home(name: str) -> int:
    return list(HOMES).index(name)


def _row(number: int, home: str, session: int, part: int, room: str, sensor: int, ticks: int, file: str):
    place = (_rooms().index((home, room)), session, part, _home(home), SENSORS[sensor], sensor)
    own = ("", f"{number}_depth.png", f"{number}_{file}") if sensor else (f"{number}_scan.txt", "", "")
    return (number, *place, *[0.0] * 8, 0, ticks, int(sensor > 0), *own, "old")


def _fill(connection: sqlite3.Connection, table: str, rows) -> None:
    listed = list(rows)
    connection.executemany(f"INSERT INTO {table} VALUES ({', '.join('?' * len(listed[0]))})", listed)
