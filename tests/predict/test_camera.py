import threading
import time
from itertools import pairwise

import cv2
import numpy as np
import pandas as pd
import pytest
from fake_categorizer import FakeCategorizer
from helpers_sequences import HEIGHT, WIDTH, coded, decoded

from placecat.__main__ import main
from placecat.errors import PlacecatError
from placecat.predict import command
from placecat.predict.sources import open_source, without_password

FPS = 100.0
REAL_CAPTURE = cv2.VideoCapture


class FakeCapture:
    """A camera that delivers a numbered frame every 10 ms."""

    opened: list = []  # noqa: RUF012
    total = 10**6
    is_there = True

    def __init__(self, address, api=None):
        self.number, self.wanted, self.is_released = 0, {}, False
        FakeCapture.opened.append((address, self))

    def isOpened(self):
        return self.is_there

    def set(self, name, value):
        self.wanted[name] = value

    def get(self, name):
        return FPS if name == cv2.CAP_PROP_FPS else 0.0

    def read(self):
        time.sleep(0.01)
        if self.number >= self.total:
            return False, None
        self.number += 1
        return True, coded((self.number - 1) % 256)

    def grab(self):
        return self.number < self.total

    def release(self):
        self.is_released = True


@pytest.fixture
def capture(monkeypatch):
    monkeypatch.setattr(cv2, "VideoCapture", FakeCapture)
    monkeypatch.setattr(FakeCapture, "opened", [])
    return FakeCapture


def camera(text="camera"):
    return open_source(text, fps=None, usual_fps=5.0, size=(WIDTH, HEIGHT))


def test_a_slow_reader_gets_the_newest_frame(capture):
    source = camera("camera:2")
    address, made = capture.opened[0]
    assert address == 2
    assert made.wanted == {cv2.CAP_PROP_FRAME_WIDTH: WIDTH, cv2.CAP_PROP_FRAME_HEIGHT: HEIGHT}
    seen = []
    frames = source.frames(1)
    for frame in frames:
        seen.append((frame.number, frame.seconds, decoded(frame.image)))
        time.sleep(0.1)
        if len(seen) == 4:
            break
    frames.close()
    numbers, seconds, images = zip(*seen, strict=True)
    assert numbers == (1, 2, 3, 4)
    assert all(after - before >= 5 for before, after in pairwise(images))
    # Frame times are arrival times.
    assert np.allclose(np.diff(seconds), 0.1, atol=0.05)
    assert source.arrived > 4
    assert made.is_released
    assert not [thread for thread in threading.enumerate() if thread.name == "camera"]


def test_a_fast_reader_gets_every_frame_once(capture, monkeypatch):
    monkeypatch.setattr(capture, "total", 12)
    # The first frame is missing because it was used to find the size.
    assert [decoded(frame.image) for frame in camera().frames(1)] == list(range(1, 12))


def test_a_missing_or_silent_camera_is_an_error(capture, monkeypatch):
    monkeypatch.setattr(capture, "total", 0)
    with pytest.raises(PlacecatError, match="camera 0 opens but delivers no frames"):
        camera()
    monkeypatch.setattr(capture, "is_there", False)
    with pytest.raises(PlacecatError, match=r"camera 0 cannot be opened.*camera:1"):
        camera()
    with pytest.raises(PlacecatError, match=r"^rtsp://host/x cannot be opened"):
        camera("rtsp://me:secret@host/x")


def test_passwords_are_removed():
    assert without_password("rtsp://me:secret@host:5/a@b") == "rtsp://host:5/a@b"
    assert without_password("a@b.mp4") == "a@b.mp4"


@pytest.fixture
def system(monkeypatch):
    monkeypatch.setattr(command.Categorizer, "load", lambda path, **_: FakeCategorizer(FPS))


def test_a_camera_stops_after_the_seconds_and_never_overwrites_results(
    capture, system, tmp_path, monkeypatch, capsys
):
    monkeypatch.chdir(tmp_path)
    for _ in range(2):
        main(["predict", "camera", "--seconds", "0.3", "--video"])
    assert sorted(path.name for path in (tmp_path / "predictions").iterdir()) == ["camera_0", "camera_0_2"]
    shown = capsys.readouterr().out
    assert "frames arrived in between and were dropped" in shown
    table = pd.read_csv(tmp_path / "predictions/camera_0/frames.csv")
    assert table["seconds"].between(0, 0.3, inclusive="left").all()
    # The film runs in real time, although frames were skipped while others were drawn.
    film = capture_length(tmp_path / "predictions/camera_0/annotated.mp4")
    assert film == round(table["seconds"].iloc[-1] * FPS) + 1
    with pytest.raises(SystemExit, match="contains the prediction for camera"):
        main(["predict", "camera", "--seconds", "0.3", "--output", "predictions/camera_0"])


def test_the_system_receives_the_real_time_between_camera_frames(capture, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    made = FakeCategorizer(FPS)
    monkeypatch.setattr(command.Categorizer, "load", lambda path, **_: made)
    original = FakeCategorizer.update

    def update(self, frame, seconds):
        # Each frame takes longer than the one before.
        time.sleep(0.02 * len(self.times))
        return original(self, frame, seconds)

    monkeypatch.setattr(FakeCategorizer, "update", update)
    main(["predict", "camera", "--seconds", "0.8"])
    table = pd.read_csv(tmp_path / "predictions/camera_0/frames.csv")
    assert len(table) > 2
    assert made.times[0] == 1 / FPS
    np.testing.assert_allclose(made.times[1:], np.diff(table["seconds"]), atol=1e-9)
    assert made.times[-1] > 3 / FPS


def capture_length(path):
    capture, count = REAL_CAPTURE(str(path)), 0
    while capture.grab():
        count += 1
    return count


def test_ctrl_c_writes_the_results_so_far(capture, system, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    original, calls = FakeCategorizer.update, []

    def update(self, frame, seconds):
        calls.append(1)
        if len(calls) == 6:
            raise KeyboardInterrupt
        return original(self, frame, seconds)

    monkeypatch.setattr(FakeCategorizer, "update", update)
    main(["predict", "camera"])
    assert "Stopped. Writing the results so far." in capsys.readouterr().out
    assert len(pd.read_csv(tmp_path / "predictions/camera_0/frames.csv")) == 5


def test_file_options_are_rejected_for_a_camera(capture, system):
    for option, message in (
        ("--every=2", "--every works only with files"),
        ("--labels=x.csv", "--labels works only with files"),
    ):
        with pytest.raises(SystemExit, match=message):
            main(["predict", "camera", option])


def test_a_few_failed_reads_do_not_end_the_footage(capture, monkeypatch):
    read = FakeCapture.read

    def fails_at_times(self):
        self.calls = getattr(self, "calls", 0) + 1
        return (False, None) if 2 < self.calls < 12 and self.calls % 4 else read(self)

    monkeypatch.setattr(FakeCapture, "read", fails_at_times)
    monkeypatch.setattr(FakeCapture, "total", 12)
    source = camera()
    numbers = [decoded(frame.image) for frame in source.frames(1)]
    # The first frame was read when the camera was opened. A slow machine may drop others.
    assert numbers == sorted(numbers) and numbers[-1] == 11


@pytest.mark.parametrize("said", [90000.0, 1000.0, 0.0, float("nan")])
def test_implausible_frame_rates_of_a_stream_are_ignored(capture, monkeypatch, said):
    monkeypatch.setattr(FakeCapture, "get", lambda self, name: said)
    assert camera("rtsp://somewhere/1").fps == 30.0
