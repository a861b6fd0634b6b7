"""The stage `tables` on random results."""

import numpy as np
import pandas as pd
import pytest

from made_results import PARAMS, ROOT, made, write_scores
from placecat import files, paths, settings
from placecat.stages import tables
from placecat.thesis import definitions
from placecat.thesis.tables import tables_of
from placecat.training import fold_file
from project import contents

LOST = ("trials/table_04/First-Order Dependency Tree||991", "home_1")


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    """A folder in which the stage has run."""
    folder = tmp_path_factory.mktemp("run")
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        prepare(folder)
        tables.main()
    return folder


def shown(kind):
    """Return the definitions of the metrics or plots that DVC compares."""
    return settings.load(ROOT / f"data/thesis/{kind}.yaml")


def prepare(folder):
    """Write the inputs of the stage."""
    (folder / "data").mkdir()
    (folder / "data/thesis").symlink_to(ROOT / "data/thesis")
    (folder / "conf").symlink_to(ROOT / "conf")
    paths.PARAMS.write_text((ROOT / "params.yaml").read_text())
    results = made()
    del results.measured[LOST[0]]
    write_scores(paths.SCORES, results, [(LOST[0], home, "too few frames") for home in ("home_1", "home_6")])
    for home in PARAMS["dataset"]["homes"]:
        nu = {"nu": [0.2, 0.2, 0.175 if home == "home_2" else 0.2]}
        fold_file.write(fold_file.path_of(paths.CUES / "gist/5-5-1", home, paths.NO_SEED), {}, nu)
        # The second frame is the least informative one and has no label.
        labels = pd.DataFrame({"label": "x", "class": [0, -1, 1, 2]})
        files.write_csv(paths.sequences(home) / "labels.csv", labels)
        information = np.array([0.09, 0.01, 0.05, 0.3], np.float32)
        files.write_array(paths.features(home) / "information.npy", information)
    trials = [
        ("trials/table_03/gamma=1.0||0.2", "home_6", "no-seed", 0.15625, 0.2),
        ("trials/table_03/gamma=1.0||0.01", "home_6", "no-seed", 0.01, 0.01),
        ("trials/table_01/||46", "home_1", "seed-0", "", ""),
    ]
    facts = pd.DataFrame(trials, columns=["trial", "home", "seed", "nu_lowest", "nu_highest"])
    files.write_csv(paths.TRIALS / "gist/facts.csv", facts)


@pytest.mark.slow
def test_every_table_is_written_in_three_formats_with_all_other_reports(run):
    names = set(tables_of(PARAMS, ROOT))
    assert {f"table_{number:02d}" for number in range(1, 32)} < names
    written = {path.name for path in (run / paths.TABLES).iterdir()}
    assert written == {f"{name}.{ending}" for name in names for ending in ("csv", "md", "tex")}
    for path in (
        paths.ACCURACIES,
        paths.PROBABILITIES,
        paths.IN_TEXT,
        paths.METRICS,
        paths.SUMMARY,
    ):
        assert (run / path).stat().st_size > 0
    plots = {path.relative_to(run / paths.PLOTS).as_posix() for path in (run / paths.PLOTS).rglob("*.csv")}
    assert plots == {f"{kind}/{panel}.csv" for kind, panels in shown("plots").items() for panel in panels}


def test_no_cell_of_any_table_is_empty_without_a_reason(run):
    for path in sorted((run / paths.TABLES).glob("*.csv")):
        table = pd.read_csv(path, keep_default_na=False)
        assert (table["note"] != "").all()
        lost = table[table["measured"] == ""]
        assert (lost["note"].str.startswith("too few frames")).all()
        assert len(lost) == (3 if path.stem == "table_04" else 0)


def test_numbers_other_than_accuracies_come_from_records(run):
    lines = pd.read_csv(run / paths.IN_TEXT).set_index(["name", "quantity"])["measured"]
    assert lines["nu_in_force"].to_dict() == {"lowest nu in force": 0.15625, "highest nu in force": 0.2}
    assert sorted(lines["uninformative_views"]) == [0.05, 0.09]
    # The files in git are missing.
    assert lines[["processing_rate", "test_cycle", "svm_training"]].isna().all()


def test_the_quality_of_probabilities_is_in_a_table_and_the_summary(run):
    table = pd.read_csv(run / paths.PROBABILITIES)
    quality = made().quality
    assert table["result"].tolist() == list(quality)
    log_loss = dict(zip(table["result"], table["log_loss"], strict=True))
    for name, one in quality.items():
        assert log_loss[name] == pytest.approx(one.values["log_loss"].mean(), abs=0.0006)
    chosen = shown("metrics")["log_loss"]
    assert len(chosen) == 2
    summary = files.read_json(run / paths.SUMMARY)
    assert summary["log_loss"] == {column: log_loss[name] for column, name in chosen.items()}
    assert set(summary) == {"log_loss", *shown("metrics")["accuracy"]}


@pytest.mark.slow
def test_a_second_run_writes_the_same_bytes_and_keeps_optional_tables(run, monkeypatch):
    """The same scores produce the same bytes; a table without settings is removed."""
    monkeypatch.chdir(run)
    (name,) = definitions.optional()
    first = contents(run, "reports")
    assert len(first) > 100
    kept = {f"{name}.csv": "table,note\nAddition,kept\n", f"{name}.md": "# kept\n", f"{name}.tex": "kept\n"}
    (paths.TABLES / "table_99.csv").write_text("gone\n")
    for file, text in kept.items():
        (paths.OPTIONAL_TABLES / file).write_text(text)
    tables.main()
    found = contents(run, "reports")
    for file in kept:
        (paths.OPTIONAL_TABLES / file).unlink()
    assert found == first | {f"reports/optional_tables/{file}": text.encode() for file, text in kept.items()}
