"""The files of an experiment, and its result in one line."""

from pathlib import Path
from typing import Any

from placecat import files
from placecat.errors import PlacecatError

RESULT = "result.json"
SECONDS = "seconds.json"
TRACEBACK = "traceback.txt"
SUMMARY = "summary.csv"
FAILED = "failed"
# Of every result, by the names in the tables' runs; results of older versions have the first one only.
MEASURES = ("accuracy", "log_loss", "calibration_error")
# The preliminary result of a job.
KILLED = "its process was killed, perhaps because memory ran out"


def failure(message: str) -> dict[str, Any]:
    """The result of an experiment that failed."""
    return {FAILED: message, "accuracy": None, "reason": None}


def read(folder: Path) -> dict[str, Any]:
    """Read result.json of a job's folder; raises PlacecatError if it is missing or not JSON."""
    path = folder / RESULT
    try:
        result: dict[str, Any] = files.read_json(path)
    except FileNotFoundError:
        raise PlacecatError(f"it left no result in {folder}") from None
    except ValueError:
        raise PlacecatError(f"{path} is damaged: remove it and run again") from None
    return result


def shown(result: dict[str, Any]) -> str:
    """A result in one line."""
    if FAILED in result:
        return f"failed: {result[FAILED]}"
    if result["accuracy"] is None:
        return f"no number: {result['reason']}"
    return f"{result['accuracy']:.2f} %" + quality(result)


def quality(result: dict[str, Any]) -> str:
    """Log-loss and calibration error as the end of a line; "" if the result has none."""
    log_loss, error = (result.get(measure) for measure in MEASURES[1:])
    if log_loss is None or error is None:
        return ""
    return f", log-loss {log_loss:.3f} nats, calibration error {error:.2f} %"
