from pathlib import Path

import numpy as np
import pandas as pd
import pytest
import yaml

from placecat.errors import PlacecatError
from placecat.reporting import layouts
from placecat.reporting.markdown import table_markdown
from placecat.reporting.results import Results
from placecat.reporting.tables import CONTRADICTIONS, fill_table

ROOT = Path(__file__).resolve().parents[2]
PARAMS = yaml.safe_load((ROOT / "params.yaml").read_text())
OTHER = {"title": "some homes", "thesis_data": None}
SAME = {"title": "d", "thesis_data": "VPC-2009 home database"}
CLASSES = tuple(PARAMS["dataset"]["classes"])


@pytest.fixture(scope="module")
def published():
    table = pd.read_csv(ROOT / "data/thesis/published_tables.csv")
    return table.fillna({"group": "", "row": "", "column": ""})


def results_for(table, homes):
    names = {row["result"] for row in table.get("rows", [])} | {table.get("result")} - {None}
    rng = np.random.default_rng(0)
    confusion = {name: rng.integers(1, 50, (homes, 5, 5)) for name in sorted(names - {None})}
    return Results(tuple(f"H{number}" for number in range(homes)), CLASSES, confusion)


@pytest.mark.parametrize("name", list(PARAMS["tables"]))
def test_every_published_cell_is_measured(name, published):
    table = PARAMS["tables"][name]
    filled = fill_table(table, results_for(table, 6), published, OTHER)
    own = published[published["table"] == table["number"]]
    assert len(own) > 0
    assert len(filled) == len(own)
    assert filled["measured"].notna().all()
    assert filled["published"].tolist() == own["value"].tolist()
    assert (
        filled["note"]
        .str.startswith("measured on some homes; the published number is from the VPC-2009")
        .all()
    )


@pytest.mark.parametrize("name", list(PARAMS["tables"]))
def test_with_fewer_homes_every_empty_cell_has_a_reason(name, published):
    table = PARAMS["tables"][name]
    filled = fill_table(table, results_for(table, 4), published, SAME)
    empty = filled[filled["measured"].isna()]
    homes = empty["column"] + empty["row"]
    assert homes.str.contains("Home [56]").all()
    assert (empty["note"].str.split(";").str[0] == "the data set has only 4 homes").all()


def test_with_more_homes_new_cells_follow_the_published(published):
    table = PARAMS["tables"]["table_05"]
    filled = fill_table(table, results_for(table, 7), published, SAME)
    extra = filled[filled["column"] == "Home 7"]
    assert extra["published"].isna().all()
    assert extra["measured"].notna().all()


def test_the_numbers_are_those_of_the_results(published):
    table = PARAMS["tables"]["table_05"]
    results = results_for(table, 6)
    filled = fill_table(table, results, published, SAME)
    svm = filled[filled["row"] == "SVM"].set_index("column")["measured"]
    expected = results.by_home("cues/gist/5-5-1")
    assert svm["Home 2"] == pytest.approx(expected[1], abs=0.005)
    assert svm["Average"] == pytest.approx(expected.mean(), abs=0.005)


def test_contradictions_of_the_thesis_are_real_and_noted(published):
    for number, group, row, column in CONTRADICTIONS:
        own = published[
            (published["table"] == number) & (published["group"] == group) & (published["row"] == row)
        ]
        values = own.set_index("column")["value"]
        others = values.drop(column)
        assert abs(others.mean() - values[column]) > 0.02
    table = PARAMS["tables"]["table_06"]
    filled = fill_table(table, results_for(table, 6), published, SAME)
    noted = filled[filled["note"].str.contains("contradicts")]
    assert noted[["row", "column", "published"]].values.tolist() == [["Home 2", "Average", 43.75]]


def test_a_class_without_frames_has_a_note(published):
    table = PARAMS["tables"]["table_06"]
    results = results_for(table, 6)
    results.confusion["cues/gist/5-5-1"][2, 3] = 0
    filled = fill_table(table, results, published, SAME)
    cell = filled[(filled["row"] == "Home 3") & (filled["column"] == "Living Room")].iloc[0]
    assert np.isnan(cell["measured"])
    assert cell["note"] == "H2 has no frame of living_room"


def test_every_layout_is_used_and_unknown_ones_are_refused():
    assert {table["layout"] for table in PARAMS["tables"].values()} == set(layouts.names())
    with pytest.raises(PlacecatError, match=r"tables\.table_07\.layout 'x'.*by_class, by_home"):
        layouts.cells({"number": 7, "layout": "x"}, results_for({}, 1))


@pytest.mark.parametrize("data", [SAME, OTHER], ids=["same", "other"])
def test_markdown_shows_both_numbers_apart(published, data):
    table = PARAMS["tables"]["table_26"]
    results = results_for(table, 6)
    dataset = data | {"homes": results.homes}
    filled = fill_table(table, results, published, dataset)
    text = table_markdown(table, filled, dataset)
    measured, below = text.split("## Published")
    assert f"{results.by_home('integration/das_551_all').mean():.2f} |" in measured
    assert "47.53 |" in below
    assert "47.53 |" not in measured
    assert ("do not compare" in below) is (data is OTHER)
    assert "Home 1 is H0" in measured
