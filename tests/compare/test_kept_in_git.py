"""Tables in a folder, compared with those in a real git repository."""

import shutil
from pathlib import Path

import pandas as pd
import pytest
import yaml

from placecat import files, paths
from placecat.compare import kept_in_git
from placecat.errors import PlacecatError
from project import run

SETTINGS = {
    "dataset": {"title": "made homes"},
    "cues": {"gist": {"nu": 0.2, "gamma": 2.0}},
    "reproducibility": {"tolerance": 2.0},
}


def write_tables(*numbers):
    for table, number in enumerate(numbers, start=1):
        filled = pd.DataFrame(
            {
                "table": table,
                "group": "",
                "row": ["SVM", "KNN"],
                "column": "Home 1",
                "published": 30.0,
                "measured": [number, 25.0],
                "spread": [0.5, None],
                "seeds": [2, 0],
                "note": "measured on made homes",
            }
        )
        files.write_csv(paths.TABLES / f"table_{table:02d}.csv", filled)
        files.write_text(paths.TABLES / f"table_{table:02d}.md", "no table\n")
    in_text = filled.drop(columns=["table", "group"]).assign(name="gist")
    files.write_text(paths.IN_TEXT_DEFINITIONS, "gist: {}\n")
    files.write_csv(paths.IN_TEXT, in_text.assign(measured=[number + 1, 24.0]))
    verdict = "holds" if numbers[0] > 30 else "does not hold"
    files.write_csv(paths.FINDINGS, pd.DataFrame({"number": [1, 2], "verdict": [verdict, "undecided"]}))


def write_settings(**changed):
    files.write_text(paths.PARAMS, yaml.safe_dump(SETTINGS | changed))


