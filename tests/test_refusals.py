"""On a full disk or without permission, one message names the file, and no incomplete file is left."""

import errno
import os
import resource
import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

from placecat import files
from placecat.errors import PlacecatError, exiting
from placecat.predict.film import Film

LARGE = np.random.default_rng(0).random(20000)
WRITERS = {
    "array.npy": lambda path: files.write_array(path, LARGE),
    "arrays.npz": lambda path: files.write_arrays(path, {"a": LARGE}),
    "content.json": lambda path: files.write_json(path, list(LARGE)),
    "table.csv": lambda path: files.write_csv(path, pd.DataFrame({"a": LARGE})),
    "text.txt": lambda path: files.write_text(path, "a" * 200_000),
}


@pytest.fixture
def small_files():
    """Limit files to 100 kB; larger ones fail as on a full disk."""
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    handler = signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (100_000, before[1]))
    yield
    resource.setrlimit(resource.RLIMIT_FSIZE, before)
    signal.signal(signal.SIGXFSZ, handler)


@pytest.mark.parametrize("name", WRITERS)
def test_a_failed_write_names_the_file_and_leaves_the_old_one(tmp_path, name, small_files):
    target = tmp_path / name
    target.write_text("before")
    with pytest.raises(
        PlacecatError, match=rf"cannot write .*{name}: .*; (allow larger files|free some space)"
    ):
        WRITERS[name](target)
    assert target.read_text() == "before"
    assert [path.name for path in tmp_path.iterdir()] == [name]


@pytest.mark.parametrize(
    ("number", "remedy"),
    [
        (errno.ENOSPC, "free some space"),
        (errno.EACCES, "permission"),
        (errno.EROFS, "choose a writable folder"),
        (errno.ENAMETOOLONG, "shorter name"),
    ],
)
def test_system_errors_give_one_message(number, remedy):
    with pytest.raises(SystemExit) as caught, exiting():
        raise OSError(number, os.strerror(number), "some/file.csv")
    assert str(caught.value).startswith(f"placecat: some/file.csv: {os.strerror(number)}; ")
    assert remedy in str(caught.value)


def test_an_error_of_the_program_keeps_its_traceback():
    with pytest.raises(FileNotFoundError), exiting():
        Path("/nowhere/at/all").read_text()


def test_a_closed_pipe_ends_silently():
    program = "from placecat.errors import exiting\nwith exiting():\n    while True:\n        print('line')"
    process = subprocess.Popen(
        [sys.executable, "-c", program], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    process.stdout.readline()
    process.stdout.close()
    assert process.stderr.read() == ""
    assert process.wait(20) == 1
    process.stderr.close()


@pytest.mark.parametrize("suffix", [".mp4", ".webm"])
def test_an_incomplete_video_raises_an_error(tmp_path, suffix, small_files):
    pictures = np.random.default_rng(0).integers(0, 255, (50, 120, 160, 3)).astype(np.uint8)
    path = tmp_path / f"film{suffix}"
    film = Film(path, 10.0, (160, 120))
    with pytest.raises(PlacecatError, match=rf"film{suffix} could not be written in full"), film:
        for number, picture in enumerate(pictures):
            film.add(picture, number / 10)
    with Film(path, 10.0, (160, 120)) as film:
        film.add(pictures[0], 0.0)
