"""Tests of `placecat import panoramas`, from images to the input of the stage `sequences`."""

import json
import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
import time

import cv2
import numpy as np
import pandas as pd
import pytest
import yaml
from worlds import colour, faces, sphere, write

from placecat.__main__ import main
from placecat.config.compose import compose
from placecat.panoramas.command import read_settings
from placecat.panoramas.plan import plan
from placecat.panoramas.render import view_rays
from placecat.panoramas.sources import read
from placecat.settings import Loader
from placecat.stages.sequences import list_homes
from project import ROOT, contents

ROOMS = ["Kitchen", "bedroom 1", "bedroom 2", "living-room", "dining room", "bathroom", "hall"]
SMALL = ["width=32", "height=18", "fps=0.5"]


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """Create a folder with the project settings and a source of four homes.

    Each image of a home has a different shade of grey.
    """
    (tmp_path / "conf/dataset").mkdir(parents=True)
    for name in ("panoramas.yaml", "dataset/my_homes.yaml"):
        shutil.copy(ROOT / "conf" / name, tmp_path / "conf" / name)
    rows = []
    for home in ("Home1", "Home2", "Home3", "Home4"):
        for number, room in enumerate(ROOMS * 2):
            grey = 20 + 16 * number
            floor = 1 if number < len(ROOMS) else 2
            write(tmp_path / f"source/{home}/{grey}.jpg", np.full((32, 64, 3), grey, dtype=np.uint8))
            rows.append((home, floor, f"{home}/{grey}.jpg", room))
    table = pd.DataFrame(rows, columns=["home", "floor", "file", "room"])
    table.to_csv(tmp_path / "source/rooms.csv", index=False)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("PLACECAT_WORKERS", "1")
    return tmp_path


def run(*changes):
    main(["import", "panoramas", "source", "homes", *SMALL, *changes])


def refused(*changes):
    with pytest.raises(SystemExit) as caught:
        run(*changes)
    assert "\n" not in str(caught.value)
    return str(caught.value)


def names(folder):
    return sorted(path.name for path in folder.iterdir())


