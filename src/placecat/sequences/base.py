"""What every layout delivers: a home, its frames in order, and its labels as class numbers."""

import difflib
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path, PurePosixPath

import cv2
import numpy as np
import pandas as pd
from numpy.typing import NDArray

from placecat.errors import PlacecatError

COLUMNS = ("sequence", "number", "source", "position", "seconds", "label")
"""The columns of `Home.frames`."""


@dataclass(frozen=True, eq=False)
class Home:
    """One home: where its frames are and what they show. Nothing is decoded.

    Attributes
    ----------
    name
        Unique within its data set. A COLD name has the site, too (``freiburg-seq1_cloudy1``).
    root
        The folder that the `source` column is relative to.
    fps
        Frames a second.
    camera
        A name for the camera; frames of one camera share its height, lens and colour response.
    width, height
        Size of every frame in pixels, taken from the first.
    frames
        One row a frame, in order, indexed 0, 1, ...: ``sequence`` (str: the floor of a VPC home, the sequence
        folder of COLD, "1" for a video or a folder), ``number`` (int32, from 1 in each sequence), ``source``
        (str, POSIX path relative to `root`: an image or the video file), ``position`` (int32, frame position
        in the video from 0; -1 for an image file), ``seconds`` (float64, since the start of the sequence) and
        ``label`` (str as in the label file; "" when there is none).
    label_files
        Sequence to its label file, relative to `root`; empty when there is none.
    label_lines
        (frames,) int32, the line of the label file that gave each frame its label, from 1; 0 when there is
        none.
    """

    name: str
    root: Path
    fps: float
    camera: str
    width: int
    height: int
    frames: pd.DataFrame
    label_files: Mapping[str, str]
    label_lines: NDArray[np.int32]

    def __post_init__(self) -> None:
        if list(self.frames.columns) != list(COLUMNS):
            raise TypeError(f"frames has the columns {list(self.frames.columns)}, not {list(COLUMNS)}")
        if len(self.label_lines) != len(self.frames):
            raise TypeError(f"{len(self.label_lines)} label lines for {len(self.frames)} frames")


def frame_table(
    sequence: Sequence[str] | str,
    source: Sequence[str] | str,
    position: Sequence[int] | int,
    number: Sequence[int],
    seconds: Sequence[float] | NDArray[np.float64],
    label: Sequence[str],
) -> pd.DataFrame:
    """Build `Home.frames` with its column types.

    Parameters
    ----------
    sequence, source, position
        One value a frame, or one for all.
    number, seconds, label
        One value a frame.

    Returns
    -------
    pandas.DataFrame
        The columns `COLUMNS`, indexed from 0.
    """
    table = pd.DataFrame({"number": np.asarray(number, dtype=np.int32)})
    table["sequence"] = sequence
    table["source"] = source
    table["position"] = np.asarray(position, dtype=np.int32)
    table["seconds"] = np.asarray(seconds, dtype=np.float64)
    table["label"] = list(label)
    return table[list(COLUMNS)]


def read_frames(
    home_root: Path | str, frames: pd.DataFrame, *, size: tuple[int, int] | None = None
) -> Iterator[NDArray[np.uint8]]:
    """Decode frames in the order of the rows.

    A video is decoded from its start and frames between rows are passed over; a row that lies before the
    last one re-opens the file. The file is never asked to seek: containers answer with a nearby frame without
    saying so. Rows in increasing position cost one pass.

    Parameters
    ----------
    home_root
        `Home.root`.
    frames
        Any rows of `Home.frames`, in any order.
    size
        (width, height) in pixels that every frame must have; None takes that of the first row.

    Yields
    ------
    numpy.ndarray
        (H, W, 3) uint8, BGR.

    Raises
    ------
    PlacecatError
        If a frame is missing, unreadable, or of another size, naming its file.
    """
    root = Path(home_root)
    video: _Video | None = None
    try:
        for source, position in zip(frames["source"], frames["position"], strict=True):
            path = root / relative(source, "frame list")
            if position < 0:
                image = read_image(path)
            else:
                if video is None or video.path != path:
                    if video is not None:
                        video.close()
                    video = _Video(path)
                image = video.read(int(position))
            found = (image.shape[1], image.shape[0])
            if size is None:
                size = found
            if found != size:
                where = str(path) if position < 0 else f"{path} frame {position + 1}"
                raise PlacecatError(
                    f"{where}: the frame is {found[0]}x{found[1]}, the others of this home are "
                    f"{size[0]}x{size[1]}; a home needs one frame size: convert the frame or take it out."
                )
            yield image
    finally:
        if video is not None:
            video.close()


