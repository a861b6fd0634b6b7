import os

from project import run

MAIN = ("python", "-m", "placecat", "--help")


def test_a_package_hidden_by_pythonpath_is_reported_in_one_line(tmp_path):
    other = tmp_path / "other"
    (other / "cv2").mkdir(parents=True)
    (other / "cv2/__init__.py").write_text("raise ImportError")
    here = os.environ.get("PYTHONPATH", "")
    both = os.pathsep.join(filter(None, [here, str(other)]))
    for command in (MAIN, ("python", "-m", "placecat.stages.toy")):
        result = run(tmp_path, *command, check=False, PYTHONPATH=both)
        assert result.returncode == 1
        assert result.stderr.startswith("placecat: PYTHONPATH hides the installed cv2")
        assert result.stderr.endswith("unset PYTHONPATH\n")
    # Other packages of the user, and folders that only share a name, do no harm.
    (other / "cv2/__init__.py").unlink()
    (other / "mine").mkdir()
    (other / "mine/__init__.py").write_text("")
    assert run(tmp_path, *MAIN, PYTHONPATH=both).returncode == 0