@pytest.mark.slow
def test_every_frame_has_the_label_of_its_panorama(folder, capsys):
    run()
    assert names(folder) == ["conf", "homes", "source"]
    said = capsys.readouterr().out
    assert re.search(r"Home1: \d+ frames, \d+ stays, 2 floors", said)
    command = re.search(r'make repro SET="(.*)"', said)[1]
    settings = yaml.load(compose(shlex.split(command), ROOT / "conf"), Loader=Loader)["dataset"]
    assert settings["homes"] == ["Home1", "Home2", "Home3", "Home4"]
    assert settings["fps"] == 0.5
    # The stage `sequences` makes the same call.
    list_homes(settings, folder / "data/sequences", "dataset")
    wanted = ["kitchen", "bedroom", "bedroom", "living_room", "dining_room", "bathroom", "corridor"]
    for home in settings["homes"]:
        frames = pd.read_csv(folder / f"data/sequences/{home}/frames.csv")
        labels = pd.read_csv(folder / f"data/sequences/{home}/labels.csv")["label"]
        greys = [cv2.imread(str(folder / "homes" / source)) for source in frames["source"]]
        assert {picture.shape for picture in greys} == {(18, 32, 3)}
        numbers = np.rint((np.array([picture.mean() for picture in greys]) - 20) / 16).astype(int)
        assert [wanted[number % 7] for number in numbers] == labels.tolist()
        assert (numbers // 7 + 1 == frames["sequence"]).all()
        assert set(labels) == set(wanted)
        # The table beside the frames names the panorama of each frame.
        looks = pd.read_csv(folder / f"homes/{home}/looks.csv")
        shown = np.repeat(looks["panorama"], looks["end"] - looks["start"] + 1)
        assert [f"{home}/{20 + 16 * number}.jpg" for number in numbers] == shown.tolist()
    card = (folder / "homes/README.md").read_text()
    total = len(list((folder / "homes").rglob("*.jpg")))
    assert f"4 homes, {total} frames of 32x18 pixels, 0.5 frames/s" in card
    assert "from 56 panoramas in the folder `source`" in card
    kitchen = sum(path.read_text().count("kitchen") for path in (folder / "homes").glob("*/label.txt"))
    columns = [line.split(" | ") for line in card.splitlines() if line.startswith("| ")]
    place = columns[0].index("kitchen")
    assert sum(int(re.search(r"\((\d+)\)", row[place])[1]) for row in columns[1:]) == kitchen
    assert yaml.safe_load(card.split("```yaml\n")[1].split("```")[0]) == read_settings(SMALL)


def zind_data(image_path, **pano):
    """Return the data of a Zillow Indoor Dataset home with one panorama."""
    partial_room = {"pano_1": {"image_path": image_path, **pano}}
    return {"merger": {"1": {"complete_room_01": {"partial_room_01": partial_room}}}}


@pytest.mark.parametrize(
    ("source", "home"), [("equirectangular", "flat"), ("cubes", "flat"), ("zind", "zind_flat")]
)
def test_frames_are_the_planned_views(folder, source, home):
    shutil.rmtree(folder / "source")
    (folder / "source/flat").mkdir(parents=True)
    if source == "zind":
        data = zind_data("a.png", label="kitchen", floor_number=1, is_inside=True)
        (folder / "source/flat/zind_data.json").write_text(json.dumps(data))
    else:
        (folder / "source/rooms.csv").write_text("home,file,room\nflat,flat/a.png,kitchen\n")
    if source == "cubes":
        for letter, face in zip("frblud", faces(64), strict=True):
            write(folder / f"source/flat/a.png_{letter}.jpg", face)
    else:
        write(folder / "source/flat/a.png", sphere(128))
    changes = [
        f"source={source}",
        "fps=3.0",
        "quality=100",
        "tilt=[-60,60]",
        "stays.kitchen={mean: 10, deviation: 1}",
    ]
    run(*changes)
    settings = read_settings([*SMALL, *changes])
    looks = plan(read(folder / "source", settings), settings)["1"]
    path = np.concatenate([look.path for look in looks])
    assert len(path) > 25
    for number, (pan, tilt, fov) in enumerate(path, start=1):
        frame = cv2.imread(str(folder / f"homes/{home}/1/{number:08d}.jpg")).astype(float)
        wanted = colour(*np.moveaxis(view_rays(pan, tilt, fov, 32, 18), -1, 0))
        # JPEG halves the colour resolution.
        assert np.abs(frame - wanted).max() < 12
        assert np.abs(frame - wanted).mean() < 1.5


def test_results_do_not_depend_on_the_number_of_workers(folder, two_workers):
    run("homes=[Home1]")
    one = contents(folder, "homes")
    shutil.rmtree(folder / "homes")
    os.environ["PLACECAT_WORKERS"] = "2"
    run("homes=[Home1]")
    assert contents(folder, "homes") == one
    shutil.rmtree(folder / "homes")
    run("homes=[Home1]", "walk=1")
    assert contents(folder, "homes") != one


def test_existing_files_are_never_replaced(folder):
    (folder / "homes").mkdir()
    assert "homes already exists: choose another name" in refused()
    assert names(folder / "homes") == []


@pytest.mark.parametrize(
    ("picture", "message"),
    [
        (
            np.zeros((32, 60, 3), np.uint8),
            "100.jpg: the image is 60x32, but a full sphere must be twice as wide as it is high",
        ),
        (None, "100.jpg: not a readable image"),
    ],
)
def test_a_bad_picture_is_named_and_nothing_is_left(folder, picture, message):
    path = folder / "source/Home2/100.jpg"
    path.write_bytes(b"no image") if picture is None else write(path, picture)
    said = refused()
    assert message in said
    assert picture is None or "rooms.csv line 21" in said
    assert names(folder) == ["conf", "source"]


def test_a_face_that_is_no_square_is_named(folder):
    (folder / "source/rooms.csv").write_text("home,file,room\nflat,a,kitchen\n")
    for letter, face in zip("frblud", faces(16), strict=True):
        write(folder / f"source/a_{letter}.jpg", face[:8] if letter == "u" else face)
    assert "a_u.jpg is 16x8, but all faces of this cube must be 16x16" in refused("source=cubes")


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (
            "widht=32",
            "conf/panoramas.yaml has no setting 'widht'; did you mean 'width'? (valid: source, table, homes",
        ),
        ("labels.larder=[x]", "labels has no setting 'larder'; to add it, write +labels.larder=[x] ("),
        ("labels.kitchn=[x]", "labels has no setting 'kitchn'; did you mean 'kitchen'? ("),
        ("fps=0", "fps=0: it must be greater than 0"),
        ("fps", "the override 'fps' has no value"),
        ("visits=[2,1]", "visits=[2, 1]: the first must not be larger than the second"),
        ("tilt=[-91,0]", "tilt.0=-91"),
        ("labels.living_room=7", "labels.living_room=7: it must be a list"),
        ("ways=[my room]", "must not contain spaces"),
        ("cubes.file=face.jpg", "it must contain FILE and FACE"),
        ("stays.kitchen.mean=0", "stays.kitchen.mean=0"),
        ("+stays.kitchen.mode=1", "stays.kitchen has no setting 'mode'"),
    ],
)
def test_a_wrong_setting_is_refused(folder, change, message):
    assert message in refused(change)
    assert names(folder) == ["conf", "source"]


