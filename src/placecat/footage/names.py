"""Names of files and folders: their order, and what they may not be."""

import re
from pathlib import PurePosixPath

from placecat.errors import PlacecatError


def natural(name: str) -> tuple[tuple[tuple[int, int, str], ...], str]:
    """Key that sorts file and folder names with runs of digits as numbers; equal only for equal names."""
    parts = re.findall(r"[0-9]+|[^0-9]+", name)
    return tuple((0, int(part), "") if part.isdigit() else (1, 0, part.casefold()) for part in parts), name


def relative(name: str, origin: str) -> PurePosixPath:
    """Check by its text that a POSIX path stays below the folder that it is relative to.

    Raises PlacecatError, which begins with `origin`, if it is empty, absolute, or holds ``..``.
    """
    path = PurePosixPath(name)
    if not path.parts or path.is_absolute() or ".." in path.parts or "\\" in name or "\0" in name:
        raise PlacecatError(f"{origin}: {name!r} is not a path below the data folder; correct it.")
    return path
