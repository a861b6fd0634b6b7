import dataclasses
from functools import cache

import numpy as np
import pandas as pd
import pytest

from made_results import ROOT, made, published, published_text, records, with_homes
from placecat.errors import PlacecatError
from placecat.results.measured import Results
from placecat.thesis import definitions
from placecat.thesis.in_text import COLUMNS, in_text

ENTRIES = definitions.in_text(ROOT)
PUBLISHED = published_text()
RESULTS = made()
KEY = ["name", "quantity", "home"]
HOME = {"title": "some homes", "thesis_data": None}
SPLITS = {"university": {"title": "a university", "thesis_data": None}, "apartments": HOME}
RECORDS = records()
REFERENCES = [name for name, entry in ENTRIES.items() if "reference" in entry]


def lines_of(results=RESULTS, entries=ENTRIES, dataset=HOME, known=RECORDS):
    return in_text(entries, results, PUBLISHED, dataset, SPLITS, known)


def fill(*arguments, **others):
    return lines_of(*arguments, **others).set_index(KEY)


@cache
def filled():
    return fill()


def test_every_published_number_has_a_line():
    assert list(lines_of().columns) == [*COLUMNS, "notes", "number"]
    lines = filled()
    assert lines.index.is_unique
    for row in PUBLISHED.itertuples():
        line = lines.loc[(row.name, row.quantity, row.home)]
        assert line["published"] == pytest.approx(row.value, nan_ok=True)
        assert line["section"] == row.section
        assert f'"{row.quote}"' in line["note"] or not np.isfinite(line["measured"])
        assert row.note in line["note"]
        assert np.isfinite(line["measured"]) != (row.name in REFERENCES)


def test_the_published_numbers_match_the_thesis():
    value = PUBLISHED.set_index(KEY)["value"]
    assert value["gist_without_color", "without colour", "Home 6"] == 35.41
    assert value["gist_without_center_surround", "without centre-surround", "Home 6"] == 30.96
    assert value["toy_problem", "parallel scheme", ""] == 99.74
    assert value["toy_problem", "sequential scheme", ""] == 99.56
    assert sorted(value[value.index.get_level_values(0).str.startswith("wu_")]) == [39.8, 41.87, 46.78]
    assert value["filter", "SIFT: difference", "Average"] == -1.15
    assert value["filter", "Centrist: difference", "Average"] == -2.95
    assert sorted(value["uninformative_views"]) == [0.04046, 0.09519]
    assert sorted(value["nu_in_force"]) == [0.15, 0.2]
    assert (PUBLISHED["quote"].str.len() > 0).all()


def test_a_comparison_shows_both_sides_and_their_difference():
    lines = filled().loc["gist_without_color"]
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


def test_trials_below_a_name_are_compared_in_pairs():
    lines = filled()
    flat = lines.loc["flat_kmeans"]["measured"].xs("Average", level="home")
    differences = [flat[f"{number} clusters: difference"] for number in (46, 91, 196, 496)]
    assert flat["difference, lowest"] == pytest.approx(min(differences), abs=0.005)
    assert "; for " in lines.loc[("flat_kmeans", "difference, lowest", "Average"), "note"]
    short = lines.loc["color_mv_short"]["measured"].xs("Average", level="home")
    each = short[short.index.str.endswith(": difference")]
    assert len(each) == 12
    assert short["difference, mean"] == pytest.approx(each.mean(), abs=0.01)


def test_errors_on_the_last_class_are_compared_as_a_ratio():
    errors = [100 - RESULTS.of(f"toy/last/{scheme}").by_home()[:, 0] for scheme in ("sequential", "parallel")]
    line = filled().loc[("toy_problem", "error on the last class, sequential / parallel", "")]
    assert line["measured"] == pytest.approx((errors[0] / errors[1]).mean(), abs=0.005)
    assert line["published"] == 3
    assert "measured on circles of our choice" in line["note"]
    assert "compare" not in line["note"]


def test_the_accuracy_on_the_toy_problem_is_over_all_points():
    line = fill().loc[("toy_problem", "parallel scheme", "")]
    assert line["measured"] == pytest.approx(RESULTS.of("toy/parallel").plain().mean(), abs=0.005)


