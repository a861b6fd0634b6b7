"""Checks shared by all layouts: folders, names within them, and the frame rate."""

import os
from collections.abc import Iterable, Mapping
from pathlib import Path

import numpy as np

from placecat.errors import PlacecatError
from placecat.footage.names import natural, relative


def inside(path: Path, folder: Path, origin: str) -> None:
    """Raise an error if a symbolic link takes a path outside a folder.

    `origin` says where the path is listed, for the error message.
    """
    if not path.resolve().is_relative_to(folder.resolve()):
        raise PlacecatError(
            f"{origin}: {path} is a link that points outside {folder}; replace the link with the data itself."
        )


def check_listed(folder: Path, limit: Path, origin: str, listed: Mapping[str, str], remedy: str) -> None:
    """Raise an error if a frame is missing, or if a link points outside the folder `limit`.

    `origin` is the file that lists the frames. `listed` maps the name of each frame to its position in
    that file. `remedy` tells the user what to do about a missing frame.
    """
    inside(folder, limit, origin)
    links = {entry.name: entry.is_symlink() for entry in os.scandir(folder)} if folder.is_dir() else {}
    for name, where in listed.items():
        if name not in links:
            raise PlacecatError(f"{folder / name}: the frame is missing ({where}); {remedy}.")
        if links[name]:
            inside(folder / name, limit, where)


def data_folder(root: Path) -> Path:
    """Return the folder with the homes. Raises PlacecatError if it is missing or not a folder."""
    return existing(root, "set dataset.root to the folder that contains the homes.")


def home_folder(root: Path, name: str) -> Path:
    """Find a home's folder in the folder of its data set. The name may contain slashes.

    Raises PlacecatError if either folder is missing or the name points outside `root`.
    """
    folder = data_folder(root) / relative(name, "dataset.homes")
    return existing(folder, "correct dataset.homes or dataset.root.")


def existing(folder: Path, advice: str) -> Path:
    """Return a folder, or raise a PlacecatError ending in `advice` if it is missing or not a folder."""
    if not folder.is_dir():
        what = "is not a folder" if folder.exists() else "does not exist"
        raise PlacecatError(f"{folder} {what}; {advice}")
    return folder


def by_name(paths: Iterable[Path]) -> dict[str, Path]:
    """Map folder names, and file names without their suffixes, to paths in natural order.

    Raises PlacecatError if two names are the same.
    """
    named: dict[str, Path] = {}
    for path in sorted(paths, key=lambda one: natural(one.name)):
        first = named.setdefault(path.name if path.is_dir() else path.stem, path)
        if first != path:
            raise PlacecatError(f"{path} and {first.name} have the same name; rename or remove one of them.")
    return named


def frame_rate(fps: float | None, home: str, known: float | None = None) -> float:
    """Return the frame rate of a home in frames per second.

    The rate is `fps` or, if that is None, `known`, which comes from the files of the home. Raises
    PlacecatError unless the rate is positive.
    """
    rate = known if fps is None else fps
    if rate is None or not np.isfinite(rate) or rate <= 0:
        what = "not in the files" if rate is None else f"{rate}"
        raise PlacecatError(f"{home}: the frame rate is {what}; set dataset.fps to a positive number.")
    return float(rate)
