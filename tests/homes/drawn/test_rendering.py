"""Rendering into a folder always creates the same bytes, even if it is killed at any point and restarted."""

import os
import signal
from types import SimpleNamespace

import numpy as np
import pytest
from filelock import FileLock

from placecat.errors import PlacecatError
from placecat.seeds import derive
from placecat_homes import __main__ as command
from placecat_homes.drawn import homes, rendering, top_view
from placecat_homes.drawn.homes import name_of
from placecat_homes.drawn.rendering import render_homes

pytest.importorskip("embreex", reason="rendering needs the optional extra")

pytestmark = pytest.mark.slow

LABELS = ["bedroom", "transition", "kitchen"]


class Died(BaseException):
    pass


@pytest.fixture
def small(monkeypatch):
    """Replace plans and films with fast ones. The dictionary maps (home, frame) to functions to call."""
    at = {}

    def draw(number, seed, source):
        at.pop((number, "plan"), lambda: None)()
        text = f"shot: {{name: {name_of(number, seed)}}}\nplan: {{}}\n"
        return SimpleNamespace(building=None, walk=None, text=lambda: text)

    def film(path, source):
        number = int(path.stem.rpartition("_")[2])

        def frames():
            for k in range(len(LABELS)):
                at.pop((number, k), lambda: None)()
                rng = np.random.default_rng(derive(path.read_text(), k))
                yield rng.integers(0, 255, (source.video.height, source.video.width, 3)).astype(np.uint8)

        return SimpleNamespace(frames=frames, labels=LABELS)

    monkeypatch.setenv("PLACECAT_WORKERS", "1")
    monkeypatch.setattr(homes, "draw", draw)
    monkeypatch.setattr(rendering, "film", film)
    monkeypatch.setattr(top_view, "top_view", lambda building, walk: np.zeros((8, 8, 3), np.uint8))
    return at


def make(folder, count=3, seed=1, **options):
    return render_homes(count, seed, folder, width=160, height=90, **options)


def content(folder):
    return {
        path.relative_to(folder).as_posix(): path.read_bytes()
        for path in folder.rglob("*")
        if path.is_file() and path.name != ".lock"
    }


def killed():
    os.kill(os.getpid(), signal.SIGKILL)


@pytest.mark.parametrize("where", [(2, "plan"), (1, 0), (2, 1), (3, 2)])
def test_a_killed_run_resumes_with_the_same_bytes(tmp_path, small, where):
    make(tmp_path / "whole")
    child = os.fork()
    if child == 0:
        small[where] = killed
        make(tmp_path / "killed")
        os._exit(0)
    assert os.waitpid(child, 0)[1] == signal.SIGKILL
    assert content(tmp_path / "killed").keys() != content(tmp_path / "whole").keys()
    kept = {path: path.stat().st_mtime_ns for path in (tmp_path / "killed").glob("*.mp4")}
    make(tmp_path / "killed")
    assert content(tmp_path / "killed") == content(tmp_path / "whole")
    assert all(path.stat().st_mtime_ns == made for path, made in kept.items())


def test_an_error_leaves_no_partial_home(tmp_path, small):
    def fail():
        raise Died

    small[2, 1] = fail
    with pytest.raises(Died):
        make(tmp_path)
    assert [path.name for path in tmp_path.glob("*.mp4")] == ["home_1.mp4"]
    assert not list(tmp_path.glob(".rendering-*"))


def test_adding_homes_keeps_the_existing_ones(tmp_path, small):
    make(tmp_path, count=2)
    before = content(tmp_path)
    made = make(tmp_path, count=4)
    assert [path.name for path in made] == [f"home_{k}.mp4" for k in (1, 2, 3, 4)]
    after = content(tmp_path)
    assert {name: after[name] for name in before if name != "contact_sheet.jpg"} == {
        name: data for name, data in before.items() if name != "contact_sheet.jpg"
    }
    assert (
        tmp_path / "home_4.csv"
    ).read_text() == "start,end,label\n1,1,bedroom\n2,2,transition\n3,3,kitchen\n"


def test_only_plans(tmp_path, small):
    made = make(tmp_path, only_plans=True)
    assert [path.name for path in made] == ["home_1.yaml", "home_2.yaml", "home_3.yaml"]
    assert not list(tmp_path.glob("*.mp4"))
    assert all(path.with_suffix(".png").is_file() for path in made)


def test_a_folder_with_other_homes_raises_an_error(tmp_path, small):
    make(tmp_path, count=1)
    before = content(tmp_path)
    with pytest.raises(PlacecatError, match=r"has homes with a different seed \(1, now 2\): choose another"):
        make(tmp_path, count=1, seed=2)
    with pytest.raises(PlacecatError, match=r"different video.fps \(5, now 10\)"):
        make(tmp_path, count=1, fps=10)
    assert content(tmp_path) == before
    (tmp_path / "homes.yaml").unlink()
    with pytest.raises(PlacecatError, match=r"has videos but no homes\.yaml"):
        make(tmp_path, count=1)


def test_a_concurrent_run_in_the_folder_raises_an_error(tmp_path, small):
    with FileLock(tmp_path / ".lock"), pytest.raises(PlacecatError, match="another process renders into"):
        make(tmp_path)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--homes", "24"], "--homes needs --seed"),
        (["--homes", "0", "--seed", "1"], "--homes must be from 1 to 1000, not 0"),
        (["--homes", "2", "--seed", "-1"], "--seed must be from 0 to 4294967295, not -1"),
        (["--homes", "2", "--seed", "1", "--size", "640"], "--size must be WIDTHxHEIGHT, such as 640x360"),
        (["--homes", "2", "--seed", "1", "--size", "641x360"], "width and height must be even, not 641x360"),
        (["--homes", "2", "--seed", "1", "--frames", "3"], "frames must be a whole number from 200"),
        (["--seed", "1"], "--seed needs --homes"),
        (["--plans"], "--plans needs --homes"),
        (["homes/home_1", "--homes", "2", "--seed", "1"], "use either video names or --homes, not both"),
    ],
)
def test_the_command_rejects_invalid_options(tmp_path, monkeypatch, options, message):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(SystemExit) as ended:
        command.main(options)
    assert str(ended.value).startswith("placecat: ") and message in str(ended.value)
    assert not list(tmp_path.iterdir())


def test_the_command_prints_the_folder_it_created(tmp_path, small, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    command.main(["--homes", "2", "--seed", "7", "--size", "160x90"])
    assert capsys.readouterr().out == "2 homes are in homes_of_seed_7\n"
    assert len(list((tmp_path / "homes_of_seed_7").glob("home_*.mp4"))) == 2
