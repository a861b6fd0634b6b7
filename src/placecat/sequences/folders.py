"""The folders of a data set, the names in them, and the frame rate: what every layout checks."""

from pathlib import Path

import numpy as np

from placecat.errors import PlacecatError
from placecat.footage.names import natural, relative


def inside(path: Path, folder: Path, origin: str) -> None:
    """Refuse an existing path that, links followed, leaves a folder.

    Parameters
    ----------
    path
        A path whose name was read from a file.
    folder
        The folder it may not leave.
    origin
        Where the name was written, for the message.

    Raises
    ------
    PlacecatError
        If a symbolic link leads out of the folder.
    """
    if not path.resolve().is_relative_to(folder.resolve()):
        raise PlacecatError(
            f"{origin}: {path} is a link that leads out of {folder}; put the data itself there."
        )


def data_folder(root: Path) -> Path:
    """Give the folder that holds the homes; PlacecatError if it is missing or not a folder."""
    return _existing(root, "set dataset.root to the folder that holds the homes.")


def home_folder(root: Path, name: str) -> Path:
    """Find the folder of one home below the folder of its data set; the name may hold slashes.

    Raises
    ------
    PlacecatError
        If either folder is missing or the name leads out of `root`.
    """
    folder = data_folder(root) / relative(name, "dataset.homes")
    return _existing(folder, "correct dataset.homes or dataset.root.")


def _existing(folder: Path, advice: str) -> Path:
    if not folder.is_dir():
        what = "not a folder" if folder.exists() else "no such folder"
        raise PlacecatError(f"{folder}: {what}; {advice}")
    return folder


def some_homes(homes: list[str], root: Path, expected: str) -> list[str]:
    """Sort home names in natural order.

    Raises
    ------
    PlacecatError
        If there are none below `root`; the message says what is `expected` of a home of this layout.
    """
    if not homes:
        raise PlacecatError(
            f"{root}: no home here; expected {expected}. Correct dataset.root or dataset.layout."
        )
    return sorted(homes, key=natural)


def frame_rate(fps: float | None, home: str, known: float | None = None) -> float:
    """Settle the frame rate of a home, in frames a second.

    Parameters
    ----------
    fps
        The setting; None to use what the files say.
    home
        Name of the home, for the message.
    known
        What the files say, if they do.

    Raises
    ------
    PlacecatError
        If neither gives a positive rate.
    """
    rate = known if fps is None else fps
    if rate is None or not np.isfinite(rate) or rate <= 0:
        what = "unknown from the files" if rate is None else f"{rate}"
        raise PlacecatError(f"{home}: the frame rate is {what}; set dataset.fps to a positive number.")
    return float(rate)
