from collections.abc import Iterator
from pathlib import Path

import pytest
from helpers_sequences import decoded, write_image

from placecat.errors import PlacecatError
from placecat.footage.frames import read_frames
from placecat.sequences import cold, open_home

NAMES = [
    "t1152000000.900000_x0.2_y0.1_a-1.5.jpeg",
    "t1152000001.100000_x-0.25_y0.000158_a0.1.jpeg",
    "t1152000001.350000_x0.3_y-0.1_a3.jpeg",
]


def write_sequence(root: Path, name: str, labels: list[str], first: int = 1) -> None:
    for number, image in enumerate(NAMES, start=first):
        write_image(root / name / "std_cam" / image, number)
    text = "".join(f"{image} {label}\n" for image, label in zip(NAMES, labels, strict=True))
    write_list(root, name, text)


def write_list(root: Path, name: str, text: str) -> None:
    path = root / name / "localization/places.lst"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


@pytest.mark.parametrize(
    ("label", "code"),
    [
        ("CR", "CR"),
        ("CR-A", "CR"),
        ("CR-B", "CR"),
        ("TL3-B", "TL"),
        ("PA12", "PA"),
        ("1PO", "1PO"),
        ("1PO-A", "1PO"),
        ("2PO-B", "2PO"),
        ("2PO1-A", "2PO"),
        ("2PO2", "2PO"),
        ("LAB", "LAB"),
        ("RL-A", "RL"),
        ("CNR-A", "CNR"),
    ],
)
def test_codes(label: str, code: str) -> None:
    assert cold.code(label) == code


@pytest.mark.parametrize("label", ["", "12", "CR-C", "CR-AB", "cr", "CR A", "CR1A", "-A", "CR-", "CR\n"])
def test_labels_that_are_not_from_cold_have_no_code(label: str) -> None:
    assert cold.code(label) is None


def test_read_a_sequence(tmp_path: Path) -> None:
    write_sequence(tmp_path, "town/seq1", ["CR-A", "2PO1-A", "TL"])
    write_image(tmp_path / "town/seq1/std_cam/t1152000009.000000_x0_y0_a0.jpeg", 99)
    home = cold.read_home(tmp_path, "town-seq1", camera="robot")
    assert home.frames["label"].tolist() == ["CR", "2PO", "TL"]
    assert home.frames["sequence"].tolist() == ["seq1"] * 3
    assert home.frames["number"].tolist() == [1, 2, 3]
    assert home.frames["seconds"].tolist() == [0.0, 0.2, 0.45]
    assert home.frames["source"].tolist() == [f"town/seq1/std_cam/{name}" for name in NAMES]
    assert home.label_lines.tolist() == [1, 2, 3]
    assert home.label_files == {"seq1": "town/seq1/localization/places.lst"}
    assert home.fps == pytest.approx(1 / 0.225)
    assert (home.camera, home.width, home.height) == ("robot", 64, 48)
    assert [decoded(image) for image in read_frames(tmp_path, home.frames)] == [1, 2, 3]
    assert cold.read_home(tmp_path, "town-seq1", fps=5.0).fps == 5.0


def test_read_all_sequences_of_a_site(tmp_path: Path) -> None:
    for number in (10, 2):
        write_sequence(tmp_path, f"town/seq{number}", ["CR", "CR", "KT"], first=number)
    home = cold.read_home(tmp_path, "town")
    assert home.frames["sequence"].tolist() == ["seq2"] * 3 + ["seq10"] * 3
    assert home.frames["number"].tolist() == [1, 2, 3, 1, 2, 3]
    assert home.frames["seconds"].tolist() == [0.0, 0.2, 0.45] * 2
    assert home.label_files["seq10"] == "town/seq10/localization/places.lst"
    assert home.fps == pytest.approx(1 / 0.225)
    assert [decoded(image) for image in read_frames(tmp_path, home.frames)] == [2, 3, 4, 10, 11, 12]


