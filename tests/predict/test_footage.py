"""Predict from real-world footage with damage, uneven times or a rotated phone."""

import json
from fractions import Fraction

import numpy as np
import pandas as pd
import pytest
from clips import steady, turned_on_the_way, write_clip, zero
from fake_categorizer import FakeCategorizer

from placecat.__main__ import main
from placecat.errors import PlacecatError
from placecat.footage.recording import Recording
from placecat.predict import command, destination

UNEVEN = [*steady(45), *(1.5 + np.arange(45) / 3)]
CHAIN = {"g": "1000", "bf": "0", "preset": "ultrafast"}


@pytest.fixture
def system(tmp_path, monkeypatch):
    """Return a system that needs no training, and change to an empty folder."""
    made = FakeCategorizer()
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(command.Categorizer, "load", lambda path, **_: made)
    return made


def predicted(*arguments, name="walk"):
    main(["predict", *map(str, arguments)])
    folder = command.Path("predictions") / name
    return pd.read_csv(folder / "frames.csv"), json.loads((folder / "summary.json").read_text()), folder


@pytest.mark.parametrize("number", [41, 58])
def test_lost_frames_keep_their_numbers_and_are_reported(system, tmp_path, capsys, number):
    zero(write_clip(tmp_path / "walk.mp4", steady(60), options=CHAIN), number)
    table, summary, folder = predicted("walk.mp4", "--video")
    assert table["frame"].tolist() == [one for one in range(1, 61) if one != number]
    assert np.allclose(table["seconds"], (table["frame"] - 1) / 30, atol=0.001)
    assert summary["lost_frames"] == [number]
    assert summary["frames_of_footage"] == 60
    note = f"walk.mp4: frame {number} of 60 cannot be decoded and is lost"
    assert note in summary["notes"][0]
    assert f"placecat: note: {note}" in capsys.readouterr().err
    assert pd.read_csv(folder / "segments.csv")["end"].iloc[-1] == 60
    # The annotated video runs in real time.
    assert Recording(folder / "annotated.mp4").count == 60


def test_the_frame_after_a_lost_frame_is_used(system, tmp_path):
    zero(write_clip(tmp_path / "walk.mp4", steady(30), options=CHAIN), 11)
    table, _, _ = predicted("walk.mp4", "--every", 5)
    assert table["frame"].tolist() == [1, 6, 12, 16, 21, 26]


def test_undamaged_footage_has_no_note(system, tmp_path, capsys):
    write_clip(tmp_path / "walk.mp4", steady(30))
    _, summary, _ = predicted("walk.mp4")
    assert not {"lost_frames", "damaged_frames", "turned_frames", "notes"} & set(summary)
    assert capsys.readouterr().err == ""


@pytest.mark.slow
def test_times_come_from_the_file(system, tmp_path):
    write_clip(tmp_path / "walk.mp4", UNEVEN)
    (tmp_path / "walk.csv").write_text("start_seconds,end_seconds,label\n0,1.5,kitchen\n1.5,16.2,bedroom\n")
    table, summary, folder = predicted("walk.mp4", "--labels", "walk.csv", "--video")
    assert np.allclose(table["seconds"], UNEVEN, atol=0.001)
    assert table["seconds"][45] == 1.5
    assert np.allclose(system.times[1:], np.diff(UNEVEN), atol=1e-3)
    assert summary["seconds"] == pytest.approx(16.2, abs=0.01)
    assert sum(map(sum, summary["agreement"]["confusion"][2:])) == 45
    assert Recording(folder / "annotated.mp4").timing().end == pytest.approx(UNEVEN[-1], abs=0.1)


@pytest.mark.parametrize(("seconds", "frames"), [(1.5, 45), (3.0, 50), (0.05, 2)])
def test_seconds_option_uses_the_times_in_the_file(system, tmp_path, seconds, frames):
    write_clip(tmp_path / "walk.mp4", UNEVEN)
    table, summary, _ = predicted("walk.mp4", "--seconds", seconds)
    assert len(table) == frames
    assert summary["seconds"] == pytest.approx(seconds, abs=0.001)


def test_a_file_without_plausible_times_needs_a_frame_rate(system, tmp_path):
    write_clip(tmp_path / "walk.webm", np.arange(9) / 1000, codec="libvpx", rate=1000, tick=Fraction(1, 1000))
    with pytest.raises(
        SystemExit, match=r"has no plausible times for its frames .* set the frame rate with --fps"
    ):
        predicted("walk.webm")
    assert predicted("walk.webm", "--fps", 30)[1]["seconds"] == 0.3


def test_rotating_the_phone_does_not_stretch_frames(system, tmp_path, capsys, monkeypatch):
    seen, update = [], system.update
    monkeypatch.setattr(system, "update", lambda frame, seconds: seen.append(frame) or update(frame, seconds))
    turned_on_the_way(tmp_path / "walk.webm")
    table, summary, _ = predicted("walk.webm")
    assert len(table) == 10
    assert summary["turned_frames"] == [6, 7, 8, 9, 10]
    assert "from frame 6 on, 5 frames differ in size" in capsys.readouterr().err
    # Turned frames are cropped to 48x36 pixels and enlarged to 64x48, so each column is 8 pixels wide instead
    # of 6.
    assert {frame.shape for frame in seen} == {(48, 64, 3)}
    edges = np.flatnonzero(np.abs(np.diff(seen[6][24, :, 0].astype(int))) > 60)
    assert edges[0] == pytest.approx(64 / 48 * 6, abs=2)


def reserved(output=None, *, is_live=False):
    return destination.reserved(output, "walk", "walk.mp4", [], is_live=is_live, force=False)


def test_concurrent_predictions_do_not_share_a_folder(system, tmp_path):
    with reserved() as first:
        message = "walk is being written by another prediction: wait for it"
        with pytest.raises(PlacecatError, match=message), reserved():
            pass
        with reserved(tmp_path / "other") as second:
            assert second == tmp_path / "other"
        with reserved(is_live=True) as third, reserved(is_live=True) as fourth:
            assert (third.name, fourth.name) == ("walk_2", "walk_3")
    with reserved() as again:
        assert again == first
    assert not (tmp_path / "predictions").exists()
