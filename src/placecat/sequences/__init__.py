"""Readers of homes and their labels: one module per layout on disk.

A layout is a module of this package that defines ``list_homes(root)`` and ``read_home(root, name, *, fps,
camera)``, which do what `list_homes` and `open_home` here say; its file name is its name in the settings.
Adding a file adds a layout.
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

# The module of a layout defines these.
READER = ("list_homes", "read_home")


def layouts() -> list[str]:
    """Name the layouts that can be read: modules of this package that define a reader, sorted."""
    return lookup.names(__name__, *READER)


def settings_of(layout: str) -> list[str]:
    """Name the settings of a layout: the parameters of its ``read_home`` beside the folder and the home.

    Raises PlacecatError if the layout is unknown.
    """
    return list(inspect.signature(_reader(layout).read_home).parameters)[2:]


def list_homes(layout: str, root: Path | str, **settings: Any) -> list[str]:
    """Name the homes in a folder, at least one, in natural order (Home2 before Home10).

    The parameters are those of :func:`open_home`; settings that only matter there are passed over. Raises
    PlacecatError if the layout or a setting is unknown, or the folder is missing, not readable or holds no
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
        Of the layout, see `settings_of`: ``fps`` (frames a second, or None where the layout knows it),
        ``camera`` (its name) and others.

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
    _refuse_unknown(layout, settings)
    with reading(Path(root) / name):
        return reader.read_home(Path(root), name, **settings)


def open_home_of(dataset: Mapping[str, Any], name: str, **changed: Any) -> Home:
    """Read a home of a data set by its settings, some of them `changed`; errors as in :func:`open_home`.

    Parameters
    ----------
    dataset
        As in conf/dataset; ``camera`` is one name for all homes, or a name by home.
    name
        One of its homes.
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
