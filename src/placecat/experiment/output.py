"""The files of an experiment, and where Hydra puts them."""

from pathlib import Path
from typing import Any, ClassVar

from hydra.experimental.callback import Callback
from omegaconf import DictConfig

RESULT = "result.json"
SECONDS = "seconds.json"
TRACEBACK = "traceback.txt"
SUMMARY = "summary.csv"
# Written by Hydra when an experiment starts.
OVERRIDES = ".hydra/overrides.yaml"
FAILED = "failed"


class Remember(Callback):
    """Remember the output folder, which Hydra names by the time, for the summary at the end."""

    folder: ClassVar[Path | None] = None

    def on_run_start(self, config: DictConfig, **kwargs: Any) -> None:
        """Before a single experiment."""
        Remember.folder = Path(config.hydra.run.dir)

    def on_multirun_start(self, config: DictConfig, **kwargs: Any) -> None:
        """Before a sweep: what an earlier one left in the same folder is no result of this one."""
        Remember.folder = Path(config.hydra.sweep.dir)
        for pattern in (f"*/{RESULT}", f"*/{OVERRIDES}", SUMMARY):
            for path in list(Remember.folder.glob(pattern)):
                path.unlink()


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
