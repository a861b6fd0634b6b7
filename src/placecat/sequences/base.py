"""A home and its frames in order, as every layout gives them."""

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
"""One more column, for pictures that have to be turned."""


@dataclass(frozen=True, eq=False)
class Home:
    """One home: where its frames are and what they show. Nothing is decoded.

    Attributes
    ----------
    name
        Unique within its data set. A COLD name has the site, too (``freiburg-seq1_cloudy1``).
    root
        The folder that the `source` column is relative to.
    fps
        Frames a second.
    camera
        A name for the camera; frames of one camera share its height, lens and colour response.
    width, height
        Size of every frame in pixels, turned, taken from the first.
    frames
        One row per frame, in order, indexed 0, 1, ...: ``sequence`` (str: the floor of a VPC home, the
        sequence folder of COLD, "1" for a video or a folder), ``number`` (int32, from 1 in each sequence),
        ``source`` (str, POSIX path relative to `root`: an image, the video file or the bag), ``position``
        (int32, from 0: of the frame in the video, with lost frames counted, or of the message among those of
        the bag that have pictures; -1 for an image file), ``seconds`` (float64, since the start of the
        sequence) and ``label`` (str as in the label file; "" for none). Where pictures have to be turned,
        also ``turn`` (int32, degrees clockwise: 0, 90, 180 or 270).
    label_files
        Sequence to its label file, relative to `root`; empty for none.
    label_lines
        (frames,) int32, the line of the label file that gave each frame its label, from 1; 0 for none.
    lost
        Numbers of frames that cannot be decoded: they have no row.
    damaged
        Numbers of frames that were decoded with errors.
    note
        The damage in words; may be empty.
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
        """Whether every frame of a sequence, except its first, comes 1 / `fps` after the one before."""
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

    `sequence`, `source` and `position` have one value per frame or one for all, `number`, `seconds` and
    `label` one per frame. `turn` is in degrees clockwise, for every frame; 0 leaves out the column `TURN`.
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
    """A home whose frames are image files; the first of them gives the size."""
    turn = int(frames[TURN][0]) if TURN in frames else 0
    height, width = turned(read_image(root / frames["source"][0]), turn).shape[:2]
    lines = np.asarray(label_lines, dtype=np.int32)
    return Home(name, root, fps, camera, width, height, frames, label_files, lines)
