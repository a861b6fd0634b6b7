"""The Hydra application behind ``placecat experiment`` and ``placecat search`` (conf/experiment.yaml)."""

import hashlib
import os
import re
import sys
from collections.abc import Sequence
from pathlib import Path

import hydra
from hydra.errors import HydraException
from omegaconf.errors import OmegaConfBaseException

from placecat import compute, paths
from placecat.config import overrides
from placecat.config.compose import refusal
from placecat.errors import PlacecatError
from placecat.experiment import options
from placecat.experiment.job import job

# Maximum number of characters that keys take up in a folder name.
_LONGEST = 80


def main(arguments: Sequence[str]) -> None:
    """Run the experiments described by the Hydra arguments.

    Raises PlacecatError outside a project folder, or if Hydra cannot compose the settings. Raises SystemExit,
    with a message or status 1, if another setting is invalid or an experiment fails.
    """
    for path in (paths.CONF / f"{options.CONFIG}.yaml", paths.PARAMS):
        if not path.is_file():
            raise PlacecatError(f"{path} is missing here ({Path.cwd()}): run this in the project folder")
    from hydra._internal.utils import get_args

    arguments = list(arguments)
    given = get_args(arguments)
    overrides.check(given.overrides, several=True)
    if given.help:
        # Hydra prints no help for sweeps.
        arguments = ["--help"]
    elif given.multirun:
        if given.cfg or given.info:
            raise PlacecatError("--cfg and --info show one experiment: use `placecat experiment` without -m")
        if not any(one.startswith("hydra.sweep.dir=") for one in given.overrides):
            arguments.append(f"hydra.sweep.dir={folder_of(given.overrides)}")
    options.register()
    # Hydra's launcher starts one process per core, as counted by joblib.
    workers = compute.wanted_workers()
    if workers is not None:
        os.environ.setdefault("LOKY_MAX_CPU_COUNT", str(workers))
    sys.argv = ["placecat experiment", *arguments]
    start = hydra.main(version_base="1.3", config_path=str(paths.CONF.resolve()), config_name=options.CONFIG)(
        job
    )
    # Otherwise, Hydra prints its errors itself, with its search path.
    os.environ.setdefault("HYDRA_FULL_ERROR", "1")
    try:
        with compute.as_set():
            start()
    except (HydraException, OmegaConfBaseException) as error:
        raise refusal(error) from None


def folder_of(given: Sequence[str]) -> str:
    """Name a sweep folder after its overrides other than Hydra's, so that the same command finds it again."""
    own = [one for one in given if not one.startswith(("hydra.", "hydra/launcher"))]
    keys = "-".join(re.sub(r"[^\w.]", "", one.partition("=")[0]) for one in own)
    return f"multirun/{keys[:_LONGEST]}-{hashlib.sha256(repr(own).encode()).hexdigest()[:8]}"


def search(arguments: Sequence[str]) -> None:
    """Search for settings. The first argument may name a file in conf/search; the rest are overrides."""
    rest = list(arguments)
    if rest and "=" not in rest[0] and not rest[0].startswith("-"):
        rest[0] = f"+search={rest[0]}"
    main(["--multirun", "hydra/sweeper=optuna", *rest])
