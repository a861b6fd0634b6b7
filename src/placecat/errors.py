"""The one exception that means: the user can mend this."""

import difflib
import sys
from collections.abc import Iterable, Iterator
from contextlib import contextmanager


class PlacecatError(ValueError):
    """Bad input or an impossible setting.

    Its message is one sentence or two that name the file, line or setting and what to do. The command line
    prints the message without a traceback and exits with status 1.
    """


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


def did_you_mean(name: object, valid: Iterable[str], before: str = "; ") -> str:
    """Ask whether the nearest of the valid names was meant, after `before`; empty if none is near."""
    nearest = difflib.get_close_matches(str(name), list(valid), n=1)
    return f"{before}did you mean {nearest[0]!r}?" if nearest else ""
