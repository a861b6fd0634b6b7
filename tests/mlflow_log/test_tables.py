import multiprocessing
from collections import Counter
from contextlib import suppress
from dataclasses import replace
from functools import cache

import numpy as np
import pandas as pd
import pytest

import made_results
from placecat import files
from placecat.errors import PlacecatError
from placecat.experiment import output
from placecat.mlflow_log import store, tables
from placecat.mlflow_log.content import figures_run, table_run
from placecat.mlflow_log.tables import RowRun, TableRun, log_tables
from placecat.provenance.made import made
from placecat.report.charts.accuracy import bars_of
from placecat.results.confusion import shares
from placecat.thesis.decisions import decisions_of
from placecat.thesis.records import trials_of
from placecat.thesis.tables import dataset_of, fill_table, tables_of

pytestmark = [pytest.mark.slow, pytest.mark.xdist_group("mlflow")]


@pytest.fixture(scope="module")
def database(tmp_path_factory):
    """A database for all tests, since a new one takes a second; each test has its own experiment."""
    return tmp_path_factory.mktemp("mlflow")


@pytest.fixture
def log(database, request):
    """Return a function that logs two tables, one of which has two rows."""

    def write(folder):
        (folder / "table_05.csv").write_text("1")
        return [folder / "table_05.csv"]

    rows = [
        RowRun("SVM", {"row": "SVM", "protocol": "5-5-1"}, {"accuracy": 30.5}),
        RowRun("KNN", {"row": "KNN"}, {"accuracy": 29.0}),
    ]

    def log(content="30.5, 29.0", data_version="v1", commit="", both=True):
        run = TableRun(
            "table_05",
            "Table 5: Gist",
            content,
            {"cues.gist.classifier.base.nu": "0.2"},
            {"average/SVM": 30.5},
            "As *measured*: {run_id}",
            rows,
            write,
        )
        other = replace(run, name="table_06", title="Table 6: Other", content="never changes", rows=())
        return log_tables(
            [run, other] if both else [run],
            uri=f"sqlite:///{database / 'mlflow.db'}",
            experiment=request.node.name,
            description="All tables",
            data="test homes",
            data_version=data_version,
            commit=commit,
            artifacts=database / "artifacts",
        )

    return log


@pytest.fixture
def runs(database, request):
    client = store.connect(f"sqlite:///{database / 'mlflow.db'}")

    def runs(table="table_05", current=None):
        """Return the runs of a table and its rows; only finished runs count as current."""
        experiment = client.get_experiment_by_name(request.node.name)
        found = client.search_runs([experiment.experiment_id])
        return {
            run.info.run_id: run
            for run in found
            if run.data.tags["placecat.table"] == table
            and current
            in (None, (run.data.tags["placecat.current"], run.info.status) == ("true", "FINISHED"))
        }

    return runs


def names(found):
    return sorted(run.info.run_name for run in found.values())


def test_a_table_is_a_run_and_is_never_logged_twice(log, runs, database):
    first = log(commit="a" * 40)
    before = runs()
    # The same result from another commit is not a new result.
    assert log(commit="b" * 40) == first
    assert set(runs()) == set(before)
    (table,) = [run for run in before.values() if run.data.tags["placecat.kind"] == "table"]
    rows = [run for run in before.values() if run.data.tags["placecat.kind"] == "row"]
    assert names(runs(current=True)) == ["KNN", "SVM", "Table 5: Gist"]
    assert table.data.metrics == {"average/SVM": 30.5}
    assert table.data.params == {"cues.gist.classifier.base.nu": "0.2"}
    assert table.data.tags["data_version"] == "v1"
    assert table.data.tags["mlflow.source.git.commit"] == "a" * 40
    assert table.data.tags["mlflow.note.content"] == f"As *measured*: {table.info.run_id}"
    assert {run.data.tags["mlflow.parentRunId"] for run in rows} == {table.info.run_id}
    assert {run.info.run_name: run.data.tags.get("protocol") for run in rows} == {"SVM": "5-5-1", "KNN": None}
    assert table.data.tags["protocol"] == "5-5-1"
    assert {run.data.metrics["accuracy"] for run in rows} == {30.5, 29.0}
    assert len(list((database / "artifacts" / table.info.run_id).rglob("table_05.csv"))) == 1


def test_a_row_takes_three_calls(log, monkeypatch):
    """Each call takes several transactions; there is one more call for the description of a table."""
    from mlflow import MlflowClient

    log()
    calls = Counter()
    for name in ("create_run", "log_batch", "set_terminated", "set_tag", "get_run", "log_artifact"):
        original = getattr(MlflowClient, name)

        def counted(*arguments, name=name, original=original, **options):
            calls[name] += 1
            return original(*arguments, **options)

        monkeypatch.setattr(MlflowClient, name, counted)
    log("31.0, 29.0")
    # There are a table and two rows; the tags of the three superseded runs change.
    assert calls == {"create_run": 3, "log_batch": 3 + 1 + 3, "set_terminated": 3}


