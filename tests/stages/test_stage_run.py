"""What every stage does around its own work, with a stage of the test's."""

import json

import pytest

from project import run

STAGE = """
import time

from placecat.errors import PlacecatError
from placecat.stages import run


def main(home: str) -> None:
    \"\"\"Take a moment.\"\"\"
    time.sleep(0.3)
    if home == "nowhere":
        raise PlacecatError("there is no such home")
    if home == "broken":
        raise ZeroDivisionError


if __name__ == "__main__":
    run(main, item="home")
"""
WITHOUT_ITEM = (
    STAGE.replace("home: str", "*homes").replace("home ==", "'' ==").replace('item="home"', 'items="homes"')
)


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "features.py").write_text(STAGE)
    (tmp_path / "render.py").write_text(WITHOUT_ITEM)
    return tmp_path


def test_a_stage_records_its_wall_time(folder):
    run(folder, "python", "features.py", "home_1", PLACECAT_CALL="abc")
    (path,) = (folder / "data/times").iterdir()
    assert path.name == "features@home_1.json"
    content = json.loads(path.read_text())
    assert 0.3 <= content.pop("seconds") < 60
    assert content == {"call": "abc", "item": "home_1", "stage": "features"}


def test_a_stage_run_by_hand_is_of_no_call(folder):
    run(folder, "python", "render.py", "a", "b", PLACECAT_CALL="")
    content = json.loads((folder / "data/times/render.json").read_text())
    assert (content["call"], content["item"]) == ("", "")


@pytest.mark.parametrize("home", ["nowhere", "broken"])
def test_a_stage_that_fails_records_nothing(folder, home):
    result = run(folder, "python", "features.py", home, check=False)
    assert result.returncode == 1
    assert ("Traceback" in result.stderr) is (home == "broken")
    assert not (folder / "data").exists()
