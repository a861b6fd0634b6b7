"""A video file a home, with a label CSV: ``<name>.mp4`` and ``<name>.csv``.

Without the CSV every frame is unlabelled, which is enough to predict on new footage.
"""

from pathlib import Path

import cv2
import numpy as np

from placecat.errors import PlacecatError
from placecat.sequences.base import Home, frame_table, open_video
from placecat.sequences.folders import data_folder, frame_rate, relative, some_homes
from placecat.sequences.labels import label_csvs, read_label_csv

SUFFIXES = (".avi", ".m4v", ".mkv", ".mov", ".mp4", ".mpeg", ".mpg", ".webm")
"""File name endings taken for a video, in either case."""


def list_homes(root: Path) -> list[str]:
    """Name the videos without their endings; no two may be alike. See `placecat.sequences.list_homes`."""
    files = [path for path in data_folder(root).iterdir() if _is_video(path)]
    homes = some_homes([path.stem for path in files], root, f"videos ({', '.join(SUFFIXES)})")
    for name in homes:
        _file(root, name)
    return homes


def read_home(root: Path, name: str, *, fps: float | None = None, camera: str = "") -> Home:
    """Read one video as one sequence, ``1``; see `placecat.sequences.open_home`.

    Without `fps` the rate is that of the container. The frames are counted by passing over the whole video
    once: the number in the container is often an estimate.
    """
    relative(name, "dataset.homes")
    path = _file(data_folder(root), name)
    count, known, width, height = _measure(path)
    rate = frame_rate(fps, name, known)
    files = label_csvs(root, f"{name}.csv")
    if files:
        labels, lines = read_label_csv(root / files[0], count, rate, "the video")
    else:
        labels, lines = [""] * count, np.zeros(count, dtype=np.int32)
    positions = np.arange(count)
    return Home(
        name=name,
        root=root,
        fps=rate,
        camera=camera,
        width=width,
        height=height,
        frames=frame_table(
            "1",
            path.relative_to(root).as_posix(),
            positions.tolist(),
            (positions + 1).tolist(),
            positions / rate,
            labels,
        ),
        label_files={"1": files[0]} if files else {},
        label_lines=lines,
    )


def _is_video(path: Path) -> bool:
    return path.suffix.lower() in SUFFIXES and not path.name.startswith(".") and path.is_file()


def _file(root: Path, name: str) -> Path:
    wanted = root / name
    beside = wanted.parent.iterdir() if wanted.parent.is_dir() else []
    found = sorted(path for path in beside if _is_video(path) and path.stem == wanted.name)
    if not found:
        raise PlacecatError(
            f"{root / name}: no video of this name ({', '.join(SUFFIXES)}); correct dataset.homes."
        )
    if len(found) > 1:
        raise PlacecatError(f"{found[1]}: {found[0].name} has the same name; rename or remove one.")
    return found[0]


def _measure(path: Path) -> tuple[int, float | None, int, int]:
    capture = open_video(path)
    try:
        done, first = capture.read()
        if not done:
            raise PlacecatError(f"{path}: the video has no readable frame; restore or convert it.")
        count = 1
        while capture.grab():
            count += 1
        fps = capture.get(cv2.CAP_PROP_FPS)
    finally:
        capture.release()
    return count, fps if fps > 0 else None, first.shape[1], first.shape[0]
