"""Show the progress of a loop: one updated line in a terminal, occasional lines in a log."""

import sys
from collections.abc import Callable, Iterable
from typing import Any

from tqdm import tqdm

# Seconds between lines in a log, and before the first line.
IN_LOG = 30.0
_IN_TERMINAL = 0.2
_COUNT = "{desc}: {n_fmt}{unit}, {rate_fmt}{postfix}"
_TIME_LEFT = "{desc}: {n_fmt} of {total_fmt}{unit}, {remaining} left{postfix}"
_BAR = "{desc}: {percentage:3.0f}% |{bar:20}| {n_fmt} of {total_fmt}{unit}, {remaining} left{postfix}"


class Progress(tqdm):
    """A progress line on standard error, with the time left.

    In a terminal, it is a single line that disappears at the end. Elsewhere, a line is written every `IN_LOG`
    seconds, so short loops write nothing. `iterable` is None if the caller uses :meth:`update` instead.
    `total` is None if unknown. `unit` is a plural noun for the steps.
    """

    def __init__(
        self, iterable: Iterable[Any] | None = None, *, description: str, total: int | None, unit: str
    ) -> None:
        is_terminal = sys.stderr.isatty()
        with_total = _BAR if is_terminal else _TIME_LEFT
        super().__init__(
            iterable,
            desc=description,
            total=total,
            unit=f" {unit}",
            bar_format=with_total if total is not None else _COUNT,
            file=sys.stderr,
            leave=False,
            dynamic_ncols=is_terminal,
            mininterval=_IN_TERMINAL if is_terminal else IN_LOG,
            maxinterval=IN_LOG,
            delay=0 if is_terminal else IN_LOG,
        )

    def close(self) -> None:
        """End the line in a terminal; write nothing to a log."""
        self.disable = self.disable or not self.fp.isatty()
        super().close()

    @staticmethod
    def status_printer(file: Any) -> Callable[[str], None]:
        """Return a function that overwrites the line in a terminal, or writes a new line elsewhere."""
        if file.isatty():
            return tqdm.status_printer(file)

        def write_line(text: str) -> None:
            # tqdm clears its line by writing an empty one.
            if text.strip():
                file.write(f"{text}\n")
                file.flush()

        return write_line
