"""The command `placecat demo`."""

import shutil

import cv2
import numpy as np
import pandas as pd
import pytest

from placecat.__main__ import main
from placecat.config.compose import compose
from placecat.demo import command
from placecat.errors import PlacecatError
from placecat.footage.recording import Recording
from placecat.predict.film import Film
from placecat.seeds import derive
from project import ROOT, SMALL
from sketch import draw_room

HOMES = ["home_1", "home_2", "home_3"]
PLACES = ["bedroom", "bathroom", "kitchen", "living_room", "dining_room"]
PER_ROOM, SIZE = 60, (320, 180)


def film_home(root, name):
    """Write a drawn home as a video with labels, like those that come with the project."""
    rows = []
    with Film(root / f"{name}.mp4", 5.0, SIZE) as film:
        for place in PLACES:
            wall = draw_room(place, np.random.default_rng(derive("demo", name, place)))
            start = len(rows) * PER_ROOM
            for number in range(PER_ROOM):
                view = wall[20:380, 20 * number : 20 * number + 640]
                film.add(cv2.resize(view, SIZE, interpolation=cv2.INTER_AREA), (start + number) / 5)
            rows.append((start + 1, start + PER_ROOM, place))
    pd.DataFrame(rows, columns=["start", "end", "label"]).to_csv(root / f"{name}.csv", index=False)


def test_the_demo_classifies_a_walk(tmp_path, monkeypatch, capsys, two_workers):
    shutil.copytree(ROOT / "conf", tmp_path / "conf")
    few = [value for value in SMALL if value.startswith(("codebooks.", "cues."))]
    few.append(f"dataset.homes=[{','.join(HOMES)}]")
    monkeypatch.setattr(command, "compose", lambda values: compose([*values, *few]))
    (tmp_path / "data/homes").mkdir(parents=True)
    for name in HOMES:
        film_home(tmp_path / "data/homes", name)
    monkeypatch.chdir(tmp_path)
    main(["demo"])
    printed = capsys.readouterr().out
    out = tmp_path / command.OUTPUT
    assert sorted(path.name for path in out.iterdir()) == sorted(command.FILES)
    table = pd.read_csv(out / command.TABLE, index_col="result")
    assert len(table) == 7 and table.iloc[:, 0].between(0, 100).all()
    # The drawn rooms are easy to classify.
    assert table.iloc[-1, 0] > 40
    frames = pd.read_csv(out / "frames.csv")
    assert len(frames) == len(PLACES) * PER_ROOM // 10
    assert Recording(out / command.CLIP).count == len(frames)
    assert cv2.imread(str(out / command.TIMELINE)).shape[1] > 400
    assert '<video src="data:video/webm;base64,' in (out / command.PAGE).read_text()
    assert all(
        str(command.OUTPUT / name) in printed for name in (command.TIMELINE, command.CLIP, command.PAGE)
    )


def test_the_demo_replaces_only_its_own_files(tmp_path):
    folder = tmp_path / "demo"
    command._check(folder)
    folder.mkdir()
    (folder / command.PAGE).touch()
    command._check(folder)
    (folder / "mine.txt").touch()
    with pytest.raises(PlacecatError, match=r"mine\.txt is not from the demo.*move it elsewhere"):
        command._check(folder)


def test_a_file_in_the_way_is_refused(tmp_path):
    (tmp_path / "demo").touch()
    with pytest.raises(PlacecatError, match="is a file, but the demo needs a folder there"):
        command._check(tmp_path / "demo")
