"""Test the Robot@Home2 layout on a small database with the same tables."""

import os
import shutil
from pathlib import Path

import cv2
import numpy as np
import pytest
from helpers_sequences import coded, decoded
from made_robot_at_home import HOMES, PAUSE, STEP, Seen, change, make

from placecat.errors import PlacecatError
from placecat.footage.frames import read_frames
from placecat.sequences import open_home
from placecat.sequences.robot_at_home import read_home

# The top is white, so a rotation is visible. The columns below it encode the number.
WIDTH, HEIGHT, TOP = 48, 64, 16


def picture(home: str, room: str, number: int) -> np.ndarray:
    image = coded(number % 256, WIDTH, HEIGHT)
    image[:TOP] = 200
    return image


def number_of(image: np.ndarray) -> int:
    return decoded(np.ascontiguousarray(image[TOP:]))


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, list[Seen]]:
    """Create a data set whose path contains characters with a special meaning in URLs."""
    root = tmp_path_factory.mktemp("data") / "a home?#%41"
    return root, make(root, picture)


@pytest.fixture
def copied(made: tuple[Path, list[Seen]], tmp_path: Path) -> Path:
    """Make a copy that tests can damage.

    Its images are hard links, so tests may replace them but must not write to them.
    """
    copy = tmp_path / "copy"
    shutil.copytree(made[0] / "files", copy / "files", copy_function=os.link)
    return Path(shutil.copy(made[0] / "rh.db", copy)).parent


def expected(seen: list[Seen], home: str, camera: str) -> list[Seen]:
    return [one for one in seen if (one.home, one.camera) == (home, camera)]


@pytest.mark.parametrize("home", HOMES)
@pytest.mark.parametrize("camera", ["RGBD_1", "RGBD_2"])
@pytest.mark.parametrize("observations", ["labelled", "all"])
def test_frames_are_in_time_order(
    made: tuple[Path, list[Seen]], home: str, camera: str, observations: str
) -> None:
    root, seen = made
    wanted = [one for one in expected(seen, home, camera) if observations == "all" or one.is_labelled]
    found = open_home("robot_at_home", root, home, camera=camera, observations=observations)
    assert found.frames["source"].tolist() == [one.source for one in wanted]
    assert found.frames["label"].tolist() == [one.kind for one in wanted]
    assert found.frames["sequence"].tolist() == [one.session for one in wanted]
    assert (found.camera, found.width, found.height) == (camera, WIDTH, HEIGHT)
    assert "turn" not in found.frames
    for _, part in found.frames.groupby("sequence"):
        assert part["number"].tolist() == list(range(1, len(part) + 1))
        assert part["seconds"].iloc[0] == 0
    numbers = [seen.index(one) % 256 for one in wanted]
    assert [number_of(image) for image in read_frames(root, found.frames)] == numbers


def test_three_sessions_are_sequences_of_one_home(made: tuple[Path, list[Seen]]) -> None:
    frames = read_home(made[0], "sarmis").frames
    # Two sub-sessions with four rooms and three frames each.
    assert frames.groupby("sequence").size().to_dict() == {f"sarmis-s{n}": 2 * 4 * 3 for n in (1, 2, 3)}


def test_times_come_from_the_database(made: tuple[Path, list[Seen]]) -> None:
    root, seen = made
    ticks = [one.ticks for one in expected(seen, "rx2", "RGBD_2") if one.is_labelled]
    assert max(np.diff(ticks)) > PAUSE
    as_seen = read_home(root, "rx2", camera="RGBD_2", longest_gap=1000.0)
    np.testing.assert_allclose(as_seen.frames["seconds"], (np.array(ticks) - ticks[0]) / 1e7, atol=1e-9)
    home = read_home(root, "rx2", camera="RGBD_2")
    np.testing.assert_allclose(np.diff(home.frames["seconds"]), np.minimum(np.diff(ticks) / 1e7, 1.0))
    assert home.fps == as_seen.fps == pytest.approx(1e7 / STEP, rel=1e-4)
    assert not home.is_even
    even = read_home(root, "rx2", camera="RGBD_2", fps=4.0)
    assert even.frames["seconds"].tolist() == [n / 4 for n in range(len(ticks))]
    assert even.is_even


