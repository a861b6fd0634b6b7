import tempfile
from pathlib import Path

import numpy as np
import pytest
from helpers_sequences import decoded, write_image
from hypothesis import given
from hypothesis import strategies as st

from placecat.errors import PlacecatError
from placecat.footage.frames import read_frames
from placecat.sequences import vpc2009

# This text has every irregularity of the real files: multiple spaces, unevenly spaced end lines, floors out
# of order, two consecutive transitions, a note after the end, and no newline at the end of the file.
TRAPS = (
    "1/\n5\n1       2     hall\n3   3     transition\n4\t5   transition\n-1      -1      end\n"
    "2/\n3\n1       3       kitchen\n-1      -1 end\n"
    "0/\n2\n1       1       bedroom\n2       2       bathroom\n-1  -1  end\n-1      -1 end\n"
    "\nREMARK:\n1/ frames 4 - 5 show a room without a name\xfc"
)


def write_home(root: Path, text: str, floors: dict[str, int], name: str = "Home1") -> None:
    for floor, count in floors.items():
        for number in range(1, count + 1):
            write_image(root / name / floor / f"{number:08d}.jpg", number + 32 * int(floor))
    (root / name).mkdir(parents=True, exist_ok=True)
    (root / name / "label.txt").write_bytes(text.encode("latin-1"))


def floors_of(text: str) -> list[vpc2009.Floor]:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "label.txt"
        path.write_bytes(text.encode("latin-1"))
        return vpc2009.read_floors(path)


def test_home_with_every_irregularity(tmp_path: Path) -> None:
    write_home(tmp_path, TRAPS, {"0": 2, "1": 5, "2": 3})
    home = vpc2009.read_home(tmp_path, "Home1", fps=2.0, camera="phone")
    assert (home.name, home.root, home.fps, home.camera) == ("Home1", tmp_path, 2.0, "phone")
    assert (home.width, home.height) == (64, 48)
    frames = home.frames
    assert frames["sequence"].tolist() == list("1111122200")
    assert frames["number"].tolist() == [1, 2, 3, 4, 5, 1, 2, 3, 1, 2]
    assert frames["seconds"].tolist() == [0, 0.5, 1, 1.5, 2, 0, 0.5, 1, 0, 0.5]
    assert frames["label"].tolist() == ["hall"] * 2 + ["transition"] * 3 + ["kitchen"] * 3 + [
        "bedroom",
        "bathroom",
    ]
    assert frames["source"].iloc[[0, 5, 9]].tolist() == [
        "Home1/1/00000001.jpg",
        "Home1/2/00000001.jpg",
        "Home1/0/00000002.jpg",
    ]
    assert set(frames["position"]) == {-1}
    assert home.label_lines.tolist() == [3, 3, 4, 5, 5, 9, 9, 9, 13, 14]
    assert home.label_files["0"] == "Home1/label.txt"
    images = read_frames(tmp_path, frames, size=(64, 48))
    assert [decoded(image) for image in images] == [33, 34, 35, 36, 37, 65, 66, 67, 1, 2]


def test_windows_line_endings_and_byte_order_mark() -> None:
    text = "\xef\xbb\xbf1/\r\n2\r\n1 2 kitchen\r\n-1 -1 end\r\n-1 -1 end\r\n"
    assert [(floor.name, floor.count, floor.segments[0].label) for floor in floors_of(text)] == [
        ("1", 2, "kitchen")
    ]


def test_images_are_read_in_numeric_order(tmp_path: Path) -> None:
    text = "1/\n11\n1 11 kitchen\n-1 -1 end\n-1 -1 end\n"
    write_home(tmp_path, text, {})
    for number in range(1, 12):
        write_image(tmp_path / f"Home1/1/{number}.jpg", number)
    (tmp_path / "Home1/1/Thumbs.db").write_bytes(b"x")
    (tmp_path / "Home1/1/._00000001.jpg").write_bytes(b"x")
    home = vpc2009.read_home(tmp_path, "Home1", fps=1.0)
    assert [decoded(image) for image in read_frames(tmp_path, home.frames)] == list(range(1, 12))