def test_another_image_folder(tmp_path: Path) -> None:
    write_sequence(tmp_path, "town/seq1", ["CR", "CR", "KT"])
    (tmp_path / "town/seq1/std_cam").rename(tmp_path / "town/seq1/omni_cam")
    assert len(cold.read_home(tmp_path, "town-seq1", images="omni_cam").frames) == 3
    with pytest.raises(PlacecatError, match=r"seq1/std_cam: the image folder is missing; .*dataset.images"):
        cold.read_home(tmp_path, "town-seq1")


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", r"places\.lst: the label file is empty"),
        (
            f"{NAMES[0]} CR\n{NAMES[1]}\n",
            r"places\.lst line 2: 't.*' must consist of an image name and a label",
        ),
        (f"{NAMES[0]} CR A\n", r"line 1: .* must consist of an image name and a label"),
        (f"../{NAMES[0]} CR\n", r"line 1: '\.\./t.* is not an image name"),
        (f"/etc/{NAMES[0]} CR\n", r"line 1: '/etc/.* is not an image name"),
        ("t1.000000_x/../../../a.jpeg CR\n", r"line 1: .* is not an image name"),
        ("t1.000000_x\\..\\a.jpeg CR\n", r"line 1: .* is not an image name"),
        ("t1.5_x0_y0_a0.jpeg CR\n", r"line 1: .* is not an image name"),
        ("image1.jpeg CR\n", r"line 1: 'image1.jpeg' is not an image name of the form t<seconds>"),
        (f"{NAMES[0]} hall\n", r"line 1: 'hall' is not a label of the form CODE"),
        (f"{NAMES[1]} CR\n\n{NAMES[0]} CR\n", r"line 3: .* is not later than the image on line 1"),
        (f"{NAMES[0]} CR\n{NAMES[0]} CR\n", r"line 2: .* is not later than the image on line 1"),
        (
            f"{NAMES[0]} CR\nt1152000005.000000_x0.jpeg CR\n",
            r"t1152000005\.000000_x0\.jpeg: the frame is missing \(.*lst line 2\)",
        ),
    ],
)
def test_error_messages(text: str, message: str, tmp_path: Path) -> None:
    write_sequence(tmp_path, "town/seq1", ["CR", "CR", "KT"])
    write_list(tmp_path, "town/seq1", text)
    with pytest.raises(PlacecatError, match=message):
        cold.read_home(tmp_path, "town-seq1")


@pytest.mark.parametrize("seconds", ["9" * 5000, "9" * 400, "1e308", "nan", "inf", "-5"])
def test_absurd_times_are_rejected(seconds: str, tmp_path: Path) -> None:
    write_list(tmp_path, "town/seq1", f"t{seconds}.000000_x0_y0_a0.jpeg CR\n")
    with pytest.raises(PlacecatError, match=r"places\.lst line 1: .*not an image name") as caught:
        cold.read_home(tmp_path, "town-seq1")
    assert len(str(caught.value)) < 400


def test_an_unreadable_folder_is_not_skipped(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    write_sequence(tmp_path, "town/seq1", ["CR", "CR", "CR"])
    before = Path.iterdir

    def refuse(path: Path) -> Iterator[Path]:
        if path.name == "town":
            raise PermissionError(13, "Permission denied", str(path))
        return before(path)

    monkeypatch.setattr(Path, "iterdir", refuse)
    with pytest.raises(PlacecatError, match=r"town: cannot be read \(Permission denied\)"):
        open_home("cold", tmp_path, "town")


def test_image_is_a_link_out_of_the_sequence(tmp_path: Path) -> None:
    write_sequence(tmp_path, "town/seq1", ["CR", "CR", "KT"])
    write_image(tmp_path / "secret.jpeg", 1)
    image = tmp_path / "town/seq1/std_cam" / NAMES[1]
    image.unlink()
    image.symlink_to(tmp_path / "secret.jpeg")
    with pytest.raises(PlacecatError, match=r"places\.lst line 2: .* is a link that points outside"):
        cold.read_home(tmp_path, "town-seq1")


def test_missing_label_file(tmp_path: Path) -> None:
    (tmp_path / "town/seq1").mkdir(parents=True)
    with pytest.raises(PlacecatError, match=r"seq1/localization/places\.lst: the label file is missing"):
        cold.read_home(tmp_path, "town-seq1")


def test_a_single_frame_has_no_frame_rate(tmp_path: Path) -> None:
    write_sequence(tmp_path, "town/seq1", ["CR", "CR", "KT"])
    write_list(tmp_path, "town/seq1", f"{NAMES[0]} CR\n")
    with pytest.raises(PlacecatError, match=r"the frame rate is not in the files; set dataset.fps"):
        cold.read_home(tmp_path, "town-seq1")
    assert len(cold.read_home(tmp_path, "town-seq1", fps=5.0).frames) == 1


def test_a_name_with_a_slash_is_rejected(tmp_path: Path) -> None:
    write_sequence(tmp_path, "town/seq1", ["CR", "CR", "KT"])
    with pytest.raises(PlacecatError, match=r"'town/seq1' contains a slash; write 'town-seq1'"):
        cold.read_home(tmp_path, "town/seq1")
