"""The complete command at a tiny size, with made-up features and one cheap real stage."""

import copy
import importlib
import json
import shutil
import sys
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
import yaml
from made_features import HOMES, PARAMS, make

from placecat.config import compose
from placecat.errors import PlacecatError
from placecat_bench.scale import command, full_run, measurements
from placecat_bench.scale.watching import Watched
from project import ROOT

SCALE = {
    "sizes": [1.0, 0.5],
    "test_homes": ["a"],
    "stages": ["codebooks"],
    "regions": 6,
    "jitter": 0.1,
    "most_gib": 16.0,
    "homes": {
        name: {
            "floors": 2,
            "labels": {"bedroom": [60, 2], "kitchen": [40, 1], "bathroom": [50, 2], "x": [30, 4]},
        }
        for name in "abcd"
    },
}


def run_here(words, folder, log):
    """Like `watch`, but without the import time of a new process."""
    python, option, module = words
    assert (python, option) == (sys.executable, "-m")
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        importlib.import_module(module).main()
    return Watched(20.0, 3.0, 1.5) if folder.name == "360" else Watched(40.0, 6.0, 2.5)


def make_variant(features):
    """Make a variant with the regions of every third frame and other descriptors."""
    folder = features / "variant_other"
    folder.mkdir()
    shutil.copy(features / "descriptors.json", folder)
    rows = np.arange(0, len(np.load(features / "count.npy")), 3)
    np.save(folder / "frames.npy", rows)
    for name in ("count", "regions", "local_hog"):
        np.save(folder / f"{name}.npy", np.load(features / f"{name}.npy")[rows])


@pytest.fixture(scope="module")
def ran(tmp_path_factory):
    folder = tmp_path_factory.mktemp("project")
    params = copy.deepcopy(PARAMS)
    params["dataset"]["ignored"] = ["x"]
    params["codebooks"] = {"gist_cells": params["codebooks"]["gist_cells"]}
    make(folder, params=params)
    shutil.copytree(folder / "data/features", folder / "data/tracks")
    for home in HOMES:
        make_variant(folder / "data/features" / home)
    shutil.copy(ROOT / "dvc.yaml", folder)
    for path in (
        "data/site_sequences",
        "data/site_features",
        "data/splits",
        "data/thesis",
        "reports",
        "conf",
    ):
        (folder / path).mkdir(exist_ok=True)
    (folder / "data/toy.csv").touch()
    (folder / "reports/times.csv").write_text("stage,runs,seconds\nfeatures,4,36.0\nfigures,1,5.0\n")
    (folder / "conf/scale.yaml").write_text(yaml.safe_dump(SCALE))
    # Composing the settings of this project would take most of the time.
    made = copy.deepcopy(params)
    made["dataset"]["homes"], made["protocol"]["test_homes"] = list("abcd"), ["a"]
    asked = []
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        patch.setenv("PLACECAT_WORKERS", "1")
        patch.setattr(compose, "compose", lambda overrides: asked.append(overrides) or yaml.safe_dump(made))
        patch.setattr(measurements, "watch", run_here)
        command.run(keep=True)
    return folder, asked


def test_project_settings_are_composed_with_other_homes(ran):
    _, asked = ran
    assert "dataset.homes=[a,b,c,d]" in asked[0] and "protocol.test_homes=[a]" in asked[0]
    assert "dataset.thesis_data=null" in asked[0]


def test_homes_have_the_requested_size_and_walk(ran):
    folder, _ = ran
    made = folder / "data/scale/720/data"
    labels = pd.read_csv(made / "sequences/a/labels.csv")
    frames = pd.read_csv(made / "sequences/a/frames.csv")
    assert labels["label"].value_counts().to_dict() == {"bedroom": 60, "bathroom": 50, "kitchen": 40, "x": 30}
    assert (
        labels["class"] == labels["label"].map({"bedroom": 0, "kitchen": 1, "bathroom": 2, "x": -1})
    ).all()
    assert frames["sequence"].is_monotonic_increasing and set(frames["sequence"]) == {1, 2}
    for kind in ("features", "tracks"):
        assert (np.load(made / kind / "a/count.npy") == SCALE["regions"]).all()
        hog = np.load(made / kind / "a/local_hog.npy")
        assert hog.shape == (180, 6, 6) and hog.dtype == np.float32
        assert len(np.unique(hog, axis=0)) == 180
    # The made-up descriptors reveal the place. Drawn descriptors come from the same place in the source home.
    source = np.load(folder / f"data/features/{HOMES[1]}/holistic_gist.npy")
    own = pd.read_csv(folder / f"data/sequences/{HOMES[1]}/labels.csv")["class"].to_numpy()
    drawn = np.load(made / "features/b/holistic_gist.npy")
    where = pd.read_csv(made / "sequences/b/labels.csv")["class"].to_numpy()
    for place in (0, 1, 2):
        nearest = ((drawn[where == place, None] - source[None]) ** 2).sum(axis=2).argmin(axis=1)
        assert (own[nearest] == place).mean() > 0.95


