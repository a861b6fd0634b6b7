"""A copy of the project in a separate folder, for tests that really run DVC."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import yaml

from placecat.config.compose import compose
from sketch import draw_homes

ROOT = Path(__file__).resolve().parents[1]

# With four drawn homes, small frames and small codebooks, every stage runs quickly.
HOMES = "data/drawn"
DRAWN = {"frames_per_room": 6, "width": 320, "height": 180}
SITES = {"university": "data/drawn_university", "apartments": "data/drawn_apartments"}
PLACES = "[bedroom,bathroom,kitchen,living_room,dining_room]"
REGION_CUES = ("orientation_mv_y", "hog_y", "sift_y", "centrist_y", "color_mv_y")
TRACKED_CUES = ("hog_tracked", "sift_tracked", "centrist_tracked")
_PARTS = "[{sequence: Home1, places: null}, {sequence: Home2, places: null}]"
SMALL = [
    "dataset=my_homes",
    f"dataset.root={HOMES}",
    "dataset.homes=[Home1,Home2,Home3,Home4]",
    "dataset.fps=5.0",
    *(f"codebooks.{name}.tree.max_clusters=46" for name in (*REGION_CUES, *TRACKED_CUES)),
    *(f"codebooks.{name}.tree.max_clusters=16" for name in ("gist_cells", "centrist_cells")),
    *(f"cues.{name}.classifier.clusters=46" for name in (*REGION_CUES, *TRACKED_CUES)),
    *(f"cues.{name}.classifier.clusters=16" for name in ("gist_naive_bayes", "centrist_naive_bayes")),
    "cues.spatial_pact.classifier.reduction.components=8",
    *(
        f"splits.{split}.{setting}"
        for split, root in SITES.items()
        for setting in (
            "dataset.layout=vpc2009",
            f"dataset.root={root}",
            "dataset.fps=5.0",
            "dataset.camera=drawn",
            "dataset.ignored=[transition,corridor]",
            "dataset.homes=[Home1,Home2,Home3]",
            f"dataset.classes={PLACES}",
            f"cue_parts={_PARTS}",
            f"integration_parts={_PARTS}",
            "test=[Home3]",
        )
    ),
    # Only two of the four homes are tested; the others have a reason instead of a number.
    "protocol.test_homes=[Home1,Home3]",
    "protocol.extra.sequences=[Home1]",
    # The sheets of patches are small.
    "figures.clusters.patches=4",
    "toy.training=200",
    "toy.testing=500",
    "toy.seeds=[0,1]",
    "toy.sensitivity.seeds=[0]",
    "verdict.resamples=200",
    "verdict.minimum_units=2",
]


def light_conf(folder):
    """Copy conf/."""
    shutil.copytree(ROOT / "conf", folder)
    return folder


def _lighten(*folders):
    """Reduce training rounds, iterations and clusters in copies of definitions, so that trials are short."""
    for path in (path for folder in folders for path in folder.rglob("*.yaml")):
        text = re.sub(r"n_rounds: \d+", "n_rounds: 4", path.read_text())
        if path.name == "rvm.yaml":
            text = text.replace("max_iter: 200", "max_iter: 3")
        if path.name == "discriminative_regions.yaml":
            text = text.replace("clusters: 196", "clusters: 46")
        path.write_text(text)


def rendered():
    """List the folders of the videos from the stage `render`, relative to the project."""
    render = yaml.safe_load((ROOT / "dvc.yaml").read_text())["stages"]["render"]
    outs = [next(iter(out)) for out in render["outs"]]
    return [out for out in outs if not out.endswith(".jpg")]


def environment(**extra):
    """Return the environment of this test, with its own Python first on the path."""
    here = str(Path(sys.executable).parent)
    own = {"PATH": os.pathsep.join([here, os.environ["PATH"]]), "MLFLOW_DISABLE_TELEMETRY": "true"}
    # Otherwise, `dvc init` would start a process that reports its use.
    own["DVC_NO_ANALYTICS"] = "true"
    clean = {name: value for name, value in os.environ.items() if not name.startswith("GIT_")}
    return clean | own | extra


def run(folder, *command, check=True, **extra):
    """Run a command in the copy; the result contains its output."""
    result = subprocess.run(
        command, cwd=folder, env=environment(**extra), capture_output=True, text=True, check=False
    )
    if check and result.returncode != 0:
        raise AssertionError(f"{command} failed\n{result.stdout[-4000:]}\n{result.stderr[-4000:]}")
    return result


def init(folder):
    """Initialise git and DVC in a folder."""
    run(folder, "git", "init", "-q")
    run(folder, "dvc", "init", "-q")
    shutil.copy(ROOT / ".dvc/config", folder / ".dvc/config")


def commit(folder):
    """Commit everything."""
    run(folder, "git", "add", ".")
    run(
        folder,
        "git",
        "-c",
        "user.name=test",
        "-c",
        "user.email=test@example.org",
        "commit",
        "-qm",
        "measured",
    )


def copy_project(folder, overrides=SMALL):
    """Copy the pipeline from git, draw small homes, compose small settings, and initialise DVC.

    The videos are not copied; empty folders stand for the output of the frozen stage `render`.
    """
    for name in ("conf", "src"):
        shutil.copytree(
            ROOT / name, folder / name, ignore=shutil.ignore_patterns("__pycache__", "*.egg-info")
        )
    shutil.copytree(ROOT / "data/thesis", folder / "data/thesis")
    _lighten(folder / "conf", folder / "data/thesis/tables")
    for out in rendered():
        (folder / out).mkdir()
    shutil.copy(ROOT / "data/contact_sheet.jpg", folder / "data")
    draw_homes(folder / HOMES, homes=4, **DRAWN)
    university, apartments = (folder / root for root in SITES.values())
    draw_homes(university, homes=3, **DRAWN)
    shutil.copytree(university, apartments)
    shutil.copytree(ROOT / "reports/optional_tables", folder / "reports/optional_tables")
    (folder / "reports/replication").mkdir()
    kept = ("benchmarks.csv", "benchmarks.json", "scale.csv", "scale.json", "scale_growth.csv")
    for name in (*kept, "times.csv", "times.json", "replication/facts.json", "replication/findings.csv"):
        shutil.copy(ROOT / "reports" / name, folder / "reports" / name)
    for name in ("dvc.yaml", ".dvcignore", ".gitignore"):
        shutil.copy(ROOT / name, folder / name)
    (folder / "params.yaml").write_text(compose(overrides, conf=folder / "conf"))
    init(folder)
    return folder


def repro(folder, *arguments, check=True, **extra):
    """Run `dvc repro`; return the names of the stages that ran, and the result."""
    result = run(folder, "dvc", "repro", *arguments, check=check, **extra)
    lines = result.stdout.splitlines()
    ran = [line.split("'")[1] for line in lines if line.startswith("Running stage '")]
    return ran, result


def contents(folder, *parts):
    """Return the bytes of every file below the given paths."""
    found = {}
    for part in parts:
        root = folder / part
        for path in [root] if root.is_file() else sorted(root.rglob("*")):
            if path.is_file() and path.name != ".gitignore":
                found[path.relative_to(folder).as_posix()] = path.read_bytes()
    return found
