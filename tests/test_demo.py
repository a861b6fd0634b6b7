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
# The last frames in each room are a transition, which is not tested.
PER_ROOM, UNLABELLED, SIZE = 60, 10, (320, 180)


def film_home(root, name):
    """Write a drawn home as a video with labels, like those that come with the project."""
    rows = []
    with Film(root / f"{name}.mp4", 5.0, SIZE) as film:
        for start, place in zip(range(0, len(PLACES) * PER_ROOM, PER_ROOM), PLACES, strict=True):
            wall = draw_room(place, np.random.default_rng(derive("demo", name, place)))
            for number in range(PER_ROOM):
                view = wall[20:380, 20 * number : 20 * number + 640]
                film.add(cv2.resize(view, SIZE, interpolation=cv2.INTER_AREA), (start + number) / 5)
            end = start + PER_ROOM
            rows += [(start + 1, end - UNLABELLED, place), (end - UNLABELLED + 1, end, "transition")]
    pd.DataFrame(rows, columns=["start", "end", "label"]).to_csv(root / f"{name}.csv", index=False)


def test_the_demo_classifies_a_walk(tmp_path, monkeypatch, capsys, two_workers):
    shutil.copytree(ROOT / "conf", tmp_path / "conf")
    few = [value for value in SMALL if value.startswith(("codebooks.", "cues."))]
    few += [f"dataset.homes=[{','.join(HOMES)}]", "protocol.cue_frames.step=4"]
    monkeypatch.setattr(command, "compose", lambda values: compose([*values, *few]))
    (tmp_path / "data/homes").mkdir(parents=True)
    for name in HOMES:
        film_home(tmp_path / "data/homes", name)
    (tmp_path / "reports").mkdir()
    (tmp_path / "reports/accuracies.csv").write_text(
        "result,home,place,accuracy\nsmoothing/das_551_best,home_3,all,51.2\n"
    )
    monkeypatch.chdir(tmp_path)
    main(["demo"])
    printed = capsys.readouterr().out
    out = tmp_path / command.OUTPUT
    assert sorted(path.name for path in out.iterdir()) == sorted(command.FILES)
    table = pd.read_csv(out / command.TABLE, index_col="result")
    assert len(table) == 7 and table["make demo"].between(0, 100).all()
    # The rows have the same names as in Table 26.
    assert list(table.index[-2:]) == ["Integration", "HMM"] and table.loc["HMM", "make repro"] == 51.2
    # The drawn rooms are easy to classify.
    assert table.iloc[-1, 0] > 40
    frames = pd.read_csv(out / "frames.csv")
    assert len(frames) == len(PLACES) * PER_ROOM // 10
    assert Recording(out / command.CLIP).count == len(frames)
    assert cv2.imread(str(out / command.TIMELINE)).shape[1] > 400
    page = (out / command.PAGE).read_text()
    assert '<video src="data:video/webm;base64,' in page
    labelled = len(PLACES) * (PER_ROOM - UNLABELLED) // 10
    for text in (printed, page):
        assert f"The demo tested only {labelled} frames, so" in text
        assert "Its cues learned from 1 frame in 20; in make repro, they learn from 1 in 4, and all" in text
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
