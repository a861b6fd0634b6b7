"""Names of files and folders: their order, and what they may not be."""

import re
from pathlib import PurePosixPath

from placecat.errors import PlacecatError


def natural(name: str) -> tuple[tuple[tuple[int, int, str], ...], str]:
    """Key that sorts file and folder names with runs of digits as numbers; equal only for equal names."""
    parts = re.findall(r"[0-9]+|[^0-9]+", name)
    return tuple((0, int(part), "") if part.isdigit() else (1, 0, part.casefold()) for part in parts), name


def relative(name: str, origin: str) -> PurePosixPath:
    """Check that a POSIX path stays below the folder it is relative to, by its text.

    Raises
    ------
    PlacecatError
        If it is empty, absolute, or holds ``..``; `origin` says where it was written.
    """
    path = PurePosixPath(name)
    if not path.parts or path.is_absolute() or ".." in path.parts or "\\" in name or "\0" in name:
        raise PlacecatError(f"{origin}: {name!r} is no path below the data folder; correct it.")
    return path
