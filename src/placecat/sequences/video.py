"""Layout with one video and one label file per home: ``<name>.mp4`` and ``<name>.csv``.

If there is no CSV, every frame is unlabelled. Predictions on new footage need no labels.
"""

from collections.abc import Iterator
from pathlib import Path

from placecat.errors import PlacecatError
from placecat.footage.names import relative
from placecat.footage.recording import Recording
from placecat.sequences.base import Home
from placecat.sequences.folders import by_name, data_folder, frame_rate
from placecat.sequences.labels import find_labels
from placecat.sequences.recorded import home_of

SUFFIXES = (".avi", ".m4v", ".mkv", ".mov", ".mp4", ".mpeg", ".mpg", ".webm")
"""Suffixes of video files, in upper or lower case."""


def read_home(root: Path, name: str, *, fps: float | None = None, camera: str = "") -> Home:
    """Read one video as one sequence, ``1``; see `placecat.sequences.open_home`.

    Without `fps`, the times come from the file.
    """
    wanted = data_folder(root) / relative(name, "dataset.homes")
    beside = _videos(wanted.parent) if wanted.parent.is_dir() else ()
    videos = by_name(path for path in beside if path.stem == wanted.name)
    if not videos:
        raise PlacecatError(
            f"{wanted}: there is no video with this name ({', '.join(SUFFIXES)}); correct dataset.homes."
        )
    recording = Recording(videos[wanted.name])
    timing = recording.timing(None if fps is None else frame_rate(fps, name))
    labels = find_labels(root, [f"{name}.csv"], timing, "the video")
    return home_of(name, root, camera, [("1", recording, timing, labels)], "video")


def _videos(folder: Path) -> Iterator[Path]:
    for path in folder.iterdir():
        if path.suffix.lower() in SUFFIXES and not path.name.startswith(".") and path.is_file():
            yield path
