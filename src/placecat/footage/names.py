"""Sort file and folder names in natural order, and check relative paths."""

import re
from pathlib import PurePosixPath

from placecat.errors import PlacecatError


def natural(name: str) -> tuple[tuple[tuple[int, int, str], ...], str]:
    """Return a sort key that compares runs of digits as numbers; only equal names have equal keys."""
    parts = re.findall(r"[0-9]+|[^0-9]+", name)
    return tuple((0, int(part), "") if part.isdigit() else (1, 0, part.casefold()) for part in parts), name


def relative(name: str, origin: str) -> PurePosixPath:
    """Check that a relative POSIX path stays inside its folder, without resolving symbolic links.

    Raises a PlacecatError that begins with `origin` if the path is empty or absolute, or contains ``..``, a
    backslash or a NUL.
    """
    path = PurePosixPath(name)
    if not path.parts or path.is_absolute() or ".." in path.parts or "\\" in name or "\0" in name:
        raise PlacecatError(f"{origin}: {name!r} is not a path below the data folder; correct it.")
    return path
