"""Export a prediction for robotics tools, as MCAP and Rerun files outside the results folder.

The modules for these formats are imported late because they import Matplotlib for its colours.
"""

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

_ENDINGS = {"mcap": ".mcap", "rerun": ".rrd"}
OPTIONS = tuple(_ENDINGS)


def _kind(option: str) -> "type[McapFile] | type[RerunFile]":
    from placecat.predict.mcap_file import McapFile
    from placecat.predict.rerun_file import RerunFile

    return McapFile if option == "mcap" else RerunFile


def check(wanted: Mapping[str, Path], folder: Path, read: Sequence[Path], *, force: bool) -> None:
    """Check that the files can be written, before any work starts.

    `wanted` maps each option, one of `OPTIONS`, to its file. `folder` is the results folder, which will be
    replaced. An existing file is replaced only with `force`. The input files in `read` are never replaced.
    Raises PlacecatError if a package is missing, a suffix is wrong, or a file is off limits or not writable.
    """
    for option, path in wanted.items():
        ending = _ENDINGS[option]
        _kind(option).require()
        given = f"--{option} is {path}"
        if path.suffix != ending:
            raise PlacecatError(f"{given}: choose a name that ends in {ending}")
        if any(path.resolve().is_relative_to(other.resolve()) for other in read):
            raise PlacecatError(f"{given}, which is an input to the prediction: choose another name")
        if path.resolve().is_relative_to(folder.resolve()):
            raise PlacecatError(
                f"{given}, but the prediction replaces the folder {folder}: choose another name"
            )
        if path.exists() and not force:
            raise PlacecatError(f"{given}, which already exists: choose another name, or use --force")
        files.check_writable(path)


@contextmanager
def opened(
    wanted: Mapping[str, Path], classes: tuple[str, ...], size: tuple[int, int], start: int
) -> Iterator[list["Export"]]:
    """Open the files that :func:`check` accepted, and rename them to their final names if the block succeeds.

    `size` is the (width, height) of the frames. `start` is the first frame's time in nanoseconds since 1970,
    or 0 if unknown.
    """
    with ExitStack() as stack:
        exports: list[Export] = []
        for option, path in wanted.items():
            temporary = stack.enter_context(files.replacing(path))
            export: Export = _kind(option)(temporary, path.stem, classes, size, start)
            stack.enter_context(export)
            exports.append(export)
        yield exports
