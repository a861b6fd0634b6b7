"""The type `Home`, which every layout returns, and functions that build it."""

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
"""Extra column, present only if images must be rotated."""


@dataclass(frozen=True, eq=False)
class Home:
    """A home: the label of each frame and where to find its image, but no pixels.

    Attributes
    ----------
    name
        The name of the home, unique within its data set. In COLD, it includes the site
        (``freiburg-seq1_cloudy1``).
    fps
        Frames per second.
    camera
        Name of the camera. Homes with the same camera name share the camera height, lens and colour response.
    width, height
        Size of every frame in pixels after rotation, measured on the first frame.
    frames
        One row per frame, in order, with the index 0, 1, ... The columns are:

        - ``sequence`` (str): the floor in a VPC home, the sequence folder in COLD, or "1" for a video or a
          folder.
        - ``number`` (int32): the number of the frame in its sequence, counted from 1.
        - ``source`` (str): the image, the video file or the bag, as a POSIX path relative to `root`.
        - ``position`` (int32): the index of the frame in its video, including lost frames, or the index of
          the message among the image messages of its bag. It starts at 0. For an image file, it is -1.
        - ``seconds`` (float64): the time since the start of the sequence.
        - ``label`` (str): the label as in the label file, or "" if there is none.
        - ``turn`` (int32), only if images must be rotated: 0, 90, 180 or 270 degrees clockwise.
    label_files
        Maps each sequence to its label file, relative to `root`. Empty if there are none.
    label_lines
        Line of each frame in the label file, (frames,) int32, counted from 1, or 0 for a frame without a
        label.
    lost, damaged, note
        `lost` lists the numbers of the frames that cannot be decoded and therefore have no row. `damaged`
        lists the numbers of the frames that were decoded with errors. `note` describes the damage, or is ""
        if there is none.
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
        """Whether consecutive frames of a sequence are always 1 / `fps` seconds apart."""
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
