"""The command `placecat replicate`: groups of homes are run one by one and judged together."""

import numpy as np
import pytest
from made_groups import HOMES, OVERRIDES, make_project, make_stage

import made_results
from placecat import files, paths
from placecat.errors import PlacecatError
from placecat.replication import command, groups

FILES = ("findings.csv", "findings_comparisons.csv", "accuracies.csv", "power.csv", "facts.json")

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def finished(tmp_path_factory):
    """A project after an uninterrupted run, the stages that ran, and the printed text."""
    folder, ran = tmp_path_factory.mktemp("replicated"), []
    with pytest.MonkeyPatch.context() as patch:
        make_project(folder)
        patch.chdir(folder)
        patch.setattr(groups, "_run_stage", make_stage(ran))
        said = command.run(OVERRIDES)
    return folder, ran, said


def contents(folder):
    return {
        path.relative_to(folder).as_posix(): path.read_bytes()
        for path in sorted((folder / paths.REPLICATION).rglob("*"))
        if path.is_file()
    }


def test_every_group_runs_every_stage_and_the_ledger_covers_all_homes(finished):
    folder, ran, said = finished
    assert ran == [(f"group_{number}", stage) for number in (1, 2) for stage in groups.STAGES]
    assert "34 findings on 12 homes" in said
    names = {path.name for path in (folder / paths.REPLICATION).iterdir()}
    assert names == {*FILES, "group_1", "group_2"}
    facts = files.read_json(folder / paths.REPLICATION / "facts.json")
    assert (facts["homes"], facts["groups"], facts["level"]) == (12, 2, 0.98)
    assert sum(facts["verdicts"].values()) == 34


def test_the_ledger_counts_the_homes_of_both_groups_once(finished):
    folder, _, _ = finished
    findings = files.read_table(folder / paths.REPLICATION / "findings.csv").set_index("number")
    assert findings.loc[7, "units"] == "12 homes"
    # Table 3 only tests the first and the fifth home of a group.
    assert findings.loc[3, "units"] == "4 homes"
    first, second = (made_results.made(made_results.with_homes(6) | _of(part), drawn=part) for part in (1, 2))
    gains = [
        one.of("cues/gist_naive_bayes/5-5-1").by_home().mean(axis=0)
        - one.of("trials/gist_without_center_surround/||").by_home().mean(axis=0)
        for one in (first, second)
    ]
    assert float(findings.loc[7, "difference"]) == pytest.approx(np.concatenate(gains).mean(), abs=0.006)


def _of(part):
    homes = HOMES[6 * (part - 1) : 6 * part]
    return {"dataset": made_results.PARAMS["dataset"] | {"homes": homes}}


def test_findings_on_other_data_come_from_the_ledger_of_six_homes(finished):
    folder, _, _ = finished
    old, new = (
        files.read_table(path).set_index("number")
        for path in (folder / paths.FINDINGS, folder / paths.REPLICATION / "findings.csv")
    )
    assert new.index[~new["replicated"]].tolist() == [27, 28, 29]
    for number in (27, 28, 29):
        assert new.loc[number, old.columns].astype(str).tolist() == old.loc[number].astype(str).tolist()
    assert new.loc[26, "units"] == "12 homes" != old.loc[26, "units"]


def test_accuracies_are_means_over_homes(finished):
    folder, _, _ = finished
    table = files.read_table(folder / paths.REPLICATION / "accuracies.csv").set_index("result")
    homes = np.concatenate(
        [
            made_results.made(
                _of(part) | {k: v for k, v in made_results.PARAMS.items() if k != "dataset"}, drawn=part
            )
            .of("integration/das_551_all")
            .by_home()
            .mean(axis=0)
            for part in (1, 2)
        ]
    )
    row = table.loc["integration/das_551_all"]
    assert row["homes"] == 12
    assert float(row["accuracy"]) == pytest.approx(homes.mean(), abs=0.006)
    assert float(row["deviation"]) == pytest.approx(homes.std(ddof=1), abs=0.006)
    assert not table.index.str.startswith(("splits/", "toy/")).any()


def test_nothing_runs_again_until_something_changes(finished, monkeypatch):
    folder, _, said = finished
    monkeypatch.chdir(folder)
    ran, before = [], contents(folder)
    monkeypatch.setattr(groups, "_run_stage", make_stage(ran))
    assert command.run(OVERRIDES) == said
    assert ran == [] and contents(folder) == before
    (paths.REPLICATION / "group_2" / "tables.csv").write_text("damaged")
    command.run(OVERRIDES)
    assert {name for name, _ in ran} == {"group_2"} and contents(folder) == before


def test_a_killed_run_resumes_and_produces_the_same_bytes(finished, tmp_path, monkeypatch):
    make_project(tmp_path)
    monkeypatch.chdir(tmp_path)
    ran = []
    monkeypatch.setattr(groups, "_run_stage", make_stage(ran, fails_at=("group_2", "tables")))
    with pytest.raises(KeyboardInterrupt):
        command.run(OVERRIDES)
    assert {path.name for path in paths.REPLICATION.iterdir()} == {"group_1"}
    ran.clear()
    monkeypatch.setattr(groups, "_run_stage", make_stage(ran))
    command.run(OVERRIDES)
    assert {name for name, _ in ran} == {"group_2"}
    assert contents(tmp_path) == contents(finished[0])


def test_groups_can_run_one_by_one(finished, tmp_path, monkeypatch):
    make_project(tmp_path)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(groups, "_run_stage", make_stage([]))
    assert "--groups 1" in command.run(OVERRIDES, [2])
    command.run(OVERRIDES, [1])
    assert contents(tmp_path) == contents(finished[0])
    with pytest.raises(PlacecatError, match="other homes or settings"):
        command.run([*OVERRIDES, "cues.gist.classifier.base.nu=0.1"], [1])


def test_user_errors(tmp_path, monkeypatch):
    make_project(tmp_path)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(groups, "_run_stage", make_stage([]))
    with pytest.raises(PlacecatError, match=r"6 homes.*two groups"):
        command.run([])
    with pytest.raises(PlacecatError, match="group 3 does not exist"):
        command.run(OVERRIDES, [3])
    paths.TOY.unlink()
    with pytest.raises(PlacecatError, match=r"toy.csv.*make repro"):
        command.run(OVERRIDES)
    assert not paths.REPLICATION.exists()


def test_a_real_stage_fails_with_a_message(tmp_path, monkeypatch):
    """The stage runs in a separate process and fails, because the folder has no videos."""
    make_project(tmp_path)
    monkeypatch.chdir(tmp_path)
    with pytest.raises(PlacecatError, match="the stage sequences failed"):
        command.run(OVERRIDES)
