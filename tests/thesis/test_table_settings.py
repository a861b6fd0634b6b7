"""The tables use only known settings, with the values in the thesis."""

import numpy as np
import pytest

import made_results
from made_results import PARAMS, ROOT
from placecat import lookup
from placecat.cues import estimators
from placecat.evaluation.trials import expand
from placecat.learning.spatial_pca import SpatialPCA
from placecat.results.sources import sources
from placecat.thesis.tables import tables_of

TABLES = tables_of(PARAMS, ROOT)
STUDIES = {name: table for study in made_results.STUDIES.values() for name, table in study.items()}
HOMES = PARAMS["dataset"]["homes"]
TRIALS = {
    trial.name: trial.settings for name, table in STUDIES.items() for trial in expand(name, table, HOMES)
}

SETTINGS = {
    "by_home": {"number", "title", "thesis_data", "layout", "rows"},
    "by_class": {"number", "title", "thesis_data", "layout", "result"},
    "pooled_by_class": {"number", "title", "thesis_data", "layout", "rows", "split"},
    "probabilities": {"number", "title", "thesis_data", "layout", "caption", "rows"},
    "grid": {"number", "title", "thesis_data", "layout", "trial", "homes", "axes"},
}


@pytest.mark.parametrize("name", list(TABLES))
def test_a_table_has_exactly_the_settings_of_its_layout(name):
    table = {key: value for key, value in TABLES[name].items() if key != "name"}
    wanted = SETTINGS[table["layout"]]
    if name == "addition_toy":
        wanted = (wanted - {"split"}) | {"data", "plain"}
    assert set(table) == wanted
    for row in table.get("rows", []):
        assert set(row) == {"group", "row", "result"}


@pytest.mark.parametrize("name", list(STUDIES))
def test_a_study_has_the_settings_of_trials(name):
    assert set(STUDIES[name]) == SETTINGS["grid"]
    assert set(STUDIES[name]["axes"]) <= {"group", "row", "column"}
    if name in made_results.STUDIES["text"]:
        assert STUDIES[name]["layout"] is None
        assert STUDIES[name]["number"] is None


def test_the_results_of_tables_exist_in_the_pipeline():
    known = sources(PARAMS)
    for table in TABLES.values():
        for result in [*(row["result"] for row in table.get("rows", [])), table.get("result")]:
            assert result is None or result in known or result in TRIALS or result.startswith("toy/")


def test_the_table_of_probabilities_covers_every_cue_and_system():
    table = TABLES["addition_probabilities"]
    shown = [row["result"] for row in table["rows"]]
    assert len(shown) == len(set(shown))
    wanted = {f"cues/{cue}/5-5-1" for cue in PARAMS["cues"]}
    wanted |= {f"integration/{system}" for system in PARAMS["systems"]}
    wanted |= {name for name in sources(PARAMS) if name.startswith(("smoothing/", "tempered/"))}
    assert set(shown) == wanted
    titles = {row["result"]: row["row"] for row in table["rows"]}
    for cue, own in PARAMS["cues"].items():
        assert titles[f"cues/{cue}/5-5-1"] == own["title"]
    assert f"ln 5 = {np.log(len(PARAMS['dataset']['classes'])):.3f}" in table["caption"]


@pytest.mark.parametrize("name", list(STUDIES))
def test_every_trial_can_be_made(name):
    own = [trial for trial_name, trial in TRIALS.items() if trial_name.startswith(f"trials/{name}/")]
    assert own
    for trial in own:
        check(trial)


def check(trial):
    descriptor, classifier = trial["descriptor"], trial["classifier"]
    assert set(trial) <= {"descriptor", "classifier", "codebook"}
    assert descriptor["name"] in PARAMS["descriptors"][descriptor["kind"]]
    if descriptor["kind"] == "local":
        regions = PARAMS["regions"]
        if "variant" in descriptor:
            assert descriptor["name"] in PARAMS["region_variants"]["descriptors"]
            regions = regions | PARAMS["region_variants"]["variants"][descriptor["variant"]]["regions"]
        known = {"kind", "name", "y_pos", "y_weight", "color", "max_regions"}
        assert set(descriptor) - {"variant"} == known
        assert descriptor["color"] is None or descriptor["color"] in PARAMS["descriptors"]["local"]
        assert descriptor["max_regions"] <= regions["max_regions"]
    assert classifier["model"] in lookup.names("placecat.cues", "fit")
    if classifier["model"] == "discriminative_regions":
        assert set(classifier) == {"model", "cue", "clusters", "keep"}
        assert descriptor["kind"] == "local"
        check(trial | {"classifier": classifier["cue"]})
        return
    given = {"naive_bayes": {"n_values": 2}, "dependency_tree": {"n_values": 2}}
    base = classifier["base"]
    built = estimators.build(base, "base", **given.get(base["name"], {}))
    if "scheme" in classifier:
        estimators.build(classifier["scheme"], "scheme", base=built)
        if classifier["reduction"] is not None:
            SpatialPCA(**classifier["reduction"])
    else:
        assert set(classifier) == {"model", "base", "clusters"}
        assert (classifier["clusters"] - 1) % 15 == 0
        assert set(trial["codebook"]) == {"cells", "tree"}
        assert trial["codebook"]["cells"] == (16 if descriptor["kind"] == "holistic" else 1) or (
            classifier["model"] == "knn"
        )
    assert ("codebook" in trial) == ("clusters" in classifier)


