import tempfile
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from placecat.errors import PlacecatError
from placecat.footage.timing import Timing, even
from placecat.sequences.labels import Segment, check_segments, expand_segments, label_csv, read_label_csv

runs = st.lists(
    st.tuples(st.integers(1, 60), st.sampled_from(["kitchen", "bedroom", "transition"])),
    min_size=1,
    max_size=12,
)


def naive(lengths: list[tuple[int, str]]) -> list[str]:
    return [label for length, label in lengths for _ in range(length)]


def intervals(lengths: list[tuple[int, str]]) -> list[tuple[int, int, str]]:
    rows, first = [], 1
    for length, label in lengths:
        rows.append((first, first + length - 1, label))
        first += length
    return rows


def read(text: str, count: int, fps: float = 25.0) -> tuple[list[str], list[int]]:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "a.csv"
        path.write_bytes(text.encode())
        labels, lines = read_label_csv(path, even(count, fps), "the video")
    return labels, lines.tolist()


@given(runs)
def test_expanded_segments_equal_a_loop(lengths: list[tuple[int, str]]) -> None:
    segments = [Segment(a, b, label, 5 + i) for i, (a, b, label) in enumerate(intervals(lengths))]
    expected = naive(lengths)
    check_segments(segments, len(expected), Path("a"), "floor 1/", "line 2")
    labels, lines = expand_segments(segments)
    assert labels == expected
    assert lines.tolist() == [5 + i for i, (length, _) in enumerate(lengths) for _ in range(length)]
    assert lines.dtype == np.int32


@given(runs, st.data())
def test_a_moved_bound_is_rejected(lengths: list[tuple[int, str]], data: st.DataObject) -> None:
    rows = intervals(lengths)
    moved = data.draw(st.integers(0, len(rows) - 1))
    which, step = data.draw(st.sampled_from([0, 1])), data.draw(st.integers(-70, 70).filter(bool))
    segments = []
    for i, (first, last, label) in enumerate(rows):
        bounds = [first, last]
        bounds[which] += step * (i == moved)
        segments.append(Segment(bounds[0], bounds[1], label, i))
    with pytest.raises(PlacecatError):
        check_segments(segments, len(naive(lengths)), Path("a"), "floor 1/", "line 2")


@given(runs)
def test_csv_in_frames(lengths: list[tuple[int, str]]) -> None:
    rows = [f"{a},{b},{label}" for a, b, label in intervals(lengths)]
    labels, lines = read("\n".join(["start,end,label", *rows]), len(naive(lengths)))
    assert labels == naive(lengths)
    assert lines == [2 + i for i, (length, _) in enumerate(lengths) for _ in range(length)]


@given(runs, st.sampled_from([4.9, 5.0, 24000 / 1001, 25.0, 30000 / 1001, 60.0]))
def test_csv_in_rounded_seconds(lengths: list[tuple[int, str]], fps: float) -> None:
    rows = [f"{(a - 1) / fps:.3f},{b / fps:.3f},{label}" for a, b, label in intervals(lengths)]
    labels, _ = read("\n".join(["start_seconds,end_seconds,label", *rows]), len(naive(lengths)), fps)
    assert labels == naive(lengths)


def test_csv_in_seconds_with_uneven_frame_times(tmp_path: Path) -> None:
    path = tmp_path / "a.csv"
    uneven = Timing(np.array([0.0, 0.1, 0.2, 100.2]), 100.3, 10.0, False)
    for start, expected in ((0.19, 2), (0.2, 2), (50.1, 2), (50.3, 3), (100.2, 3)):
        path.write_text(f"start_seconds,end_seconds,label\n0,{start},a\n{start},100.3,b\n")
        labels, _ = read_label_csv(path, uneven, "the video")
        assert labels == ["a"] * expected + ["b"] * (4 - expected)
    path.write_text("start_seconds,end_seconds,label\n0,1000000,a\n")
    with pytest.raises(
        PlacecatError, match=r"line 2: .* but the video has 4 frames \(100\.300 s at an uneven"
    ):
        read_label_csv(path, uneven, "the video")
    with pytest.raises(PlacecatError, match=r"line 2: .* but the video has 4 frames \(0\.400 s at 10 frames"):
        read_label_csv(path, even(4, 10.0), "the video")