@pytest.mark.slow
def test_a_home_without_a_class_and_too_few_homes_are_reported(folder, capsys):
    table = (folder / "source/rooms.csv").read_text()
    (folder / "source/rooms.csv").write_text(
        "".join(
            line for line in table.splitlines(keepends=True) if "bathroom" not in line or "Home3" not in line
        )
    )
    run("homes=[Home2,Home3]")
    said = capsys.readouterr().out
    assert "Home3 lacks bathroom.\n" in said
    assert "need at least four homes" in said
    assert "repro" not in said
    shutil.rmtree(folder / "homes")
    run()
    said = capsys.readouterr().out
    assert "At least" not in said
    assert said.rstrip().endswith('dataset.fps=0.5 dataset.require_all_classes=false"')


def test_panoramas_in_no_frame_are_reported(folder, capsys):
    rooms = [("hall", 20), *[("kitchen", 36 + 16 * number) for number in range(8)]]
    table = "".join(f"Home1,Home1/{grey}.jpg,{room}\n" for room, grey in rooms)
    (folder / "source/rooms.csv").write_text(f"home,file,room\n{table}")
    run("visits=[1,1]", "longest_look=1000")
    said = capsys.readouterr().out
    assert re.search(r"^Home1: \d+ frames, 2 stays, 1 floor$", said, re.MULTILINE)
    shown = set(pd.read_csv(folder / "homes/Home1/looks.csv")["panorama"])
    assert shown == {"Home1/20.jpg", "Home1/36.jpg"}
    missing = [f"Home1/{grey}.jpg" for _, grey in rooms[2:]]
    assert f"7 of 9 panoramas do not appear in any frame: {', '.join(missing[:5])}, ...\n" in said
    card = (folder / "homes/README.md").read_text()
    assert "\n1 home, " in card
    lines = "".join(f"- `{one}`\n" for one in missing)
    assert f"\n7 of 9 panoramas do not appear in any frame:\n\n{lines}\n## What it is not\n" in card
    shutil.rmtree(folder / "homes")
    run("visits=[4,4]", "longest_look=1", "fps=5.0")
    assert "not appear in any" not in capsys.readouterr().out
    assert "not appear in any" not in (folder / "homes/README.md").read_text()


def test_odd_names_of_homes_reach_the_next_command_whole(folder, capsys):
    table = (folder / "source/rooms.csv").read_text()
    table = re.sub("^Home1,", "Flat A,", table, flags=re.MULTILINE)
    table = re.sub("^Home2,", "$HOME 007,", table, flags=re.MULTILINE)
    (folder / "source/rooms.csv").write_text(re.sub("^Home3,", "12,", table, flags=re.MULTILINE))
    run()
    command = capsys.readouterr().out.splitlines()[-1].strip()
    assert command.startswith("placecat repro ")
    from hydra.core.override_parser.overrides_parser import OverridesParser

    words = subprocess.run(
        ["sh", "-c", f'printf "%s\\n" {command}'], capture_output=True, text=True, check=True
    ).stdout.splitlines()[2:]
    values = {one.key_or_group: one.value() for one in OverridesParser.create().parse_overrides(words)}
    assert values["dataset.homes"] == ["Flat A", "$HOME 007", "12", "Home4"]


@pytest.mark.slow
def test_killed_on_the_way_it_leaves_nothing_under_the_name(folder):
    environment = os.environ | {"PYTHONPATH": str(ROOT / "src")}
    command = [sys.executable, "-m", "placecat", "import", "panoramas", "source", "homes", "height=36"]
    process = subprocess.Popen(command, cwd=folder, env=environment, start_new_session=True)
    end = time.monotonic() + 60
    while not list(folder.glob(".homes.*.partial/*/*/*.jpg")):
        assert process.poll() is None
        assert time.monotonic() < end
        time.sleep(0.02)
    os.killpg(process.pid, signal.SIGKILL)
    process.wait()
    assert not (folder / "homes").exists()
    run()
    assert (folder / "homes/README.md").is_file()
