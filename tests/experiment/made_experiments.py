"""A generated project, and conf/experiment.yaml composed as in the application."""

import copy
from pathlib import Path

from hydra import compose, initialize_config_dir
from hydra.core.global_hydra import GlobalHydra
from made_features import PARAMS, make
from omegaconf import OmegaConf

from placecat import paths, settings
from placecat.experiment import options, sweep
from placecat.experiment.combination import resolve

CONF = Path(__file__).resolve().parents[2] / "conf"
# The generated features need few regions and few clusters.
SMALL = ("descriptor.max_regions=4", "codebook.tree.branching=4", "classifier.clusters=13")


def make_project(folder, **options):
    """Make a project with generated features of four homes and the settings in git."""
    params = copy.deepcopy(PARAMS)
    params["dataset"]["title"] = "made homes"
    folder.mkdir(parents=True, exist_ok=True)
    make(folder, params=params, **options)
    (folder / "conf").symlink_to(CONF)
    return folder


def composed(*overrides):
    options.register()
    with initialize_config_dir(str(paths.CONF.resolve()), version_base="1.3"):
        return OmegaConf.to_container(compose("experiment", overrides=list(overrides)), resolve=True)


def resolved(*overrides, **changed):
    return resolve(composed(*overrides) | changed, settings.load())


def swept(*overrides):
    """Return the checked experiments and the combinations of a sweep."""
    options.register()
    with initialize_config_dir(str(paths.CONF.resolve()), version_base="1.3"):
        config = compose("experiment", return_hydra_config=True)
        lines, combinations = sweep.grid(overrides, GlobalHydra.instance().config_loader())
        return sweep.check(config, lines, combinations), combinations
