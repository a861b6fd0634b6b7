"""Each addition in conf/optional changes its own settings and nothing else."""

import inspect

import pytest
import yaml
from helpers_sequences import write_image

from made_results import PARAMS, made
from optional import with_optional
from placecat import paths
from placecat.cues import estimators
from placecat.fusion.log_pool import SMALLEST
from placecat.results.sources import sources
from placecat.schema import references
from placecat.sequences import listing
from placecat.stages import site_sequences
from placecat.thesis import definitions, layouts
from placecat.thesis.tables import tables_of
from placecat.vision import discovery
from project import ROOT

NAMES = sorted(path.stem for path in (ROOT / "conf/optional").glob("*.yaml"))
# Additions that replace the data of a split.
DATA = ["cold"]
EVERY = pytest.mark.parametrize("name", NAMES)
# One worker runs all of these tests, so that each addition is composed only once.
pytestmark = pytest.mark.xdist_group("optional")


def differences(one, other, where=""):
    """Yield the dotted names of settings in `other` that `one` lacks or has with another value."""
    for key, value in other.items():
        name = f"{where}{key}"
        if isinstance(value, dict) and isinstance(one.get(key), dict):
            yield from differences(one[key], value, f"{name}.")
        elif one.get(key) != value:
            yield name


@pytest.mark.slow
@pytest.mark.parametrize("name", [name for name in NAMES if name not in DATA])
def test_existing_settings_do_not_change(name):
    extended = with_optional(name)
    references.check(extended)
    assert set(differences(extended, PARAMS)) <= {"smoothing.cues", "model.system"}
    assert extended["smoothing"]["cues"][: len(PARAMS["smoothing"]["cues"])] == PARAMS["smoothing"]["cues"]
    assert set(differences(PARAMS, extended)) - {"smoothing.cues", "model.system"}


@EVERY
def test_all_settings_are_known_and_given(name):
    extended = with_optional(name)
    for kind in ("local", "holistic"):
        for descriptor in extended["descriptors"][kind].keys() - PARAMS["descriptors"][kind].keys():
            module, own = discovery.entry(kind, descriptor, extended["descriptors"][kind][descriptor])
            settings = inspect.signature(module.describe).parameters.values()
            defaults = {one.name: one.default for one in settings if one.kind is one.KEYWORD_ONLY}
            assert own == defaults
    for cue in extended["cues"].keys() - PARAMS["cues"].keys():
        estimators.build(extended["cues"][cue]["classifier"]["base"], cue)


@EVERY
def test_new_tables_are_additions_with_existing_results(name):
    extended = with_optional(name)
    results, known, before = made(extended), sources(extended), tables_of(PARAMS, ROOT)
    for table_name, table in tables_of(extended, ROOT).items():
        if table_name not in before:
            assert table_name in definitions.optional(ROOT)
            assert table["number"] is None
            assert table["title"].startswith("Addition: ")
            assert {row["result"] for row in table["rows"]} <= known.keys()
            assert {over for gain in table.get("gains", []) for over in gain["over"]} <= known.keys()
            assert len(layouts.LAYOUTS[table["layout"]](table, results)) > 0


def test_the_embedding_is_one_more_cue_and_system():
    extended = with_optional("embedding")
    assert extended["cues"]["embedding"]["classifier"] == PARAMS["cues"]["gist"]["classifier"]
    best = PARAMS["systems"]["das_551_best"]
    system = extended["systems"]["das_551_best_embedding"]
    assert system == best | {"title": system["title"], "cues": [*best["cues"], "embedding"]}
    pool = extended["systems"]["pool_551_best_embedding"]
    integrator = {"method": "log_pool", "shrinkage": 0.03, "smallest": SMALLEST}
    assert pool == system | {"title": pool["title"], "integrator": integrator}
    assert extended["model"]["system"] == "pool_551_best_embedding"
    assert extended["smoothing"]["cues"] == [*PARAMS["smoothing"]["cues"], "embedding"]


def test_cold_is_the_university_with_the_sequences_of_the_thesis():
    """In thesis 4.9, north is Saarbruecken and south is Freiburg."""
    extended = with_optional("cold")
    references.check(extended)
    changed = {"dataset", "cue_parts", "integration_parts", "test"}
    assert {name.split(".")[2] for name in differences(PARAMS, extended)} == changed
    assert all(name.startswith("splits.university.") for name in differences(PARAMS, extended))
    own, cold = PARAMS["splits"]["university"], extended["splits"]["university"]

    def real(sequence):
        site, route, weather, number = sequence.split("_")
        town = {"north": "saarbruecken", "south": "freiburg"}[site]
        return f"{town}-seq{route}_{weather}{number}"

    assert set(cold["dataset"]["homes"]) == {real(one) for one in own["dataset"]["homes"]}
    assert cold["test"] == [real(one) for one in own["test"]]
    for parts in ("cue_parts", "integration_parts"):
        expected = [{"sequence": real(one["sequence"]), "places": one["places"]} for one in own[parts]]
        assert cold[parts] == expected
    assert cold["dataset"]["thesis_data"] == tables_of(PARAMS, ROOT)["table_30"]["thesis_data"]
    assert cold["dataset"]["classes"] == own["dataset"]["classes"]


CODES = ["CR", "TL", "PA", "1PO", "2PO", "LO", "KT", "ST", "LAB", "RL", "TR", "CNR"]


def test_every_room_of_cold_is_mapped_to_a_class():
    dataset = with_optional("cold")["splits"]["university"]["dataset"]
    assert sorted(dataset["aliases"]) == sorted(CODES)
    assert set(dataset["aliases"].values()) == set(dataset["classes"])
    assert dataset["ignored"] == []


@pytest.mark.slow
def test_cold_on_disk_is_listed_as_the_university(tmp_path, monkeypatch):
    dataset = with_optional("cold")["splits"]["university"]["dataset"]
    for sequence in dataset["homes"]:
        site, name = sequence.split("-")
        folder = tmp_path / "COLD" / site / name
        images = [f"t{1152000000 + number}.000000_x0.1_y-0.2_a0.5.jpeg" for number in range(len(CODES))]
        for image in images:
            write_image(folder / "std_cam" / image, 1)
        (folder / "localization").mkdir()
        labels = "".join(f"{image} {code}1-A\n" for image, code in zip(images, CODES, strict=True))
        (folder / "localization/places.lst").write_text(labels)
    monkeypatch.chdir(tmp_path)
    params = {"splits": {"university": {"dataset": dataset | {"root": "COLD"}}}}
    paths.PARAMS.write_text(yaml.safe_dump(params))
    site_sequences.main()
    for sequence in dataset["homes"]:
        labels = listing.read_labels(f"university/{sequence}")
        assert [dataset["classes"][index] for index in labels] == [dataset["aliases"][code] for code in CODES]
    assert listing.sequence_slices("university/freiburg-seq3_cloudy2") == [slice(0, len(CODES))]