def base_of(name):
    return TRIALS[f"trials/{name}"]["classifier"]["base"]


@pytest.mark.parametrize(
    ("base", "numbers"),
    [
        ("knn", [1, 11, 12, 13, 24, 25]),
        ("gentle_adaboost", [2, 14, 15]),
        ("nu_svm", [3]),
        ("naive_bayes", [16, 17, 18]),
        ("dependency_tree", [19, 20, 21]),
    ],
)
def test_each_table_has_its_classifier(base, numbers):
    for number in numbers:
        own = [trial for name, trial in TRIALS.items() if name.startswith(f"trials/table_{number:02d}/")]
        assert {trial["classifier"]["base"]["name"] for trial in own} == {base}


@pytest.mark.parametrize("number", [11, 12, 13, 16, 17, 18, 19, 20, 21, 24, 25])
def test_labels_of_region_descriptors_match_the_descriptors(number):
    names = {"Ori M/V": "orientation_mv", "HOG": "hog", "SIFT": "sift", "Centrist": "centrist"}
    names["Color M/V"] = "color_mv"
    for name, trial in TRIALS.items():
        if name.startswith(f"trials/table_{number:02d}/"):
            group, row, column = name.removeprefix(f"trials/table_{number:02d}/").split("|")
            parts = (group or row).split(" + ")
            descriptor = trial["descriptor"]
            assert descriptor["name"] == names[parts[0]]
            assert descriptor["y_pos"] == ("y-Pos" in parts)
            assert descriptor["color"] == ("color_mv" if "Color M/V" in parts[1:] else None)
            assert descriptor["max_regions"] == 25
            assert not column or trial["classifier"]["clusters"] == int(column)


def test_table_02_has_the_labelled_gist_factors_and_rounds():
    for name, trial in TRIALS.items():
        if name.startswith("trials/table_02/"):
            words = name.split("|")[1].split()
            classifier = trial["classifier"]
            assert classifier["reduction"] == {"cells": 1, "components": None, "factor": float(words[3][:-1])}
            assert classifier["base"]["n_rounds"] == int(words[4])


def test_table_03_varies_gamma_and_nu():
    for name, trial in TRIALS.items():
        if name.startswith("trials/table_03/"):
            group, _, column = name.removeprefix("trials/table_03/").split("|")
            base = trial["classifier"]["base"]
            assert (f"gamma={base['gamma']}", str(base["nu"])) == (group, column)


def test_table_04_compares_the_two_joint_models():
    models = {
        name.split("/")[2].split("|")[0]: base_of(name.removeprefix("trials/"))
        for name in TRIALS
        if "table_04" in name
    }
    assert models["Naive Bayes"] == PARAMS["cues"]["gist_naive_bayes"]["classifier"]["base"]
    assert models["First-Order Dependency Tree"]["name"] == "dependency_tree"


@pytest.mark.parametrize(
    ("name", "rounds", "reduced"),
    [
        ("table_14/|HOG|No PCA, 20 weak", 20, False),
        ("table_14/|HOG|PCA 4, 20 weak", 20, True),
        ("table_14/|HOG|PCA 4, 10 weak", 10, True),
        ("table_15/|SIFT + y-Pos + Color M/V|", 20, True),
    ],
)
def test_boosting_of_regions(name, rounds, reduced):
    assert base_of(name)["n_rounds"] == rounds
    reduction = TRIALS[f"trials/{name}"]["classifier"]["reduction"]
    assert (reduction is not None) == reduced
    if reduced:
        assert (reduction["cells"], reduction["factor"]) == (1, 4.0)