def test_csv_from_a_spreadsheet() -> None:
    text = '\ufeffstart, end, label\r\n1, 2,"living room"\r\n\r\n,,\r\n3,3, hall \r\n'
    assert read(text, 3) == (["living room", "living room", "hall"], [2, 2, 5])


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", r"a\.csv: the label file is empty; write the labels"),
        (" \n\n", r"a\.csv: the label file is empty"),
        ("start,end,label\n", r"a\.csv: the video has no labels; label its frames 1 to 9"),
        (
            "1,9,kitchen\n",
            r"a\.csv line 1: the header is '1,9,kitchen'; write start,end,label .* or start_seconds,",
        ),
        ("label,start,end\n", r"line 1: the header is 'label,start,end'"),
        ("\nstart;end;label\n1;9;kitchen\n", r"line 2: the header is 'start;end;label'"),
        ("start,end,label\n1,4,a\n6,9,b\n", r"a\.csv line 3: frame 5 of the video has no label \(a gap\)"),
        ("start,end,label\n2,9,a\n", r"line 2: frame 1 of the video .* \(a gap\)"),
        ("start,end,label\n1,2,a\n5,9,b\n", r"line 3: frames 3 to 4 of the video"),
        (
            "start,end,label\n1,4,a\n4,9,b\n",
            r"line 3: .* starts at frame 4, but line 2 ends at frame 4 \(an overlap\); start it at 5",
        ),
        ("start,end,label\n0,9,a\n", r"line 2: the segment starts at frame 0, but frame numbers start at 1"),
        (
            "start,end,label\n1,8,a\n",
            r"line 2: the last segment of the video ends at frame 8, .* 9 frames \(0\.360 s .*label frame 9,",
        ),
        ("start,end,label\n1,10,a\n", r"line 2: the segment ends at frame 10, but the video has 9 frames"),
        ("start,end,label\n1,5,a\n6,4,b\n", r"line 3: the segment starts at frame 6 but ends at frame 4"),
        ("start,end,label\n1,x,a\n", r"line 2: 'x' is not a whole number"),
        ("start,end,label\n1,9.5,a\n", r"line 2: '9\.5' is not a whole number"),
        ("start,end,label\n1,٩,a\n", r"line 2: '٩' is not a whole number"),
        ("start,end,label\n1,,a\n", r"line 2: '' is not a whole number"),
        ("start,end,label\n1,9\n", r"line 2 has 2 columns; expected start,end,label"),
        ("start,end,label\n1,9,a,b\n", r"line 2 has 4 columns"),
        ("start,end,label\n1,4,a\n5,9,\n", r"line 3: the label is empty"),
        ("start_seconds,end_seconds,label\n0,now,a\n", r"line 2: 'now' is not a time"),
        ("start_seconds,end_seconds,label\n0,nan,a\n", r"line 2: 'nan' is not a time"),
        ("start_seconds,end_seconds,label\n-1,0.36,a\n", r"line 2: '-1' is not a time"),
        (
            "start_seconds,end_seconds,label\n0,0.01,a\n",
            r"line 2: no frame lies between 0 and 0\.01 s at 25 frames",
        ),
        ("start_seconds,end_seconds,label\n0,0.16,a\n0.2,0.36,b\n", r"line 3: frame 5 of the video .*gap"),
        ("start_seconds,end_seconds,label\n0,0.36,a\n0.2,0.36,b\n", r"line 3: .*line 2 ends at frame 9"),
    ],
)
def test_error_messages(text: str, message: str) -> None:
    with pytest.raises(PlacecatError, match=message):
        read(text, 9)


@pytest.mark.parametrize(
    "number", ["9" * 5000, "1e308", "-1e308", "nan", "inf", "-inf", "9" * 400, "-5", "-0.1"]
)
@pytest.mark.parametrize("header", ["start,end,label", "start_seconds,end_seconds,label"])
@pytest.mark.parametrize("row", ["{},9,a", "0,{},a", "{},{},a"])
def test_absurd_numbers_are_rejected(number: str, header: str, row: str) -> None:
    with pytest.raises(PlacecatError, match=r"^\S*a\.csv line 2: ") as caught:
        read(f"{header}\n{row.replace('{}', number)}\n", 9)
    assert len(str(caught.value)) < 300


def test_suffix_may_be_in_upper_or_lower_case(tmp_path: Path) -> None:
    (tmp_path / "flat").mkdir()
    for name in ("flat.CSV", "flats.csv", "flat.csv.txt", "flat/labels.Csv"):
        (tmp_path / name).write_text("")
    assert label_csv(tmp_path, "flat.csv", "nowhere/labels.csv") == "flat.CSV"
    assert label_csv(tmp_path, "flat/labels.csv") == "flat/labels.Csv"
    assert label_csv(tmp_path, "labels.csv") is None
    with pytest.raises(PlacecatError, match=r"flat\.CSV and .*flat/labels\.Csv label the same home; remove"):
        label_csv(tmp_path, "flat.csv", "flat/labels.csv")
    (tmp_path / "flat.csv").write_text("")
    with pytest.raises(PlacecatError, match=r"flat\.csv label the same home; remove one"):
        label_csv(tmp_path, "flat.csv")


def test_an_unreadable_label_file_gives_one_message(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(path: Path) -> bytes:
        raise PermissionError(13, "Permission denied", str(path))

    monkeypatch.setattr(Path, "read_bytes", refuse)
    with pytest.raises(PlacecatError, match=r"a\.csv: the label file cannot be opened \(Permission denied\)"):
        read_label_csv(tmp_path / "a.csv", even(9, 25.0), "the video")


def test_label_file_is_missing_or_a_folder(tmp_path: Path) -> None:
    with pytest.raises(PlacecatError, match=r"a\.csv: the label file is missing"):
        read_label_csv(tmp_path / "a.csv", even(9, 25.0), "the video")
    with pytest.raises(PlacecatError, match="the label file cannot be opened"):
        read_label_csv(tmp_path, even(9, 25.0), "the video")


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ("start,end,label\n1,9,kitchen\n".encode("utf-16"), "UTF-16; save it as UTF-8"),
        ("start,end,label\n1,9,küche\n".encode("latin-1"), "line 2 is not UTF-8"),
        (b'start,end,label\n1,4,"kitchen\n5,9,bath\n', "line 2: a quotation mark is not closed"),
        (b"start,end,label\n" + b"1,9,kitchen\n" * 1_500_000, "larger than 16 MB"),
    ],
    ids=["utf-16", "latin-1", "quote", "huge"],
)
def test_files_that_are_not_label_csv_files(tmp_path: Path, content: bytes, message: str) -> None:
    (tmp_path / "a.csv").write_bytes(content)
    with pytest.raises(PlacecatError, match=rf"a\.csv.*{message}"):
        read_label_csv(tmp_path / "a.csv", even(9, 25.0), "the video")
