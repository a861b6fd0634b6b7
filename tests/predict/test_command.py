import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import cv2
import numpy as np
import pandas as pd
import pytest
from commands import predict, refused
from fake_categorizer import CLASSES, STAY, FakeCategorizer, expected
from helpers_sequences import WIDTH, coded, write_image, write_video
from matplotlib.figure import Figure

from placecat.footage.timing import even
from placecat.predict import command, timeline
from placecat.sequences.labels import read_label_csv

COUNT = 30
TABLES = ("frames.csv", "segments.csv", "summary.json", "timeline.png", "visits.csv")


@pytest.fixture
def footage(tmp_path, monkeypatch):
    """Create a folder with footage, and use a system that needs no training."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(command.Categorizer, "load", lambda path, **_: FakeCategorizer())
    write_video(tmp_path / "walk.avi", COUNT)
    for number in range(COUNT):
        write_image(tmp_path / f"images/frame{number}.png", number)
    return tmp_path


@pytest.fixture
def folder(footage, monkeypatch):
    """Like `footage`, but with an empty timeline, because drawing a real one dominates the run time."""
    monkeypatch.setattr(timeline, "draw", lambda prediction, title, truth: Figure(figsize=(1, 1)))
    return footage


def frames_of(path):
    capture, found = cv2.VideoCapture(str(path)), []
    while (read := capture.read())[0]:
        found.append(read[1])
    return found, capture.get(cv2.CAP_PROP_FPS)


def probabilities(table, prefix):
    return table[[f"{prefix}_{name}" for name in CLASSES]].to_numpy()


@pytest.mark.parametrize("source", ["walk.avi", "images"])
def test_tables_contain_exactly_the_outputs_of_the_system(footage, source, capsys):
    predict(source)
    name = source.removesuffix(".avi")
    results = footage / "predictions" / name
    table = pd.read_csv(results / "frames.csv")
    smoothed, alone = map(np.stack, zip(*map(expected, range(COUNT)), strict=True))
    assert np.array_equal(probabilities(table, "p"), smoothed)
    assert np.array_equal(probabilities(table, "frame_p"), alone)
    assert table["frame"].tolist() == list(range(1, COUNT + 1))
    assert table["seconds"].tolist() == [number / 25 for number in range(COUNT)]
    assert table["place"].tolist() == [CLASSES[number // STAY % 3] for number in range(COUNT)]
    assert table["frame_place"][1] == CLASSES[1]
    assert table["name"].tolist() == [*table["place"][:11], *["unknown"] * 19]
    visits = (results / "visits.csv").read_text()
    assert visits == (
        "place,start_seconds,end_seconds,confidence,frames\nbedroom,0.000,0.320,0.5930,8\n"
        "living_room,0.320,0.440,0.5820,3\nunknown,0.440,1.200,0.5600,19\n"
    )
    if source == "images":
        assert table["file"].tolist() == [f"frame{number}.png" for number in range(COUNT)]
    segments = (results / "segments.csv").read_text()
    assert segments == "start,end,label\n1,8,bedroom\n9,16,living_room\n17,24,kitchen\n25,30,bedroom\n"
    shown = capsys.readouterr().out
    assert " for the categorizer alone), " in shown and " times the footage's 25" in shown
    assert "The place is unknown 63.3% of the time." in shown
    assert "\nOf a fake.\nIt never says `unknown`" in shown
    summary = json.loads((results / "summary.json").read_text())
    assert (summary["share_unknown"], summary["visits"]) == (0.6333, 3)
    assert summary["share_of_time"] == {"bedroom": 0.4667, "living_room": 0.2667, "kitchen": 0.2667}
    assert sorted(path.name for path in results.iterdir()) == summary["files"]
    assert set(summary["files"]) == {*TABLES, "speed.json"}


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("frame3.jpg", "the same frame as frame3"),
        ("depth3.png", "the same frame as"),
        ("frame99.webp", "this kind of image is not supported"),
        ("frame99.jpg", "not a readable image"),
    ],
)
def test_pictures_that_are_not_frames_are_never_skipped(folder, name, message):
    content = (folder / "images/frame3.png").read_bytes()
    (folder / "images" / name).write_bytes(content[:100])
    assert message in refused("images")
    assert not list((folder / "predictions").glob("*"))


def test_unreadable_footage_gives_one_message(folder, monkeypatch):
    def refuse(path):
        raise PermissionError(13, "Permission denied", str(path))

    monkeypatch.setattr("pathlib.Path.is_dir", refuse)
    assert "images: cannot be read (Permission denied)" in refused("images")


def test_results_are_reproducible(footage):
    predict("walk.avi", "--output", "one")
    predict("walk.avi", "--output", "two")
    for name in TABLES:
        assert (footage / "one" / name).read_bytes() == (footage / "two" / name).read_bytes(), name


def test_segments_can_be_used_as_labels(footage, capsys):
    predict("walk.avi", "--every", "4")
    labels = footage / "labels.csv"
    shutil.copy(footage / "predictions/walk/segments.csv", labels)
    read, _ = read_label_csv(labels, even(COUNT, 25.0), "the video")
    assert read == [CLASSES[number // STAY % 3] for number in range(COUNT)]
    labels.write_text(labels.read_text().replace("17,24,kitchen", "17,20,transition\n21,24,bedroom"))
    predict("walk.avi", "--labels", labels, "--output", "judged")
    shown = capsys.readouterr().out
    # 14 of the 18 bedroom frames and all 8 living_room frames are correct.
    assert f"Accuracy (mean over the labelled places): {(100 * 14 / 18 + 100) / 2:.2f}%" in shown
    lines = [line.split() for line in shown.splitlines()]
    assert ["bedroom", "14", "0", "4", "77.8%"] in lines
    assert ["kitchen", "0", "0", "0", "-"] in lines


def test_an_unknown_label_is_rejected_or_ignored(folder, capsys):
    (folder / "labels.csv").write_text("start,end,label\n1,10,bedroom\n11,30,cellar\n")
    assert (
        "labels.csv line 3: 'cellar' is not one of the model's places (bedroom, living_room, kitchen)"
        in refused("walk.avi", "--labels", "labels.csv")
    )
    assert not (folder / "predictions").exists()
    predict("walk.avi", "--labels", "labels.csv", "--ignore", "cellar")
    assert "Accuracy (mean over the labelled places): 80.00%" in capsys.readouterr().out


@pytest.mark.parametrize(("option", "suffix"), [("--video", ".mp4"), ("--webm", ".webm")])
def test_annotated_video_shows_every_frame_at_the_footage_rate(folder, option, suffix):
    predict("walk.avi", option, "--seconds", "0.5")
    shown, fps = frames_of(folder / f"predictions/walk/annotated{suffix}")
    assert (len(shown), fps) == (13, 25.0)
    assert shown[0].shape == (480, 920, 3)
    # The swatch has the colour of the place, first bedroom and then living room.
    for number, color in ((0, (0x88, 0x22, 0x33)), (12, (0x7F, 0xAC, 0x3A))):
        assert np.abs(shown[number][28:36, 664:672].mean(axis=(0, 1)) - color).max() < 12


def test_frames_of_another_size_are_scaled_with_resize(folder):
    for number in range(3):
        write_image(folder / f"large/{number}.png", number, width=2 * WIDTH, height=120)
    text = refused("large")
    assert "128x120" in text and "64x48" in text and "--resize" in text
    predict("large", "--resize", "--output", "out")
    table = pd.read_csv(folder / "out/frames.csv")
    assert np.array_equal(probabilities(table, "p"), [expected(number)[0] for number in range(3)])
    assert json.loads((folder / "out/summary.json").read_text())["kept"] == [128, 96]


@pytest.mark.parametrize(
    ("arguments", "period"),
    [
        ("walk.avi", 1 / 25),
        ("walk.avi --every 5", 1 / 5),
        ("walk.avi --fps 10", 1 / 10),
        ("images", 1 / 6),
        ("images --fps 2 --every 3", 3 / 2),
    ],
)
def test_the_system_receives_the_time_between_frames(folder, monkeypatch, capsys, arguments, period):
    system = FakeCategorizer(frame_rate=6.0)
    monkeypatch.setattr(command.Categorizer, "load", lambda path, **_: system)
    predict(*arguments.split())
    every = int(arguments.partition("--every ")[2] or 1)
    assert np.allclose(system.times, period, rtol=1e-9)
    assert len(system.times) == -(-COUNT // every)
    # Any rate is accepted; a note reports rates below the model's.
    err = capsys.readouterr().err
    assert err.count("note: ") == err.count("\n") == (1 / period < 6)


@pytest.mark.parametrize(
    ("arguments", "threshold", "is_noted"),
    [
        ([], 0.579, False),
        (["--every", "2"], 0.579, True),
        (["--fps", "24.5"], 0.579, False),
        (["--fps", "20"], 0.579, True),
        # At these thresholds, places are always or never known.
        (["--every", "2"], 0.0, False),
        (["--every", "2"], float("inf"), False),
    ],
)
def test_a_low_frame_rate_is_noted(folder, monkeypatch, capsys, arguments, threshold, is_noted):
    monkeypatch.setattr(FakeCategorizer, "threshold", threshold)
    predict("walk.avi", *arguments)
    rate = "12.5" if "--every" in arguments else "20"
    note = f"only {rate} frames/s are used, but the threshold for `unknown` was chosen at 25"
    assert (note in capsys.readouterr().err) == is_noted
    assert ("notes" in json.loads((folder / "predictions/walk/summary.json").read_text())) == is_noted


def test_a_truncated_video_is_noted(folder, capsys):
    whole = (folder / "walk.avi").read_bytes()
    (folder / "cut.avi").write_bytes(whole[: len(whole) // 2])
    predict("cut.avi")
    assert "of the 30 frames listed in the file can be read" in capsys.readouterr().err
    assert 3 < len(pd.read_csv(folder / "predictions/cut/frames.csv")) < 25


def _damage(folder):
    (folder / "no.mp4").write_bytes(b"")
    (folder / "notes.txt").write_text("text")
    (folder / "void").mkdir()
    os.mkfifo(folder / "pipe.mp4")
    (folder / "other").mkdir()
    (folder / "other/summary.json").write_text('{"sha256": {}, "files": ["a"]}')
    (folder / "mixed").mkdir()
    shutil.copy(folder / "images/frame0.png", folder / "mixed/1.png")
    write_image(folder / "mixed/2.png", 1, width=2 * WIDTH)
    (folder / "torn").mkdir()
    shutil.copy(folder / "images/frame0.png", folder / "torn/1.png")
    (folder / "torn/2.png").write_bytes((folder / "images/frame1.png").read_bytes()[:50])
    (folder / "short.csv").write_text("start,end,label\n1,10,bedroom\n")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ("nothing.mp4", "there is no file or folder nothing.mp4"),
        ("home_6", "or home:NAME for a home in the data set"),
        ("no.mp4", "no.mp4: not a readable video"),
        ("notes.txt", "notes.txt: not a video with a supported suffix"),
        ("void", "void: the folder has no images"),
        ("mixed", "2.png: the image is 128x48 pixels, but the first image is 64x48"),
        ("torn", "2.png: not a readable image"),
        ("walk.avi --every 0", "--every is 0"),
        ("walk.avi --seconds 0", "--seconds is 0"),
        ("walk.avi --fps nan", "--fps is nan"),
        ("walk.avi --fps 1e-308", "--fps is 1e-308: use a number from 0.001 to 1000"),
        ("walk.avi --fps 1e308", "use a number from 0.001 to 1000"),
        ("walk.avi --every 1000000000000000000000", "--every is 1000000000000000000000"),
        ("walk.avi --ignore kitchen", "--ignore has no effect without labels"),
        ("pipe.mp4", "pipe.mp4 is not a regular file"),
        ("walk.avi --output notes.txt/x", "cannot write notes.txt/x: File exists; a file is where"),
        ("walk.avi --output other", "other contains something other than a prediction"),
        ("walk.avi --labels none.csv", "none.csv: the label file is missing"),
        ("walk.avi --labels short.csv", "label frames 11 to 30"),
        ("walk.avi --output notes.txt", "notes.txt is a file"),
        ("walk.avi --output images", "images contains something other than a prediction"),
        ("walk.avi --output . --force", ". is or contains a folder that is in use"),
        ("walk.avi --output new/..", "new/.. is or contains a folder that is in use"),
    ],
)
def test_user_errors_give_one_message_and_leave_no_files(folder, arguments, message):
    _damage(folder)
    before = sorted(folder.rglob("*"))
    assert message in refused(*arguments.split())
    assert sorted(folder.rglob("*")) == before


def test_an_empty_source_is_rejected(folder):
    assert "SOURCE is empty" in refused("")


def test_an_output_link_is_kept_and_its_target_is_written(folder):
    (folder / "far").mkdir()
    (folder / "near").symlink_to("far")
    predict("walk.avi", "--output", "near")
    assert (folder / "near").is_symlink()
    assert (folder / "far/frames.csv").is_file()


def test_newlines_in_names_are_escaped(footage, capsys):
    predict("walk.avi", "--output", "a\nAll is well")
    assert "a\\nAll is well: " in capsys.readouterr().out


def test_a_name_of_dots_gives_the_folder_footage(folder):
    (folder / "walk.avi").rename(folder / "...avi")
    predict("...avi")
    assert (folder / "predictions/footage/frames.csv").exists()
    assert (folder / "...avi").exists()


def test_only_an_unedited_prediction_of_the_same_source_is_replaced(folder):
    predict("walk.avi", "--output", "out")
    predict("walk.avi", "--output", "out", "--every", "2")
    assert len(pd.read_csv(folder / "out/frames.csv")) == COUNT // 2
    assert "contains the prediction for walk.avi" in refused("images", "--output", "out")
    segments = folder / "out/segments.csv"
    segments.write_text(segments.read_text().replace("kitchen", "bedroom"))
    assert "segments.csv was added or edited" in refused("walk.avi", "--output", "out")
    assert "is in out, which would be replaced" in refused(
        "walk.avi", "--output", "out", "--labels", segments, "--force"
    )
    predict("walk.avi", "--output", "out", "--force")
    (folder / "out/segments.edited.csv").unlink()
    (folder / "out/notes.txt").write_text("mine")
    assert "notes.txt was added or edited" in refused("walk.avi", "--output", "out")


def test_edited_or_added_files_are_kept_even_with_force(folder, capsys):
    predict("walk.avi", "--output", "out")
    segments = folder / "out/segments.csv"
    written, first = segments.read_text(), segments.read_text() + "31,32,kitchen\n"
    segments.write_text(first)
    (folder / "out/notes").mkdir()
    (folder / "out/notes/a.txt").write_text("mine")
    predict("images", "--output", "out", "--force")
    assert f"segments.csv was added or edited, so it is kept as {Path('out/segments.edited.csv')}" in (
        capsys.readouterr().err
    )
    assert segments.read_text() == written
    # The copy counts as an added file. Unedited tables are not copied.
    assert "was added or edited" in refused("images", "--output", "out")
    segments.write_text("second")
    predict("walk.avi", "--output", "out", "--force")
    found = {path.name: path.read_text() for path in folder.glob("out/*.edited*")}
    assert found == {"segments.edited.csv": first, "segments.edited_2.csv": "second"}
    assert (folder / "out/notes/a.txt").read_text() == "mine"


def test_ctrl_c_on_a_file_writes_nothing(folder, monkeypatch):
    def update(self, frame, seconds, calls=[]):  # noqa: B006
        calls.append(1)
        if len(calls) == 5:
            raise KeyboardInterrupt
        return original(self, frame, seconds)

    original = FakeCategorizer.update
    monkeypatch.setattr(FakeCategorizer, "update", update)
    with pytest.raises(SystemExit) as caught:
        predict("walk.avi", "--video")
    assert caught.value.code == 130
    assert not (folder / "predictions").exists()


def test_encoded_numbers_survive_video_compression(folder):
    # The other tests assume this.
    assert np.array_equal(frames_of(folder / "walk.avi")[0][5] > 127, coded(5) > 127)


@pytest.mark.slow
def test_importing_the_command_does_not_import_matplotlib():
    program = "import sys, placecat.predict.command; print('matplotlib' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout == "False\n"
