"""Check and expand labels for frame intervals, and read label files (CSV)."""

import codecs
import csv
import math
import re
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError
from placecat.footage.timing import Timing

FRAME_HEADER = ("start", "end", "label")
"""CSV columns for intervals of frame numbers, counted from 1. Both ends are included, as in VPC-2009."""
SECOND_HEADER = ("start_seconds", "end_seconds", "label")
"""CSV columns for intervals in seconds, counted from 0. The end is excluded."""
# Both limits exceed the number of frames in any footage.
_WHOLE = re.compile(r"-?[0-9]{1,10}")
_MOST_FRAMES = 1e10
MOST_BYTES = 16 << 20
"""Largest label file accepted, enough for over 500,000 rows. Our choice."""


class Segment(NamedTuple):
    """Frames `start` to `end` (1-based, inclusive) with their label, and its line in the file."""

    start: int
    end: int
    label: str
    line: int


def check_segments(segments: Sequence[Segment], count: int, file: Path, sequence: str, counted: str) -> None:
    """Check that segments, in file order, cover frames 1 to `count` exactly once.

    Raises PlacecatError with the line number if there is a gap or an overlap, if a segment ends before it
    starts or after the last frame, or if frames at the end are unlabelled. The other parameters appear in the
    message. `file` is the label file, `sequence` names what the frames belong to (``floor 1`` or ``the
    video``), and `counted` says where `count` comes from (``line 2``).
    """
    if not segments:
        raise PlacecatError(f"{file}: {sequence} has no labels; label its frames 1 to {count}.")
    last = 0
    for number, segment in enumerate(segments):
        where = f"{file} line {segment.line}"
        if segment.end < segment.start:
            raise PlacecatError(
                f"{where}: the segment starts at frame {segment.start} but ends at frame {segment.end}; "
                "correct one of them."
            )
        if segment.start > last + 1:
            gap, has = _frames(last + 1, segment.start - 1), "has" if segment.start == last + 2 else "have"
            raise PlacecatError(
                f"{where}: {gap} of {sequence} {has} no label (a gap); add a row before this line, for "
                "example with the label transition."
            )
        if segment.start <= last:
            before = (
                f"line {segments[number - 1].line} ends at frame {last}"
                if number
                else "frame numbers start at 1"
            )
            raise PlacecatError(
                f"{where}: the segment starts at frame {segment.start}, but {before} (an overlap); start it "
                f"at {last + 1}."
            )
        if segment.end > count:
            raise PlacecatError(
                f"{where}: the segment ends at frame {segment.end}, but {sequence} has {count} frames "
                f"({counted}); correct the end, or restore the frames."
            )
        last = segment.end
    if last < count:
        raise PlacecatError(
            f"{file} line {segments[-1].line}: the last segment of {sequence} ends at frame {last}, but "
            f"there are {count} frames ({counted}); label {_frames(last + 1, count)}, for example as "
            "transition."
        )


def expand_segments(segments: Sequence[Segment]) -> tuple[list[str], NDArray[np.int32]]:
    """Expand segments accepted by `check_segments` into one label per frame.

    Returns the label of each frame, and the line number of its segment, (frames,) int32.
    """
    lengths = [segment.end - segment.start + 1 for segment in segments]
    labels = [segment.label for segment, length in zip(segments, lengths, strict=True) for _ in range(length)]
    return labels, np.repeat(np.array([segment.line for segment in segments], dtype=np.int32), lengths)


def label_csv(root: Path, *names: str) -> str | None:
    """Find the label file with one of the given names, which end in ``.csv`` and are relative to `root`.

    Returns its relative path as spelled on disk, or None if there is no such file. The suffix may be in upper
    or lower case. Raises PlacecatError if there is more than one.
    """
    found: list[Path] = []
    for wanted in (root / name for name in names):
        beside = wanted.parent.iterdir() if wanted.parent.is_dir() else ()
        found += sorted(path for path in beside if path.with_suffix(path.suffix.lower()) == wanted)
    if len(found) > 1:
        raise PlacecatError(f"{found[0]} and {found[1]} label the same home; remove one of them.")
    return found[0].relative_to(root).as_posix() if found else None


class Labels(NamedTuple):
    """The labels of n frames, and where they come from.

    `names` contains the label of each frame, or "" if it has none. `lines`, (n,) int32, contains the line
    number of each label in the label file, or 0 if there is none. `file` is the path of that file, relative
    to the folder that contains the homes, or None if no file was found.
    """

    names: list[str]
    lines: NDArray[np.int32]
    file: str | None


def find_labels(root: Path, names: Sequence[str], timing: Timing, sequence: str) -> Labels:
    """Read the label file that :func:`label_csv` finds. If it finds none, all frames are unlabelled.

    See :func:`read_label_csv` for `timing`, `sequence` and the errors raised.
    """
    file = label_csv(root, *names)
    if file is None:
        count = len(timing.seconds)
        return Labels([""] * count, np.zeros(count, np.int32), None)
    return Labels(*read_label_csv(root / file, timing, sequence), file)


