"""The command explains why it fails."""

import subprocess
import sys

import pytest

from placecat.errors import PlacecatError
from placecat_homes import __main__ as command
from placecat_homes import render
from project import ROOT, environment


def test_the_settings_of_every_video_exist():
    for name, video in render.listed().items():
        for kind in ("plan", "walk", "carriage", "camera"):
            assert (render.SETTINGS / f"{kind}/{video[kind]}.yaml").is_file(), name


def test_an_unknown_video_raises_an_error():
    with pytest.raises(PlacecatError, match=r"there is no video 'homes/home_7': choose from homes"):
        render.render(["homes/home_7"])


def test_running_outside_the_project_raises_an_error(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(PlacecatError, match=r"conf/dataset/homes.yaml is missing: run this command"):
        render.render(["homes/home_1"])
    assert not list(tmp_path.iterdir())


def test_the_command_ends_with_a_message(monkeypatch, capsys):
    with pytest.raises(SystemExit) as ended:
        command.main(["homes/home_7"])
    assert str(ended.value).startswith("placecat: there is no video 'homes/home_7': choose from")
    with pytest.raises(SystemExit) as ended:
        command.main(["--help"])
    assert ended.value.code == 0
    assert "homes/home_1" in capsys.readouterr().out


def test_an_unknown_setting_raises_an_error():
    pytest.importorskip("embreex", reason="rendering needs the optional extra")
    with pytest.raises(PlacecatError, match=r"finish.yaml has no setting 'edges'; did you mean 'edge'"):
        render.film("apartments/webcam", edges=0.1)


@pytest.mark.slow
def test_without_the_extra_a_message_says_what_to_install():
    script = (
        "import sys; sys.modules['embreex'] = None\n"
        "from placecat_homes.__main__ import main\n"
        "main(['apartments/webcam'])"
    )
    result = subprocess.run(
        [sys.executable, "-c", script],
        cwd=ROOT,
        env=environment(PLACECAT_WORKERS="1"),
        capture_output=True,
        text=True,
    )
    assert result.returncode == 1
    assert "pip install -e '.[render]'" in result.stderr
    assert "Traceback" not in result.stderr


def test_labels_are_written_as_runs_of_frames(tmp_path):
    render._write_labels(tmp_path / "a.csv", ["kitchen", "kitchen", "transition", "kitchen"])
    assert (tmp_path / "a.csv").read_text() == ("start,end,label\n1,2,kitchen\n3,3,transition\n4,4,kitchen\n")
