"""A folder of bags a home, one a floor: ``<name>/<floor>.bag``, ``<floor>.mcap`` or a folder of ROS 2.

Labels of a floor are in ``<name>/<floor>.csv``, or on a topic of strings of its bag. Without them every frame
is unlabelled.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from placecat.errors import PlacecatError
from placecat.footage.bag_recording import BagRecording
from placecat.footage.bags import STRING, Bag, is_bag
from placecat.sequences.base import Home, frame_table
from placecat.sequences.folders import data_folder, frame_rate, home_folder, natural, some_homes
from placecat.sequences.labels import label_csvs, read_label_csv


@dataclass(frozen=True, eq=False)
class _Floor:
    """The frames of one bag that can be decoded, n of them."""

    recording: BagRecording
    name: str
    size: tuple[int, int]
    numbers: list[int]
    labels: list[str]
    lines: NDArray[np.int32]
    label_file: str | None


def list_homes(root: Path) -> list[str]:
    """Name the folders that hold bags; see `placecat.sequences.list_homes`."""
    homes = [path.name for path in data_folder(root).iterdir() if path.is_dir() and _bags(path)]
    return some_homes(homes, root, "folders of bags (.bag, .mcap, or folders of ROS 2 bags)")


def read_home(
    root: Path,
    name: str,
    *,
    fps: float | None = None,
    camera: str = "",
    topic: str | None = None,
    labels_topic: str | None = None,
) -> Home:
    """Read one home, one sequence a bag; see `placecat.sequences.open_home`.

    Without `fps` the times are the stamps of the pictures. All frames are decoded once, to find those that
    cannot be: they have no row.

    Parameters
    ----------
    topic
        Of the pictures; None takes the only one of each bag.
    labels_topic
        Of strings (std_msgs/String): a frame has the label that was received last before it, and none before
        the first. None takes the label files.
    """
    for setting, value in (("topic", topic), ("labels_topic", labels_topic)):
        if value is not None and not isinstance(value, str):
            raise PlacecatError(f"dataset.{setting} is {value!r}: give the name of a topic, or null.")
    folder = home_folder(root, name)
    bags = _bags(folder)
    if not bags:
        raise PlacecatError(f"{folder}: no bag here; correct dataset.homes or dataset.root.")
    rate = None if fps is None else frame_rate(fps, name)
    floors = [_read(root, name, path, rate, topic, labels_topic) for path in bags]
    _check_sizes(floors)
    rows = [
        frame_table(
            floor.name,
            floor.recording.path.relative_to(root).as_posix(),
            floor.recording.positions[_indices(floor)].tolist(),
            floor.numbers,
            floor.recording.timing.seconds[_indices(floor)],
            floor.labels,
        )
        for floor in floors
    ]
    width, height = floors[0].size
    return Home(
        name=name,
        root=root,
        fps=float(np.median([floor.recording.timing.fps for floor in floors])),
        camera=camera,
        width=width,
        height=height,
        frames=pd.concat(rows, ignore_index=True),
        label_files={floor.name: floor.label_file for floor in floors if floor.label_file is not None},
        label_lines=np.concatenate([floor.lines for floor in floors]),
        lost=[number for floor in floors for number in floor.recording.lost],
        note=" ".join(note for floor in floors if (note := floor.recording.note())),
    )


def _indices(floor: _Floor) -> NDArray[np.int64]:
    return np.array(floor.numbers, np.int64) - 1


def _bags(folder: Path) -> list[Path]:
    """Bags of a home in natural order; no two may have one name."""
    bags = [path for path in folder.iterdir() if not path.name.startswith(".") and is_bag(path)]
    bags.sort(key=lambda path: natural(path.name))
    seen: dict[str, Path] = {}
    for path in bags:
        first = seen.setdefault(_floor_name(path), path)
        if first != path:
            raise PlacecatError(f"{path}: {first.name} has the same name; rename or remove one.")
    return bags


def _floor_name(path: Path) -> str:
    return path.name if path.is_dir() else path.stem


def _read(
    root: Path, home: str, path: Path, fps: float | None, topic: str | None, labels_topic: str | None
) -> _Floor:
    recording = BagRecording(path, topic, fps, settings="dataset.")
    size = recording.size()
    numbers = []
    for number, picture in recording.pictures():
        image = recording.image(number, picture)
        if image is None:
            continue
        if image.shape[1::-1] != size:
            raise PlacecatError(
                f"{path}: frame {number} is {image.shape[1]}x{image.shape[0]}, those before "
                f"{size[0]}x{size[1]}; a home needs one frame size: cut the bag there."
            )
        numbers.append(number)
    name = _floor_name(path)
    files = label_csvs(root, f"{home}/{name}.csv")
    if files and labels_topic is not None:
        raise PlacecatError(
            f"{root / files[0]}: dataset.labels_topic labels the same frames; remove one of both."
        )
    count = recording.count
    labels, lines = [""] * count, np.zeros(count, np.int32)
    if labels_topic is not None:
        labels = _labels_of_topic(path, labels_topic, recording.received)
    elif files:
        times = recording.timing
        starts = None if times.is_even else np.append(times.seconds, times.end)
        labels, lines = read_label_csv(root / files[0], count, times.fps, "the bag", starts)
    return _Floor(
        recording,
        name,
        size,
        numbers,
        [labels[number - 1] for number in numbers],
        lines[np.array(numbers) - 1],
        files[0] if files else None,
    )


def _labels_of_topic(path: Path, topic: str, received: NDArray[np.int64]) -> list[str]:
    """By the times of reception, since strings have no stamps."""
    bag = Bag(path)
    bag.require(topic, (STRING,), "dataset.labels_topic")
    times, labels = zip(*bag.strings(topic), strict=True)
    last = np.searchsorted(np.array(times, np.int64), received, side="right")
    return ["" if index == 0 else labels[index - 1].strip() for index in last]


def _check_sizes(floors: Sequence[_Floor]) -> None:
    for floor in floors[1:]:
        if floor.size != floors[0].size:
            raise PlacecatError(
                f"{floor.recording.path}: frames are {floor.size[0]}x{floor.size[1]}, those of "
                f"{floors[0].recording.path.name} {floors[0].size[0]}x{floors[0].size[1]}; a home needs one "
                "frame size."
            )
