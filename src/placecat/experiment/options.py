"""The options of an experiment: the descriptors, classifiers and data sets in conf/."""

from pathlib import Path
from typing import Any

import yaml
from hydra.core.config_store import ConfigStore

from placecat import paths, settings
from placecat.config import inferred

CONFIG = "experiment"
MAIN = "main"
ALL = "all"
TEST_HOME = "test_home"


def descriptors(conf: Path = paths.CONF) -> dict[str, dict[str, Any]]:
    """Map the name of each descriptor option to its settings, as in a cue (:mod:`placecat.training.store`).

    Descriptors come from conf/descriptor, from cues whose descriptor has no file there, and from
    conf/optional. If two descriptors share a name, ``NAME`` describes salient regions and ``holistic_NAME``
    describes whole frames.
    """
    further = (inferred.descriptors(conf), inferred.optional_descriptors(conf))

    def names(kind: str) -> list[str]:
        files = {path.stem for path in (conf / "descriptor" / kind).glob("*.yaml")}
        return sorted(files.union(*(one.get(kind, ()) for one in further)))

    of_regions = {"y_pos": True, "y_weight": 1.0, "color": None, "max_regions": 25, "tracked": False}
    found: dict[str, dict[str, Any]] = {
        name: {"kind": "local", "name": name, **of_regions} for name in names("local")
    }
    for name in names("holistic"):
        found[f"holistic_{name}" if name in found else name] = {"kind": "holistic", "name": name}
    return found


def classifiers() -> dict[str, dict[str, Any]]:
    """Map the name of each file in conf/classifier to its contents."""
    files = sorted((paths.CONF / "classifier").glob("*.yaml"))
    return {path.stem: yaml.load(path.read_text(encoding="utf-8"), Loader=settings.Loader) for path in files}


def register(conf: Path = paths.CONF) -> None:
    """Register descriptors and data with Hydra, which reads the other options from conf/."""
    store = ConfigStore.instance()
    for name, own in descriptors(conf).items():
        store.store(group="descriptor", name=name, node=own)
    for name in (MAIN, *sorted(path.stem for path in (conf / "split").glob("*.yaml"))):
        store.store(group="data", name=name, node={"data": name}, package="_global_")
