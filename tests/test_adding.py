"""The additions in docs/adding.md (a cue, a classifier, a table and a layout) on tiny drawn homes."""

import copy
import importlib
import re
import shutil
import sys
from pathlib import Path

import cv2
import numpy as np
import pandas as pd
import pytest

from placecat import lookup, paths, schema, settings
from placecat.config.compose import write_params
from placecat.errors import PlacecatError
from placecat.evaluation.accuracy import confusion_matrix
from placecat.results.measured import Measured, Results
from placecat.schema import signatures
from placecat.stages.features import describe_home, feature_options
from placecat.stages.sequences import list_homes
from placecat.thesis import definitions, tables
from placecat.training import plan as plans
from placecat.training.cue import Cue, train
from project import light_conf

TEXT = (Path(__file__).resolve().parents[1] / "docs/adding.md").read_text()
# Maps the path in the first line of each block to the text of the block.
BLOCKS = dict(re.findall(r"```(?:python|yaml)\n# (\S+)\n(.*?)```", TEXT, re.DOTALL))
RESULT = "cues/brightness/5-5-1"


def draw(root, homes, places):
    """Draw nine small frames of every place in every home. Each place has a different brightness."""
    rng = np.random.default_rng(0)
    for folder in (root / home / place for home in homes for place in places):
        folder.mkdir(parents=True)
        level = 30 + 40 * places.index(folder.name)
        for frame in range(9):
            image = rng.integers(level - 20, level + 20, (90, 160, 3)).astype(np.uint8)
            cv2.imwrite(str(folder / f"{frame + 1}.jpg"), image)


@pytest.fixture(scope="module")
def project(tmp_path_factory):
    """A project after all steps on the page, with composed settings and drawn homes."""
    folder = tmp_path_factory.mktemp("adding")
    conf = light_conf(folder / "conf")
    # One cue is enough, and composing takes only a quarter of the time.
    for group in ("codebook", "cue", "descriptor/local", "descriptor/holistic", "filter", "split", "system"):
        shutil.rmtree(conf / group)
        (conf / group).mkdir()
    packages = {}
    for path, text in BLOCKS.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(text)
        if path.startswith("src/"):
            package = importlib.import_module(".".join(Path(path).parts[1:-1]))
            packages[f"{package.__name__}.{Path(path).stem}"] = package, str((folder / path).parent)
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        patch.setenv("PLACECAT_WORKERS", "1")
        for package, place in packages.values():
            patch.setattr(package, "__path__", [*package.__path__, place])
            patch.setattr(package.__spec__, "submodule_search_locations", package.__path__)
        lookup._locations.cache_clear()
        none = ["protocol.extra=null", "region_variants.descriptors=[]", "region_variants.variants={}"]
        less = ["smoothing.cues=[]", "smoothing.filtered=[]", "tracking.descriptors=[]"]
        write_params(["dataset=rooms", *none, *less])
        params = settings.load()
        draw(Path(params["dataset"]["root"]), params["dataset"]["homes"], params["dataset"]["classes"])
        yield params
    lookup._locations.cache_clear()
    for name in packages:
        sys.modules.pop(name, None)


@pytest.fixture(scope="module")
def results(project):
    """Decisions of the cue in every home, after training on the others."""
    list_homes(project["dataset"], paths.SEQUENCES, "dataset")
    options = feature_options(project, {"local": {}, **project["descriptors"]})
    for home in project["dataset"]["homes"]:
        describe_home(home, Path(project["dataset"]["root"]), options, paths.FEATURES / home)
    homes, classes = (tuple(project["dataset"][name]) for name in ("homes", "classes"))
    counts = []
    for plan in plans.of_homes(project, "5-5-1"):
        trained = train(plan, Cue.of(project, "brightness"))
        assert [type(one.estimator).__name__ for one in trained.model.scheme.scorer_.machines] == [
            "NearestMean"
        ] * 5
        proba = trained.predict(plan.test)
        assert proba.shape == (45, 5)
        np.testing.assert_allclose(proba.sum(axis=1), 1)
        counts.append(confusion_matrix(plan.tested[0].labels(), proba.argmax(axis=1), len(classes)))
    return Results(
        homes, classes, {RESULT: Measured(homes, (paths.NO_SEED,), classes, np.array([counts]))}, {}
    )


def test_the_page_has_all_files_and_is_short():
    folders = [str(Path(path).parent) for path in BLOCKS]
    assert folders == [
        "src/placecat/vision/holistic",
        "conf/cue",
        "src/placecat/learning",
        "conf/classifier",
        "data/thesis/tables",
        "src/placecat/sequences",
        "conf/dataset",
    ]
    assert TEXT.count("```") == 2 * len(BLOCKS)
    assert len(TEXT.splitlines()) <= 170


def test_the_layout_is_read(project):
    from placecat import sequences

    homes = project["dataset"]["homes"]
    home = sequences.open_home("rooms", "data/rooms", homes[0], fps=5.0, camera="")
    assert len(home.frames) == 45
    assert set(home.frames["label"]) == set(project["dataset"]["classes"])


def test_the_settings_come_from_the_module_and_the_files(project):
    assert project["descriptors"]["holistic"] == {"brightness": {"cells": 4}}
    classifier = project["cues"]["brightness"]["classifier"]
    assert classifier["base"] == {"name": "nearest_mean", "spread": 2.0}
    assert classifier["scheme"]["name"] == "one_against_all"


def test_the_cue_discriminates_places_and_the_table_has_its_accuracy(project, results):
    table = {**definitions.tables(project)["addition_brightness"], "name": "addition_brightness"}
    published = pd.DataFrame(columns=["table", "group", "row", "column", "value"])
    filled = tables.fill_table(table, results, published, project["dataset"], {})
    assert list(filled["column"]) == ["Home 1", "Home 2", "Home 3", "Home 4", "Average"]
    expected = results.of(RESULT).by_home()[0]
    np.testing.assert_allclose(filled["measured"], [*expected, expected.mean()], atol=0.011)
    # Chance is 20%. Two means cannot separate a place of medium brightness.
    assert expected.mean() > 50


@pytest.mark.parametrize(
    "part",
    [
        "cues.brightness",
        "cues.brightness.classifier",
        "cues.brightness.classifier.base",
        "descriptors.holistic.brightness",
        "dataset",
    ],
)
def test_a_setting_that_the_modules_do_not_have_is_refused(project, part):
    changed = copy.deepcopy(project)
    settings.get(changed, part)["nonsense"] = 1
    with pytest.raises(PlacecatError, match=f"^{part} has no setting 'nonsense'"):
        schema.check(changed)
        signatures.check(changed)