def commit(folder):
    run(folder, "git", "add", "-A")
    run(folder, "git", "-c", "user.name=a", "-c", "user.email=a@b", "commit", "-q", "-m", "tables")


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A project in a subfolder of a repository; HEAD has two tables and their files."""
    project = tmp_path / "project"
    project.mkdir()
    monkeypatch.chdir(project)
    for name in ("GIT_DIR", "GIT_WORK_TREE", "GIT_INDEX_FILE"):
        monkeypatch.delenv(name, raising=False)
    write_settings()
    write_tables(31.2, 40.0)
    run(tmp_path, "git", "init", "-q")
    commit(tmp_path)
    return project


def test_an_unchanged_run_agrees(folder):
    assert kept_in_git.compare("HEAD") == (
        [
            "Tables: 6 of 6 cells match the old ones (git HEAD).",
            "Findings: 2 of 2 verdicts match the old ones.",
        ],
        True,
    )


def test_a_change_within_the_tolerance_agrees(folder):
    write_tables(29.7, 40.0)
    lines, is_as_kept = kept_in_git.compare("HEAD")
    assert is_as_kept
    assert lines[0].startswith(
        "Tables: 5 of 6 cells match the old ones (git HEAD); largest difference 1.50 points in Table 1 "
        "(SVM, Home 1), within the tolerance"
    )
    assert lines[-1].endswith(
        "1 of 2 verdicts match the old ones; finding 1 was 'holds' and is now 'does not hold'."
    )


def test_the_tolerance_is_a_setting(folder):
    write_tables(29.7, 40.0)
    write_settings(reproducibility={"tolerance": 1.4})
    lines, is_as_kept = kept_in_git.compare("HEAD")
    assert not is_as_kept
    assert "beyond the tolerance of 1.4 points" in lines[0]
    assert "Settings differ" not in " ".join(lines)


def test_changed_settings_explain_any_difference(folder):
    write_tables(29.7, 10.0)
    write_settings(cues={"gist": {"nu": 0.1, "gamma": 2.0}}, compute={"kind": "dask"})
    lines, is_as_kept = kept_in_git.compare("HEAD")
    assert is_as_kept
    assert lines[-1] == "Settings differ: cues.gist.nu. Expect differences."


def test_a_missing_table_is_a_disagreement(folder):
    (paths.TABLES / "table_01.csv").unlink()
    lines, is_as_kept = kept_in_git.compare("HEAD")
    assert not is_as_kept
    assert "; 2 lost a number." in lines[0]


def test_an_older_revision_can_be_compared(folder):
    write_tables(35.0, 40.0)
    commit(folder)
    assert kept_in_git.compare("HEAD")[0][0] == "Tables: 6 of 6 cells match the old ones (git HEAD)."
    lines, is_as_kept = kept_in_git.compare("HEAD~1")
    assert not is_as_kept
    assert "largest difference 3.80 points in Table 1" in lines[0]
    assert "(git HEAD~1)" in lines[0]


def test_tables_on_other_data_are_not_compared(folder):
    write_tables(80.0, 90.0)
    write_settings(dataset={"title": "my homes; second floor"})
    assert kept_in_git.compare("HEAD") == (
        [
            "Tables are not compared: the old ones (git HEAD) were measured on made homes, the new "
            "ones on my homes; second floor.",
        ],
        True,
    )


@pytest.mark.parametrize("revision", ["nowhere", "HEAD~1", "--all", "HEAD:project/params.yaml", ""])
def test_an_unknown_revision_is_an_error(folder, revision):
    with pytest.raises(
        PlacecatError, match=f"git has no revision {revision!r}: `git log --oneline` lists the existing ones$"
    ):
        kept_in_git.read_revision(revision)


def test_a_revision_without_tables_is_an_error(folder):
    shutil.rmtree(paths.TABLES)
    commit(folder)
    with pytest.raises(PlacecatError, match="git HEAD has no tables in reports/tables: use a revision"):
        kept_in_git.read_revision("HEAD")


def test_a_folder_without_tables_is_an_error(folder):
    shutil.rmtree(paths.TABLES)
    with pytest.raises(PlacecatError, match="reports/tables has no tables: run `placecat repro`"):
        kept_in_git.compare("HEAD")


def test_a_missing_repository_is_an_error(folder):
    shutil.rmtree(Path("../.git"))
    with pytest.raises(PlacecatError, match="this folder is not in a git repository"):
        kept_in_git.compare("HEAD")


def test_missing_git_is_an_error(folder, monkeypatch):
    monkeypatch.setenv("PATH", "")
    with pytest.raises(PlacecatError, match="git is not installed"):
        kept_in_git.compare("HEAD")


def test_only_runs_that_make_an_optional_table_compare_it(folder):
    """A run that does not make the table leaves the one in git unchanged and does not mention it."""
    for number, needs in ((1, ""), (2, "needs: cues.embedding\n")):
        definition = paths.TABLE_DEFINITIONS / f"table_{number:02d}.yaml"
        files.write_text(definition, f"number: {number}\n{needs}")
    commit(folder)
    said, _ = kept_in_git.compare("HEAD")
    assert said[0] == "Tables: 4 of 4 cells match the old ones (git HEAD)."
    (paths.TABLES / "table_02.csv").unlink()
    assert kept_in_git.compare("HEAD") == (said, True)
    write_tables(31.2, 45.0)
    write_settings(cues=SETTINGS["cues"] | {"embedding": {}})
    said, _ = kept_in_git.compare("HEAD")
    assert said[0].startswith("Tables: 4 of 6 cells match")
    assert "  Table 2: 1 of 2 cells differ, by at most 5.00 points" in said


def test_two_revisions_or_folders_can_be_compared(folder, tmp_path):
    first = kept_in_git.compare("HEAD")
    write_tables(35.0, 40.0)
    commit(folder)
    other = tmp_path / "other"
    shutil.copytree(folder, other)
    by_revision = kept_in_git.compare("HEAD~1", "HEAD")
    assert by_revision[0][0].startswith("Tables: 5 of 6 cells match the old ones (git HEAD~1); largest")
    assert kept_in_git.compare("HEAD~1", str(other)) == by_revision
    assert kept_in_git.compare(str(other))[0][0].endswith(f"old ones (the folder {other}).")
    assert kept_in_git.compare("HEAD~1", "HEAD~1") == (
        [first[0][0].replace("HEAD", "HEAD~1"), first[0][1]],
        True,
    )
