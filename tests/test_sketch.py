import hashlib
from pathlib import Path

import cv2
import numpy as np
import pytest

from placecat.errors import PlacecatError
from placecat.sequences import list_homes, open_home, read_frames
from sketch import ROOMS, WALL_HEIGHT, WALL_WIDTH, draw_homes, draw_room, shade

SMALL = {"homes": 4, "frames_per_room": 4, "width": 96, "height": 54}
CLASSES = {"kitchen", "bathroom", "living_room", "dining_room", "bedroom"}


def digests(root: Path) -> dict[str, str]:
    files = sorted(path for path in root.rglob("*") if path.is_file())
    return {
        path.relative_to(root).as_posix(): hashlib.sha256(path.read_bytes()).hexdigest() for path in files
    }


@pytest.fixture(scope="module")
def drawn(tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("sketch") / "deep/homes"
    draw_homes(out, **SMALL)
    return out


def test_the_reader_reads_them(drawn: Path) -> None:
    assert list_homes("vpc2009", drawn) == ["Home1", "Home2", "Home3", "Home4"]
    for name in list_homes("vpc2009", drawn):
        home = open_home("vpc2009", drawn, name, fps=5.0)
        labels = home.frames["label"]
        assert set(labels) == {*CLASSES, "corridor", "transition"}
        assert labels.value_counts()[sorted(CLASSES)].tolist().count(4) == 3
        assert labels.value_counts()[sorted(CLASSES)].tolist().count(6) == 2
        assert home.frames["sequence"].unique().tolist() == (["1", "2"] if name == "Home4" else ["1"])
        assert (home.width, home.height) == (96, 54)
        frames = list(read_frames(drawn, home.frames, size=(96, 54)))
        assert len(frames) == len(labels)
        assert min(float(frame.std()) for frame in frames) > 5


def test_nothing_else_is_left(drawn: Path) -> None:
    assert [path.name for path in drawn.parent.iterdir()] == ["homes"]


def test_same_seed_same_bytes(drawn: Path, tmp_path: Path) -> None:
    draw_homes(tmp_path / "again", **SMALL)
    assert digests(tmp_path / "again") == digests(drawn)


def test_another_seed_is_another_home(drawn: Path, tmp_path: Path) -> None:
    draw_homes(tmp_path / "other", **{**SMALL, "homes": 1}, seed=1)
    one, other = digests(drawn), digests(tmp_path / "other")
    assert one["Home1/1/00000001.jpg"] != other["Home1/1/00000001.jpg"]


def test_every_room_of_every_home_differs(drawn: Path) -> None:
    images = [digest for name, digest in digests(drawn).items() if name.endswith(".jpg")]
    assert len(set(images)) == len(images)


@pytest.mark.slow
def test_colours_do_not_tell_classes() -> None:
    # The nearest mean colour of the other homes' classes names few walls correctly (chance 20 %).
    homes, rooms = 12, sorted(CLASSES)
    means = np.array(
        [
            [
                draw_room(room, np.random.default_rng([home, i])).mean(axis=(0, 1))
                for i, room in enumerate(rooms)
            ]
            for home in range(homes)
        ]
    )
    right = 0
    for home in range(homes):
        others = np.delete(means, home, axis=0).mean(axis=0)
        distance = np.linalg.norm(means[home][:, None] - others, axis=2)
        right += int((distance.argmin(axis=1) == np.arange(len(rooms))).sum())
    assert right / (homes * len(rooms)) <= 0.35


def test_threads_do_not_change_a_byte(tmp_path: Path) -> None:
    threads = cv2.getNumThreads()
    try:
        cv2.setNumThreads(1 if threads > 1 else 2)
        draw_homes(tmp_path / "again", **{**SMALL, "homes": 1, "width": 640, "height": 360})
        cv2.setNumThreads(threads)
        draw_homes(tmp_path / "more", **{**SMALL, "homes": 1, "width": 640, "height": 360})
    finally:
        cv2.setNumThreads(threads)
    assert digests(tmp_path / "again") == digests(tmp_path / "more")


def test_a_failure_leaves_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(path: Path, data: bytes) -> int:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "write_bytes", full)
    with pytest.raises(OSError, match="No space left"):
        draw_homes(tmp_path / "homes", **SMALL)
    assert list(tmp_path.iterdir()) == []


def test_walls_are_of_the_size_given() -> None:
    for room in ROOMS:
        wall = draw_room(room, np.random.default_rng(3))
        assert (wall.shape, wall.dtype) == ((WALL_HEIGHT, WALL_WIDTH, 3), np.uint8)


def test_shade() -> None:
    assert shade((10, 100, 200), 1.5) == (15, 150, 255)


def test_an_empty_folder_is_taken_over_and_a_full_one_refused(tmp_path: Path) -> None:
    out = tmp_path / "homes"
    out.mkdir()
    leftover = tmp_path / ".homes.partial"
    (leftover / "Home9").mkdir(parents=True)
    draw_homes(out, **{**SMALL, "homes": 1})
    assert list_homes("vpc2009", out) == ["Home1"]
    assert not leftover.exists()
    with pytest.raises(PlacecatError, match="homes: already there; remove it"):
        draw_homes(out, **SMALL)


@pytest.mark.parametrize(
    ("setting", "value"), [("homes", 0), ("frames_per_room", 1), ("width", 8), ("height", 8)]
)
def test_too_small(setting: str, value: int, tmp_path: Path) -> None:
    with pytest.raises(PlacecatError, match=f"{setting} is {value}; set it to [0-9]+ or more"):
        draw_homes(tmp_path / "homes", **{**SMALL, setting: value})
    assert list(tmp_path.iterdir()) == []
