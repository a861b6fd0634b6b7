"""What `placecat repro` does before DVC starts."""

import shutil

import made_pipeline
import pytest

from placecat import __main__
from placecat.errors import PlacecatError
from placecat.runs import repro
from project import run


def test_a_folder_without_git_is_reported_in_one_line(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / ".dvc").mkdir()
    (tmp_path / ".dvc/config").write_text("[core]\n    analytics = false\n")
    with pytest.raises(PlacecatError, match=r"not a git repository.*`git init`.*core\.no_scm true"):
        repro.run()


@pytest.mark.parametrize("before", [b"a: 1\n", None])
@pytest.mark.parametrize(
    ("status", "has_ended", "is_back"),
    [(1, False, True), (1, True, False), (None, False, True), (0, True, False)],
)
def test_a_rejected_run_restores_the_settings(tmp_path, monkeypatch, before, status, has_ended, is_back):
    """If `status` is None, the run fails before DVC starts. `has_ended` says whether a stage has ended."""
    monkeypatch.chdir(tmp_path)
    params, lock = tmp_path / "params.yaml", tmp_path / "dvc.lock"
    lock.write_text("records")
    if before is not None:
        params.write_bytes(before)

    def run(**_):
        assert params.read_text() == "a: 2\n"
        if status is None:
            raise PlacecatError("no git")
        if has_ended:
            lock.write_text("more records")
        return status

    monkeypatch.setattr(__main__, "write_params", lambda overrides: params.write_text("a: 2\n"))
    monkeypatch.setattr(__main__, "_measure", lambda *_: "")
    monkeypatch.setattr(repro, "run", run)
    if status == 0:
        __main__.main(["repro", "a=2"])
    else:
        with pytest.raises(SystemExit):
            __main__.main(["repro", "a=2"])
    after = params.read_bytes() if params.exists() else None
    assert after == (before if is_back else b"a: 2\n")


NO_GIT = ("dvc", "config", "--local", "core.no_scm", "true")


@pytest.mark.parametrize("remedy", [("git", "init", "-q"), NO_GIT])
@pytest.mark.slow
def test_either_remedy_helps(tmp_path, remedy):
    folder = made_pipeline.make(tmp_path / "project", names=("first",))
    shutil.rmtree(folder / ".git")
    run(folder, *remedy)
    run(folder, *made_pipeline.REPRO)
    assert (folder / "made/first/one.json").exists()
