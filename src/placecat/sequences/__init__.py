"""Frames and labels in: one module a layout on disk.

A layout is a module of this package that defines ``list_homes(root)`` and ``read_home(root, name, *, fps,
camera)``, which do what `list_homes` and `open_home` here say; its file name is its name in the settings.
Adding a file adds a layout.
"""

import importlib
import inspect
import pkgutil
from pathlib import Path
from types import ModuleType
from typing import Any

from placecat.errors import PlacecatError
from placecat.sequences.base import Home, read_frames
from placecat.sequences.places import place_labels, require_classes

__all__ = ["Home", "layouts", "list_homes", "open_home", "place_labels", "read_frames", "require_classes"]


def layouts() -> list[str]:
    """Name the layouts that can be read.

    Returns
    -------
    Module names in this package that define a reader, sorted.
    """
    names = sorted(module.name for module in pkgutil.iter_modules(__path__))
    return [name for name in names if _is_reader(importlib.import_module(f"{__name__}.{name}"))]


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
        If the layout is unknown, or the folder is missing or holds no home of this layout.
    """
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
        Passed to the layout's ``read_home``: ``fps`` (frames a second, or None where the layout knows it),
        ``camera`` (its name) and whatever else that layout takes.

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
    reader = _reader(layout)
    known = list(inspect.signature(reader.read_home).parameters)[2:]
    for setting in settings:
        if setting not in known:
            raise PlacecatError(
                f"dataset.{setting} is no setting of the layout {layout!r}; it takes {', '.join(known)}."
            )
    return reader.read_home(Path(root), name, **settings)


def _is_reader(module: ModuleType) -> bool:
    return hasattr(module, "list_homes") and hasattr(module, "read_home")


def _reader(layout: str) -> ModuleType:
    if layout in {module.name for module in pkgutil.iter_modules(__path__)}:
        module = importlib.import_module(f"{__name__}.{layout}")
        if _is_reader(module):
            return module
    raise PlacecatError(f"dataset.layout: no layout {layout!r}; use one of {', '.join(layouts())}.")
