"""Damaged inputs of several kinds, and their outcomes."""

import io
import math
from collections.abc import Mapping
from contextlib import redirect_stderr
from pathlib import Path

import cv2
import mutants
import numpy as np
import yaml
from made_system import frames, make_system

from placecat import settings
from placecat.categorizer import model_file
from placecat.config.check import check
from placecat.errors import PlacecatError
from placecat.footage.frames import read_frames
from placecat.footage.pictures import read_image
from placecat.footage.timing import even
from placecat.sequences import labels, video
from project import ROOT

RIGHT, MESSAGE, TRACEBACK, WRONG = OUTCOMES = ("right", "message", "traceback", "wrong")

# No setting of this project has these numbers.
NO_NUMBERS = ("abc", math.nan, math.inf, -math.inf, {"a": 1}, -1e300)
LINES = ["start,end,label", "1,5,kitchen", "6,9,transition", "10,30,living room"]
ODD_CELLS = ["9" * 5000, "1e308", "-1", "nan", "inf", "", "0", "5", "ä", "\x00", '"', "1,2,3,4", "\u202e"]


class Inputs:
    """A kind of input in a separate folder. `intact` is its correct result; `try_one` damages an input."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        folder.mkdir(parents=True, exist_ok=True)

    def attempt(self, rng):
        """Damage one input and read it. Return one of OUTCOMES and the message."""
        try:
            with redirect_stderr(io.StringIO()):
                return self.try_one(rng)
        except PlacecatError as error:
            return (MESSAGE if "\n" not in str(error) else WRONG), str(error)
        except Exception as error:
            return TRACEBACK, repr(error)


class Models(Inputs):
    """Files of a small trained system."""

    def __init__(self, folder):
        super().__init__(folder)
        self._path = folder / "model.placecat"
        model_file.write(self._path, make_system())
        self._content, self._frames = self._path.read_bytes(), frames(2)
        self._expected = mutants.decisions(self._path, self._frames)

    def try_one(self, rng):
        is_forged = bool(rng.integers(2))
        self._path.write_bytes(self._content if is_forged else mutants.damaged(self._content, rng))
        if is_forged:
            mutants.forged(self._path, rng)
        said = mutants.outcome(self._path, self._frames, self._expected, is_forged=is_forged)
        known = {"refused": MESSAGE, "same": RIGHT, "other": RIGHT, "traceback": TRACEBACK}
        return known.get(said.partition(":")[0], WRONG), said


class Pictures(Inputs):
    """JPEG and PNG files."""

    def __init__(self, folder):
        super().__init__(folder)
        image = cv2.resize(np.random.default_rng(0).integers(0, 256, (30, 40, 3), np.uint8), (320, 240))
        self._contents = {}
        for number, (ending, options) in enumerate(
            [(".jpg", ()), (".jpg", (cv2.IMWRITE_JPEG_PROGRESSIVE, 1)), (".png", ())]
        ):
            path = folder / f"{number}{ending}"
            path.write_bytes(cv2.imencode(ending, image, options)[1].tobytes())
            self._contents[path.name] = path.read_bytes(), read_image(path)

    def try_one(self, rng):
        name = str(rng.choice(list(self._contents)))
        content, expected = self._contents[name]
        path = self.folder / f"one{name}"
        path.write_bytes(mutants.damaged(content, rng))
        return (RIGHT if np.array_equal(read_image(path), expected) else WRONG), name


class Videos(Inputs):
    """Video files with common containers and codecs."""

    def __init__(self, folder):
        super().__init__(folder)
        self._contents = {}
        for ending, codec in ((".mp4", "mp4v"), (".avi", "MJPG"), (".webm", "VP80")):
            path = folder / f"whole{ending}"
            writer = cv2.VideoWriter(str(path), cv2.VideoWriter.fourcc(*codec), 25, (160, 120))
            rng = np.random.default_rng(0)
            for _ in range(30):
                patch = rng.integers(0, 256, (6, 8, 3), np.uint8)
                writer.write(cv2.resize(patch, (160, 120), interpolation=cv2.INTER_LINEAR))
            writer.release()
            self._contents[ending] = path.read_bytes(), self._read(path)
            path.unlink()

    def _read(self, path):
        home = video.read_home(path.parent, path.stem)
        images = list(read_frames(path.parent, home.frames))
        return home.frames["seconds"].to_numpy(), images, home.note

    def try_one(self, rng):
        ending = str(rng.choice(list(self._contents)))
        content, (seconds, images, _) = self._contents[ending]
        path = self.folder / f"one{ending}"
        path.write_bytes(mutants.damaged(content, rng))
        try:
            found_seconds, found, note = self._read(path)
        finally:
            path.unlink()
        if note:
            return MESSAGE, note
        is_same = np.array_equal(found_seconds, seconds) and all(map(np.array_equal, found, images))
        return (RIGHT if is_same else WRONG), ending


class Labels(Inputs):
    """Label files of a video. A cell, a line or some bytes are changed."""

    def try_one(self, rng):
        lines = list(LINES)
        kind, at = rng.integers(4), int(rng.integers(len(lines)))
        if kind == 0:
            cells = lines[at].split(",")
            cells[rng.integers(len(cells))] = str(rng.choice(ODD_CELLS))
            lines[at] = ",".join(cells)
        elif kind == 1:
            lines[at] = str(rng.choice(ODD_CELLS))
        elif kind == 2:
            lines.insert(at, lines[rng.integers(len(lines))])
        content = ("\n".join(lines) + "\n").encode()
        path = self.folder / "flat.csv"
        path.write_bytes(mutants.damaged(content, rng) if kind == 3 else content)
        found, at_lines = labels.read_label_csv(path, even(30, 25.0), "the video")
        return (RIGHT if len(found) == len(at_lines) == 30 else WRONG), ""


class Settings(Inputs):
    """Settings. A number in params.yaml changes its type, or becomes a number that no setting has."""

    def __init__(self, folder):
        super().__init__(folder)
        self._text = (ROOT / "params.yaml").read_text(encoding="utf-8")

    def try_one(self, rng):
        params = yaml.load(self._text, Loader=settings.Loader)
        places = list(_numbers(params))
        here, key, name = places[rng.integers(len(places))]
        here[key] = NO_NUMBERS[rng.integers(len(NO_NUMBERS))]
        check(params)
        return WRONG, f"{name}={here[key]}"


def _numbers(here, name=""):
    """Yield the container, the key and the dotted name of every number in nested containers."""
    items = here.items() if isinstance(here, Mapping) else enumerate(here)
    for key, value in items:
        if isinstance(value, Mapping | list):
            yield from _numbers(value, f"{name}{key}.")
        elif isinstance(value, int | float) and not isinstance(value, bool):
            yield here, key, f"{name}{key}"


KINDS = {"models": Models, "pictures": Pictures, "videos": Videos, "labels": Labels, "settings": Settings}
