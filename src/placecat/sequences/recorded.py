"""Homes made of recordings (videos or bags): each recording is a sequence with a label CSV next to it.

All frames are decoded once to find the lost ones. A lost frame has no row but keeps its number, because
labels refer to frame numbers.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from placecat.errors import PlacecatError
from placecat.footage.bag_recording import BagRecording
from placecat.footage.recording import Recording, Size
from placecat.footage.timing import Timing
from placecat.sequences.base import Home, frame_table
from placecat.sequences.labels import Labels


@dataclass(frozen=True, eq=False)
class Recorded:
    """One recording of a home, with a row in `frames` for each frame that can be decoded."""

    recording: Recording | BagRecording
    sequence: str
    fps: float
    size: Size
    frames: pd.DataFrame
    label_lines: NDArray[np.int32]
    label_file: str | None


def read_recorded(
    root: Path, recording: Recording | BagRecording, timing: Timing, sequence: str, labels: Labels, kind: str
) -> Recorded:
    """Decode the frames of a recording and list them.

    Parameters
    ----------
    root
        The folder of the homes.
    timing, labels
        Times and labels of all frames, including lost ones.
    sequence
        The name of the sequence.
    kind
        ``video`` or ``bag``, for messages.

    Raises
    ------
    PlacecatError
        If no frame can be decoded, or frames differ in size.
    """
    first, numbers = recording.size(), []
    for frame in recording.pictures():
        if (size := frame.size) is None:
            continue
        if size != first:
            raise PlacecatError(
                f"{recording.path}: frame {frame.number} is {size[0]}x{size[1]}, but earlier ones are "
                f"{first[0]}x{first[1]} (was the camera turned?); a home needs one frame size: cut the "
                f"{kind} there."
            )
        numbers.append(frame.number)
    rows = np.array(numbers) - 1
    source = recording.path.relative_to(root).as_posix()
    names = [labels.names[row] for row in rows]
    frames = frame_table(sequence, source, recording.positions[rows], numbers, timing.seconds[rows], names)
    return Recorded(recording, sequence, timing.fps, first, frames, labels.lines[rows], labels.file)


def home_of(name: str, root: Path, camera: str, parts: Sequence[Recorded]) -> Home:
    """Join recordings into a home with their median frame rate. Raises PlacecatError if sizes differ."""
    first = parts[0]
    for part in parts:
        if part.size != first.size:
            raise PlacecatError(
                f"{part.recording.path}: frames are {part.size[0]}x{part.size[1]}, but in "
                f"{first.recording.path.name} {first.size[0]}x{first.size[1]}; a home needs one frame size."
            )
    return Home(
        name=name,
        root=root,
        fps=float(np.median([part.fps for part in parts])),
        camera=camera,
        width=first.size[0],
        height=first.size[1],
        frames=pd.concat([part.frames for part in parts], ignore_index=True),
        label_files={part.sequence: part.label_file for part in parts if part.label_file is not None},
        label_lines=np.concatenate([part.label_lines for part in parts]),
        lost=[number for part in parts for number in part.recording.lost],
        damaged=[number for part in parts for number in part.recording.damaged],
        note=" ".join(note for part in parts if (note := part.recording.note())),
    )
