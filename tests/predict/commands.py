"""Run `placecat predict` in the current process."""

import pytest

from placecat.__main__ import main


def predict(*arguments):
    main(["predict", *map(str, arguments)])


def refused(*arguments):
    """Return the one-line error message of a command that fails."""
    with pytest.raises(SystemExit) as caught:
        predict(*arguments)
    text = str(caught.value)
    assert text.startswith("placecat: ") and len(text.splitlines()) == 1, text
    return text
