"""Print, write and log the results of a sweep or of a single experiment."""

import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from placecat import files
from placecat.errors import PlacecatError
from placecat.experiment import output, summary


def tell(folder: Path, combinations: Sequence[dict[str, str]], *, log: Sequence[str] | None) -> bool:
    """Print, write and log a sweep's results; return whether all experiments and the logging succeeded.

    `combinations` has the swept keys and values of each started experiment. `log` has the sweep's overrides,
    for MLflow; None turns logging off.
    """
    ran = summary.read(folder, combinations)
    if not ran:
        return True
    files.write_csv(folder / output.SUMMARY, summary.as_frame(ran))
    print(f"\n{summary.text(ran)}\n\nDetails: {folder / output.SUMMARY}")
    is_logged = log is None or _log(lambda tracking: tracking.log_sweep(ran, folder, log))
    return is_logged and not any(one.has_failed for one in ran)


def tell_one(folder: Path, result: dict[str, object], *, log: bool) -> bool:
    """Print and log a single experiment's result; return whether the logging succeeded."""
    print(f"\n{summary.text_of_one(result)}\n\nDetails: {folder / output.RESULT}")
    return not log or _log(lambda tracking: tracking.log_one(result, folder))


def _log(write: Callable[[Any], str]) -> bool:
    """Log to MLflow; print where, or why it failed. The results are already on disk."""
    # Imported here, since it imports MLflow.
    from placecat.experiment import tracking

    try:
        print(f"Logged: {write(tracking)}")
    except PlacecatError as error:
        print(
            f"placecat: nothing was logged to MLflow: {error}; track=false turns logging off", file=sys.stderr
        )
        return False
    return True
