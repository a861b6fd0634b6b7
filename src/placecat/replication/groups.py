"""Groups of homes. The protocol of the thesis runs on each group in a separate folder."""

import hashlib
import json
import os
import subprocess
from collections.abc import Mapping, Sequence
from contextlib import chdir
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import yaml

from placecat import files, paths, settings
from placecat.compute import lifeline
from placecat.errors import PlacecatError
from placecat.replication import group_results
from placecat.runs import items, linked_folder, lock, unchanged

# The stages from the homes to the tables, in order, and the other project files that they need.
STAGES = (
    *("sequences", "features", "tracks", "codebooks", "cues", "integration"),
    *("filtering", "smoothing", "trials", "scores", "tables"),
)
LINKED = (
    *(Path("dvc.yaml"), Path("src"), paths.CONF, paths.PUBLISHED.parent, paths.SITE_SEQUENCES),
    *(paths.SITE_FEATURES, paths.SPLITS, paths.TOY, paths.BENCHMARKS, paths.SCALE_STAGES),
)
_DONE = "done.json"


@dataclass(frozen=True)
class Group:
    """A group of homes, with its number (counting from 1), its homes, and all settings for a run on them."""

    number: int
    homes: tuple[str, ...]
    params: Mapping[str, Any]

    @property
    def folder(self) -> Path:
        """The working folder of the group, which is not in git."""
        return paths.REPLICATION_DATA / f"group_{self.number}"


def split(params: Mapping[str, Any], size: int) -> tuple[list[Group], tuple[str, ...]]:
    """Split the homes of a data set into groups of `size`, in the order of ``dataset.homes``.

    Returns the groups, and the homes left over, which are too few for another group. Raises PlacecatError if
    there are fewer than two groups.
    """
    homes = [str(home) for home in settings.get(params, "dataset.homes")]
    count = len(homes) // size
    if count < 2:
        raise PlacecatError(
            f"the data set has {len(homes)} homes, but a replication needs two groups of {size}: choose "
            "another data set (dataset=... dataset.homes=...)"
        )
    parts = [tuple(homes[first : first + size]) for first in range(0, count * size, size)]
    groups = [Group(n, part, _restricted(params, part, homes)) for n, part in enumerate(parts, start=1)]
    return groups, tuple(homes[count * size :])


def _restricted(params: Mapping[str, Any], of_group: Sequence[str], homes: Sequence[str]) -> dict[str, Any]:
    """Restrict the settings to the homes of a group, including settings with one value per home."""
    dataset = dict(params["dataset"])
    for name, value in dataset.items():
        if isinstance(value, Mapping) and value and set(value) <= set(homes):
            dataset[name] = {home: one for home, one in value.items() if home in of_group}
    # Make the path absolute, since stages run in another folder.
    root = str(Path(dataset["root"]).resolve())
    return {**params, "dataset": {**dataset, "homes": list(of_group), "root": root}}


def run(group: Group) -> bool:
    """Run the stages of a group and write its results to reports/replication, unless nothing has changed.

    A killed run resumes where it stopped. Returns whether anything ran. Raises PlacecatError if a stage
    fails, `make repro` has not run, or another process runs this group.
    """
    folder = group.folder
    with lock.of_folder(folder, "runs in"):
        linked_folder.link(folder, LINKED)
        text = yaml.safe_dump(dict(group.params), sort_keys=False, allow_unicode=True)
        if not (folder / paths.PARAMS).exists() or (folder / paths.PARAMS).read_text("utf-8") != text:
            files.write_text(folder / paths.PARAMS, text)
        target = group_results.folder_of(group.number)
        if _is_done(folder, target):
            return False
        for stage, command in linked_folder.commands(STAGES).items():
            print(f"Group {group.number}, stage {stage}", flush=True)
            _run_stage(folder, stage, command)
        group_results.write(target, folder, group.homes, group.params)
        files.write_json(folder / _DONE, {"inputs": _inputs(folder), "results": items.checksum(target)})
    return True


def _run_stage(folder: Path, stage: str, command: Sequence[str]) -> None:
    # These variables make the stage stop if this process is killed.
    environment = os.environ | {"DVC_STAGE": stage, lifeline.DVC: str(os.getpid())}
    status = subprocess.run(command, cwd=folder, env=environment, check=False).returncode
    if status != 0:
        raise PlacecatError(
            f"the stage {stage} failed in {folder}: fix the error above, then run this again to continue"
        )


def _is_done(folder: Path, target: Path) -> bool:
    try:
        done = files.read_json(folder / _DONE)
    except (FileNotFoundError, ValueError):
        return False
    expected = {"inputs": _inputs(folder), "results": items.checksum(target) if target.is_dir() else ""}
    return bool(done == expected)


def _inputs(folder: Path) -> str:
    """Return a checksum of the settings, code and data of all stages; see `placecat.runs.unchanged.state`."""
    with chdir(folder):
        state = {path: of_path for stage in STAGES for path, of_path in unchanged.state(stage).items()}
    return hashlib.sha256(json.dumps(state, sort_keys=True).encode()).hexdigest()