def read_image(path: Path) -> NDArray[np.uint8]:
    """Decode one image file.

    Parameters
    ----------
    path
        JPEG, PNG or anything else that OpenCV reads.

    Returns
    -------
    numpy.ndarray
        (H, W, 3) uint8, BGR.

    Raises
    ------
    PlacecatError
        If the file is missing, cannot be opened, or is not a whole image.
    """
    try:
        data = np.fromfile(path, dtype=np.uint8)
    except FileNotFoundError:
        raise PlacecatError(f"{path}: the frame is missing; restore it, or correct the label file.") from None
    except OSError as error:
        raise PlacecatError(f"{path}: the frame cannot be opened ({error.strerror}).") from None
    image = cv2.imdecode(data, cv2.IMREAD_COLOR) if data.size else None
    if image is None:
        raise PlacecatError(
            f"{path}: not a readable image ({data.size} bytes; cut off or damaged?); restore the file."
        )
    return image  # type: ignore[return-value]


def open_video(path: Path) -> cv2.VideoCapture:
    """Open a video file at its first frame.

    Parameters
    ----------
    path
        Anything that OpenCV's FFmpeg reads.

    Returns
    -------
    cv2.VideoCapture
        The caller releases it.

    Raises
    ------
    PlacecatError
        If the file is missing or not a video.
    """
    if not path.is_file():
        raise PlacecatError(f"{path}: the video is missing; restore it, or correct dataset.homes.")
    # FFmpeg only: other backends read file names with digits as image series.
    capture = cv2.VideoCapture(str(path), cv2.CAP_FFMPEG)
    if not capture.isOpened():
        raise PlacecatError(
            f"{path}: not a readable video (damaged, or a codec that OpenCV lacks); convert it."
        )
    return capture


