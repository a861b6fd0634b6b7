"""A made project, and conf/experiment.yaml composed as the application does."""

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
# For the made features: few regions, few clusters.
SMALL = ("descriptor.max_regions=4", "codebook.tree.branching=4", "classifier.clusters=13")


def make_project(folder, **options):
    """A project with made features of four homes, and the settings in git."""
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
    """The experiments and combinations of a sweep, checked."""
    options.register()
    with initialize_config_dir(str(paths.CONF.resolve()), version_base="1.3"):
        config = compose("experiment", return_hydra_config=True)
        lines, combinations = sweep.grid(overrides, GlobalHydra.instance().config_loader())
        return sweep.check(config, lines, combinations), combinations