def test_a_changed_result_supersedes_and_leaves_others_alone(log, runs):
    log()
    first, other = runs(), set(runs("table_06"))
    log("31.0, 29.0")
    current = runs(current=True)
    assert names(current) == ["KNN", "SVM", "Table 5: Gist"]
    assert not set(current) & set(first)
    (table,) = [key for key, run in current.items() if run.data.tags["placecat.kind"] == "table"]
    for key in first:
        tags = runs()[key].data.tags
        assert tags["placecat.current"] == "false"
        assert tags["placecat.superseded_by"] == table
    assert set(runs("table_06")) == other
    # Logging the old result again makes a new run: superseded runs stay superseded.
    log()
    assert len(runs(current=True)) == 3
    assert len(runs()) == 9
    log(data_version="v2")
    assert len(runs(current=True)) == 3
    assert not set(runs("table_06", current=True)) & other


def test_a_removed_table_is_not_current(log, runs):
    log()
    log(both=False)
    assert runs("table_06", current=True) == {}
    assert len(runs(current=True)) == 3
    log()
    assert len(runs("table_06", current=True)) == 1


def _dying(original, calls, last, killed):
    def dying(*arguments, **named):
        if next(calls) >= last:
            killed.append(last)
            raise PlacecatError("killed")
        return original(*arguments, **named)

    return dying


def test_logging_recovers_from_a_kill_at_any_point(log, runs, monkeypatch):
    """Abort before each writing call in turn, and continue from the state at this point."""
    from mlflow import MlflowClient

    log()
    for last in range(1, 100):
        old, content, killed = set(runs(current=True)), f"31.0, {last}", []
        calls = iter(range(1, 1000))
        with monkeypatch.context() as patch:
            for name in ("create_run", "log_batch", "set_terminated"):
                patch.setattr(MlflowClient, name, _dying(getattr(MlflowClient, name), calls, last, killed))
            with suppress(PlacecatError):
                log(content)
        if not killed:
            break
        current = runs(current=True)
        # Current runs are all old or all new, so nothing appears twice.
        assert set(current) <= old or not set(current) & old
        assert len(set(names(current))) == len(current)
        if "Table 5: Gist" in names(current) and not set(current) <= old:
            assert len(current) == 3
        log(content)
        found = runs()
        assert names(runs(current=True)) == ["KNN", "SVM", "Table 5: Gist"]
        assert not set(runs(current=True)) & old
        # No incomplete runs are left.
        assert {run.info.status for run in found.values()} == {"FINISHED"}
        assert len(found) == 3 * (last + 1)
    # The runs of the table and its rows are created, filled and ended, then tags of old and new runs change.
    assert last > 8


@pytest.fixture(scope="module")
def results():
    return made_results.made()


def filled(name, results, params=made_results.PARAMS):
    table = tables_of(params, made_results.ROOT)[name]
    return table, fill_table(table, results, made_results.published(), dataset_of(table, params), {})


@cache
def how(result):
    return made(result, made_results.PARAMS, _trials())


@cache
def _trials():
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(made_results.ROOT)
        return trials_of(made_results.PARAMS)


def gathered(name, results):
    table, cells = filled(name, results)
    run = table_run(table, cells, results, dataset_of(table, made_results.PARAMS), {}, [], how)
    return run, cells


def test_a_row_has_numbers_by_home_and_a_confusion_matrix(results, tmp_path):
    run, cells = gathered("table_26", results)
    by_name = {row.name: row for row in run.rows}
    row = by_name["Table 26: 5-5-1, all cues, Gist"]
    good = results.quality["cues/gist/5-5-1"].averages()
    own = cells[(cells["group"] == "5-5-1, all cues") & (cells["row"] == "Gist")].set_index("column")[
        "measured"
    ]
    shown = {f"accuracy/home_{number}": own[f"Home {number}"] for number in range(1, 7)}
    assert row.metrics == shown | {"accuracy": own["Average"]} | good
    assert good.keys() == {"log_loss", "calibration_error", "stay_accuracy"}
    assert row.metrics.keys() >= set(output.MEASURES)
    for measure, value in good.items():
        assert run.metrics[f"{measure}/5-5-1 all cues/Gist"] == value
    assert run.metrics["accuracy/5-5-1 all cues/Gist"] == own["Average"]
    assert row.params["result"] == "cues/gist/5-5-1"
    assert row.description == "- `cues/gist/5-5-1`: the cue gist (Gist) trained alone, 5-5-1"
    paths = {path.name: path for path in row.files(tmp_path)}
    # MLflow lists images first.
    assert sorted(paths) == ["confusion.png", "counts.csv"]
    table = pd.read_csv(paths["counts.csv"])
    measured = results.of("cues/gist/5-5-1")
    for (home, truth), counts in table.groupby(["home", "truth"])[list(measured.classes)].sum().iterrows():
        h, i = measured.homes.index(home), measured.classes.index(truth)
        np.testing.assert_array_equal(counts, measured.confusion[:, h, i].sum(axis=0))


