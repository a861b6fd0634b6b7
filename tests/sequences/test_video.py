from pathlib import Path

import numpy as np
import pytest
from helpers_sequences import decoded, write_video

from placecat.errors import PlacecatError
from placecat.sequences import video
from placecat.sequences.base import read_frames


def test_round_trip(tmp_path: Path) -> None:
    write_video(tmp_path / "flat.v2.avi", 12, fps=12.5)
    (tmp_path / "flat.v2.csv").write_text("start,end,label\n1,5,kitchen\n6,12,transition\n")
    home = video.read_home(tmp_path, "flat.v2", camera="phone")
    assert (home.fps, home.camera, home.width, home.height) == (12.5, "phone", 64, 48)
    assert home.frames["label"].tolist() == ["kitchen"] * 5 + ["transition"] * 7
    assert home.frames["position"].tolist() == list(range(12))
    assert home.frames["number"].tolist() == list(range(1, 13))
    np.testing.assert_allclose(home.frames["seconds"], np.arange(12) / 12.5)
    assert set(home.frames["source"]) == {"flat.v2.avi"}
    assert set(home.frames["sequence"]) == {"1"}
    assert home.label_files == {"1": "flat.v2.csv"}
    assert home.label_lines.tolist() == [2] * 5 + [3] * 7
    assert [decoded(image) for image in read_frames(tmp_path, home.frames)] == list(range(12))
    assert [decoded(image) for image in read_frames(tmp_path, home.frames[1::3])] == [1, 4, 7, 10]


@pytest.mark.parametrize(
    ("ending", "codec"), [("avi", "MJPG"), ("mp4", "mp4v"), ("mkv", "FFV1"), ("MKV", "mp4v")]
)
def test_every_frame_is_counted(ending: str, codec: str, tmp_path: Path) -> None:
    write_video(tmp_path / f"flat.{ending}", 40, fps=30000 / 1001, codec=codec)
    home = video.read_home(tmp_path, "flat")
    assert len(home.frames) == 40
    assert home.fps == pytest.approx(30000 / 1001, rel=1e-4)
    assert [decoded(image) for image in read_frames(tmp_path, home.frames[::-7])] == list(range(39, -1, -7))


def test_labels_whose_ending_is_in_capitals(tmp_path: Path) -> None:
    write_video(tmp_path / "flat.avi", 4)
    (tmp_path / "flat.CSV").write_text("start,end,label\n1,4,kitchen\n")
    home = video.read_home(tmp_path, "flat")
    assert home.frames["label"].tolist() == ["kitchen"] * 4
    assert home.label_files == {"1": "flat.CSV"}


def test_without_labels(tmp_path: Path) -> None:
    write_video(tmp_path / "flat.avi", 3)
    home = video.read_home(tmp_path, "flat", fps=5.0)
    assert home.frames["label"].tolist() == ["", "", ""]
    assert home.label_lines.tolist() == [0, 0, 0]
    assert home.label_files == {}
    assert home.frames["seconds"].tolist() == [0.0, 0.2, 0.4]


def test_list_homes(tmp_path: Path) -> None:
    for name in ("b10.MP4", "b2.avi", ".b1.avi", "notes.csv"):
        (tmp_path / name).write_bytes(b"")
    (tmp_path / "folder.avi").mkdir()
    assert video.list_homes(tmp_path) == ["b2", "b10"]
    (tmp_path / "b2.mkv").write_bytes(b"")
    with pytest.raises(PlacecatError, match=r"b2\.mkv: b2\.avi has the same name; rename or remove one"):
        video.list_homes(tmp_path)


def test_a_video_in_a_subfolder(tmp_path: Path) -> None:
    write_video(tmp_path / "town/flat.avi", 3)
    (tmp_path / "town/flat.csv").write_text("start_seconds,end_seconds,label\n0,0.12,kitchen\n")
    home = video.read_home(tmp_path, "town/flat")
    assert set(home.frames["source"]) == {"town/flat.avi"}
    assert home.frames["label"].tolist() == ["kitchen"] * 3


def test_messages(tmp_path: Path) -> None:
    with pytest.raises(
        PlacecatError, match=r"flat: no video of this name \(\.avi, .*\); correct dataset.homes"
    ):
        video.read_home(tmp_path, "flat")
    with pytest.raises(PlacecatError, match=r"town/flat: no video of this name"):
        video.read_home(tmp_path, "town/flat")
    (tmp_path / "flat.avi").write_bytes(b"no video")
    with pytest.raises(PlacecatError, match=r"flat\.avi: not a readable video"):
        video.read_home(tmp_path, "flat")
    write_video(tmp_path / "flat.avi", 3)
    (tmp_path / "flat.csv").write_text("start,end,label\n1,2,kitchen\n")
    with pytest.raises(
        PlacecatError, match=r"flat\.csv line 2: the last segment of the video ends at frame 2"
    ):
        video.read_home(tmp_path, "flat")


def test_cut_off_video_is_shorter_and_says_so(tmp_path: Path) -> None:
    write_video(tmp_path / "flat.avi", 40)
    (tmp_path / "flat.csv").write_text("start,end,label\n1,40,kitchen\n")
    data = (tmp_path / "flat.avi").read_bytes()
    (tmp_path / "flat.avi").write_bytes(data[: len(data) // 2])
    with pytest.raises(
        PlacecatError, match=r"flat\.csv line 2: the segment ends at frame 40, but the video has"
    ):
        video.read_home(tmp_path, "flat")
