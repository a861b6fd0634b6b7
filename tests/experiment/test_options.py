"""The options of an experiment."""

from pathlib import Path

import pytest
from hydra import compose, initialize_config_dir
from made_experiments import CONF

from placecat.experiment import options


def test_descriptor_names_are_unique(project):
    found = options.descriptors()
    files = sorted((CONF / "descriptor").glob("*/*.yaml"))
    assert {(own["kind"], own["name"]) for own in found.values()} == {
        *((path.parent.name, path.stem) for path in files),
        ("holistic", "embedding"),
    }
    assert found["centrist"]["kind"] == "local"
    assert found["holistic_centrist"] == {"kind": "holistic", "name": "centrist"}


def test_a_descriptor_without_a_file_can_be_chosen(tmp_path):
    (tmp_path / "cue").mkdir()
    (tmp_path / "optional").mkdir()
    (tmp_path / "cue/new.yaml").write_text("descriptor: {kind: holistic, name: gist}\n")
    (tmp_path / "optional/more.yaml").write_text("descriptors: {local: {hog: {}}}\n")
    assert {name: own["kind"] for name, own in options.descriptors(tmp_path).items()} == {
        "hog": "local",
        "gist": "holistic",
    }


def test_one_override_sends_a_sweep_to_a_cluster(project):
    pytest.importorskip("hydra_plugins.hydra_submitit_launcher")
    options.register()
    with initialize_config_dir(str(Path("conf").resolve()), version_base="1.3"):
        config = compose("experiment", overrides=["hydra/launcher=submitit_slurm"], return_hydra_config=True)
    launcher = config.hydra.launcher
    assert launcher._target_.endswith("SlurmLauncher")
    assert launcher.submitit_folder.startswith("multirun/")
    assert launcher.name == "experiment"