@given(
    st.lists(
        st.lists(
            st.tuples(st.integers(1, 40), st.sampled_from(["kitchen", "transition"])), min_size=1, max_size=8
        ),
        min_size=1,
        max_size=3,
    ),
    st.sampled_from([" ", "      ", "\t"]),
    st.booleans(),
)
def test_floors_round_trip(floors: list[list[tuple[int, str]]], gap: str, newline: bool) -> None:
    text = []
    for number, runs in enumerate(floors):
        text += [f"{number}/", str(sum(length for length, _ in runs))]
        first = 1
        for length, label in runs:
            text.append(gap.join([str(first), str(first + length - 1), label]))
            first += length
        text.append(gap.join(["-1", "-1", "end"]))
    found = floors_of("\n".join([*text, "-1 -1 end"]) + "\n" * newline)
    assert [floor.name for floor in found] == [str(number) for number in range(len(floors))]
    assert [[(s.end - s.start + 1, s.label) for s in floor.segments] for floor in found] == floors


END = "-1 -1 end\n"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", r"label\.txt: the label file is empty"),
        (
            "1/\n9\n1 4 a\n6 9 b\n" + END * 2,
            r"label\.txt line 4: frame 5 of floor 1/ has no label \(a gap\)",
        ),
        ("1/\n9\n2 9 a\n" + END * 2, r"line 3: frame 1 of floor 1/"),
        (
            "1/\n9\n1 4 a\n3 9 b\n" + END * 2,
            r"line 4: the segment starts at frame 3, but line 3 ends at frame 4",
        ),
        ("1/\n9\n1 10 a\n" + END * 2, r"line 3: .* frame 10, but floor 1/ has 9 frames \(line 2\)"),
        (
            "1/\n9\n1 4 a\n5 7 b\n" + END * 2,
            r"line 4: the last segment of floor 1/ ends at frame 7, .* 9 frames \(line 2\)",
        ),
        ("1/\n9\n9 1 a\n" + END * 2, r"line 3: the segment starts at frame 9 but ends at frame 1"),
        ("1/\n9\n1 9 a\n-1 -1 end\n2/\n5\n6 9 a\n" + END * 2, r"line 7: frames 1 to 5 of floor 2/"),
        ("1/\n9\n1 4,5 a\n" + END * 2, r"line 3: '4,5' is not a whole number"),
        ("1/\nnine\n1 9 a\n" + END * 2, r"line 2: 'nine' is not a whole number"),
        (
            "1/\n9 frames\n1 9 a\n" + END * 2,
            r"line 2: '9 frames' must be the number of frames on floor 1/",
        ),
        ("1/\n0\n" + END * 2, r"line 2: '0' must be the number of frames"),
        ("1/\n9\n" + END * 2, r"label\.txt: floor 1/ has no labels"),
        ("1/\n9\n1 9 dining room\n" + END * 2, r"line 3: '1 9 dining room' must be 'first last label'"),
        ("1/\n9\n1 9\n" + END * 2, r"line 3: '1 9' must be"),
        ("1/\n9\n\nNOTES: none\n1 9 a\n" + END * 2, r"line 4: 'NOTES: none' must be"),
        ("9\n1 9 a\n" + END * 2, r"line 1: '9' must be a floor such as '1/'"),
        (END * 2, r"line 1: '-1 -1 end' must be a floor"),
        ("../\n9\n1 9 a\n" + END * 2, r"line 1: '\.\./' must be a floor"),
        ("/etc/\n9\n1 9 a\n" + END * 2, r"line 1: '/etc/' must be a floor"),
        ("1/\n9\n1 9 a\n-1 -1 end\n1/\n9\n1 9 a\n" + END * 2, r"line 5: floor 1/ is listed twice"),
        (
            "1/\n9\n1 9 a\n2/\n5\n1 5 b\n" + END * 2,
            r"line 4: floor 1/ has no end line; write '-1 -1 end' before",
        ),
        ("1/\n9\n1 9 a\n", r"label\.txt: floor 1/ has no end line; write '-1 -1 end' at the end"),
        ("1/\n9\n1 9 a\n" + END, r"label\.txt: the second end line, which ends the labels, is missing"),
        ("1/\n9\n1 9 a\n-1 -1 end\nNOTES:\n", r"line 5: 'NOTES:' must be a floor such as '1/', or"),
    ],
)
def test_error_messages_for_labels(text: str, message: str) -> None:
    with pytest.raises(PlacecatError, match=message):
        floors_of(text)


@pytest.mark.parametrize("number", ["9" * 5000, "1e308", "nan", "inf", "-5", "9" * 11])
@pytest.mark.parametrize("text", ["1/\n{}\n1 2 hall\n", "1/\n2\n{} 2 hall\n", "1/\n2\n1 {} hall\n"])
def test_absurd_numbers_are_rejected(number: str, text: str) -> None:
    with pytest.raises(PlacecatError, match=r"label\.txt line [23]: ") as caught:
        floors_of(text.replace("{}", number) + "-1 -1 end\n-1 -1 end\n")
    assert len(str(caught.value)) < 300


