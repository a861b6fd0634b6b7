"""Errors that the user can mend, and how a program ends on them."""

import difflib
import errno
import os
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
    """A number that these data cannot give, whatever the settings; a table says so in its place."""


class SettingError(PlacecatError):
    """A setting that is wrong, whatever the data."""


# What a disk, a file system or the system's limits refuse, and what to do.
_REFUSED = {
    errno.ENOSPC: "make room and run again",
    errno.EDQUOT: "make room and run again",
    errno.EFBIG: "allow larger files (ulimit -f) and run again",
    errno.EACCES: "give yourself the permission, or another place",
    errno.EPERM: "give yourself the permission, or another place",
    errno.EROFS: "give another place, which can be written to",
    errno.EIO: "the disk or the network fails: check it",
    errno.EMFILE: "allow more open files (ulimit -n)",
    errno.ENFILE: "close other programs",
    errno.ENAMETOOLONG: "give a shorter name",
    errno.ENOTDIR: "a file stands where a folder is needed: give another name",
    errno.EEXIST: "a file stands where a folder is needed: give another name",
    errno.EISDIR: "give the name of a file",
}


@contextmanager
def exiting() -> Iterator[None]:
    """End the program without a traceback.

    On a mistake of the user's, or if the disk is full or the permission missing, it ends with one message and
    status 1, on Ctrl-C with 130, and quietly if nobody reads its output any more.
    """
    try:
        yield
    except PlacecatError as error:
        sys.exit(f"placecat: {error}")
    except BrokenPipeError:
        # Or Python complains of it when it ends.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        sys.exit(1)
    except OSError as error:
        if not is_refusal(error):
            raise
        sys.exit(f"placecat: {refusal(error)}")
    except KeyboardInterrupt:
        sys.exit(130)


def printable(text: str) -> str:
    """Escape what a terminal would obey or could not show, e.g. as ``\\x1b``; line ends stay.

    Titles, labels and names of files may hold such characters, and a message names them.
    """
    if text.isprintable():
        return text
    return "".join(
        one if one.isprintable() or one in "\n\t" else one.encode("unicode_escape").decode() for one in text
    )


def one_line(text: object) -> str:
    """A name as :func:`printable` gives it, which may not begin a line of its own."""
    return printable(str(text)).replace("\n", "\\n")


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


def is_refusal(error: OSError) -> bool:
    """Whether the system refused to read or write, so that the user can mend it."""
    # NumPy says how much it wrote, and no reason.
    return error.errno in _REFUSED or (error.errno is None and "requested and" in str(error))


def refusal(error: OSError, path: object = None) -> str:
    """Say what the system refused, for which file (by default that of the error), and what to do."""
    name = error.filename if path is None else path
    where = "" if name is None else f"{os.fsdecode(name) if isinstance(name, bytes) else name}: "
    number = error.errno or errno.ENOSPC
    return f"{where}{error.strerror or os.strerror(number)}; {_REFUSED.get(number, 'give another place')}"


def did_you_mean(name: object, valid: Iterable[str], before: str = "; ") -> str:
    """Suggest the nearest valid name, after `before`; empty if none is near."""
    nearest = difflib.get_close_matches(str(name), list(valid), n=1)
    return f"{before}did you mean {nearest[0]!r}?" if nearest else ""