def test_there_is_no_ratio_without_errors():
    results = made()
    confusion = results.measured["toy/last/parallel"].confusion
    confusion *= np.eye(confusion.shape[-1], dtype=int)
    line = fill(results).loc[("toy_problem", "error on the last class, sequential / parallel", "")]
    assert np.isnan(line["measured"])
    assert line["note"].startswith("toy/last/parallel makes no errors")


def test_numbers_on_other_data_are_not_comparable():
    note = filled().loc[("gist_without_color", "without colour", "Home 6"), "note"]
    assert "the published number is from the VPC-2009 home database and is not comparable" in note
    same = fill(dataset={"title": "d", "thesis_data": "VPC-2009 home database"})
    other = same[same["note"].str.contains("is not comparable")]
    names = {
        "university_beside_homes",
        "university_integration",
        "university_fewer_cues",
        "robot_integration",
    }
    assert set(other.index.get_level_values("name")) == names


def test_numbers_by_wu_are_not_measured():
    lines = filled().loc[REFERENCES]
    assert len(lines) == 4
    assert lines["measured"].isna().all()
    assert lines["note"].str.contains("Wu.*not measured here").all()
    own = filled().loc[("wu_centrist", "Wu, Centrist", "Average"), "measured"]
    assert own == pytest.approx(RESULTS.of("cues/centrist_naive_bayes/5-5-1").by_home().mean(), abs=0.005)


def test_places_are_averaged_over_the_homes_that_show_them():
    results = made()
    results.measured["smoothing/spatial_pact"].confusion[:, 2, 3] = 0
    lines = fill(results).loc["pact_smoothing"]["measured"].xs("Average", level="home")
    sides = [results.of(name).by_class()[0] for name in ("smoothing/spatial_pact", "cues/spatial_pact/5-5-1")]
    kitchen = results.classes.index("kitchen")
    assert lines["Kitchen: difference"] == pytest.approx(
        sides[0][:, kitchen].mean() - sides[1][:, kitchen].mean(), abs=0.005
    )
    living = results.classes.index("living_room")
    shown = [0, 1, 3, 4, 5]
    assert lines["Living Room: smoothed"] == pytest.approx(sides[0][shown, living].mean(), abs=0.005)
    of_gist = filled().loc["gist_smoothing"]["measured"].xs("Average", level="home")
    each = [of_gist[f"{place}: difference"] for place in ("Bedroom", "Kitchen", "Dining Room", "Living Room")]
    assert of_gist["difference, highest"] == max([*each, of_gist["Bathroom: difference"]])


def test_a_star_selects_the_best_trial():
    lines = filled().loc["colour_knn"]
    for name, table in (("with colour", "table_13"), ("without", "table_12")):
        group = "SIFT + y-Pos" + (" + Color M/V" if table == "table_13" else "")
        averages = {
            number: RESULTS.of(f"trials/{table}/{group}||{number}").by_home().mean()
            for number in (46, 196, 496)
        }
        line = lines.loc[(f"SIFT: {name}", "Average")]
        assert line["measured"] == pytest.approx(max(averages.values()), abs=0.005)
        assert line["note"] == f"measured on some homes; the best: {max(averages, key=averages.get)}"
    differences = [
        lines.loc[(f"{one}: difference", "Average"), "measured"]
        for one in ("SIFT", "HOG", "Centrist", "Ori M/V")
    ]
    assert lines.loc[("difference, lowest", "Average"), "measured"] == min(differences)
    best = filled().loc[("orientation_beside_best_naive_bayes", "the best descriptor", "Average"), "measured"]
    every = [
        one.by_home().mean() for name, one in RESULTS.measured.items() if name.startswith("trials/table_16/")
    ]
    assert best == pytest.approx(max(every), abs=0.005)


def test_sequences_of_a_split_are_counted_together_as_in_its_table():
    line = filled().loc[("university_integration", "integration of five cues", "")]
    one = RESULTS.of("splits/university/integration/five")
    assert len(one.homes) > 1
    counts = one.confusion.sum(axis=1)
    by_class = 100 * np.diagonal(counts, axis1=1, axis2=2) / counts.sum(axis=2)
    assert line["measured"] == pytest.approx(by_class.mean(), abs=0.005)
    assert "measured on a university" in line["note"]
    homes = filled().loc[("university_beside_homes", "homes, HMM", "")]
    assert homes["measured"] == pytest.approx(
        RESULTS.of("smoothing/das_551_best").by_home().mean(), abs=0.005
    )