def read_label_csv(path: Path, timing: Timing, sequence: str) -> tuple[list[str], NDArray[np.int32]]:
    """Read the UTF-8 label CSV for a video or a folder of frames.

    With the header ``start,end,label``, the rows contain frame numbers, counted from 1, and both ends are
    included. With the header ``start_seconds,end_seconds,label``, the rows contain seconds from the start.
    Times are rounded to the nearest frame boundary, so a few decimal places are enough. Exactly one row must
    cover each frame.

    `timing` covers all frames. Messages refer to the frames as `sequence`, such as ``the video`` or ``the
    folder``. Returns the label of each frame without surrounding spaces, and the line number of its row,
    (frames,) int32. Raises PlacecatError with the line number if the header, a number or a label is wrong, or
    if a frame is covered by no row or by more than one.
    """
    rows = read_rows(path)
    header = tuple(cell.strip() for cell in rows[0][1]) if rows else ()
    if header not in (FRAME_HEADER, SECOND_HEADER):
        raise PlacecatError(
            f"{path} line {rows[0][0] if rows else 1}: the header is {shown(','.join(header))}; write "
            f"{','.join(FRAME_HEADER)} (frame numbers from 1) or {','.join(SECOND_HEADER)}."
        )
    starts, segments = timing.starts, []
    for line, row in rows[1:]:
        cells = [cell.strip() for cell in row]
        if len(cells) != 3:
            raise PlacecatError(f"{path} line {line} has {len(cells)} columns; expected {','.join(header)}.")
        if not cells[2]:
            raise PlacecatError(f"{path} line {line}: the label is empty; write one, for example transition.")
        if header == FRAME_HEADER:
            start, end = (whole(cell, path, line) for cell in cells[:2])
        else:
            start, end = _from_seconds(cells[:2], starts, timing.fps, path, line)
        segments.append(Segment(start, end, cells[2], line))
    rate = f"{timing.fps:g} frames a second" if timing.is_even else "an uneven rate"
    check_segments(segments, len(timing.seconds), path, sequence, f"{timing.end:.3f} s at {rate}")
    return expand_segments(segments)


def read_text(path: Path) -> str:
    """Read a UTF-8 label file, without its byte order mark.

    Invalid bytes become U+FFFD, because some real files end with free text in another encoding. Raises
    PlacecatError if the file is missing, empty, too large or in UTF-16, or if it cannot be opened.
    """
    try:
        if path.is_file() and path.stat().st_size > MOST_BYTES:
            raise PlacecatError(f"{path} is larger than {MOST_BYTES >> 20} MB, so it is not a label file.")
        content = path.read_bytes()
    except FileNotFoundError:
        raise PlacecatError(
            f"{path}: the label file is missing; restore it, or correct dataset.homes."
        ) from None
    except OSError as error:
        raise PlacecatError(f"{path}: the label file cannot be opened ({error.strerror}).") from None
    if content.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        raise PlacecatError(f"{path}: the file is UTF-16; save it as UTF-8.")
    text = content.decode("utf-8-sig", errors="replace")
    if not text.strip():
        raise PlacecatError(f"{path}: the label file is empty; write the labels, or restore it.")
    return text


def read_rows(path: Path) -> list[tuple[int, list[str]]]:
    """Read the line number and cells of each non-empty row of a CSV file.

    Raises PlacecatError in the same cases as `read_text`. If the file is not valid UTF-8 or CSV, the message
    names the line.
    """
    lines = read_text(path).splitlines()
    for number, line in enumerate(lines, start=1):
        if "\ufffd" in line:
            raise PlacecatError(f"{path} line {number} is not UTF-8; save the file as UTF-8.")
        if line.count('"') % 2:
            raise PlacecatError(f"{path} line {number}: a quotation mark is not closed; close or remove it.")
    reader = csv.reader(lines)
    try:
        return [(reader.line_num, row) for row in reader if any(cell.strip() for cell in row)]
    except csv.Error as error:
        raise PlacecatError(
            f"{path} line {reader.line_num} is not valid CSV ({error}); correct it."
        ) from None


def whole(text: str, path: Path, line: int) -> int:
    """Read a whole number with up to ten digits and an optional minus sign.

    Raises a PlacecatError that names `path` and `line` for any other text.
    """
    if not _WHOLE.fullmatch(text):
        raise PlacecatError(f"{path} line {line}: {shown(text)} is not a whole number; write a frame number.")
    return int(text)


def shown(text: str) -> str:
    """Quote text from a file for a message, and shorten long text."""
    return repr(text) if len(text) <= 80 else f"{text[:80]!r}... ({len(text)} characters)"


def _frames(first: int, last: int) -> str:
    return f"frames {first} to {last}" if last > first else f"frame {first}"


def _from_seconds(
    cells: Sequence[str], starts: NDArray[np.float64], fps: float, path: Path, line: int
) -> tuple[int, int]:
    bounds = []
    for cell in cells:
        try:
            seconds = float(cell)
        except ValueError:
            seconds = math.nan
        if not (seconds >= 0 and seconds * fps < _MOST_FRAMES):
            raise PlacecatError(
                f"{path} line {line}: {shown(cell)} is not a time; write a number of seconds."
            )
        bounds.append(_boundary(seconds, starts, fps))
    if bounds[1] <= bounds[0]:
        raise PlacecatError(
            f"{path} line {line}: no frame lies between {cells[0]} and {cells[1]} s at {fps:g} frames a "
            "second; correct the times."
        )
    return bounds[0] + 1, bounds[1]


def _boundary(seconds: float, starts: NDArray[np.float64], fps: float) -> int:
    """Return the number of frames before the nearest frame boundary.

    After the last frame, frames are assumed to continue at the rate `fps`.
    """
    if seconds > starts[-1]:
        # Assume at most one more day of frames.
        return len(starts) - 1 + math.floor(min(seconds - float(starts[-1]), 86400.0) * fps + 0.5)
    after = int(np.searchsorted(starts, seconds))
    return after - 1 if after and seconds - starts[after - 1] < starts[after] - seconds else after
