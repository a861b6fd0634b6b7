"""The type `Home`, which every layout returns: a home and its frames in order."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from placecat.footage.pictures import read_image, turned

COLUMNS = ("sequence", "number", "source", "position", "seconds", "label")
"""The columns of `Home.frames`."""
TURN = "turn"
"""Additional column for pictures that must be turned."""


@dataclass(frozen=True, eq=False)
class Home:
    """A home: the location and label of each frame, without pixels.

    Attributes
    ----------
    name
        Unique within its data set. A COLD name includes the site (``freiburg-seq1_cloudy1``).
    fps
        Frames per second.
    camera
        Name of the camera; homes with the same name have the same camera height, lens and colour response.
    width, height
        Size of every frame in pixels after turning, measured on the first frame.
    frames
        One row per frame, in order, indexed 0, 1, ...: ``sequence`` (str: the floor of a VPC home, the
        sequence folder of COLD, "1" for a video or a folder), ``number`` (int32, from 1 in each sequence),
        ``source`` (str, POSIX path relative to `root`: an image, the video file or the bag), ``position``
        (int32, from 0: index of the frame in the video, counting lost frames, or of the message among the
        picture messages of the bag; -1 for an image file), ``seconds`` (float64, since the start of the
        sequence) and ``label`` (str as in the label file; "" for none). If pictures must be turned, also
        ``turn`` (int32, degrees clockwise: 0, 90, 180 or 270).
    label_files
        Maps each sequence to its label file, relative to `root`; empty without labels.
    label_lines
        (frames,) int32, each frame's line in the label file, from 1; 0 without a label.
    lost, damaged, note
        Numbers of the frames that cannot be decoded and so have no row; numbers of the frames decoded with
        errors; and a description of the damage, or "" if there is none.
    """

    name: str
    root: Path
    fps: float
    camera: str
    width: int
    height: int
    frames: pd.DataFrame
    label_files: Mapping[str, str]
    label_lines: NDArray[np.int32]
    lost: Sequence[int] = ()
    damaged: Sequence[int] = ()
    note: str = ""

    @property
    def is_even(self) -> bool:
        """Whether consecutive frames of a sequence are always 1 / `fps` apart."""
        names = self.frames["sequence"].to_numpy()
        steps = np.diff(self.frames["seconds"])[names[1:] == names[:-1]]
        return bool((np.abs(steps * self.fps - 1) < 1e-6).all())

    def __post_init__(self) -> None:
        if [column for column in self.frames.columns if column != TURN] != list(COLUMNS):
            raise TypeError(f"frames has the columns {list(self.frames.columns)}, not {list(COLUMNS)}")
        if len(self.label_lines) != len(self.frames):
            raise TypeError(f"{len(self.label_lines)} label lines for {len(self.frames)} frames")


def frame_table(
    sequence: Sequence[str] | str,
    source: Sequence[str] | str,
    position: Sequence[int] | NDArray[np.int64] | int,
    number: Sequence[int],
    seconds: Sequence[float] | NDArray[np.float64],
    label: Sequence[str],
    turn: int = 0,
) -> pd.DataFrame:
    """Build `Home.frames` with its column types, indexed from 0.

    `sequence`, `source` and `position` have one value per frame, or a single value for all frames. `turn` is
    the clockwise rotation of all frames in degrees; 0 omits the column `TURN`.
    """
    columns = {
        "sequence": sequence,
        "number": np.asarray(number, dtype=np.int32),
        "source": source,
        "position": np.asarray(position, dtype=np.int32),
        "seconds": np.asarray(seconds, dtype=np.float64),
        "label": list(label),
    }
    return pd.DataFrame(columns | ({TURN: np.int32(turn)} if turn else {}))


def home_of_pictures(
    name: str,
    root: Path,
    fps: float,
    camera: str,
    frames: pd.DataFrame,
    label_files: Mapping[str, str],
    label_lines: Sequence[int] | NDArray[np.int32],
) -> Home:
    """Build a home whose frames are image files; the first file determines the size."""
    turn = int(frames[TURN][0]) if TURN in frames else 0
    height, width = turned(read_image(root / frames["source"][0]), turn).shape[:2]
    lines = np.asarray(label_lines, dtype=np.int32)
    return Home(name, root, fps, camera, width, height, frames, label_files, lines)
