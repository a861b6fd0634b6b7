"""Read homes and their labels. Each layout on disk has a module in this package.

A layout is a module that defines ``read_home(root, name, *, fps, camera)``, as documented in `open_home`.
Settings refer to it by its module name. To add a layout, add a module.
"""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from placecat import lookup
from placecat.errors import PlacecatError, reading
from placecat.footage.frames import read_frames
from placecat.sequences.base import Home
from placecat.sequences.places import place_labels, require_classes

__all__ = [
    "Home",
    "open_home",
    "open_home_of",
    "place_labels",
    "read_frames",
    "require_classes",
]


def open_home(layout: str, root: Path | str, name: str, **settings: Any) -> Home:
    """List the frames of a home, without decoding them (see `read_frames`), and read their labels.

    Raises PlacecatError if the layout is unknown, the home cannot be read, or its labels do not match its
    frames. The message names the file and, if possible, the line.

    Parameters
    ----------
    layout
        A module in this package.
    root
        The folder that contains the homes.
    name
        The name of a home in `root`.
    **settings
        Keyword parameters of the layout's ``read_home``: ``fps`` (frames per second, or None to take the rate
        from the files), ``camera`` (the name of the camera), and others.
    """
    reader = lookup.module(__name__, layout, "dataset.layout", "read_home")
    with reading(Path(root) / name):
        return reader.read_home(Path(root), name, **settings)


def open_home_of(dataset: Mapping[str, Any], name: str, **changed: Any) -> Home:
    """Read a home with the settings of its data set. Settings in `changed` take precedence.

    `dataset` contains the settings from a file in conf/dataset. Its ``camera`` is one name for all homes, or
    maps each home to a name. Raises the same errors as :func:`open_home`.
    """
    layout, camera = dataset["layout"], dataset["camera"]
    if not isinstance(camera, str):
        if name not in camera:
            raise PlacecatError(
                f"dataset.camera lists no camera for {name}: add dataset.camera.{name}, or set one for all "
                "homes"
            )
        camera = camera[name]
    taken = lookup.parameters(__name__, layout, "read_home")
    given = {setting: dataset[setting] for setting in taken if setting in dataset}
    return open_home(layout, dataset["root"], name, **given | {"camera": camera} | changed)
