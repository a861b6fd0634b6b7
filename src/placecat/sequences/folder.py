"""A folder of frames a home, with a label CSV: ``<name>/*.jpg`` and ``<name>.csv`` or ``<name>/labels.csv``.

Frames are JPEG or PNG files, see `placecat.footage.pictures.list_frames`. Without a CSV every frame is
unlabelled.
"""

from pathlib import Path

import numpy as np

from placecat.errors import PlacecatError
from placecat.footage.pictures import SUFFIXES, has_pictures, list_frames, read_image
from placecat.sequences.base import Home, frame_table
from placecat.sequences.folders import data_folder, frame_rate, home_folder, some_homes
from placecat.sequences.labels import label_csvs, read_label_csv


def list_homes(root: Path) -> list[str]:
    """Name the folders that hold images; see `placecat.sequences.list_homes`."""
    homes = [path.name for path in data_folder(root).iterdir() if path.is_dir() and has_pictures(path)]
    return some_homes(homes, root, f"folders of images ({', '.join(SUFFIXES)})")


def read_home(root: Path, name: str, *, fps: float | None = None, camera: str = "") -> Home:
    """Read one folder as one sequence, ``1``; see `placecat.sequences.open_home`. `fps` has to be given."""
    path = home_folder(root, name)
    images = list_frames(path)
    if not images:
        raise PlacecatError(
            f"{path}: no frames here ({', '.join(SUFFIXES)}); correct dataset.homes or dataset.root."
        )
    rate = frame_rate(fps, name)
    files = label_csvs(root, f"{name}.csv", f"{name}/labels.csv")
    if len(files) > 1:
        raise PlacecatError(f"{root / files[0]}: {root / files[1]} labels the same home; remove one.")
    if files:
        labels, lines = read_label_csv(root / files[0], len(images), rate, "the folder")
    else:
        labels, lines = [""] * len(images), np.zeros(len(images), dtype=np.int32)
    height, width = read_image(path / images[0]).shape[:2]
    numbers = np.arange(1, len(images) + 1)
    return Home(
        name=name,
        root=root,
        fps=rate,
        camera=camera,
        width=width,
        height=height,
        frames=frame_table(
            "1", [f"{name}/{image}" for image in images], -1, numbers.tolist(), (numbers - 1) / rate, labels
        ),
        label_files={"1": files[0]} if files else {},
        label_lines=lines,
    )
