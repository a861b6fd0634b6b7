import dataclasses

import numpy as np
import pytest
import yaml

from made_results import PARAMS, ROOT, made, published_text, with_homes
from placecat.errors import PlacecatError
from placecat.reporting.in_text import COLUMNS, in_text
from placecat.reporting.results import Results

ENTRIES = PARAMS["in_text"]
PUBLISHED = published_text()
RESULTS = made()
KEY = ["name", "quantity", "home"]
HOME = {"title": "some homes", "thesis_data": None}


def fill(results=RESULTS, entries=ENTRIES, dataset=HOME):
    return in_text(entries, results, PUBLISHED, dataset).set_index(KEY)


def test_every_published_number_has_a_line():
    filled = in_text(ENTRIES, RESULTS, PUBLISHED, HOME)
    assert list(filled.columns) == COLUMNS
    lines = filled.set_index(KEY)
    assert lines.index.is_unique
    for row in PUBLISHED.itertuples():
        line = lines.loc[(row.name, row.quantity, row.home)]
        assert line["published"] == pytest.approx(row.value, nan_ok=True)
        assert line["section"] == row.section
        assert f'"{row.quote}"' in line["note"] or not np.isfinite(line["measured"])
        assert np.isfinite(line["measured"]) != row.name.startswith("wu_")


def test_the_numbers_of_the_text_are_those_of_the_thesis():
    value = PUBLISHED.set_index(KEY)["value"]
    assert value["gist_without_color", "without colour", "Home 6"] == 35.41
    assert value["gist_without_center_surround", "without centre-surround", "Home 6"] == 30.96
    assert value["toy_problem", "parallel scheme", ""] == 99.74
    assert value["toy_problem", "sequential scheme", ""] == 99.56
    assert sorted(value[value.index.get_level_values(0).str.startswith("wu_")]) == [39.8, 41.87, 46.78]
    assert (PUBLISHED["quote"].str.len() > 0).all()


def test_a_comparison_shows_both_sides_and_their_difference():
    lines = fill().loc["gist_without_color"]
    both = [
        RESULTS.of(name).by_home() for name in ("trials/gist_without_color/||", "cues/gist_naive_bayes/5-5-1")
    ]
    measured = lines["measured"].xs("Home 6", level="home")
    assert measured["without colour"] == pytest.approx(both[0][:, 5].mean(), abs=0.005)
    assert measured["with colour"] == pytest.approx(both[1][:, 5].mean(), abs=0.005)
    difference = both[0] - both[1]
    assert measured["difference"] == pytest.approx(difference[:, 5].mean(), abs=0.005)
    average = lines.loc[("difference", "Average")]
    assert average["measured"] == pytest.approx(difference.mean(), abs=0.005)
    assert average["spread"] == pytest.approx(np.ptp(difference.mean(axis=1)), abs=0.006)


def test_results_below_a_name_are_compared_pair_by_pair():
    lines = fill()
    flat = lines.loc["flat_kmeans"]["measured"].xs("Average", level="home")
    differences = [flat[f"{number} clusters: difference"] for number in (46, 91, 196, 496)]
    assert flat["difference, lowest"] == pytest.approx(min(differences), abs=0.005)
    assert "that of " in lines.loc[("flat_kmeans", "difference, lowest", "Average"), "note"]
    short = lines.loc["color_mv_short"]["measured"].xs("Average", level="home")
    each = short[short.index.str.endswith(": difference")]
    assert len(each) == 12
    assert short["difference, mean"] == pytest.approx(each.mean(), abs=0.01)


def test_the_error_on_the_last_class_is_compared_as_a_ratio():
    errors = [100 - RESULTS.of(f"toy/last/{scheme}").by_home()[:, 0] for scheme in ("sequential", "parallel")]
    line = fill().loc[("toy_problem", "error on the last class, sequential / parallel", "")]
    assert line["measured"] == pytest.approx((errors[0] / errors[1]).mean(), abs=0.005)
    assert line["published"] == 3
    assert "measured on circles of our choice" in line["note"]
    assert "compare" not in line["note"]


