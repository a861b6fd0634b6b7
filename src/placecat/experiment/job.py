"""The Hydra job that runs one combination of settings, in this process or in a worker."""

import logging
import math
import os
import sys
import time
import traceback
from pathlib import Path
from typing import TYPE_CHECKING, Any

from hydra.core.hydra_config import HydraConfig
from hydra.experimental.callback import Callback
from hydra.types import RunMode
from omegaconf import DictConfig, OmegaConf
from omegaconf.errors import OmegaConfBaseException

from placecat import compute, files, settings
from placecat.compute import lifeline, parallel
from placecat.config.compose import refusal
from placecat.errors import PlacecatError
from placecat.experiment import output

if TYPE_CHECKING:
    from placecat.experiment.combination import Experiment

# Environment variable that passes the sweep's process ID to workers.
WORKERS_OF = "PLACECAT_SWEEP"
_log = logging.getLogger(__name__)


class Check(Callback):
    """Reject invalid settings of a single experiment before Hydra makes its folder (conf/experiment.yaml)."""

    def on_run_start(self, config: DictConfig, **kwargs: Any) -> None:
        """Exit with one message if the settings are invalid."""
        own = OmegaConf.masked_copy(config, [str(name) for name in config if name != "hydra"])
        try:
            _experiment(own)
        # Hydra only warns of other exceptions from a callback.
        except PlacecatError as error:
            sys.exit(f"placecat: {error}")
        except OmegaConfBaseException as error:
            sys.exit(f"placecat: {refusal(error)}")


def _experiment(config: DictConfig) -> "Experiment":
    # Imported late: this imports scikit-learn, which `--help` does not need.
    from placecat.experiment.combination import resolve

    return resolve(OmegaConf.to_container(config, resolve=True), settings.load())  # type: ignore[arg-type]


def job(config: DictConfig) -> float:
    """Compute one experiment, write result.json to Hydra's output folder, and return the accuracy.

    The accuracy is the mean over test homes in percent, or NaN if there is none. result.json contains the
    result of :func:`placecat.experiment.running.compute` and its origin. In a sweep, a failed job raises no
    exception, because that would abort the other experiments. Instead, result.json states the reason, and the
    sweep exits with status 1. The result of a single experiment is also printed and logged here.
    """
    # Imported late, as above.
    from placecat.experiment import running

    hydra = HydraConfig.get()
    folder = Path(hydra.runtime.output_dir)
    is_single = hydra.mode == RunMode.RUN
    if os.environ.get(WORKERS_OF) == str(os.getppid()):
        lifeline.end_with(os.getppid())
    start = time.perf_counter()
    # Written first, since a killed job cannot report anything.
    files.write_json(folder / output.RESULT, output.failure(output.KILLED))
    (folder / output.TRACEBACK).unlink(missing_ok=True)
    origin: dict[str, Any] = {}
    try:
        # In a sweep, experiments already run in parallel, so each uses one process unless there is a cluster.
        workers = parallel.workers() if is_single or compute.cluster() is not None else 1
        experiment = _experiment(config)
        origin = running.made_from(experiment)
        result = running.compute(experiment, workers=workers)
    except PlacecatError as error:
        result = output.failure(str(error))
    except Exception as error:
        _log.debug("", exc_info=True)
        files.write_text(folder / output.TRACEBACK, traceback.format_exc())
        result = output.failure(
            f"{type(error).__name__}: {error} (a bug in placecat: see {folder / output.TRACEBACK})"
        )
    # The time goes into a separate file, since result.json must not depend on when and where it was computed.
    files.write_json(folder / output.SECONDS, round(time.perf_counter() - start, 2))
    # Written last: if the sweep is killed later, this marks the job as finished.
    files.write_json(folder / output.RESULT, result | origin)
    if not is_single:
        _log.info("%s: %s", " ".join(hydra.overrides.task), output.shown(result))
    elif output.FAILED in result:
        sys.exit(f"placecat: {result[output.FAILED]}")
    else:
        from placecat.experiment import summary

        if not summary.tell_one(folder, result, log=bool(config.track)):
            sys.exit(1)
    return math.nan if result["accuracy"] is None else result["accuracy"]
