"""Exports of a prediction to robotics tools, beside its folder: MCAP and Rerun.

Their modules are imported late, since they import Matplotlib for its colours.
"""

import importlib
from collections.abc import Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from placecat import files
from placecat.errors import PlacecatError

if TYPE_CHECKING:
    from placecat.predict.mcap_file import McapFile
    from placecat.predict.rerun_file import RerunFile

    Export = McapFile | RerunFile

_KINDS = {".mcap": ("--mcap", "mcap_file"), ".rrd": ("--rerun", "rerun_file")}


def check(wanted: Mapping[str, Path], folder: Path, read: Sequence[Path], *, force: bool) -> None:
    """Refuse files that cannot be written, before the work.

    Parameters
    ----------
    wanted
        Ending (``.mcap``, ``.rrd``) to the file.
    folder
        Of the results: it will be replaced.
    read
        Files and folders that are read.
    force
        Replace a file that is there, but never one that is read.

    Raises
    ------
    PlacecatError
        If a package is missing, a name ends otherwise, or something is in the way.
    """
    for ending, path in wanted.items():
        option, module = _KINDS[ending]
        importlib.import_module(f"placecat.predict.{module}").require()
        if path.suffix != ending:
            raise PlacecatError(f"{option} is {path}: give a name that ends with {ending}")
        for other in read:
            if path.resolve().is_relative_to(other.resolve()):
                raise PlacecatError(f"{option} is {path}, which is read: give another name")
        if path.resolve().is_relative_to(folder.resolve()):
            raise PlacecatError(f"{option} is {path}, in {folder}, which is replaced: give another name")
        if path.exists() and not force:
            raise PlacecatError(f"{option} is {path}, which exists: give another name, or --force")
        files.check_writable(path)


@contextmanager
def opened(
    wanted: Mapping[str, Path], classes: tuple[str, ...], size: tuple[int, int], start: int
) -> Iterator[list["Export"]]:
    """Open what :func:`check` accepts; the files get their names if the block succeeds.

    Parameters
    ----------
    wanted
        As for :func:`check`.
    classes
        Places.
    size
        (width, height) of the frames that are added.
    start
        Nanoseconds since 1970 of the first frame; 0 if it is not known.
    """
    with ExitStack() as stack:
        exports: list[Export] = []
        for ending, path in wanted.items():
            temporary = stack.enter_context(files.replacing(path))
            if ending == ".mcap":
                from placecat.predict.mcap_file import McapFile

                exports.append(stack.enter_context(McapFile(temporary, path.stem, classes, size, start)))
            else:
                from placecat.predict.rerun_file import RerunFile

                exports.append(stack.enter_context(RerunFile(temporary, path.stem, classes, start)))
        yield exports
