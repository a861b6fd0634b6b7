"""The VPC-2009 home database: ``HomeN/<floor>/%08d.jpg`` and ``HomeN/label.txt``.

For each floor, the label file lists the folder, the number of frames, the segments, and an end line. A
segment is a line ``first last label``. Frame numbers start at 1 on every floor, and segments include both
ends. A second end line marks the end of the labels, and free text may follow. Columns are separated by spaces
or tabs.

References
----------
J. Wu, H. I. Christensen, J. M. Rehg, Visual Place Categorization: Problem, Dataset, and Algorithm. IROS 2009.
"""

import os
import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pandas as pd

from placecat.errors import PlacecatError
from placecat.sequences.base import Home, frame_table, home_of_pictures
from placecat.sequences.folders import frame_rate, home_folder, inside
from placecat.sequences.labels import Segment, check_segments, expand_segments, read_text, shown, whole

LABEL_FILE = "label.txt"
_END = ["-1", "-1", "end"]
_FLOOR = re.compile(r"([A-Za-z0-9_-]+)/")
_FRAME = re.compile(r"([0-9]{1,10})\.jpe?g", re.IGNORECASE)


@dataclass(frozen=True)
class Floor:
    """A floor: its folder, its declared number of frames, the line that declares it, and its segments."""

    name: str
    count: int
    line: int
    segments: tuple[Segment, ...]


def read_home(root: Path, name: str, *, fps: float | None = None, camera: str = "") -> Home:
    """Read one home, with one sequence per floor, in the order of the label file.

    See `placecat.sequences.open_home`. `fps` is required. The frames on disk must match the label file.
    """
    folder = home_folder(root, name)
    rate = frame_rate(fps, name)
    file = folder / LABEL_FILE
    floors = read_floors(file)
    tables, lines = [], []
    for floor in floors:
        sources = [f"{name}/{floor.name}/{image}" for image in _images(folder, floor, file)]
        labels, floor_lines = expand_segments(floor.segments)
        seconds = np.arange(floor.count) / rate
        tables.append(frame_table(floor.name, sources, -1, range(1, floor.count + 1), seconds, labels))
        lines.append(floor_lines)
    frames = pd.concat(tables, ignore_index=True)
    label_files = {floor.name: f"{name}/{LABEL_FILE}" for floor in floors}
    return home_of_pictures(name, root, rate, camera, frames, label_files, np.concatenate(lines))


def read_floors(file: Path) -> list[Floor]:
    """Read the floors, at least one, from a ``label.txt`` in file order.

    Raises PlacecatError with the line number if anything other than floors precedes the second end line.
    """
    floors: list[Floor] = []
    name, count, count_line = "", 0, 0
    segments: list[Segment] = []
    for line, text in enumerate(read_text(file).split("\n"), start=1):
        words = text.split()
        where = f"{file} line {line}"
        if not words:
            continue
        if not name:
            if words == _END and floors:
                return floors
            floor = _FLOOR.fullmatch(words[0])
            if floor is None or len(words) > 1:
                raise PlacecatError(
                    f"{where}: {shown(text.strip())} must be a floor such as '1/', or '-1 -1 end' after the "
                    "last floor."
                )
            name, count, segments = floor[1], 0, []
            if any(name == other.name for other in floors):
                raise PlacecatError(
                    f"{where}: floor {name}/ is listed twice; correct its name, or merge the two lists."
                )
        elif not count:
            if len(words) > 1 or whole(words[0], file, line) < 1:
                raise PlacecatError(
                    f"{where}: {shown(text.strip())} must be the number of frames on floor {name}/."
                )
            count, count_line = int(words[0]), line
        elif words == _END:
            check_segments(segments, count, file, f"floor {name}/", f"line {count_line}")
            floors.append(Floor(name, count, count_line, tuple(segments)))
            name = ""
        elif _FLOOR.fullmatch(words[0]):
            raise PlacecatError(
                f"{where}: floor {name}/ has no end line; write '-1 -1 end' before this line."
            )
        elif len(words) != 3:
            raise PlacecatError(f"{where}: {shown(text.strip())} must be 'first last label' or '-1 -1 end'.")
        else:
            segments.append(Segment(whole(words[0], file, line), whole(words[1], file, line), words[2], line))
    missing = (
        f"floor {name}/ has no end line" if name else "the second end line, which ends the labels, is missing"
    )
    raise PlacecatError(f"{file}: {missing}; write '-1 -1 end' at the end of the file.")


def _images(folder: Path, floor: Floor, file: Path) -> list[str]:
    path = folder / floor.name
    if not path.is_dir():
        raise PlacecatError(f"{path}: the folder for this floor is missing; restore it, or correct {file}.")
    inside(path, folder, str(file))
    found: dict[int, str] = {}
    for image in sorted(entry.name for entry in os.scandir(path)):
        if image.startswith(".") or not image.lower().endswith((".jpg", ".jpeg")):
            continue
        match = _FRAME.fullmatch(image)
        number = int(match[1]) if match else 0
        if number < 1 or number in found:
            what = (
                f"is the same frame as {found[number]}" if number in found else "has no frame number above 0"
            )
            raise PlacecatError(f"{path / image} {what}; rename or remove it.")
        found[number] = image
    declared = f"{file} line {floor.line} declares {floor.count} frames"
    for number in range(1, floor.count + 1):
        if number not in found:
            raise PlacecatError(
                f"{path / f'{number:08d}.jpg'}: the frame is missing ({declared}); restore it, or correct "
                "that line."
            )
    extra = [number for number in found if number > floor.count]
    if extra:
        raise PlacecatError(
            f"{path / found[min(extra)]} is past the end ({declared}); remove it, or correct the labels."
        )
    return [found[number] for number in range(1, floor.count + 1)]
