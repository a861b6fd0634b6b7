"""The Hydra application of conf/experiment.yaml: ``placecat experiment`` and ``placecat search``."""

import os
import sys
from collections.abc import Sequence
from pathlib import Path

import hydra

from placecat import compute, paths
from placecat.errors import PlacecatError
from placecat.experiment import options
from placecat.experiment.job import job


def main(arguments: Sequence[str]) -> None:
    """Run what the arguments ask for.

    Parameters
    ----------
    arguments
        Those of any Hydra application.

    Raises
    ------
    PlacecatError
        This is not the project's folder.
    SystemExit
        With a message or status 1: a setting is wrong, or an experiment failed.
    """
    for path in (paths.CONF / f"{options.CONFIG}.yaml", paths.PARAMS):
        if not path.is_file():
            raise PlacecatError(f"{path} is missing here ({Path.cwd()}): run this in the project's folder")
    options.register()
    # The launcher uses all the cores that joblib counts.
    workers = compute.wanted_workers()
    if workers is not None:
        os.environ.setdefault("LOKY_MAX_CPU_COUNT", str(workers))
    sys.argv = ["placecat experiment", *arguments]
    start = hydra.main(version_base="1.3", config_path=str(paths.CONF.resolve()), config_name=options.CONFIG)(
        job
    )
    with compute.as_set():
        start()


def search(arguments: Sequence[str]) -> None:
    """Search settings: the first argument may name a file of conf/search; the rest, as for `main`."""
    rest = list(arguments)
    if rest and "=" not in rest[0] and not rest[0].startswith("-"):
        rest[0] = f"+search={rest[0]}"
    main(["--multirun", "hydra/sweeper=optuna", *rest])
