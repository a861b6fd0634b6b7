"""Tours with six square images per panorama, and a table that lists the room of each panorama."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from placecat.panoramas.cube import FACES
from placecat.panoramas.panorama import Panorama
from placecat.panoramas.sources.equirectangular import read_table


def read(root: Path, settings: Mapping[str, Any]) -> list[Panorama]:
    """List the panoramas in a folder; see `placecat.panoramas.sources.read`.

    The `cubes` setting defines how the six image names are derived from the value in the `file` column.
    """
    pattern, names = settings["cubes"]["file"], settings["cubes"]["faces"]

    def files(file: str) -> list[str]:
        return [
            file.join(part.replace("FACE", names[face]) for part in pattern.split("FILE")) for face in FACES
        ]

    return read_table(root, settings, files)
