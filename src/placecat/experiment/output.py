"""The files of an experiment, and its result in a few words."""

from typing import Any

RESULT = "result.json"
SECONDS = "seconds.json"
TRACEBACK = "traceback.txt"
SUMMARY = "summary.csv"
FAILED = "failed"


def failure(message: str) -> dict[str, Any]:
    """The result of an experiment that failed."""
    return {FAILED: message, "accuracy": None, "reason": None}


def shown(result: dict[str, Any]) -> str:
    """A result in a few words."""
    if FAILED in result:
        return f"failed: {result[FAILED]}"
    if result["accuracy"] is None:
        return f"no number: {result['reason']}"
    return f"{result['accuracy']:.2f} %"
