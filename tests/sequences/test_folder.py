from pathlib import Path

import pytest
from helpers_sequences import decoded, write_image

from placecat.errors import PlacecatError
from placecat.footage.frames import read_frames
from placecat.sequences import folder

CSV = "start,end,label\n1,2,kitchen\n3,4,bedroom\n"


def write_home(root: Path) -> None:
    for number, name in enumerate(["f1.jpg", "f2.PNG", "f10.jpeg", "f11.jpg"]):
        write_image(root / "flat" / name, number)
    (root / "flat/._f1.jpg").write_bytes(b"x")
    (root / "flat/notes.txt").write_bytes(b"x")


@pytest.mark.parametrize("file", ["flat.csv", "flat.CSV", "flat/labels.csv"])
def test_round_trip(file: str, tmp_path: Path) -> None:
    write_home(tmp_path)
    (tmp_path / file).write_text(CSV)
    home = folder.read_home(tmp_path, "flat", fps=2.0, camera="phone")
    assert home.frames["source"].tolist() == ["flat/f1.jpg", "flat/f2.PNG", "flat/f10.jpeg", "flat/f11.jpg"]
    assert home.frames["label"].tolist() == ["kitchen", "kitchen", "bedroom", "bedroom"]
    assert home.frames["seconds"].tolist() == [0.0, 0.5, 1.0, 1.5]
    assert home.frames["number"].tolist() == [1, 2, 3, 4]
    assert home.label_files == {"1": file}
    assert home.label_lines.tolist() == [2, 2, 3, 3]
    assert (home.camera, home.width, home.height, home.fps) == ("phone", 64, 48, 2.0)
    assert [decoded(image) for image in read_frames(tmp_path, home.frames)] == [0, 1, 2, 3]


def test_without_labels(tmp_path: Path) -> None:
    write_home(tmp_path)
    home = folder.read_home(tmp_path, "flat", fps=2.0)
    assert home.frames["label"].tolist() == [""] * 4
    assert (home.label_files, home.label_lines.tolist()) == ({}, [0] * 4)


def test_unsupported_pictures_are_rejected(tmp_path: Path) -> None:
    write_image(tmp_path / "flat/1.webp", 1)
    with pytest.raises(PlacecatError, match=r"1\.webp: this kind of image is not supported"):
        folder.read_home(tmp_path, "flat", fps=2.0)


def test_error_messages(tmp_path: Path) -> None:
    with pytest.raises(PlacecatError, match=r"flat does not exist; correct dataset.homes"):
        folder.read_home(tmp_path, "flat", fps=2.0)
    (tmp_path / "flat").mkdir()
    with pytest.raises(PlacecatError, match=r"flat contains no frames \(\.jpeg, \.jpg, \.png\)"):
        folder.read_home(tmp_path, "flat", fps=2.0)
    write_home(tmp_path)
    with pytest.raises(PlacecatError, match=r"flat: the frame rate is not in the files; set dataset.fps"):
        folder.read_home(tmp_path, "flat")
    (tmp_path / "flat.csv").write_text("start,end,label\n1,3,kitchen\n")
    with pytest.raises(
        PlacecatError, match=r"flat\.csv line 2: the last segment of the folder ends at frame 3"
    ):
        folder.read_home(tmp_path, "flat", fps=2.0)
    (tmp_path / "flat/labels.csv").write_text(CSV)
    with pytest.raises(
        PlacecatError, match=r"flat\.csv and .*flat/labels\.csv label the same home; remove one"
    ):
        folder.read_home(tmp_path, "flat", fps=2.0)
    (tmp_path / "flat/labels.csv").unlink()
    (tmp_path / "flat.csv").write_text(CSV)
    (tmp_path / "flat/f1.jpg").write_bytes(b"")
    with pytest.raises(PlacecatError, match=r"f1\.jpg: not a readable image \(0 bytes"):
        folder.read_home(tmp_path, "flat", fps=2.0)
