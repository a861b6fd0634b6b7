"""What Hydra runs for each combination, in this process or in a worker."""

import logging
import math
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

_log = logging.getLogger(__name__)


def job(config: DictConfig) -> float:
    """Compute one experiment and write result.json to Hydra's output folder.

    Nothing is raised, so that a failure does not cost the other experiments of a sweep: it is in
    result.json, and the sweep ends with status 1.

    Returns
    -------
    float
        Accuracy in percent, the mean over test homes; NaN where there is none.
    """
    hydra = HydraConfig.get()
    folder = Path(hydra.runtime.output_dir)
    for name in (output.RESULT, output.TRACEBACK):
        (folder / name).unlink(missing_ok=True)
    start = time.perf_counter()
    try:
        # A sweep's experiments run beside each other, unless each can use a cluster.
        alone = hydra.mode == RunMode.RUN or compute.cluster() is not None
        workers = parallel.workers() if alone else 1
        result = run(OmegaConf.to_container(config, resolve=True), workers=workers)
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
    accuracy = result["accuracy"]
    _log.info("%s: %s", " ".join(hydra.overrides.task), output.shown(result))
    return math.nan if accuracy is None else accuracy


def run(config: Any, *, workers: int = 1) -> dict[str, Any]:
    """Compute one experiment.

    Parameters
    ----------
    config
        conf/experiment.yaml, composed, as plain containers.

    Returns
    -------
    dict
        See :func:`placecat.experiment.running.compute`.

    Raises
    ------
    PlacecatError
        A combination that cannot be.
    """
    # Here, since they import scikit-learn, which shell completion does without.
    from placecat.experiment.combination import resolve
    from placecat.experiment.running import compute

    return compute(resolve(config, settings.load()), workers=workers)
