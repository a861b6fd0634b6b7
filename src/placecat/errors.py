"""The one exception that means: the user can mend this."""

import difflib
import sys
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path


class PlacecatError(ValueError):
    """Bad input or an impossible setting.

    Its message is one sentence or two that name the file, line or setting and what to do. The command line
    prints the message without a traceback and exits with status 1.
    """

    def __init__(self, message: str) -> None:
        super().__init__(printable(message))


class NotComputable(PlacecatError):
    """These data cannot give this number, whatever the settings: a table says so in its place."""


class SettingError(PlacecatError):
    """A setting that is wrong, whatever the data."""


@contextmanager
def exiting() -> Iterator[None]:
    """End the program without a traceback: on a mistake with its message and status 1, on Ctrl-C with 130."""
    try:
        yield
    except PlacecatError as error:
        sys.exit(f"placecat: {error}")
    except KeyboardInterrupt:
        sys.exit(130)


def printable(text: str) -> str:
    """Write what a terminal would obey, or could not show, as Python writes it, e.g. ``\\x1b``; lines stay.

    Titles, labels and names of files may hold such characters, and a message names them.
    """
    if text.isprintable():
        return text
    return "".join(
        one if one.isprintable() or one in "\n\t" else one.encode("unicode_escape").decode() for one in text
    )


@contextmanager
def reading(path: Path) -> Iterator[None]:
    """Read what a user gave: an error of the system, such as a missing permission, becomes one message.

    Raises
    ------
    PlacecatError
        Naming the file that the system names, or `path`.
    """
    try:
        yield
    except OSError as error:
        name = error.filename if error.filename is not None else path
        raise PlacecatError(
            f"{name}: cannot be read ({error.strerror or error}); make it readable."
        ) from None


def did_you_mean(name: object, valid: Iterable[str], before: str = "; ") -> str:
    """Ask whether the nearest of the valid names was meant, after `before`; empty if none is near."""
    nearest = difflib.get_close_matches(str(name), list(valid), n=1)
    return f"{before}did you mean {nearest[0]!r}?" if nearest else ""
