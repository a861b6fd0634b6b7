"""What every stage does before and after its work, shown with an artificial stage."""

import json

import pytest

from project import run

STAGE = """
import os
import time

from placecat.errors import PlacecatError
from placecat.stages import run


def main() -> None:
    \"\"\"Take a moment.\"\"\"
    time.sleep(0.3)
    home = os.environ.get("ITS_HOME")
    if home == "nowhere":
        raise PlacecatError("there is no such home")
    if home == "broken":
        raise ZeroDivisionError


if __name__ == "__main__":
    run(main)
"""


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "features.py").write_text(STAGE)
    return tmp_path


def test_a_stage_records_its_wall_time(folder):
    run(folder, "python", "features.py", PLACECAT_CALL="abc")
    (path,) = (folder / "data/times").iterdir()
    assert path.name == "features.json"
    content = json.loads(path.read_text())
    assert 0.3 <= content.pop("seconds") < 60
    assert content == {"call": "abc", "runs": 1, "stage": "features"}


def test_a_stage_run_by_hand_belongs_to_no_call(folder):
    run(folder, "python", "features.py", PLACECAT_CALL="")
    assert json.loads((folder / "data/times/features.json").read_text())["call"] == ""


@pytest.mark.parametrize("home", ["nowhere", "broken"])
def test_a_stage_that_fails_records_nothing(folder, home):
    result = run(folder, "python", "features.py", check=False, ITS_HOME=home)
    assert result.returncode == 1
    assert ("Traceback" in result.stderr) is (home == "broken")
    assert not (folder / "data").exists()


def test_a_stage_rejects_invalid_settings(folder):
    """Settings from any source are checked, since `dvc exp run` and editors do not check them."""
    (folder / "params.yaml").write_text("protocol: {seeds: []}\nsmoothing: {transition_counts: .nan}\n")
    result = run(folder, "python", "features.py", check=False)
    assert result.returncode == 1
    assert result.stderr.startswith("placecat: protocol")
    assert "Traceback" not in result.stderr
