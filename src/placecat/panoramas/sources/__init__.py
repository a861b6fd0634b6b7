"""Sources of panoramas, one module per source.

A source is a module of this package with a function ``read(root, settings)``. The function lists the
panoramas in a folder according to the settings of conf/panoramas.yaml. Those settings refer to a source by
its module name.
"""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from placecat import lookup, schema
from placecat.errors import PlacecatError, did_you_mean, reading
from placecat.panoramas.panorama import Panorama
from placecat.schema.names import FileName, Label
from placecat.sequences.folders import existing, inside

_HOME, _ROOM = schema.of_type(FileName), schema.of_type(Label)


def read(root: Path, settings: Mapping[str, Any]) -> list[Panorama]:
    """List the panoramas in a folder according to the settings of conf/panoramas.yaml.

    Checks that the images exist, but does not decode them. Raises PlacecatError if the source is unknown,
    if the folder contains no panoramas, or if a file is missing or invalid. The message names the file and,
    if possible, the line.
    """
    source = lookup.module(__name__, settings["source"], "source", "read")
    existing(root, "specify the folder with the panoramas.")
    with reading(root):
        panoramas: list[Panorama] = source.read(root, settings)
        if settings["homes"] is not None:
            there = {one.home for one in panoramas}
            for home in settings["homes"]:
                if home not in there:
                    raise PlacecatError(f"homes: there is no home {home!r}{did_you_mean(home, there)}")
            panoramas = [one for one in panoramas if one.home in settings["homes"]]
        if not panoramas:
            raise PlacecatError(
                f"{root} contains no panoramas; correct SOURCE, or the source or labels setting."
            )
        for one in panoramas:
            schema.check_value(one.home, _HOME, f"{one.origin}: home")
            schema.check_value(one.room, _ROOM, f"{one.origin}: room")
            _check_files(root, one, settings)
    _check_names(panoramas)
    return panoramas


def _check_files(root: Path, panorama: Panorama, settings: Mapping[str, Any]) -> None:
    hint = ""
    if len(panorama.files) > 1:
        pattern = settings["cubes"]["file"]
        hint = f"; correct the file column there, or cubes.file={pattern}, which names the faces"
    for file in panorama.files:
        path = root / file
        if not path.is_file():
            raise PlacecatError(f"{path}: the image is missing ({panorama.origin}){hint}.")
        inside(path, root, panorama.origin)


def _check_names(panoramas: list[Panorama]) -> None:
    """Raise an error if the names of two homes differ only in case, or if an image is listed twice."""
    homes: dict[str, str] = {}
    files: dict[str, str] = {}
    for one in panoramas:
        first = homes.setdefault(one.home.casefold(), one.home)
        if first != one.home:
            raise PlacecatError(
                f"{one.origin}: the home names {first!r} and {one.home!r} differ only in case; "
                "rename one of them."
            )
        for file in one.files:
            where = files.setdefault(file, one.origin)
            if where != one.origin:
                raise PlacecatError(
                    f"{one.origin}: {file} is already listed ({where}); remove one of the two."
                )
