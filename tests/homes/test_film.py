"""The stored videos match the output of the renderer."""

import cv2
import numpy as np
import pytest

pytest.importorskip("embreex", reason="rendering needs the optional extra")

from placecat.footage.recording import Recording
from placecat_homes import render
from project import ROOT

pytestmark = [pytest.mark.slow, pytest.mark.xdist_group("film")]

NAME = "apartments/webcam"
FRAMES = (0, 180, 450)


@pytest.fixture(scope="module")
def film():
    # Fewer light points, an eighth of the rays and small previews for the exposure make the light only a
    # little coarser and noisier.
    light = {"directions": 32, "bounces": 3, "lamp_rays": 1, "chunk": 4096}
    return render.film(NAME, edge=0.2, light=light, preview=40)


@pytest.fixture(scope="module")
def kept():
    recording = Recording(ROOT / f"data/{NAME}.mp4")
    return {number: next(recording.pictures(number + 1)).image() for number in FRAMES}


def soft(frame):
    """Remove the noise and the traces of compression."""
    return cv2.GaussianBlur(frame.astype(np.float32), (0, 0), 2.0)


def test_rendered_frames_match_the_stored_video(film, kept):
    made = {number: soft(film.frame(number)) for number in FRAMES}
    for number in FRAMES:
        differences = {other: np.abs(soft(kept[number]) - made[other]).mean() for other in FRAMES}
        # In grey levels from 0 to 255. The difference from any other frame is several times larger.
        assert differences[number] < 5, differences
        assert min(differences, key=differences.get) == number, differences


def test_labels_match_the_stored_file(film, tmp_path):
    render._write_labels(tmp_path / "labels.csv", film.labels)
    assert (tmp_path / "labels.csv").read_bytes() == (ROOT / f"data/{NAME}.csv").read_bytes()


def test_the_camera_stays_on_free_floor(film):
    ground = film.building.ground()
    path = film.walk
    assert len(path.position) == len(film.labels) == render.listed()[NAME]["frames"]
    assert ground.is_free(path.position[:, :2]).all()
