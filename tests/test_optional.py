"""Additions of conf/optional: what each changes, and that it changes nothing else."""

import inspect
from pathlib import Path

import pytest

from made_results import PARAMS, made
from optional import with_optional
from placecat import references
from placecat.compose import found
from placecat.cues import estimators
from placecat.errors import PlacecatError
from placecat.reporting import layouts
from placecat.reporting.sources import sources
from placecat.reporting.tables import tables_of
from placecat.vision import holistic, local
from project import ROOT

NAMES = sorted(path.stem for path in (ROOT / "conf/optional").glob("*.yaml"))
EVERY = pytest.mark.parametrize("name", NAMES)


def differences(one, other, where=""):
    """Dotted names of what `other` has and `one` has not, or has otherwise."""
    for key, value in other.items():
        name = f"{where}{key}"
        if isinstance(value, dict) and isinstance(one.get(key), dict):
            yield from differences(one[key], value, f"{name}.")
        elif one.get(key) != value:
            yield name


@EVERY
def test_everything_that_was_there_stays(name):
    extended = with_optional(name)
    references.check(extended)
    assert not [one for one in differences(extended, PARAMS) if one != "smoothing.cues"]
    assert extended["smoothing"]["cues"][: len(PARAMS["smoothing"]["cues"])] == PARAMS["smoothing"]["cues"]
    assert set(differences(PARAMS, extended)) - {"smoothing.cues"}


@EVERY
def test_all_settings_are_known_and_given(name):
    extended = with_optional(name)
    for kind, package in (("local", local), ("holistic", holistic)):
        for descriptor in extended["descriptors"][kind].keys() - PARAMS["descriptors"][kind].keys():
            module, own = package.entry(descriptor, extended["descriptors"][kind][descriptor])
            settings = inspect.signature(module.describe).parameters.values()
            defaults = {one.name: one.default for one in settings if one.kind is one.KEYWORD_ONLY}
            assert {key: tuple(v) if isinstance(v, list) else v for key, v in own.items()} == defaults
    for cue in extended["cues"].keys() - PARAMS["cues"].keys():
        estimators.build(extended["cues"][cue]["classifier"]["base"], cue)


@EVERY
def test_its_tables_show_results_that_there_are_and_are_additions(name):
    extended = with_optional(name)
    results, known = made(extended), sources(extended)
    for table_name, table in tables_of(extended).items():
        if table_name not in tables_of(PARAMS):
            assert table_name in PARAMS["optional_tables"]
            assert table["number"] is None
            assert table["title"].startswith("Addition: ")
            assert {row["result"] for row in table["rows"]} <= known.keys()
            assert {over for gain in table.get("gains", []) for over in gain["over"]} <= known.keys()
            assert len(layouts.cells(table, results)) > 0


def test_the_embedding_is_one_more_cue_and_system():
    extended = with_optional("embedding")
    assert extended["cues"]["embedding"]["classifier"] == PARAMS["cues"]["gist"]["classifier"]
    best = PARAMS["systems"]["das_551_best"]
    system = extended["systems"]["das_551_best_embedding"]
    assert system == best | {"title": system["title"], "cues": [*best["cues"], "embedding"]}
    assert extended["smoothing"]["cues"] == [*PARAMS["smoothing"]["cues"], "embedding"]


def test_tables_of_additions_are_listed_for_the_runs_without_them(tmp_path: Path):
    (tmp_path / "optional").mkdir()
    (tmp_path / "optional/b.yaml").write_text("tables: {table_y: {}, table_x: {}}\n")
    (tmp_path / "optional/a.yaml").write_text("cues: {}\n")
    assert found(tmp_path).endswith("optional_tables:\n- table_x\n- table_y\n")
    (tmp_path / "optional/a.yaml").write_text("cues: {\n")
    with pytest.raises(PlacecatError, match=r"optional/a\.yaml is no valid YAML"):
        found(tmp_path)
