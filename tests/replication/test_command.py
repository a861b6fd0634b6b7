"""`placecat replicate`: groups of homes, run one by one, judged together."""

import numpy as np
import pandas as pd
import pytest
from made_groups import HOMES, OVERRIDES, make_project, make_stage

import made_results
from placecat import files, paths
from placecat.errors import PlacecatError
from placecat.evaluation.verdict import HOLDS
from placecat.replication import command, group_results, groups

FILES = ("findings.csv", "findings_comparisons.csv", "accuracies.csv", "power.csv", "facts.json")


@pytest.fixture(scope="module")
def finished(tmp_path_factory):
    """A project after an undisturbed run, and the stages that ran."""
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


def test_every_group_runs_every_stage_and_the_ledger_is_of_all_homes(finished):
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
    findings = files.read_csv(folder / paths.REPLICATION / "findings.csv").set_index("number")
    assert findings.loc[7, "units"] == "12 homes"
    # Table 3 tests on the first and the fifth home of a group.
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


def test_findings_on_other_data_are_those_of_the_six_homes(finished):
    folder, _, _ = finished
    old, new = (
        files.read_csv(path).set_index("number")
        for path in (folder / paths.FINDINGS, folder / paths.REPLICATION / "findings.csv")
    )
    for number in (27, 28, 29):
        assert new.loc[number, old.columns].astype(str).tolist() == old.loc[number].astype(str).tolist()
    assert new.loc[26, "units"] == "12 homes" != old.loc[26, "units"]


def test_accuracies_are_means_over_homes(finished):
    folder, _, _ = finished
    table = files.read_csv(folder / paths.REPLICATION / "accuracies.csv").set_index("result")
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


def test_a_killed_run_ends_in_the_same_bytes(finished, tmp_path, monkeypatch):
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


def test_mistakes(tmp_path, monkeypatch):
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


def test_homes_without_a_group_are_left():
    dataset = made_results.PARAMS["dataset"] | {"homes": [*HOMES, "attic"]}
    planned, rest = groups.split({"dataset": dataset}, 6)
    assert [group.homes for group in planned] == [tuple(HOMES[:6]), tuple(HOMES[6:])]
    assert rest == ("attic",)


def test_a_setting_with_a_value_for_each_home_keeps_those_of_the_group():
    dataset = made_results.PARAMS["dataset"] | {"homes": HOMES, "camera": {home: home[-1] for home in HOMES}}
    first, second = groups.split({"dataset": dataset}, 6)[0]
    assert list(second.params["dataset"]["camera"]) == list(second.homes) == HOMES[6:]
    assert first.params["dataset"]["aliases"] == {}


@pytest.mark.slow
def test_a_real_stage_fails_with_a_message(tmp_path, monkeypatch):
    """Through a process of its own: the folder has no videos."""
    make_project(tmp_path)
    monkeypatch.chdir(tmp_path)
    with pytest.raises(PlacecatError, match="the stage sequences failed"):
        command.run(OVERRIDES)


def test_a_clear_difference_holds_on_many_homes():
    """With 24 homes a difference of 5 points, which homes spread by 3, is decided."""
    from placecat.replication import options, pooling
    from placecat.thesis import definitions

    homes = [f"home_{number}" for number in range(1, 25)]
    params = made_results.PARAMS | {"dataset": made_results.PARAMS["dataset"] | {"homes": homes}}
    results = made_results.made(params)
    rng = np.random.default_rng(0)
    # Right frames of 100 a place.
    gained = rng.normal(5.0, 3.0, 24).round().astype(int)
    for name, right in (
        ("cues/gist_naive_bayes/5-5-1", 60 + gained),
        ("trials/gist_without_color/||", np.full(24, 60)),
    ):
        one = results.measured[name]
        one.confusion[:] = 0
        for home, count in enumerate(right):
            one.confusion[:, home] = np.eye(5, dtype=int) * count + np.roll(
                np.eye(5, dtype=int), 1, axis=1
            ) * (100 - count)
    findings = {"finding_06": definitions.findings(made_results.ROOT)["finding_06"]}
    findings["finding_06"] = findings["finding_06"] | {
        "comparisons": [one | {"range": "better"} for one in findings["finding_06"]["comparisons"]]
    }
    parts = [homes[first : first + 6] for first in range(0, 24, 6)]
    rows, details = pooling.judge(
        findings,
        made_results.PARAMS["verdict"],
        options.Options(6, 0.98, 0.1),
        results,
        made_published(),
        parts,
    )
    assert rows["verdict"].item() == HOLDS
    assert rows["difference"].item() == pytest.approx(gained.mean(), abs=0.006)
    assert details["shared"].item() == pytest.approx(_icc(gained.reshape(4, 6)), abs=0.006)


def _icc(table):
    """The intraclass correlation from scipy's analysis of variance: F = B / W."""
    from scipy import stats

    f = stats.f_oneway(*table).statistic
    return (f - 1.0) / (f + table.shape[1] - 1.0)


def made_published():
    from placecat.thesis.published import Published

    text = dict.fromkeys(("name", "section", "quantity", "home", "quote"), str)
    read = pd.read_csv(made_results.ROOT / "data/thesis/published_text.csv", dtype=text).fillna(
        dict.fromkeys(text, "")
    )
    return Published(made_results.published(), read)


def test_results_are_marked_as_of_homes_or_not():
    assert group_results.is_of_homes("trials/table_03/gamma=1.0||0.1")
    assert not group_results.is_of_homes("splits/university/hmm/five")