def test_measures_of_probabilities_are_logged_once(results, tmp_path):
    of_one, _ = gathered("table_06", results)
    name = tables_of(made_results.PARAMS, made_results.ROOT)["table_06"]["result"]
    good = results.quality[name].averages()
    assert {measure: of_one.metrics[measure] for measure in good} == good
    assert not any(good.keys() & row.metrics.keys() for row in of_one.rows)
    run, cells = gathered("addition_probabilities", results)
    row = next(one for one in run.rows if one.params["result"] == "smoothing/das_551_best")
    expected = results.quality["smoothing/das_551_best"].averages()
    assert row.metrics == pytest.approx(expected, abs=0.0051)
    assert len(run.metrics) == len(cells) == 3 * len(run.rows)
    # There is no chart, because it would mix nats and percent, but the units are named.
    assert "chart.png" not in {path.name for path in run.files(tmp_path)}
    assert "chart.png" not in run.description and "accuracy in percent" not in run.description
    assert "Log loss is in nats" in run.description


def test_all_figures_share_one_run(tmp_path):
    entries = [
        {"name": "figure_02", "number": 2, "file": "figure_02.png", "title": "Two.", "reason": None},
        {"name": "figure_20", "number": 20, "file": None, "title": "Twenty.", "reason": "no such data"},
        {"name": "figure_reliability", "number": None, "file": "figure_reliability.png", "title": "Sure."}
        | {"reason": None},
    ]
    files.write_json(tmp_path / "figures.json", entries)
    for name in ("figure_02", "figure_reliability"):
        (tmp_path / f"{name}.png").write_bytes(name.encode())
    run = figures_run(tmp_path)
    assert [path.name for path in run.files(tmp_path)] == ["figure_02.png", "figure_reliability.png"]
    assert run.metrics == {"drawn": 2, "left_out": 1}
    lines = run.description.splitlines()[-3:]
    assert lines == [
        "- **Figure 2.** Two.",
        "- **Figure 20.** Left out: no such data",
        "- **Addition.** Sure.",
    ]
    first = run.digest("v1")
    (tmp_path / "figure_reliability.png").write_bytes(b"another")
    assert figures_run(tmp_path).digest("v1") != first


def test_a_description_has_only_measured_numbers(results):
    run, cells = gathered("table_26", results)
    assert "| Gist |" in run.description
    assert f"{cells['measured'].iloc[0]:.2f}" in run.description
    # Published numbers are from other data, so they are left out with their footnotes.
    assert "Published" not in run.description
    assert "the published" not in run.description
    assert len(run.description) < 8000 - 32


def test_the_digest_covers_decisions_and_probabilities(results):
    table, cells = filled("table_05", results)
    dataset = dataset_of(table, made_results.PARAMS)
    one = results.of("cues/gist/5-5-1")
    moved = one.confusion.copy()
    moved[0, 0, 0, [1, 2]] = moved[0, 0, 0, [2, 1]] + [1, -1]
    changed = replace(results, measured=results.measured | {"cues/gist/5-5-1": replace(one, confusion=moved)})
    good = results.quality["cues/gist/5-5-1"]
    surer = replace(good, values=good.values | {"log_loss": good.values["log_loss"] + 0.01})
    better = replace(results, quality=dict(results.quality) | {"cues/gist/5-5-1": surer})
    digests = {
        table_run(table, cells, each, dataset, {}, [], how).digest("v1")
        for each in (results, changed, better)
    }
    assert len(digests) == 3


@pytest.mark.parametrize("name", ["table_01", "table_12", "table_15", "table_22", "table_06", "table_30"])
def test_charts_and_confusion_matrices_match_every_kind_of_table(results, name):
    """The confusion matrix of a row, pooled if there are several, yields the accuracy in the table."""
    table, cells = filled(name, results)
    bars = bars_of(cells)
    assert bars
    assert {bar.measured for bar in bars} <= set(cells["measured"])
    decisions = decisions_of(table, results)
    assert set(decisions) == set(zip(cells["group"], cells["row"], strict=True))
    value = cells.set_index(["group", "row", "column"])["measured"]
    for (group, row), of_row in decisions.items():
        for column, one in of_row.items():
            one = one.pooled() if table["layout"] == "pooled_by_class" else one
            mean = one.by_home().mean()
            label = column or ("Average" if (group, row, "Average") in value.index else "Home 1")
            assert value[group, row, label] == pytest.approx(mean, abs=0.0051)