class TestFrames:
    TEXT = "1/\n4\n1 4 kitchen\n" + END * 2

    def fails(self, root: Path, message: str) -> None:
        with pytest.raises(PlacecatError, match=message):
            vpc2009.read_home(root, "Home1", fps=5.0)

    def test_message_names_the_first_missing_frame(self, tmp_path: Path) -> None:
        write_home(tmp_path, self.TEXT, {"1": 4})
        (tmp_path / "Home1/1/00000002.jpg").unlink()
        (tmp_path / "Home1/1/00000003.jpg").unlink()
        self.fails(
            tmp_path, r"1/00000002\.jpg: the frame is missing \(.*label\.txt line 2 declares 4 frames\)"
        )

    def test_extra_frame(self, tmp_path: Path) -> None:
        write_home(tmp_path, self.TEXT, {"1": 6})
        self.fails(tmp_path, r"1/00000005\.jpg is past the end \(.*label\.txt line 2 declares 4 frames\)")

    @pytest.mark.parametrize("extra", ["cover.jpg", "00000000.jpg", "00000001 (2).jpg"])
    def test_image_without_a_frame_number(self, extra: str, tmp_path: Path) -> None:
        write_home(tmp_path, self.TEXT, {"1": 4})
        write_image(tmp_path / "Home1/1" / extra, 1)
        with pytest.raises(PlacecatError) as caught:
            vpc2009.read_home(tmp_path, "Home1", fps=5.0)
        assert (
            str(caught.value)
            == f"{tmp_path}/Home1/1/{extra} has no frame number above 0; rename or remove it."
        )

    def test_duplicate_frame(self, tmp_path: Path) -> None:
        write_home(tmp_path, self.TEXT, {"1": 4})
        write_image(tmp_path / "Home1/1/2.jpg", 1)
        self.fails(tmp_path, r"1/2\.jpg is the same frame as 00000002\.jpg")

    def test_missing_floor(self, tmp_path: Path) -> None:
        write_home(tmp_path, self.TEXT, {"2": 4})
        self.fails(
            tmp_path, r"Home1/1: the folder for this floor is missing; restore it, or correct .*label\.txt"
        )

    def test_empty_floor(self, tmp_path: Path) -> None:
        write_home(tmp_path, self.TEXT, {})
        (tmp_path / "Home1/1").mkdir()
        self.fails(tmp_path, r"1/00000001\.jpg: the frame is missing")

    def test_floor_is_a_link_out_of_the_home(self, tmp_path: Path) -> None:
        write_home(tmp_path, self.TEXT, {"1": 4}, "elsewhere")
        write_home(tmp_path, self.TEXT, {})
        (tmp_path / "Home1/1").symlink_to(tmp_path / "elsewhere/1")
        self.fails(tmp_path, r"label\.txt: .*Home1/1 is a link that points outside")

    def test_unreadable_first_image(self, tmp_path: Path) -> None:
        write_home(tmp_path, self.TEXT, {"1": 4})
        (tmp_path / "Home1/1/00000001.jpg").write_bytes(b"\xff\xd8 no more")
        self.fails(tmp_path, r"1/00000001\.jpg: not a readable image")

    def test_missing_label_file_and_home(self, tmp_path: Path) -> None:
        self.fails(tmp_path, r"Home1 does not exist; correct dataset.homes or dataset.root")
        (tmp_path / "Home1").mkdir()
        self.fails(tmp_path, r"label\.txt: the label file is missing")

    @pytest.mark.parametrize("fps", [0.0, -1.0, float("nan"), float("inf"), None])
    def test_frame_rate(self, fps: float | None, tmp_path: Path) -> None:
        write_home(tmp_path, self.TEXT, {"1": 4})
        with pytest.raises(
            PlacecatError, match=r"Home1: the frame rate is .*; set dataset.fps to a positive number"
        ):
            vpc2009.read_home(tmp_path, "Home1", fps=fps)


def test_frame_numbers_restart_on_each_floor() -> None:
    floors = floors_of(TRAPS)
    assert [(floor.name, floor.count, floor.line) for floor in floors] == [
        ("1", 5, 2),
        ("2", 3, 8),
        ("0", 2, 12),
    ]
    assert np.array([[s.start, s.end, s.line] for s in floors[2].segments]).tolist() == [
        [1, 1, 13],
        [2, 2, 14],
    ]