def test_a_variant_of_the_regions_is_drawn_only_for_its_own_frames(ran):
    folder, _ = ran
    drawn = folder / "data/scale/720/data/features/a/variant_other"
    assert np.load(drawn / "frames.npy").tolist() == list(range(0, 180, 3))
    most = np.load(folder / f"data/features/{HOMES[0]}/regions.npy").shape[1]
    assert np.load(drawn / "local_hog.npy").shape == (60, most, 6)
    assert (np.load(drawn / "count.npy") == most).all()
    assert (drawn / "descriptors.json").is_file()


def test_the_stage_ran_only_for_the_test_home(ran):
    folder, _ = ran
    made = {path.name for path in (folder / "data/scale/720/data/codebooks/gist_cells").glob("*.npz")}
    assert made == {f"without-{rest}.seed-{seed}.npz" for rest in ("a", "a-b") for seed in (0, 1)}


def test_times_and_growth_are_written(ran):
    folder, _ = ran
    measured = pd.read_csv(folder / "reports/scale.csv", keep_default_na=False)
    assert measured.to_numpy().tolist() == [
        [0.5, 360, "codebooks", "", 20.0, 3.0, 1.5],
        [1.0, 720, "codebooks", "", 40.0, 6.0, 2.5],
    ]
    grown = pd.read_csv(folder / "reports/scale_growth.csv", keep_default_na=False)
    assert grown.to_numpy().tolist() == [
        ["codebooks", "", 1.0, 1.0, 1.0, 40.0, 2.5],
        ["all", "", 1.0, 1.0, 1.0, 40.0, 2.5],
    ]
    facts = json.loads((folder / "reports/scale.json").read_text())
    assert facts["largest"]["frames"] == 720 and facts["largest"]["met"] is True
    # Four homes instead of one, and 720 frames instead of 360. Stages that do not depend on homes are
    # unchanged.
    assert facts["full_run"]["seconds"] == {"codebooks": 160.0, "features": 72.0, "figures": 5.0}


def test_trials_are_repeated_for_the_homes_that_tables_need(ran, monkeypatch):
    monkeypatch.chdir(ran[0])
    params = copy.deepcopy(PARAMS)
    params["protocol"]["test_homes"] = ["H1"]
    # Three trials test homes 1 and 3, and one tests all four.
    assert full_run.times_as_often("trials", params) == (3 * 2 + 4) / (3 + 1)
    assert full_run.times_as_often("scores", params) == 1.0


def test_a_size_can_be_added_later(ran, tmp_path, monkeypatch):
    folder, _ = ran
    shutil.copy(folder / "reports/scale.csv", tmp_path)
    monkeypatch.chdir(folder)
    params = yaml.safe_load((folder / "data/scale/360/params.yaml").read_text())
    monkeypatch.setattr(command.project, "build", lambda *args, **options: params)
    monkeypatch.setattr(measurements, "watch", lambda *args: Watched(10.0, 1.5, 0.5))
    monkeypatch.setattr(command.shutil, "rmtree", lambda place: None)
    command.run(sizes=[0.25], add=True, output=tmp_path)
    measured = pd.read_csv(tmp_path / "scale.csv")
    assert measured[["size", "frames"]].to_numpy().tolist() == [[0.25, 180], [0.5, 360], [1.0, 720]]
    assert measured["seconds"].tolist() == [10.0, 20.0, 40.0]
    assert json.loads((tmp_path / "scale.json").read_text())["largest"]["frames"] == 720
    growth = pd.read_csv(tmp_path / "scale_growth.csv")
    assert growth["exponent"].tolist() == pytest.approx([1.0] * 2, abs=0.03)


def test_missing_features_and_invalid_settings_raise_errors(ran, monkeypatch):
    folder, _ = ran
    monkeypatch.chdir(folder)
    (folder / "data/tracks").rename(folder / "data/away")
    with pytest.raises(PlacecatError, match="data/tracks/H1 is missing: run `make repro` first"):
        command.run()
    wrong = folder / "wrong.yaml"
    wrong.write_text(yaml.safe_dump(SCALE | {"size": 1}))
    with pytest.raises(PlacecatError, match="no setting 'size'; did you mean 'sizes'"):
        command.read_settings(wrong)
    wrong.write_text(yaml.safe_dump({"sizes": [1]}))
    with pytest.raises(PlacecatError, match="'test_homes' does not exist"):
        command.read_settings(wrong)
    with pytest.raises(PlacecatError, match=r"nothing\.yaml is missing"):
        command.read_settings(Path("nothing.yaml"))
