"""Frames and labels in: one module a layout on disk.

A layout is a module of this package that defines ``list_homes(root)`` and ``read_home(root, name, *, fps,
camera)``, which do what `list_homes` and `open_home` here say; its file name is its name in the settings.
Adding a file adds a layout.
"""

import inspect
from pathlib import Path
from types import ModuleType
from typing import Any

from placecat import lookup
from placecat.errors import PlacecatError, reading
from placecat.footage.frames import read_frames
from placecat.sequences.base import Home
from placecat.sequences.places import place_labels, require_classes

__all__ = [
    "Home",
    "layouts",
    "list_homes",
    "open_home",
    "place_labels",
    "read_frames",
    "require_classes",
    "settings_of",
]

# What the module of a layout defines.
READER = ("list_homes", "read_home")


def layouts() -> list[str]:
    """Name the layouts that can be read.

    Returns
    -------
    Module names in this package that define a reader, sorted.
    """
    return lookup.names(__name__, *READER)


def settings_of(layout: str) -> list[str]:
    """Name the settings of a layout: the parameters of its ``read_home`` beside the folder and the home.

    Raises
    ------
    PlacecatError
        If the layout is unknown.
    """
    return list(inspect.signature(_reader(layout).read_home).parameters)[2:]


def list_homes(layout: str, root: Path | str) -> list[str]:
    """Name the homes under a folder.

    Parameters
    ----------
    layout
        One of `layouts`.
    root
        The folder that holds the homes.

    Returns
    -------
    In natural order (Home2 before Home10), at least one.

    Raises
    ------
    PlacecatError
        If the layout is unknown, or the folder is missing, cannot be read or holds no home of this layout.
    """
    with reading(Path(root)):
        return _reader(layout).list_homes(Path(root))


def open_home(layout: str, root: Path | str, name: str, **settings: Any) -> Home:
    """Read the frame list and the labels of one home.

    Parameters
    ----------
    layout
        One of `layouts`.
    root
        The folder that holds the homes.
    name
        One of ``list_homes(layout, root)``.
    **settings
        Passed to the layout's ``read_home``, see `settings_of`: ``fps`` (frames a second, or None where the
        layout knows it), ``camera`` (its name) and whatever else that layout takes.

    Returns
    -------
    Home
        Its frames are listed, not decoded; see `read_frames`.

    Raises
    ------
    PlacecatError
        If the layout or a setting is unknown, the home cannot be read, or its labels do not fit its frames;
        the message names the file, and the line where there is one.
    """
    reader, known = _reader(layout), settings_of(layout)
    for setting in settings:
        if setting not in known:
            raise PlacecatError(
                f"dataset.{setting} is no setting of the layout {layout!r}; it takes {', '.join(known)}."
            )
    with reading(Path(root) / name):
        return reader.read_home(Path(root), name, **settings)


def _reader(layout: str) -> ModuleType:
    return lookup.module(__name__, layout, "dataset.layout", *READER)
