from pathlib import Path

import numpy as np
import pytest
from clips import steady, turned_on_the_way, write_clip, zero
from helpers_sequences import decoded, write_video

from placecat.errors import PlacecatError
from placecat.footage.frames import read_frames
from placecat.sequences import video


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


def test_label_file_with_upper_case_suffix(tmp_path: Path) -> None:
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


def test_a_video_in_a_subfolder(tmp_path: Path) -> None:
    write_video(tmp_path / "town/flat.avi", 3)
    (tmp_path / "town/flat.csv").write_text("start_seconds,end_seconds,label\n0,0.12,kitchen\n")
    home = video.read_home(tmp_path, "town/flat")
    assert set(home.frames["source"]) == {"town/flat.avi"}
    assert home.frames["label"].tolist() == ["kitchen"] * 3


def test_error_messages(tmp_path: Path) -> None:
    with pytest.raises(
        PlacecatError, match=r"flat: there is no video with this name \(\.avi, .*\); correct dataset.homes"
    ):
        video.read_home(tmp_path, "flat")
    with pytest.raises(PlacecatError, match=r"town/flat: there is no video with this name"):
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


def test_labels_past_the_end_of_a_truncated_video_are_rejected(tmp_path: Path) -> None:
    write_video(tmp_path / "flat.avi", 40)
    (tmp_path / "flat.csv").write_text("start,end,label\n1,40,kitchen\n")
    data = (tmp_path / "flat.avi").read_bytes()
    (tmp_path / "flat.avi").write_bytes(data[: len(data) // 2])
    with pytest.raises(
        PlacecatError, match=r"flat\.csv line 2: the segment ends at frame 40, but the video has"
    ):
        video.read_home(tmp_path, "flat")


UNEVEN = [*steady(45), *(1.5 + np.arange(45) / 3)]


def test_a_lost_frame_has_no_row_and_the_others_keep_their_numbers(tmp_path: Path) -> None:
    options = {"g": "1000", "bf": "0", "preset": "ultrafast"}
    zero(write_clip(tmp_path / "flat.mp4", steady(60), options=options), 41)
    (tmp_path / "flat.csv").write_text("start,end,label\n1,40,kitchen\n41,60,hall\n")
    home = video.read_home(tmp_path, "flat")
    rest = [number for number in range(1, 61) if number != 41]
    assert home.frames["number"].tolist() == rest
    assert home.frames["label"].tolist() == ["kitchen"] * 40 + ["hall"] * 19
    assert home.label_lines.tolist() == [2] * 40 + [3] * 19
    np.testing.assert_allclose(home.frames["seconds"], [(number - 1) / 30 for number in rest])
    assert (home.lost, home.damaged, home.fps, home.is_even) == ([41], [], 30.0, False)
    assert "frame 41 of 60 cannot be decoded and is lost" in home.note
    images = list(read_frames(tmp_path, home.frames.iloc[[0, 39, 40, 58, 2]]))
    assert [decoded(images[row]) for row in (0, 1, 4)] == [0, 39, 2]
    frames = home.frames.iloc[[40]].assign(position=40)
    with pytest.raises(
        PlacecatError, match=r"flat\.mp4: frame 41 is missing or unreadable \(the file is damaged there\)"
    ):
        next(read_frames(tmp_path, frames))


def test_label_times_refer_to_the_times_in_the_file(tmp_path: Path) -> None:
    write_clip(tmp_path / "flat.mp4", UNEVEN)
    (tmp_path / "flat.csv").write_text("start_seconds,end_seconds,label\n0,1.5,kitchen\n1.5,16.2,hall\n")
    home = video.read_home(tmp_path, "flat")
    assert home.frames["label"].tolist() == ["kitchen"] * 45 + ["hall"] * 45
    np.testing.assert_allclose(home.frames["seconds"], UNEVEN, atol=1e-4)
    assert (home.note, home.is_even) == ("", False)
    # An explicit rate applies to all frames.
    (tmp_path / "flat.csv").write_text("start_seconds,end_seconds,label\n0,1.5,kitchen\n1.5,9,hall\n")
    home = video.read_home(tmp_path, "flat", fps=10.0)
    assert home.frames["label"].tolist() == ["kitchen"] * 15 + ["hall"] * 75
    assert (home.frames["seconds"][45], home.is_even) == (4.5, True)


def test_rotating_the_phone_while_filming_is_rejected(tmp_path: Path) -> None:
    turned_on_the_way(tmp_path / "flat.webm")
    (tmp_path / "wide.webm").unlink()
    with pytest.raises(
        PlacecatError, match=r"flat\.webm: frame 6 is 48x64, but earlier frames are 64x48 .* cut the video"
    ):
        video.read_home(tmp_path, "flat")
