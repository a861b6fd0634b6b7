"""Completion in bash of what an experiment is made of; the rest of the settings Hydra completes.

Hydra offers every group of conf/, most of which is about tables, and no second value of a sweep.
"""

import os
from collections.abc import Sequence

from placecat import settings
from placecat.errors import PlacecatError
from placecat.experiment import options

_KEYS = ("descriptor", "classifier", "data", "test_home", "judge")
_FURTHER = (
    "descriptor.",
    "classifier.",
    "frames.",
    "seeds=",
    "codebook.cells=",
    "clustering@codebook.tree=",
    "limits.kernel_rows=",
    "track=",
    "hydra/launcher=",
    "hydra.",
)


def suggestions() -> list[str] | None:
    """Words that may stand for the last one in the environment variable COMP_LINE; None: Hydra knows."""
    line = os.environ.get("COMP_LINE", "")[: int(os.environ.get("COMP_POINT", "0") or 0)]
    words = line.split(" ")
    word = words[-1]
    if "=" not in word:
        if "." in word or "/" in word or word.startswith(("-", "+", "~")):
            return None
        return [*(f"{key}=" for key in _KEYS), *_FURTHER]
    key, _, value = word.partition("=")
    if key not in _KEYS:
        return None
    before = value[: value.rfind(",") + 1]
    return [f"{key}={before}{name}" for name in _values(key, words) if name not in before.split(",")]


def _values(key: str, words: Sequence[str]) -> list[str]:
    if key == "descriptor":
        return sorted(options.descriptors())
    if key == "classifier":
        return sorted(options.classifiers())
    if key == "data":
        return [options.MAIN, *options.splits()]
    if key == "judge":
        return list(options.JUDGES)
    from placecat.experiment import data

    chosen = [word.partition("=")[2] for word in words if word.startswith("data=")]
    try:
        return [*data.find(settings.load(), (chosen or [options.MAIN])[-1]).by_test, options.ALL]
    except PlacecatError:
        return []
