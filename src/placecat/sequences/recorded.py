"""Homes that consist of recordings (videos or bags), with one sequence per recording."""

from collections.abc import Iterable
from pathlib import Path

import numpy as np
import pandas as pd

from placecat.errors import PlacecatError
from placecat.footage.bag_recording import BagRecording
from placecat.footage.recording import Recording, Size
from placecat.footage.timing import Timing
from placecat.sequences.base import Home, frame_table
from placecat.sequences.labels import Labels

Part = tuple[str, Recording | BagRecording, Timing, Labels]
"""A sequence: its name, its recording, and the times and labels of all frames, including lost ones."""


def home_of(name: str, root: Path, camera: str, parts: Iterable[Part], kind: str) -> Home:
    """Decode all frames of a home's recordings to find the lost ones, and list the rest.

    A lost frame has no row but keeps its number, because labels refer to frame numbers. The frame rate of the
    home is the median rate of its recordings. Messages refer to a recording as `kind`, which is ``video`` or
    ``bag``. Raises PlacecatError if no frame of a recording can be decoded, or if frames differ in size.
    """
    rates, tables, lines, label_files = [], [], [], {}
    recordings: list[Recording | BagRecording] = []
    sizes: list[Size] = []
    for sequence, recording, timing, labels in parts:
        size = recording.size()
        sizes.append(size)
        if size != sizes[0]:
            raise PlacecatError(
                f"{recording.path}: the frames are {size[0]}x{size[1]}, but those of "
                f"{recordings[0].path.name} are {sizes[0][0]}x{sizes[0][1]}; all frames of a home must be "
                "the same size."
            )
        numbers = _readable(recording, size, kind)
        rows = np.array(numbers) - 1
        source = recording.path.relative_to(root).as_posix()
        names = [labels.names[row] for row in rows]
        positions, seconds = recording.positions[rows], timing.seconds[rows]
        tables.append(frame_table(sequence, source, positions, numbers, seconds, names))
        lines.append(labels.lines[rows])
        recordings.append(recording)
        rates.append(timing.fps)
        if labels.file is not None:
            label_files[sequence] = labels.file
    return Home(
        name=name,
        root=root,
        fps=float(np.median(rates)),
        camera=camera,
        width=sizes[0][0],
        height=sizes[0][1],
        frames=pd.concat(tables, ignore_index=True),
        label_files=label_files,
        label_lines=np.concatenate(lines),
        lost=[number for one in recordings for number in one.lost],
        damaged=[number for one in recordings for number in one.damaged],
        note=" ".join(note for one in recordings if (note := one.note())),
    )


def _readable(recording: Recording | BagRecording, first: Size, kind: str) -> list[int]:
    """Return the numbers of the decodable frames. Raise an error if the size of one differs from `first`."""
    numbers = []
    for frame in recording.pictures():
        if (size := frame.size) is None:
            continue
        if size != first:
            raise PlacecatError(
                f"{recording.path}: frame {frame.number} is {size[0]}x{size[1]}, but earlier frames are "
                f"{first[0]}x{first[1]} (was the camera rotated?); all frames of a home must be the same "
                f"size: cut the {kind} there."
            )
        numbers.append(frame.number)
    return numbers