def test_table_22_has_each_descriptor_with_the_joint_model_of_its_cue():
    best = {"Ori M/V": ("dependency_tree", 196), "HOG": ("naive_bayes", 196), "SIFT": ("naive_bayes", 496)}
    best |= {"Centrist": ("naive_bayes", 196), "Color M/V": ("dependency_tree", 46)}
    for descriptor, (model, clusters) in best.items():
        for regions in (12, 25, 38):
            trial = TRIALS[f"trials/table_22/|{descriptor} + y-Pos|{regions}"]
            assert trial["classifier"]["base"]["name"] == model
            assert trial["classifier"]["clusters"] == clusters
            assert trial["descriptor"]["max_regions"] == regions


@pytest.mark.parametrize(("number", "neighbours"), [(24, 1), (25, 3)])
def test_tables_24_and_25_use_the_best_cluster_numbers(number, neighbours):
    best = {"Ori M/V": 196, "HOG": 196, "SIFT": 496, "Centrist": 196, "Color M/V": 46}
    for descriptor, clusters in best.items():
        name = f"table_{number}/|{descriptor} + y-Pos|"
        assert TRIALS[f"trials/{name}"]["classifier"]["clusters"] == clusters
        assert base_of(name)["n_neighbors"] == neighbours


def test_homes_match_the_thesis():
    homes = {1: [1, 5], 2: [1], 3: [1, 6], 4: [1, 6], 14: [1], 15: [1], 22: [6], 24: "all", 25: "all"}
    homes |= {number: [1, 6] for number in (11, 12, 13, 16, 17, 18, 19, 20, 21)}
    assert {t["number"]: t["homes"] for t in TABLES.values() if "homes" in t and t["number"]} == homes


@pytest.mark.parametrize(
    ("name", "cue"),
    [
        ("gist_without_color", "gist_naive_bayes"),
        ("gist_without_center_surround", "gist_naive_bayes"),
        ("centrist_full_size", "centrist_naive_bayes"),
        ("centrist_on_intensity", "centrist_naive_bayes"),
        ("region_centrist_on_laplacian", "centrist_y"),
    ],
)
def test_a_variant_differs_from_its_cue_only_in_the_descriptor(name, cue):
    trial = TRIALS[f"trials/{name}/||"]
    own = PARAMS["cues"][cue]
    codebook = PARAMS["codebooks"][own["codebook"]]
    assert trial["classifier"] == own["classifier"]
    assert trial["codebook"]["cells"] == codebook["cells"]
    assert trial["descriptor"] != codebook["descriptor"]
    assert trial["descriptor"]["kind"] == codebook["descriptor"]["kind"]


def test_repeated_tables_differ_in_one_setting():
    for name, trial in TRIALS.items():
        if name.startswith("trials/color_mv_short/"):
            same = TRIALS[name.replace("color_mv_short", "table_21")]
            assert trial["descriptor"] == same["descriptor"] | {"color": "color_mv_short"}
            assert trial["classifier"] == same["classifier"]
        if name.startswith("trials/flat_kmeans/"):
            same = TRIALS[name.replace("flat_kmeans", "table_01")]
            assert trial["codebook"]["tree"]["name"] == "flat_kmeans"
            assert trial | {"codebook": None} == same | {"codebook": None}


def test_the_addition_is_marked_and_limits_the_training_regions():
    assert TABLES["addition_rvm"]["title"].startswith("Addition: ")
    limits = {
        row: TRIALS[f"trials/addition_rvm/|{row}|"]["classifier"]["max_rows"]
        for row in ("Gist", "HOG + y-Pos")
    }
    assert limits == {"Gist": None, "HOG + y-Pos": 1000}


def test_each_attention_variant_changes_one_setting():
    variants = PARAMS["region_variants"]["variants"]
    scales, used = PARAMS["attention"]["scales"], variants["as_used"]
    assert used == {"scales": None, "regions": {"max_regions": 25}}
    assert PARAMS["region_variants"]["frames"] == PARAMS["protocol"]["cue_frames"]
    assert scales == [2, 3, 4, 5]
    assert PARAMS["attention"]["use_residual"]
    changes = {name: one for name, one in variants.items() if name != "as_used"}
    assert changes == {
        "without_residual": {"scales": None, "regions": {"max_regions": 25, "use_residual": False}},
        "scales_2_to_4": {"scales": [2, 3, 4], "regions": {"max_regions": 25}},
        "fifty_regions": {"scales": None, "regions": {"max_regions": 50}},
    }
    own = PARAMS["cues"]["hog_y"]
    for name, trial in TRIALS.items():
        if name.startswith("trials/addition_attention/"):
            assert trial["classifier"] == own["classifier"]
            descriptor = PARAMS["codebooks"][own["codebook"]]["descriptor"]
            number = variants[trial["descriptor"]["variant"]]["regions"]["max_regions"]
            expected = descriptor | {"variant": trial["descriptor"]["variant"], "max_regions": number}
            assert trial["descriptor"] == expected
