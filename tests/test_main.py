import shutil
from pathlib import Path

import pytest
import yaml

from placecat.__main__ import main
from project import run

ROOT = Path(__file__).resolve().parents[1]


@pytest.fixture
def folder(tmp_path, monkeypatch):
    shutil.copytree(ROOT / "conf", tmp_path / "conf")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_params_writes_the_composed_settings(folder):
    main(["params", "smoothing.delay_step=0.5"])
    assert yaml.safe_load((folder / "params.yaml").read_text())["smoothing"]["delay_step"] == 0.5


def test_params_without_overrides_are_the_committed_ones(folder):
    main(["params"])
    assert (folder / "params.yaml").read_text() == (ROOT / "params.yaml").read_text()


def test_a_mistake_ends_with_one_message(folder):
    with pytest.raises(SystemExit) as caught:
        main(["params", "smoothing.delay_stepp=0.5"])
    assert str(caught.value).startswith("placecat: the settings cannot be composed: ")
    assert not (folder / "params.yaml").exists()


def test_outside_the_project_it_says_so(tmp_path):
    result = run(tmp_path, "placecat", "params", check=False)
    assert result.returncode == 1
    assert "run placecat in the project's folder" in result.stderr
    assert "Traceback" not in result.stderr


def test_a_missing_data_set_stops_the_first_stage(folder):
    main(["params", "dataset=my_homes", "dataset.root=nowhere"])
    result = run(folder, "python", "-m", "placecat.stages.sequences", check=False)
    assert result.returncode == 1
    assert "dataset.root is nowhere, but there is no such folder" in result.stderr
    assert "Traceback" not in result.stderr
