"""The command explains why it fails."""

import subprocess
import sys

import pytest

from placecat.errors import PlacecatError
from placecat_homes import __main__ as command
from placecat_homes import render
from project import ROOT, environment


def test_every_video_names_settings_that_exist():
    for name, video in render.listed().items():
        for kind in ("plan", "walk", "carriage", "camera"):
            assert (render.SETTINGS / f"{kind}/{video[kind]}.yaml").is_file(), name


def test_an_unknown_video_is_refused():
    with pytest.raises(PlacecatError, match=r"no video has the name 'homes/home_7': choose from homes"):
        render.render(["homes/home_7"])


def test_another_folder_than_the_projects_is_refused(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(PlacecatError, match=r"conf/dataset/homes.yaml is missing: run this command"):
        render.render(["homes/home_1"])
    assert not list(tmp_path.iterdir())


def test_the_command_ends_with_a_message(monkeypatch, capsys):
    with pytest.raises(SystemExit) as ended:
        command.main(["homes/home_7"])
    assert str(ended.value).startswith("placecat: no video has the name 'homes/home_7': choose from")
    with pytest.raises(SystemExit) as ended:
        command.main(["--help"])
    assert ended.value.code == 0
    assert "homes/home_1" in capsys.readouterr().out


def test_an_unknown_setting_is_refused():
    pytest.importorskip("embreex", reason="rendering needs the optional extra")
    with pytest.raises(PlacecatError, match=r"finish.yaml has no setting 'edges'; did you mean 'edge'"):
        render.film("apartments/webcam", edges=0.1)


@pytest.mark.slow
def test_without_the_extra_one_line_says_what_to_install():
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
