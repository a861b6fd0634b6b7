"""Errors that users can fix, and how they end the program."""

import difflib
import errno
import os
import sys
import traceback
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path


class PlacecatError(ValueError):
    """Bad input or an invalid setting.

    The message names the file, line or setting and the remedy in one or two sentences. The command line
    prints it without a traceback and exits with status 1.
    """

    def __init__(self, message: str) -> None:
        super().__init__(printable(message))


class NotComputable(PlacecatError):
    """A number that cannot be computed from the data with any settings. Tables show the reason instead."""


class SettingError(PlacecatError):
    """A setting that is invalid, regardless of the data."""


# Remedies for errors from disks, file systems and system limits.
_REFUSED = {
    errno.ENOSPC: "free some space and run again",
    errno.EDQUOT: "free some space and run again",
    errno.EFBIG: "allow larger files (ulimit -f) and run again",
    errno.EACCES: "fix the permissions, or choose another folder",
    errno.EPERM: "fix the permissions, or choose another folder",
    errno.EROFS: "choose a writable folder",
    errno.EIO: "check the disk or the network",
    errno.EMFILE: "allow more open files (ulimit -n)",
    errno.ENFILE: "close other programs",
    errno.ENAMETOOLONG: "use a shorter name",
    errno.ENOTDIR: "a file is where a folder should be: use another name",
    errno.EEXIST: "a file is where a folder should be: use another name",
    errno.EISDIR: "name a file",
}


@contextmanager
def exiting() -> Iterator[None]:
    """End the program without a traceback.

    On a user error, a full disk or a missing permission, print one message and exit with status 1.
    On Ctrl-C, exit with status 130; if the output pipe is closed, exit silently with status 1.
    """
    try:
        yield
    except (PlacecatError, OSError, KeyboardInterrupt) as error:
        status = _status(error)
        # These frames may hold parallel loops in variables. Python would end the loops only at shutdown, when
        # joblib can no longer start the next tasks and prints a traceback.
        traceback.clear_frames(error.__traceback__)
        sys.exit(status)


def _status(error: BaseException) -> str | int:
    """Return the message or the exit status for an error; re-raise it if it needs a traceback."""
    if isinstance(error, KeyboardInterrupt):
        return 130
    if isinstance(error, PlacecatError):
        return f"placecat: {error}"
    if isinstance(error, BrokenPipeError):
        # Without this, Python reports the closed pipe at exit.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 1
    if isinstance(error, OSError) and is_refusal(error):
        return f"placecat: {refusal(error)}"
    raise error


def printable(text: str) -> str:
    """Escape unprintable and control characters, except line breaks and tabs, in the form ``\\x1b``."""
    if text.isprintable():
        return text
    return "".join(
        one if one.isprintable() or one in "\n\t" else one.encode("unicode_escape").decode() for one in text
    )


def one_line(text: object) -> str:
    """Escape a name as :func:`printable` does, and escape line breaks as well."""
    return printable(str(text)).replace("\n", "\\n")


@contextmanager
def reading(path: Path) -> Iterator[None]:
    """Raise PlacecatError for system errors while reading a user file, such as a missing permission."""
    try:
        yield
    except OSError as error:
        name = error.filename if error.filename is not None else path
        raise PlacecatError(
            f"{name}: cannot be read ({error.strerror or error}); make it readable."
        ) from None


def is_refusal(error: OSError) -> bool:
    """Return whether reading or writing failed for a reason that the user can fix."""
    # NumPy reports the number of bytes written, but no error number.
    return error.errno in _REFUSED or (error.errno is None and "requested and" in str(error))


def refusal(error: OSError, path: object = None) -> str:
    """Describe a system error: the message, the file (by default the one in the error), and the remedy."""
    name = error.filename if path is None else path
    where = "" if name is None else f"{os.fsdecode(name) if isinstance(name, bytes) else name}: "
    number = error.errno or errno.ENOSPC
    return f"{where}{error.strerror or os.strerror(number)}; {_REFUSED.get(number, 'choose another folder')}"


def did_you_mean(name: object, valid: Iterable[str]) -> str:
    """Return ``; did you mean NAME?`` with the most similar valid name, or "" if none is similar."""
    nearest = difflib.get_close_matches(str(name), list(valid), n=1)
    return f"; did you mean {nearest[0]!r}?" if nearest else ""
