"""What can be chosen: descriptors and data found by looking, and the text of ``--help``."""

import textwrap
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import yaml
from hydra.core.config_store import ConfigStore

from placecat import inferred, paths

CONFIG = "experiment"
MAIN = "main"
ALL = "all"
_WIDTH = 106
TEST_HOME = "test_home"
TRAINING_HOMES = "training_homes"
JUDGES = (TEST_HOME, TRAINING_HOMES)
# Kinds of descriptors, and where the help lists them.
_KINDS = {"local": 37, "holistic": 34}


def descriptors(conf: Path = paths.CONF) -> dict[str, dict[str, Any]]:
    """Descriptors by the name that an experiment chooses them by.

    Every file of conf/descriptor, what cues name without one, and what conf/optional adds. Where both kinds
    have a descriptor of one name, the name alone means that of salient regions, and ``holistic_NAME`` that of
    whole frames.

    Returns
    -------
    dict
        Name to the settings that a cue knows the descriptor by (see :mod:`placecat.store`).
    """
    further = (inferred.descriptors(conf), inferred.optional_descriptors(conf))
    local, holistic = (
        sorted(
            {path.stem for path in (conf / "descriptor" / kind).glob("*.yaml")}.union(
                *(one.get(kind, ()) for one in further)
            )
        )
        for kind in _KINDS
    )
    found: dict[str, dict[str, Any]] = {}
    for name in local:
        found[name] = {
            "kind": "local",
            "name": name,
            "y_pos": True,
            "y_weight": 1.0,
            "color": None,
            "max_regions": 25,
            "tracked": False,
        }
    for name in holistic:
        found[f"holistic_{name}" if name in found else name] = {"kind": "holistic", "name": name}
    return found


def classifiers(conf: Path = paths.CONF) -> dict[str, dict[str, Any]]:
    """Name and content of each file of conf/classifier."""
    files = sorted((conf / "classifier").glob("*.yaml"))
    return {path.stem: yaml.safe_load(path.read_text(encoding="utf-8")) for path in files}


def splits(conf: Path = paths.CONF) -> list[str]:
    """Names of the further data sets, the files of conf/split."""
    return sorted(path.stem for path in (conf / "split").glob("*.yaml"))


def register(conf: Path = paths.CONF) -> None:
    """Make descriptors and data known to Hydra, which finds the rest in conf/."""
    store = ConfigStore.instance()
    for name, own in descriptors(conf).items():
        store.store(group="descriptor", name=name, node=own)
    for name in (MAIN, *splits(conf)):
        store.store(group="data", name=name, node={"data": name}, package="_global_")


def _listed(names: Sequence[str], column: int) -> str:
    """Names separated by commas, in lines that begin at a column."""
    return textwrap.fill(", ".join(names), _WIDTH - column).replace("\n", "\n" + " " * column)


def help_text(conf: Path = paths.CONF) -> str:
    """The text of ``--help``. Hydra's own would list all of conf/, most of which is about tables."""
    found = descriptors(conf)
    local, holistic = (
        _listed([name for name, own in found.items() if own["kind"] == kind], indent)
        for kind, indent in _KINDS.items()
    )
    by_name = classifiers(conf)
    clustered, others = (
        _listed([name for name, own in by_name.items() if ("clusters" in own) is wanted], 17)
        for wanted in (True, False)
    )
    return f"""\
Train one cue on some homes and test it on another, from the descriptors that `make repro` left in data/.
What it computes is what a cell of the tables is; here is every combination.

Usage: placecat-experiment [-m] [KEY=VALUE ...]
       python -m placecat.experiment [-m] [KEY=VALUE ...]

With -m, a KEY may have several values separated by commas: every combination is run, on all cores, and a
table of them is printed at the end. Wrong combinations are refused before anything is computed.

Keys
  descriptor     of salient regions: {local}
                 of whole frames: {holistic}
                 Those of regions have y_pos, y_weight, color, max_regions and tracked, e.g.
                 descriptor.y_pos=false or descriptor.color=color_mv.
  classifier     on clusters, classifier.clusters of them:
                 {clustered}
                 others:
                 {others}
                 On regions those with a kernel need ++classifier.max_rows=N. Other settings have the names of
                 conf/classifier, e.g. classifier.base.alpha=0.1.
  data           {", ".join((MAIN, *splits(conf)))}; main is the data set of params.yaml, the others keep to
                 their split.
  test_home      a home of the data, however it is spelled (home1, Home_1), several as [home1,home2], or all
                 (the default): then the accuracy is the mean over them.
  judge          test_home: train on the other homes, test on the test home. training_homes: never read the
                 test home, leave out one training home after the other; this is for choosing settings.
  seeds, frames.offset, frames.step
                 of the clusters, and which frames train; by default those of params.yaml.
  codebook.cells, clustering@codebook.tree
                 parts of a whole frame that are clustered separately (by default 1 for knn, else 16), and
                 hierarchical_kmeans or flat_kmeans.
  track          true: log to MLflow, every run of a sweep below one parent.

Examples
  placecat-experiment descriptor=sift classifier=knn classifier.clusters=196 test_home=home1
  placecat-experiment -m descriptor=hog,sift classifier=knn,naive_bayes classifier.clusters=46,196,496 \\
    test_home=home1,home6
  placecat-experiment -m descriptor=gist classifier=nu_svm classifier.base.nu=0.05,0.2 judge=training_homes
  placecat-experiment -m descriptor=hog data=university,apartments descriptor.y_pos=true,false
  placecat-experiment -m descriptor=hog,sift hydra/launcher=submitit_slurm hydra.launcher.partition=NAME

Output
  outputs/DATE/TIME/ of one experiment, multirun/DATE/TIME/NUMBER/ of each of a sweep: result.json with
  settings, accuracies in percent by home and seed, and counts of decisions. A sweep's summary.csv is beside.

Hydra
  -m all combinations; --cfg job shows the settings and runs nothing; hydra.launcher.n_jobs=1 uses one core;
  eval "$(placecat-experiment -sc install=bash)" completes keys and values; --hydra-help says more.
"""
