"""What is printed for people, of which a part may be text of the user's."""

import io
from typing import TextIO

from placecat.errors import printable


class Terminal(io.TextIOBase):
    """A terminal to print on: it obeys nothing that a title or the name of a file says."""

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream

    def write(self, text: str) -> int:
        """Write a text as :func:`printable` gives it, with what the terminal's coding lacks in numbers."""
        coding = self._stream.encoding or "utf-8"
        self._stream.write(printable(text).encode(coding, "backslashreplace").decode(coding))
        return len(text)

    def flush(self) -> None:
        """Write what is kept back."""
        self._stream.flush()