def test_the_accuracy_on_the_toy_problem_is_that_of_all_points():
    line = fill().loc[("toy_problem", "parallel scheme", "")]
    assert line["measured"] == pytest.approx(RESULTS.of("toy/parallel").plain().mean(), abs=0.005)


def test_no_error_gives_no_ratio():
    results = made()
    confusion = results.measured["toy/last/parallel"].confusion
    confusion *= np.eye(confusion.shape[-1], dtype=int)
    line = fill(results).loc[("toy_problem", "error on the last class, sequential / parallel", "")]
    assert np.isnan(line["measured"])
    assert line["note"].startswith("toy/last/parallel makes no error")


def test_on_other_data_numbers_do_not_compare():
    note = fill().loc[("gist_without_color", "without colour", "Home 6"), "note"]
    assert "the published number is from the VPC-2009 home database and does not compare" in note
    same = fill(dataset={"title": "d", "thesis_data": "VPC-2009 home database"})
    assert not same["note"].str.contains("compare").any()


def test_what_wu_reports_is_for_reference():
    lines = fill().loc[["wu_centrist", "wu_centrist_smoothed", "wu_sift"]]
    assert len(lines) == 3
    assert lines["measured"].isna().all()
    assert lines["note"].str.startswith("reported by Wu").all()


def test_with_fewer_homes_what_lacks_has_a_reason():
    lines = fill(made(with_homes(4)))
    line = lines.loc[("gist_without_color", "difference", "Home 6")]
    assert np.isnan(line["measured"])
    assert line["note"].startswith("the data set has only 4 homes")
    assert np.isfinite(lines.loc[("gist_without_color", "difference", "Average"), "measured"])
    assert lines["note"][lines["measured"].isna()].str.len().min() > 0


def test_an_average_is_over_the_homes_with_both_sides():
    name = "trials/gist_without_color/||"
    one = RESULTS.of(name)
    fewer = dataclasses.replace(one, homes=one.homes[:5], confusion=one.confusion[:, :5])
    results = Results(
        RESULTS.homes, RESULTS.classes, RESULTS.measured | {name: fewer}, {(name, "home_6"): "too few frames"}
    )
    lines = fill(results).loc["gist_without_color"]
    assert lines.loc[("difference", "Home 6"), "note"].startswith("too few frames")
    other = RESULTS.of("cues/gist_naive_bayes/5-5-1").by_home()
    difference = (one.by_home() - other)[:, :5].mean()
    assert lines.loc[("difference", "Average"), "measured"] == pytest.approx(difference, abs=0.005)
    assert (
        "mean over Home 1, Home 2, Home 3, Home 4, Home 5 only"
        in lines.loc[("difference", "Average"), "note"]
    )
    assert lines.loc[("with colour", "Average"), "measured"] == pytest.approx(other[:, :5].mean(), abs=0.005)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (
            {"flat_kmeans": {"sumary": "mean"}},
            "in_text.flat_kmeans has no setting 'sumary'; did you mean 'summary'",
        ),
        (
            {"flat_kmeans": {"summary": "most"}},
            "in_text.flat_kmeans.summary 'most' does not exist: use one of mean",
        ),
        ({"wu_sift": {"homes": []}}, "in_text.wu_sift has no setting 'homes'"),
        ({"flat_kmeans": {"variant": {"quantity": "x", "result": "trials/x/"}}}, "no result below trials/x/"),
        ({"extra_das_data": {"variant": {"quantity": "x", "result": "x"}}}, "no result 'x'"),
        ({"new": {"reference": "x"}}, "an entry 'new' of which the thesis says nothing"),
    ],
)
def test_mistakes_are_refused(change, message):
    entries = {name: entry | change.get(name, {}) for name, entry in (change | ENTRIES).items()}
    with pytest.raises(PlacecatError, match=message):
        fill(entries=entries)


def test_a_published_number_without_an_entry_is_refused():
    with pytest.raises(PlacecatError, match="number 'wu_sift' has no entry"):
        fill(entries={name: entry for name, entry in ENTRIES.items() if name != "wu_sift"})


def test_the_settings_are_those_of_conf():
    assert yaml.safe_load((ROOT / "conf/in_text/thesis.yaml").read_text()) == ENTRIES