@pytest.mark.parametrize("turn", [90, 180, 270])
def test_pictures_are_rotated_clockwise(made: tuple[Path, list[Seen]], turn: int) -> None:
    root, _ = made
    upright = read_home(root, "alma")
    home = read_home(root, "alma", turn=turn)  # type: ignore[arg-type]
    assert (home.width, home.height) == ((WIDTH, HEIGHT) if turn == 180 else (HEIGHT, WIDTH))
    assert home.frames["turn"].tolist() == [turn] * len(home.frames)
    both = zip(read_frames(root, home.frames), read_frames(root, upright.frames), strict=True)
    for image, before in both:
        # NumPy rotates counter-clockwise.
        np.testing.assert_array_equal(image, np.rot90(before, -turn // 90))
    with pytest.raises(PlacecatError, match="other frames of this home are 48x64"):
        next(read_frames(root, read_home(root, "alma", turn=90).frames, size=(WIDTH, HEIGHT)))


def test_database_and_picture_paths_are_settings(made: tuple[Path, list[Seen]], copied: Path) -> None:
    (copied / "rh.db").rename(copied / "other.db")
    (copied / "files").rename(copied / "pictures")
    home = read_home(copied, "anto", database="other.db", pictures="pictures/rgbd")
    assert home.frames["label"].tolist() == read_home(made[0], "anto").frames["label"].tolist()
    for setting in ("database", "pictures"):
        with pytest.raises(PlacecatError, match=rf"dataset\.{setting}: '\.\./x' is not a path below"):
            read_home(copied, "anto", **{"database": "other.db", setting: "../x"})  # type: ignore[arg-type]


def test_a_frame_without_a_room_has_no_label(copied: Path) -> None:
    change(copied, "UPDATE rh_lblrgbd SET room_id = NULL WHERE id = (SELECT max(id) FROM rh_lblrgbd)")
    assert read_home(copied, "sarmis", camera="RGBD_2").frames["label"].iloc[-1] == ""


def test_reading_writes_no_files(copied: Path) -> None:
    change(copied, "PRAGMA journal_mode = WAL; VACUUM;")
    before = {path: path.stat().st_mtime_ns for path in copied.rglob("*")}
    assert not list(copied.glob("rh.db-*"))
    read_home(copied, "alma")
    assert {path: path.stat().st_mtime_ns for path in copied.rglob("*")} == before


ONE = "files/rgbd/session_1/alma/bathroom1/subsession_1"


@pytest.mark.parametrize(
    ("statements", "message"),
    [
        ("DROP TABLE rh_rooms", r"the table rh_rooms is missing"),
        ("DROP TABLE rh_homes; CREATE VIEW rh_homes AS SELECT 0 id, 'alma' name", r"rh_homes is missing"),
        ("ALTER TABLE rh_lblrgbd DROP COLUMN time_stamp", r"rh_lblrgbd has no column time_stamp"),
        ("UPDATE rh_lblrgbd SET time_stamp = 'noon'", r"rh_lblrgbd has 'noon' in column time_stamp"),
        ("UPDATE rh_homes SET name = NULL", r"rh_homes has 'None' in column name"),
        (
            "UPDATE rh_homes SET name = zeroblob(2000000)",
            r"cannot be read as an SQLite database \(string or blob too big\)",
        ),
        ("DELETE FROM rh_homes WHERE name = 'alma'", r"no home 'alma'.*\(it has 'anto, .*dataset\.homes"),
        ("DELETE FROM rh_sensors WHERE name = 'RGBD_1'", r"no camera 'RGBD_1'.*HOKUYO1, RGBD_2, .*RGBD_4'\)"),
        ("DELETE FROM rh_lblrgbd WHERE sensor_id = 1", r"alma has no frames from camera RGBD_1 in rh_lbl"),
        ("DELETE FROM rh_room_types", r"\d+ of rh_lblrgbd refers to 0, which is not in rh_room_types"),
        ("DELETE FROM rh_home_sessions", r"refers to 0, which is not in rh_home_sessions"),
        ("DELETE FROM rh2_old2new_rgbd_files WHERE id = 100000", r"100000 of rh_lblrgbd has no image"),
        ("UPDATE rh2_old2new_rgbd_files SET new_file_2 = 'x_depth.png'", r"has no image \*_intensity"),
        ("UPDATE rh2_old2new_rgbd_files SET new_path = '../../..'", r"'\.\./.*' is not a path below"),
        ("UPDATE rh2_old2new_rgbd_files SET new_path = '/etc'", r"'/etc/.*' is not a path below"),
        ("UPDATE rh2_old2new_rgbd_files SET new_path = 'elsewhere'", r"elsewhere/.*: the frame is missing"),
    ],
)
def test_a_damaged_database(copied: Path, statements: str, message: str) -> None:
    change(copied, statements)
    with pytest.raises(PlacecatError, match=message) as caught:
        open_home("robot_at_home", copied, "alma")
    assert "\n" not in str(caught.value)
    assert len(str(caught.value)) < 400


def test_the_column_of_the_file_name_does_not_matter(made: tuple[Path, list[Seen]], copied: Path) -> None:
    change(copied, "UPDATE rh2_old2new_rgbd_files SET new_file_1 = new_file_2, new_file_2 = new_file_1")
    assert read_home(copied, "pare").frames.equals(read_home(made[0], "pare").frames)


def test_files_that_are_not_a_database(copied: Path) -> None:
    file = copied / "rh.db"
    content = file.read_bytes()
    for damaged, message in [(b"", "the table rh_homes is missing"), (b"x" * 9000, "not a database")]:
        file.write_bytes(damaged)
        with pytest.raises(PlacecatError, match=rf"rh\.db: .*{message}"):
            open_home("robot_at_home", copied, "alma")
    file.write_bytes(content[: len(content) // 3])
    with pytest.raises(PlacecatError, match=r"rh\.db: cannot be read as an SQLite database"):
        open_home("robot_at_home", copied, "alma")
    file.write_bytes(content)
    (copied / "rh.db-wal").write_bytes(b"x")
    with pytest.raises(PlacecatError, match=r"rh\.db: a program is writing to it.*\(rh\.db-wal\)"):
        open_home("robot_at_home", copied, "alma")
    file.unlink()
    with pytest.raises(PlacecatError, match=r"rh\.db: the database is missing; .*dataset\.root"):
        open_home("robot_at_home", copied, "alma")


def test_missing_pictures(copied: Path) -> None:
    (copied / ONE / "100002_intensity.png").unlink()
    with pytest.raises(PlacecatError, match=rf"{ONE}/100002_intensity\.png: the frame is missing"):
        open_home("robot_at_home", copied, "alma")
    open_home("robot_at_home", copied, "alma", camera="RGBD_2")
    shutil.rmtree(copied / "files/rgbd")
    with pytest.raises(PlacecatError, match=r"files/rgbd: the image folder is missing; unpack the images"):
        open_home("robot_at_home", copied, "alma")


def test_links_out_of_the_picture_folder(copied: Path, tmp_path: Path) -> None:
    secret = tmp_path / "secret.png"
    cv2.imwrite(str(secret), picture("", "", 1))
    (copied / ONE / "100002_intensity.png").unlink()
    (copied / ONE / "100002_intensity.png").symlink_to(secret)
    with pytest.raises(PlacecatError, match=r"100002_intensity\.png is a link that points outside"):
        open_home("robot_at_home", copied, "alma")
    # The folder with all images may be on another disk.
    (copied / ONE / "100002_intensity.png").unlink()
    shutil.copy(secret, copied / ONE / "100002_intensity.png")
    (copied / "files").rename(tmp_path / "disk")
    (copied / "files").symlink_to(tmp_path / "disk")
    assert len(open_home("robot_at_home", copied, "alma").frames) == 15
