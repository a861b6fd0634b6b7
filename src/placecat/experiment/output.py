"""The file names of an experiment, and functions that read its result and format it on one line."""

from pathlib import Path
from typing import Any

from placecat import files

RESULT = "result.json"
SECONDS = "seconds.json"
TRACEBACK = "traceback.txt"
SUMMARY = "summary.csv"
FAILED = "failed"
# Measures in a result, named as in the tables' MLflow runs.
MEASURES = ("accuracy", "log_loss", "calibration_error")
# The preliminary result of a job, which remains if its process is killed.
KILLED = "its process was killed, perhaps because memory ran out"


def failure(message: str) -> dict[str, Any]:
    """Build the result of a failed experiment."""
    return {FAILED: message, "accuracy": None, "reason": None}


def read(folder: Path) -> dict[str, Any]:
    """Read result.json from a job folder; return a failure if it is missing or not JSON."""
    path = folder / RESULT
    try:
        result: dict[str, Any] = files.read_json(path)
    except FileNotFoundError:
        return failure(f"the experiment left no result in {folder}")
    except ValueError:
        return failure(f"{path} is damaged: remove it and run the experiment again")
    return result


def shown(result: dict[str, Any]) -> str:
    """Format a result on one line."""
    if FAILED in result:
        return f"failed: {result[FAILED]}"
    if result["accuracy"] is None:
        return f"no number: {result['reason']}"
    return f"{result['accuracy']:.2f}%, {quality(result)}"


def quality(result: dict[str, Any]) -> str:
    """Format log-loss and calibration error."""
    return "log-loss {:.3f} nats, calibration error {:.2f}%".format(*(result[one] for one in MEASURES[1:]))
