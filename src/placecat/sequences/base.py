"""What every layout delivers: a home and its frames in order."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pandas as pd
from numpy.typing import NDArray

COLUMNS = ("sequence", "number", "source", "position", "seconds", "label")
"""The columns of `Home.frames`."""
TURN = "turn"
"""One more column, of pictures that are turned."""


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
        One row a frame, in order, indexed 0, 1, ...: ``sequence`` (str: the floor of a VPC home, the sequence
        folder of COLD, "1" for a video or a folder), ``number`` (int32, from 1 in each sequence), ``source``
        (str, POSIX path relative to `root`: an image, the video file or the bag), ``position`` (int32, frame
        position in the video from 0, those that are lost counted; in a bag that of the message among those
        with pictures; -1 for an image file), ``seconds`` (float64, since the start of the sequence) and
        ``label`` (str as in the label file; "" when there is none). Where pictures have to be turned, also
        ``turn`` (int32, degrees clockwise: 0, 90, 180 or 270).
    label_files
        Sequence to its label file, relative to `root`; empty when there is none.
    label_lines
        (frames,) int32, the line of the label file that gave each frame its label, from 1; 0 when there is
        none.
    lost
        Numbers of frames that cannot be decoded: they have no row.
    damaged
        Numbers of frames that were decoded with errors.
    note
        What is missing or damaged, in words; may be empty.
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
        """Whether a frame comes 1 / `fps` after the one before it, but at the start of a sequence."""
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
    position: Sequence[int] | int,
    number: Sequence[int],
    seconds: Sequence[float] | NDArray[np.float64],
    label: Sequence[str],
    turn: int = 0,
) -> pd.DataFrame:
    """Build `Home.frames` with its column types.

    Parameters
    ----------
    sequence, source, position
        One value a frame, or one for all.
    number, seconds, label
        One value a frame.
    turn
        Degrees clockwise by which every frame is turned.

    Returns
    -------
    The columns `COLUMNS`, and `TURN` unless it is 0, indexed from 0.
    """
    table = pd.DataFrame({"number": np.asarray(number, dtype=np.int32)})
    table["sequence"] = sequence
    table["source"] = source
    table["position"] = np.asarray(position, dtype=np.int32)
    table["seconds"] = np.asarray(seconds, dtype=np.float64)
    table["label"] = list(label)
    if turn == 0:
        return table[list(COLUMNS)]
    table[TURN] = np.int32(turn)
    return table[[*COLUMNS, TURN]]
