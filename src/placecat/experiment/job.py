"""The Hydra job of one combination, in this process or in a worker."""

import logging
import math
import os
import sys
import time
import traceback
from pathlib import Path
from typing import Any

from hydra.core.hydra_config import HydraConfig
from hydra.types import RunMode
from omegaconf import DictConfig, OmegaConf

from placecat import compute, files, parallel, settings
from placecat.errors import PlacecatError
from placecat.experiment import output
from placecat.runs import lifeline

# Environment variable that tells workers the process of the sweep.
WORKERS_OF = "PLACECAT_SWEEP"
_log = logging.getLogger(__name__)


def job(config: DictConfig) -> float:
    """Compute one experiment, write result.json to Hydra's output folder, and return the accuracy.

    The accuracy is the mean over test homes in percent, NaN if there is no number. result.json has the result
    of :func:`placecat.experiment.running.compute` and its origin. In a sweep nothing is raised, so a failure
    does not end the other experiments: result.json has the reason, and the sweep ends with status 1. A single
    experiment is printed and logged here.
    """
    # Late, since these import scikit-learn, which `--help` does not need.
    from placecat.experiment import running
    from placecat.experiment.combination import resolve
    from placecat.experiment.made_from import made_from

    hydra = HydraConfig.get()
    folder = Path(hydra.runtime.output_dir)
    is_single = hydra.mode == RunMode.RUN
    if os.environ.get(WORKERS_OF) == str(os.getppid()):
        lifeline.end_with(os.getppid())
    start = time.perf_counter()
    # Written first, since a killed job cannot report that it was killed.
    files.write_json(folder / output.RESULT, output.failure(output.KILLED))
    (folder / output.TRACEBACK).unlink(missing_ok=True)
    origin: dict[str, Any] = {}
    try:
        # The experiments of a sweep run in parallel, unless each can use a cluster.
        workers = parallel.workers() if is_single or compute.cluster() is not None else 1
        experiment = resolve(OmegaConf.to_container(config, resolve=True), settings.load())  # type: ignore[arg-type]
        origin = made_from(experiment)
        result = running.compute(experiment, workers=workers)
    except PlacecatError as error:
        result = output.failure(str(error))
    except Exception as error:
        _log.debug("", exc_info=True)
        files.write_text(folder / output.TRACEBACK, traceback.format_exc())
        result = output.failure(
            f"{type(error).__name__}: {error} (an error of placecat: see {folder / output.TRACEBACK})"
        )
    # In another file, since result.json must not depend on time and place.
    files.write_json(folder / output.SECONDS, round(time.perf_counter() - start, 2))
    # Written last: after a killed sweep, it marks the job as finished.
    files.write_json(folder / output.RESULT, result | origin)
    if not is_single:
        _log.info("%s: %s", " ".join(hydra.overrides.task), output.shown(result))
    elif output.FAILED in result:
        sys.exit(f"placecat: {result[output.FAILED]}")
    else:
        from placecat.experiment import sweep

        if not sweep.tell_one(folder, result, log=bool(config.track)):
            sys.exit(1)
    return math.nan if result["accuracy"] is None else result["accuracy"]
