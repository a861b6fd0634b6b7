"""Terminal output that may contain user text."""

import io
from typing import TextIO

from placecat.errors import printable


class Terminal(io.TextIOBase):
    """An output stream that escapes control characters in titles and file names."""

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream

    def write(self, text: str) -> int:
        """Write text as escaped by :func:`printable`; also escape characters that the encoding lacks."""
        coding = self._stream.encoding or "utf-8"
        self._stream.write(printable(text).encode(coding, "backslashreplace").decode(coding))
        return len(text)

    def flush(self) -> None:
        """Flush the stream, if it is open: Python also flushes when it frees this object."""
        if not self._stream.closed:
            self._stream.flush()
