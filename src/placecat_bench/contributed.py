"""OpenCV's contributed saliency, run in a separate process because its package replaces the one in use.

As a program, ``python contributed.py NAME FILE`` reads lines from standard input. For each line, it computes
the maps of all images in an .npz file and then prints a line.
"""

import os
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError

PACKAGE = "opencv-contrib-python-headless"
# `make bench` installs the package here, outside the environment.
FOLDER = Path(sys.prefix) / "contributed"


@contextmanager
def contributed(name: str, pictures: Sequence[NDArray[np.uint8]]) -> Iterator[Callable[[], None]]:
    """Create a function that computes maps of (H, W, 3) images with the `name` class in ``cv2.saliency``.

    The function raises PlacecatError if the package is missing or its process ends.
    """
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "pictures.npz"
        np.savez(file, *pictures)
        environment = os.environ | {"PYTHONPATH": str(FOLDER), "OMP_NUM_THREADS": "1"}
        command = [sys.executable, __file__, name, str(file)]
        with subprocess.Popen(
            command, env=environment, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        ) as process:

            def compute() -> None:
                assert process.stdin is not None
                assert process.stdout is not None
                with suppress(BrokenPipeError):
                    print(file=process.stdin, flush=True)
                if not process.stdout.readline():
                    raise PlacecatError(f"{PACKAGE} in {FOLDER} does not work: run `make bench`")

            yield compute
            process.communicate()


def _main(name: str, file: str) -> None:
    import cv2

    cv2.setNumThreads(1)
    with np.load(file) as saved:
        pictures = [saved[key] for key in saved.files]
    saliency = getattr(cv2.saliency, f"{name}_create")()  # type: ignore[attr-defined]
    for _ in sys.stdin:
        for picture in pictures:
            saliency.computeSaliency(picture)
        print(flush=True)


if __name__ == "__main__":
    _main(*sys.argv[1:])
