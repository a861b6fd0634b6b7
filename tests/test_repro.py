"""`placecat repro` before DVC begins."""

import shutil

import made_pipeline
import pytest

from placecat import repro
from placecat.errors import PlacecatError
from project import run


def test_a_folder_without_git_is_one_message(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / ".dvc").mkdir()
    (tmp_path / ".dvc/config").write_text("[core]\n    analytics = false\n")
    with pytest.raises(PlacecatError, match=r"not a git repository.*`git init`.*core\.no_scm true"):
        repro.run()


NO_GIT = ("dvc", "config", "--local", "core.no_scm", "true")


@pytest.mark.parametrize("remedy", [("git", "init", "-q"), NO_GIT])
@pytest.mark.slow
def test_either_remedy_helps(tmp_path, remedy):
    folder = made_pipeline.make(tmp_path / "project", names=("first",))
    shutil.rmtree(folder / ".git")
    run(folder, *remedy)
    run(folder, *made_pipeline.REPRO)
    assert (folder / "made/first/one.json").exists()
