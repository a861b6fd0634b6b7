"""What Hydra runs for each combination, in this process or in a worker."""

import logging
import math
import sys
import time
import traceback
from pathlib import Path

from hydra.core.hydra_config import HydraConfig
from hydra.types import RunMode
from omegaconf import DictConfig, OmegaConf

from placecat import compute, files, parallel, settings
from placecat.errors import PlacecatError
from placecat.experiment import output

_log = logging.getLogger(__name__)


def job(config: DictConfig) -> float:
    """Compute one experiment and write result.json to Hydra's output folder.

    In a sweep nothing is raised, so that a failure does not cost the other experiments: it is in result.json,
    and the sweep ends with status 1. A single experiment is told and logged here.

    Returns
    -------
    float
        Accuracy in percent, the mean over test homes; NaN where there is none.
    """
    # Here, since they import scikit-learn, which `--help` does without.
    from placecat.experiment import running
    from placecat.experiment.combination import resolve

    hydra = HydraConfig.get()
    folder = Path(hydra.runtime.output_dir)
    for name in (output.RESULT, output.TRACEBACK):
        (folder / name).unlink(missing_ok=True)
    is_single = hydra.mode == RunMode.RUN
    start = time.perf_counter()
    try:
        # A sweep's experiments run beside each other, unless each can use a cluster.
        workers = parallel.workers() if is_single or compute.cluster() is not None else 1
        experiment = resolve(OmegaConf.to_container(config, resolve=True), settings.load())  # type: ignore[arg-type]
        result = running.compute(experiment, workers=workers)
    except PlacecatError as error:
        result = output.failure(str(error))
    except Exception as error:
        _log.debug("", exc_info=True)
        files.write_text(folder / output.TRACEBACK, traceback.format_exc())
        result = output.failure(
            f"{type(error).__name__}: {error} (an error of placecat: see {folder / output.TRACEBACK})"
        )
    files.write_json(folder / output.RESULT, result)
    # By itself, since the result is the same whenever and wherever it is computed.
    files.write_json(folder / output.SECONDS, round(time.perf_counter() - start, 2))
    if not is_single:
        _log.info("%s: %s", " ".join(hydra.overrides.task), output.shown(result))
    elif output.FAILED in result:
        sys.exit(f"placecat: {result[output.FAILED]}")
    else:
        from placecat.experiment import sweep

        if not sweep.tell_one(folder, result, log=bool(config.track)):
            sys.exit(1)
    return math.nan if result["accuracy"] is None else result["accuracy"]