def test_pictures_have_the_same_bytes_each_time(results, tmp_path):
    run, _ = gathered("table_05", results)
    for number in (1, 2):
        folder = tmp_path / str(number)
        folder.mkdir()
        run.files(folder)
        (folder / "row").mkdir()
        run.rows[1].files(folder / "row")
    for path in (tmp_path / "1").rglob("*.png"):
        assert path.read_bytes() == (tmp_path / "2" / path.relative_to(tmp_path / "1")).read_bytes()
    assert len(list((tmp_path / "1").rglob("*.png"))) == 3


def test_rows_differ_in_their_choices(results):
    """MLflow can compare two cues, a cue and a system, or two neighbouring trials."""
    rows = {row.name: row.params for row in gathered("table_26", results)[0].rows}
    gist, hog, hmm = (rows[f"Table 26: 5-5-1, all cues, {name}"] for name in ("Gist", "HOG + y-Pos", "HMM"))
    assert (gist["decides"], gist["descriptor"], gist["classifier"]) == ("cue", "holistic gist", "nu_svm")
    assert (hog["descriptor"], hog["classifier"], hog["clusters"]) == ("local hog", "naive_bayes", "196")
    assert gist["scheme"] == "parallel" and gist["nu"] == "0.2"
    assert hmm["decides"] == "delayed HMM" and "gist" in hmm["cues"].split(", ")
    assert gist["protocol"] == "5-5-1" != rows["Table 26: 4-5-1, all cues, Gist"]["protocol"]
    # A row with several trials lists the values of all of them.
    (first, *_) = gathered("table_12", results)[0].rows
    assert first.params["clusters"] == "46, 196, 496"
    assert first.params["classifier"] == "knn"


@pytest.mark.parametrize("name", ["table_14", "table_30", "addition_filter", "addition_toy"])
def test_rows_of_every_kind_of_table_differ_in_name_and_parameters(results, name):
    rows = gathered(name, results)[0].rows
    labels = ("group", "row", "result")
    shown = [{key: row.params[key] for key in row.params if key not in labels} for row in rows]
    assert len({row.name for row in rows}) == len({repr(one) for one in shown}) == len(rows)
    assert all(one["decides"] for one in shown)


def test_a_place_without_frames_has_no_shares():
    np.testing.assert_array_equal(shares(np.array([[1, 3], [0, 0]])), [[25, 75], [np.nan, np.nan]])


def test_runs_in_a_new_format_are_logged_again(log, monkeypatch):
    first = log()
    monkeypatch.setattr(tables, "_FORM", "next")
    assert log() != first


def test_one_table_stays_current_if_another_machine_logs_too(log, runs, monkeypatch):
    """The other machine starts and finishes within each step of this one."""
    log("30.0, 29.0")
    for number, step in enumerate(("start_run", "finish_run", "_make_current", "_supersede")):
        owner = tables if step.startswith("_") else store
        original, state = getattr(owner, step), {"is_due": True}

        def interleaved(*arguments, original=original, state=state, number=number, **options):
            done = original(*arguments, **options)
            if state.pop("is_due", False):
                with monkeypatch.context() as patch:
                    patch.setattr(tables.platform, "node", lambda: "another machine")
                    log(f"31.{number}, 29.0")
            return done

        with monkeypatch.context() as patch:
            patch.setattr(owner, step, interleaved)
            log(f"32.{number}, 29.0")
        assert not state
        assert names(runs(current=True)) == ["KNN", "SVM", "Table 5: Gist"]
        current = set(runs(current=True))
        log(f"33.{number}, 29.0")
        assert names(runs(current=True)) == ["KNN", "SVM", "Table 5: Gist"]
        assert not current & set(runs(current=True))


def _log_content(log, number, start, failures):
    try:
        start.wait()
        log(f"3{number}.0, 29.0")
    except BaseException as error:
        failures.put(repr(error))


def test_four_processes_that_log_at_once_leave_one_table_current(log, runs):
    log()
    context = multiprocessing.get_context("fork")
    start, failures = context.Barrier(4), context.SimpleQueue()
    processes = [
        context.Process(target=_log_content, args=(log, number, start, failures)) for number in range(4)
    ]
    for process in processes:
        process.start()
    for process in processes:
        process.join(120)
    assert failures.empty()
    assert names(runs(current=True)) == ["KNN", "SVM", "Table 5: Gist"]
    assert names(runs("table_06", current=True)) == ["Table 6: Other"]
