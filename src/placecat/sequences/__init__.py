"""Read homes and their labels; each module reads one layout on disk.

A layout is a module of this package that defines ``list_homes(root)`` and ``read_home(root, name, *, fps,
camera)``, as documented by `list_homes` and `open_home` here. Its file name is its name in the settings. To
add a layout, add a file.
"""

import inspect
from collections.abc import Collection, Mapping
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
    "open_home_of",
    "place_labels",
    "read_frames",
    "require_classes",
    "settings_of",
]

# Functions that each layout module defines.
READER = ("list_homes", "read_home")


def layouts() -> list[str]:
    """List the layouts, sorted: the modules of this package that define a reader."""
    return lookup.names(__name__, *READER)


def settings_of(layout: str) -> list[str]:
    """List the settings of a layout: the parameters of its ``read_home`` except the folder and the home.

    Raises PlacecatError if the layout is unknown.
    """
    return list(inspect.signature(_reader(layout).read_home).parameters)[2:]


def list_homes(layout: str, root: Path | str, **settings: Any) -> list[str]:
    """List the homes in a folder, at least one, in natural order (Home2 before Home10).

    The parameters are the same as for :func:`open_home`; settings that matter only there are ignored. Raises
    PlacecatError if the layout or a setting is unknown, or if the folder is missing, unreadable, or without a
    home of this layout.
    """
    reader = _reader(layout)
    _refuse_unknown(layout, settings)
    taken = inspect.signature(reader.list_homes).parameters
    with reading(Path(root)):
        return reader.list_homes(
            Path(root), **{name: value for name, value in settings.items() if name in taken}
        )


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
        Settings of the layout (see `settings_of`): ``fps`` (frames per second, or None if the layout knows
        it), ``camera`` (its name) and others.

    Returns
    -------
    Home
        The frames are listed but not decoded; see `read_frames`.

    Raises
    ------
    PlacecatError
        If the layout or a setting is unknown, the home cannot be read, or its labels do not match its frames;
        the message names the file and, if possible, the line.
    """
    reader = _reader(layout)
    _refuse_unknown(layout, settings)
    with reading(Path(root) / name):
        return reader.read_home(Path(root), name, **settings)


def open_home_of(dataset: Mapping[str, Any], name: str, **changed: Any) -> Home:
    """Read a home with its data set's settings, except those `changed`; errors as in :func:`open_home`.

    Parameters
    ----------
    dataset
        Settings as in conf/dataset; ``camera`` is one name for all homes, or maps each home to a name.
    name
        A home of the data set.
    """
    layout, camera = dataset["layout"], dataset["camera"]
    if not isinstance(camera, str):
        if name not in camera:
            raise PlacecatError(
                f"dataset.camera names none for {name}: add dataset.camera.{name}, or name one for all"
            )
        camera = camera[name]
    given = {setting: dataset[setting] for setting in settings_of(layout) if setting in dataset}
    return open_home(layout, dataset["root"], name, **given | {"camera": camera} | changed)


def _reader(layout: str) -> ModuleType:
    return lookup.module(__name__, layout, "dataset.layout", *READER)


def _refuse_unknown(layout: str, settings: Collection[str]) -> None:
    known = settings_of(layout)
    for setting in settings:
        if setting not in known:
            raise PlacecatError(
                f"dataset.{setting}: the layout {layout!r} has no such setting; it takes {', '.join(known)}."
            )