def test_runtimes_come_from_git():
    # Each peer has a row; the first one is scikit-learn's own method.
    kept = RECORDS["benchmarks"].groupby(["module", "input", "quantity"], sort=False)["ours"].first()
    lines = filled()["measured"]
    rate = kept["frame_features", "1280x720 JPEG, for the cues", "frames/s on one core, with decoding"]
    assert lines["processing_rate", "frames/s", ""] == round(rate, 2)
    training = kept["nu_svm", "fit 8000 x 1024, 5 homes", "seconds"]
    assert lines["svm_training", "seconds", ""] == round(training, 2)
    assert "measured on one core" in filled().loc[("processing_rate", "frames/s", ""), "note"]


def test_missing_records_have_a_reason():
    empty = {name: pd.DataFrame() for name in RECORDS}
    line = fill(known=empty).loc[("nu_in_force", "lowest nu in force", "")]
    assert np.isnan(line["measured"])
    assert line["note"].startswith("not recorded")


def test_noted_contradictions_exist_in_the_thesis():
    value = published().set_index(["table", "group", "row", "column"])["value"].sort_index()

    def best(table, group):
        return value.loc[(table, group, "Average")].max()

    def centrist(table, group):
        return value.loc[(table, group, "Centrist + y-Pos", "Average")]

    living = [value.loc[(table, "", "Average", "Living Room")] for table in (9, 10)]
    filtered = "5-5-1, HOG+SIFT+Centrist+Gist+holistic Centrist"
    found = {
        "Living Room: difference": living[1] - living[0],
        "Centrist: difference": centrist(27, filtered) - centrist(26, "5-5-1, all cues"),
        "difference, highest": best(21, "SIFT + y-Pos + Color M/V") - best(20, "SIFT + y-Pos"),
    }
    noted = PUBLISHED[PUBLISHED["note"] != ""].set_index("quantity")
    assert sorted(noted.index) == sorted(found)
    for quantity, difference in found.items():
        assert f"differ by {difference:.2f}" in noted.loc[quantity, "note"]
        assert abs(difference - noted.loc[quantity, "value"]) > 0.2


def test_with_fewer_homes_missing_numbers_have_a_reason():
    lines = fill(made(with_homes(4)))
    line = lines.loc[("gist_without_color", "difference", "Home 6")]
    assert np.isnan(line["measured"])
    assert line["note"].startswith("the data set has only 4 homes")
    assert np.isfinite(lines.loc[("gist_without_color", "difference", "Average"), "measured"])
    assert lines["note"][lines["measured"].isna()].str.len().min() > 0


def test_averages_use_only_homes_with_both_sides():
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
        "mean over only Home 1, Home 2, Home 3, Home 4, Home 5"
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
        (
            {"flat_kmeans": {"variant": {"quantity": "x", "result": "trials/x/"}}},
            "no result's name begins with trials/x/",
        ),
        ({"extra_das_data": {"variant": {"quantity": "x", "result": "x"}}}, "result 'x' does not exist"),
        ({"nu_in_force": {"record": "mu"}}, "no record 'mu'"),
        (
            {"nu_in_force": {"values": [{"quantity": "x", "column": "nu"}]}},
            "in_text.nu_in_force: the record has no column 'nu'",
        ),
        (
            {"nu_in_force": {"values": [{"quantity": "x", "column": "lowest"}]}},
            "has 3 rows for 'x': add pick",
        ),
        (
            {"colour_knn": {"pairs": {"x": ["trials/none/|*|", "x"]}}},
            r"no result matches 'trials/none/\|\*\|'",
        ),
        ({"new": {"reference": "x"}}, "an entry 'new' that is not among the published numbers"),
    ],
)
def test_invalid_entries_are_rejected(change, message):
    entries = {name: entry | change.get(name, {}) for name, entry in (change | ENTRIES).items()}
    with pytest.raises(PlacecatError, match=message):
        fill(entries=entries)


def test_a_published_number_without_an_entry_is_an_error():
    with pytest.raises(PlacecatError, match="number 'wu_sift' has no entry"):
        fill(entries={name: entry for name, entry in ENTRIES.items() if name != "wu_sift"})
