"""A video file a home, with a label CSV: ``<name>.mp4`` and ``<name>.csv``.

Without the CSV every frame is unlabelled, which is enough to predict on new footage.
"""

from pathlib import Path

import numpy as np

from placecat.errors import PlacecatError
from placecat.footage.names import relative
from placecat.footage.recording import Recording
from placecat.sequences.base import Home, frame_table
from placecat.sequences.folders import data_folder, frame_rate, some_homes
from placecat.sequences.labels import label_csvs, read_label_csv

SUFFIXES = (".avi", ".m4v", ".mkv", ".mov", ".mp4", ".mpeg", ".mpg", ".webm")
"""File name endings taken for a video, in either case."""


def list_homes(root: Path) -> list[str]:
    """Name the videos without their endings; no two may be alike. See `placecat.sequences.list_homes`."""
    files = [path for path in data_folder(root).iterdir() if _is_video(path)]
    homes = some_homes([path.stem for path in files], root, f"videos ({', '.join(SUFFIXES)})")
    for name in homes:
        _file(root, name)
    return homes


def read_home(root: Path, name: str, *, fps: float | None = None, camera: str = "") -> Home:
    """Read one video as one sequence, ``1``; see `placecat.sequences.open_home`.

    Without `fps` the times are those of the file. All frames are decoded once, to find those that cannot be:
    they have no row, but keep their numbers, by which they are labelled.
    """
    relative(name, "dataset.homes")
    path = _file(data_folder(root), name)
    recording = Recording(path)
    timing = recording.timing(None if fps is None else frame_rate(fps, name))
    numbers, width, height = _decode(recording)
    files = label_csvs(root, f"{name}.csv")
    if files:
        starts = None if timing.is_even else np.append(timing.seconds, timing.end)
        every_label, every_line = read_label_csv(
            root / files[0], recording.count, timing.fps, "the video", starts
        )
        labels, lines = [every_label[number - 1] for number in numbers], every_line[np.array(numbers) - 1]
    else:
        labels, lines = [""] * len(numbers), np.zeros(len(numbers), dtype=np.int32)
    positions = np.array(numbers) - 1
    return Home(
        name=name,
        root=root,
        fps=timing.fps,
        camera=camera,
        width=width,
        height=height,
        frames=frame_table(
            "1",
            path.relative_to(root).as_posix(),
            positions.tolist(),
            numbers,
            timing.seconds[positions],
            labels,
        ),
        label_files={"1": files[0]} if files else {},
        label_lines=lines,
        lost=recording.lost,
        damaged=recording.damaged,
        note=recording.note(),
    )


def _is_video(path: Path) -> bool:
    return path.suffix.lower() in SUFFIXES and not path.name.startswith(".") and path.is_file()


def _file(root: Path, name: str) -> Path:
    wanted = root / name
    beside = wanted.parent.iterdir() if wanted.parent.is_dir() else []
    found = sorted(path for path in beside if _is_video(path) and path.stem == wanted.name)
    if not found:
        raise PlacecatError(
            f"{root / name}: no video of this name ({', '.join(SUFFIXES)}); correct dataset.homes."
        )
    if len(found) > 1:
        raise PlacecatError(f"{found[1]}: {found[0].name} has the same name; rename or remove one.")
    return found[0]


def _decode(recording: Recording) -> tuple[list[int], int, int]:
    """Numbers of the frames that can be decoded, and their (width, height)."""
    numbers: list[int] = []
    size = recording.size()
    for picture in recording.pictures():
        if picture.size != size:
            raise PlacecatError(
                f"{recording.path}: frame {picture.number} is {picture.size[0]}x{picture.size[1]}, those "
                f"before {size[0]}x{size[1]} (the phone was turned?); a home needs one frame size: cut the "
                "video there."
            )
        numbers.append(picture.number)
    return numbers, *size
