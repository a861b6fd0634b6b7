"""Read facts about a run from dvc.lock and git."""

import re
import subprocess
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from placecat import paths, settings
from placecat.errors import PlacecatError

LOCK, DEFINITION = Path("dvc.lock"), Path("dvc.yaml")


def defined_stages() -> dict[str, Any]:
    """Return the stages in dvc.yaml by name; the result is empty in a folder without a pipeline."""
    return dict(settings.read_yaml(DEFINITION)["stages"]) if DEFINITION.is_file() else {}


def data_version(stage: str = "sequences") -> str:
    """Return DVC's checksum of the frame list, which contains the checksums of the source files.

    `stage` is ``sequences``, or ``site_sequences`` for the additional data sets. Raises PlacecatError if DVC
    has not run the stage.
    """
    try:
        return str(settings.read_yaml(LOCK)["stages"][stage]["outs"][0]["md5"])
    except (PlacecatError, KeyError, TypeError):
        raise PlacecatError(f"{LOCK} has no stage {stage}: run `dvc repro` to add it") from None


def check_data(params: Mapping[str, Any]) -> None:
    """Raise PlacecatError if DVC recorded features of a ``dataset`` other than the one in `params`."""
    version = data_version()
    stages = settings.read_yaml(LOCK)["stages"]
    listed = stages["sequences"].get("params", {}).get("params.yaml", {}).get("dataset")
    described = {dep["path"]: dep.get("md5") for dep in stages.get("features", {}).get("deps", [])}
    if listed != params["dataset"] or described.get(paths.SEQUENCES.as_posix()) != version:
        raise PlacecatError(
            "the features come from a different data set than the one in params.yaml: first run "
            "`placecat repro` with this data set, or `dvc repro features tracks`"
        )


def git_commit() -> str:
    """Return the hash of the checked-out commit; "" outside a git repository."""
    try:
        result = subprocess.run(["git", "rev-parse", "HEAD"], capture_output=True, text=True, check=False)
    except OSError:
        return ""
    commit = result.stdout.strip()
    return commit if re.fullmatch(r"[0-9a-f]{40,64}", commit) else ""
