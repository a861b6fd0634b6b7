"""Layout with one folder of frames per home, ``<name>``.

Frames are JPEG or PNG files; see `placecat.footage.pictures.list_frames`. Labels are in ``<name>.csv`` or
``<name>/labels.csv``. If neither exists, every frame is unlabelled.
"""

from pathlib import Path

from placecat.errors import PlacecatError
from placecat.footage.pictures import SUFFIXES, list_frames
from placecat.footage.timing import even
from placecat.sequences.base import Home, frame_table, home_of_pictures
from placecat.sequences.folders import frame_rate, home_folder
from placecat.sequences.labels import find_labels


def read_home(root: Path, name: str, *, fps: float | None = None, camera: str = "") -> Home:
    """Read one folder as one sequence, ``1``; see `placecat.sequences.open_home`. `fps` is required."""
    path = home_folder(root, name)
    images = list_frames(path)
    if not images:
        raise PlacecatError(
            f"{path} contains no frames ({', '.join(SUFFIXES)}); correct dataset.homes or dataset.root."
        )
    rate = frame_rate(fps, name)
    timing = even(len(images), rate)
    labels = find_labels(root, [f"{name}.csv", f"{name}/labels.csv"], timing, "the folder")
    sources = [f"{name}/{image}" for image in images]
    frames = frame_table("1", sources, -1, range(1, len(images) + 1), timing.seconds, labels.names)
    label_files = {} if labels.file is None else {"1": labels.file}
    return home_of_pictures(name, root, rate, camera, frames, label_files, labels.lines)
