"""What ``--help`` and the shell tell about the options."""

from pathlib import Path

import pytest
from hydra import compose, initialize_config_dir
from made_experiments import CONF

from placecat.experiment import completion, options


def test_every_descriptor_has_a_name_of_its_own(project):
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


def test_help_names_every_option_and_fits_the_screen(project):
    text = options.help_text()
    for name in [*options.descriptors(), *options.classifiers(), *options.splits()]:
        assert name in text
    assert max(map(len, text.splitlines())) <= 110


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("placecat-experiment ", ["descriptor=", "classifier=", "test_home="]),
        ("placecat-experiment -m descriptor=", ["descriptor=hog", "descriptor=gist"]),
        ("placecat-experiment descriptor=hog,", ["descriptor=hog,sift"]),
        ("placecat-experiment classifier=", ["classifier=knn", "classifier=nu_svm"]),
        ("placecat-experiment data=", ["data=main", "data=university"]),
        ("placecat-experiment test_home=H1,", ["test_home=H1,H2", "test_home=H1,all"]),
        ("placecat-experiment data=site test_home=", ["test_home=robot"]),
        ("placecat-experiment judge=", ["judge=training_homes"]),
    ],
)
def test_bash_completes_what_an_experiment_is_made_of(project, monkeypatch, line, words):
    monkeypatch.setenv("COMP_LINE", line)
    monkeypatch.setenv("COMP_POINT", str(len(line)))
    found = completion.suggestions()
    assert set(words) <= set(found)
    assert all(word.startswith(line.split(" ")[-1]) for word in found)


def test_other_settings_are_left_to_hydra(project, monkeypatch):
    for word in ("classifier.base.", "-", "hydra/launcher="):
        monkeypatch.setenv("COMP_LINE", f"placecat-experiment {word}")
        monkeypatch.setenv("COMP_POINT", str(len(f"placecat-experiment {word}")))
        assert completion.suggestions() is None


def test_one_override_sends_a_sweep_to_a_cluster(project):
    pytest.importorskip("hydra_plugins.hydra_submitit_launcher")
    options.register()
    with initialize_config_dir(str(Path("conf").resolve()), version_base="1.3"):
        config = compose("experiment", overrides=["hydra/launcher=submitit_slurm"], return_hydra_config=True)
    launcher = config.hydra.launcher
    assert launcher._target_.endswith("SlurmLauncher")
    assert launcher.submitit_folder.startswith("multirun/")
    assert launcher.name == "experiment"