class _Video:
    """A video read forwards, re-opened to go back."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self._capture = open_video(path)
        self._next = 0

    def close(self) -> None:
        self._capture.release()

    def read(self, position: int) -> NDArray[np.uint8]:
        if position < self._next:
            self.close()
            self._capture = open_video(self.path)
            self._next = 0
        while self._next < position and self._capture.grab():
            self._next += 1
        done, image = self._capture.read() if self._next == position else (False, None)
        if not done or image is None:
            raise PlacecatError(
                f"{self.path}: frame {position + 1} is missing or unreadable (the video ends after "
                f"{self._next}); restore the file."
            )
        self._next += 1
        return image  # type: ignore[return-value]


def place_labels(
    labels: pd.Series,
    classes: Sequence[str],
    ignored: Sequence[str],
    aliases: Mapping[str, str],
    *,
    home: Home | None = None,
) -> NDArray[np.int16]:
    """Turn label names into class numbers.

    Labels in `ignored` (``transition``, ``corridor``, ...) and frames without a label stay in the sequence as
    unlabelled: not scored, never trained on, but the smoothing filter runs through them (thesis 3.3.2).

    Parameters
    ----------
    labels
        The ``label`` column of `Home.frames`, or rows of it with their index. A missing value, as pandas
        reads an empty cell, is no label.
    classes
        The classes in use; a label's number is its place in this list.
    ignored
        Labels that are no class.
    aliases
        Other spellings and codes: label to class or to ignored label. An alias goes before a class of its
        name.
    home
        The home the labels belong to, for the place in the error message.

    Returns
    -------
    numpy.ndarray
        (len(labels),) int16, -1 unlabelled.

    Raises
    ------
    PlacecatError
        If a label is neither a class, an ignored label nor an alias, or the three settings contradict each
        other.
    """
    _check_names(classes, ignored, aliases)
    numbers = {name: number for number, name in enumerate(classes)}
    numbers.update(dict.fromkeys(ignored, -1))
    numbers.update({alias: numbers[name] for alias, name in aliases.items()})
    numbers[""] = -1
    found, where = np.unique(labels.fillna("").to_numpy(dtype=str), return_inverse=True)
    unknown = [name for name in found if name not in numbers]
    if unknown:
        row = int(np.flatnonzero(np.isin(found, unknown)[where])[0])
        name = str(found[where[row]])
        raise PlacecatError(_unknown_label(name, labels.index[row], [*classes, *ignored, *aliases], home))
    return np.array([numbers[name] for name in found], dtype=np.int16)[where]


def require_classes(labels: NDArray[np.int16], classes: Sequence[str], home: str) -> None:
    """Check that a home shows every class.

    Parameters
    ----------
    labels
        (frames,) int16 from `place_labels`.
    classes
        The classes in use.
    home
        Name of the home, for the message.

    Raises
    ------
    PlacecatError
        If a class has no frame, naming it.
    """
    present = np.bincount(labels[labels >= 0], minlength=len(classes)) > 0
    absent = [name for name, there in zip(classes, present, strict=True) if not there]
    if absent:
        raise PlacecatError(
            f"{home}: no frame is labelled {' or '.join(absent)}; label some, take the home out of "
            "dataset.homes, or the class out of dataset.classes."
        )


def _check_names(classes: Sequence[str], ignored: Sequence[str], aliases: Mapping[str, str]) -> None:
    if not classes:
        raise PlacecatError("dataset.classes is empty; name at least one class.")
    if len(set(classes)) < len(classes):
        twice = next(name for name in classes if list(classes).count(name) > 1)
        raise PlacecatError(f"dataset.classes: {twice!r} is listed twice; remove one.")
    both = sorted(set(classes) & set(ignored))
    if both:
        raise PlacecatError(f"dataset.ignored: {both[0]!r} is also in dataset.classes; remove it from one.")
    for alias, name in aliases.items():
        if name not in classes and name not in ignored:
            raise PlacecatError(
                f"dataset.aliases: {alias!r} stands for {name!r}, which is neither in dataset.classes nor in "
                f"dataset.ignored{_nearest(name, [*classes, *ignored])}; correct it, or add it to "
                "dataset.ignored."
            )


def _nearest(name: str, known: Sequence[str]) -> str:
    folded = {other.casefold().replace(" ", "_"): other for other in known}
    near = difflib.get_close_matches(name.casefold().replace(" ", "_"), folded, n=1)
    return f" (did you mean {folded[near[0]]!r}?)" if near else ""


def _unknown_label(name: str, row: object, known: Sequence[str], home: Home | None) -> str:
    place = f"row {row}"
    if home is not None:
        frame = home.frames.loc[row]  # type: ignore[call-overload]
        line = int(home.label_lines[home.frames.index.get_loc(row)])
        place = f"{home.name}, sequence {frame['sequence']}, frame {frame['number']}"
        if frame["sequence"] in home.label_files:
            place += f" ({home.root / home.label_files[frame['sequence']]} line {line})"
    return (
        f"{place}: unknown label {name!r}{_nearest(name, known)}; correct it, or add it to dataset.ignored "
        "to leave such frames unlabelled (dataset.aliases if it is another name for a class)."
    )


def natural(name: str) -> tuple[tuple[tuple[int, int, str], ...], str]:
    """Sort key under which runs of digits compare as numbers.

    Parameters
    ----------
    name
        A file or folder name.

    Returns
    -------
    tuple
        Comparable with other results; equal only for equal names.
    """
    parts = re.findall(r"[0-9]+|[^0-9]+", name)
    return tuple((0, int(part), "") if part.isdigit() else (1, 0, part.casefold()) for part in parts), name


def relative(name: str, origin: str) -> PurePosixPath:
    """Check that a path stays below the folder it is relative to, by its text.

    Parameters
    ----------
    name
        A POSIX path.
    origin
        Where it was written, for the message.

    Returns
    -------
    pathlib.PurePosixPath
        The path.

    Raises
    ------
    PlacecatError
        If it is empty, absolute, or holds ``..``.
    """
    path = PurePosixPath(name)
    if not path.parts or path.is_absolute() or ".." in path.parts or "\\" in name or "\0" in name:
        raise PlacecatError(f"{origin}: {name!r} is no path below the data folder; correct it.")
    return path


def inside(path: Path, folder: Path, origin: str) -> None:
    """Check that an existing path, links followed, lies in a folder.

    Parameters
    ----------
    path
        A path whose name was read from a file.
    folder
        The folder it may not leave.
    origin
        Where the name was written, for the message.

    Raises
    ------
    PlacecatError
        If a symbolic link leads out of the folder.
    """
    if not path.resolve().is_relative_to(folder.resolve()):
        raise PlacecatError(
            f"{origin}: {path} is a link that leads out of {folder}; put the data itself there."
        )


def data_folder(root: Path) -> Path:
    """Check that the folder of a data set exists.

    Parameters
    ----------
    root
        The folder that holds the homes.

    Returns
    -------
    pathlib.Path
        `root`.

    Raises
    ------
    PlacecatError
        If it is missing or not a folder.
    """
    if not root.is_dir():
        what = "not a folder" if root.exists() else "no such folder"
        raise PlacecatError(f"{root}: {what}; set dataset.root to the folder that holds the homes.")
    return root


def home_folder(root: Path, name: str) -> Path:
    """Find the folder of one home.

    Parameters
    ----------
    root
        The folder that holds the homes.
    name
        The home; may hold slashes.

    Returns
    -------
    pathlib.Path
        An existing folder.

    Raises
    ------
    PlacecatError
        If either folder is missing or the name leads out of `root`.
    """
    folder = data_folder(root) / relative(name, "dataset.homes")
    if not folder.is_dir():
        what = "not a folder" if folder.exists() else "no such folder"
        raise PlacecatError(f"{folder}: {what}; correct dataset.homes or dataset.root.")
    return folder


def some_homes(homes: list[str], root: Path, expected: str) -> list[str]:
    """Sort home names; complain if there are none.

    Parameters
    ----------
    homes
        Names found.
    root
        Where.
    expected
        What a home of this layout consists of, for the message.

    Returns
    -------
    list of str
        In natural order.

    Raises
    ------
    PlacecatError
        If the list is empty.
    """
    if not homes:
        raise PlacecatError(
            f"{root}: no home here; expected {expected}. Correct dataset.root or dataset.layout."
        )
    return sorted(homes, key=natural)


def frame_rate(fps: float | None, home: str, known: float | None = None) -> float:
    """Settle the frame rate of a home.

    Parameters
    ----------
    fps
        The setting; None to use what the files say.
    home
        Name of the home, for the message.
    known
        What the files say, if they do.

    Returns
    -------
    float
        Frames a second, positive.

    Raises
    ------
    PlacecatError
        If neither gives a positive rate.
    """
    rate = known if fps is None else fps
    if rate is None or not np.isfinite(rate) or rate <= 0:
        what = "unknown from the files" if rate is None else f"{rate}"
        raise PlacecatError(f"{home}: the frame rate is {what}; set dataset.fps to a positive number.")
    return float(rate)
