"""Render the project's videos, using the settings in this package's conf/ folder."""

import csv
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from itertools import groupby
from pathlib import Path
from typing import TYPE_CHECKING, Any

import cv2
import yaml

from placecat import files, paths, settings
from placecat.compute.parallel import in_parallel
from placecat.errors import PlacecatError
from placecat.footage.frames import read_frames
from placecat.sequences import open_home
from placecat_homes import contact_sheet

if TYPE_CHECKING:
    from placecat_homes.film import Film

SETTINGS = Path(__file__).with_name("conf")
DATASET = paths.CONF / "dataset/homes.yaml"
TEMPORARY = ".rendering-"
"""Prefix of the temporary folders that videos are rendered in."""


def render(names: Sequence[str] = ()) -> None:
    """Render videos into the current folder's data/ folder and draw the contact sheet.

    Parameters
    ----------
    names
        Names of the videos, such as ``homes/home_1``; all if empty.

    Raises
    ------
    PlacecatError
        If a video does not exist, the ``render`` extra is not installed, or the current folder is not the
        project's folder.
    """
    videos = listed()
    wanted = names or tuple(videos)
    for name in wanted:
        if name not in videos:
            raise PlacecatError(f"there is no video {name!r}: choose from {', '.join(videos)}")
    if not DATASET.is_file():
        raise PlacecatError(f"{DATASET} is missing: run this command in the project's folder")
    in_parallel(_render, [(name,) for name in wanted], "rendering videos", locally=True)
    draw_contact_sheet()


def draw_contact_sheet() -> None:
    """Write data/contact_sheet.jpg, which shows every place in every home."""
    dataset = _read(DATASET)
    chosen = _read_settings("contact_sheet")
    views = {}
    for name in dataset["homes"]:
        home = open_home(dataset["layout"], Path(dataset["root"]), name)
        frames = read_frames(home.root, home.frames)
        by_eye = chosen.get(name, {})
        labels = contact_sheet.only(list(home.frames["label"]), by_eye)
        views[name] = contact_sheet.sharpest(frames, labels, dataset["classes"])
    picture = contact_sheet.draw(views, dataset["classes"])
    with files.replacing(paths.CONTACT_SHEET) as path:
        path.write_bytes(cv2.imencode(".jpg", picture, [cv2.IMWRITE_JPEG_QUALITY, 88])[1].tobytes())


def listed() -> dict[str, dict[str, Any]]:
    """Read the list of videos.

    Returns
    -------
    dict
        Maps ``data set/name`` to the settings of the video.
    """
    return {
        f"{folder}/{name}": video
        for folder, group in _read_settings("videos").items()
        for name, video in group.items()
    }


def film(name: str, **changes: Any) -> "Film":
    """Make a video's film from its settings.

    Parameters
    ----------
    name
        ``data set/name``.
    **changes
        Values that override settings in conf/finish.yaml.

    Returns
    -------
    Film
        The film, lit but not yet rendered.

    Raises
    ------
    PlacecatError
        If the ``render`` extra is not installed, or a setting is unknown.
    """
    video = dict(listed()[name])
    plan = video.pop("plan")
    of_plan = _read_settings(f"plan/{plan}")
    return assemble(name, video, plan, of_plan, where=f"{SETTINGS / 'videos.yaml'} {name}", **changes)


def assemble(
    name: str,
    video: Mapping[str, Any],
    plan: str,
    of_plan: Mapping[str, Any],
    *,
    where: str,
    size: tuple[int, int] | None = None,
    **changes: Any,
) -> "Film":
    """Make a film from a plan and a video's settings.

    Parameters
    ----------
    name
        Name of the video.
    video
        Settings as in conf/videos.yaml, without the plan.
    plan, of_plan
        Name and contents of the plan.
    where
        How messages refer to the video's settings.
    size
        Width and height of a frame in pixels; by default, those of the camera's frames.
    **changes
        Values that override settings in conf/finish.yaml.

    Returns
    -------
    Film
        The film, lit but not yet rendered.

    Raises
    ------
    PlacecatError
        If the ``render`` extra is not installed, or a setting is unknown.
    """
    require_extra()
    from placecat_homes.bake import Quality
    from placecat_homes.film import Film, Finish, Shot
    from placecat_homes.floorplan import FloorPlan
    from placecat_homes.sensor import Sensor
    from placecat_homes.view import Lens
    from placecat_homes.walking.carriage import Carriage
    from placecat_homes.walking.walk_statistics import Statistics

    shot = dict(video)
    walk, carriage, camera = (shot.pop(key) for key in ("walk", "carriage", "camera"))
    if "rooms" in shot:
        shot["rooms"] = tuple(shot["rooms"])
    lens_and_sensor = _read_settings(f"camera/{camera}")
    lens = dict(lens_and_sensor["lens"])
    if size is not None:
        lens["width"], lens["height"] = size
    finish = _read_settings("finish") | changes
    finish.pop("video", None)
    light = settings.call(Quality, settings=finish.pop("light"), where=f"{SETTINGS}/finish.yaml light")
    gains = lens_and_sensor["sensor"] | {"gains": tuple(lens_and_sensor["sensor"]["gains"])}
    return Film(
        settings.call(Shot, name, settings=shot, where=where),
        FloorPlan.from_dict(plan, of_plan),
        Statistics.of(_read_settings(f"walk/{walk}")),
        Carriage.of(_read_settings(f"carriage/{carriage}")),
        settings.call(Lens, settings=lens, where=f"{SETTINGS}/camera/{camera}.yaml lens"),
        settings.call(Sensor, settings=gains, where=f"{SETTINGS}/camera/{camera}.yaml sensor"),
        settings.call(Finish, settings=finish | {"light": light}, where=f"{SETTINGS}/finish.yaml"),
    )


def require_extra() -> None:
    """Raise PlacecatError if the ``render`` extra is not installed."""
    try:
        import placecat_homes.film  # noqa: F401
    except ImportError as error:
        raise PlacecatError(
            f"rendering needs the optional extra ({error.name} is missing): pip install -e '.[render]'"
        ) from None


def _render(name: str) -> None:
    target = paths.DATA / f"{name}.mp4"
    with writing(target) as (video, labels):
        write(film(name), video, labels, fps=listed()[name]["fps"])


def write(made: "Film", video: Path, labels: Path, *, fps: int) -> None:
    """Render a film to a video file and write its labels."""
    from placecat_homes.encode import write_video

    write_video(video, made.frames(), fps=fps, **_read_settings("finish")["video"])
    _write_labels(labels, made.labels)


@contextmanager
def writing(target: Path) -> Iterator[tuple[Path, Path]]:
    """Yield temporary paths for a video and its labels. On success, move both into place, the video last."""
    target.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=target.parent, prefix=TEMPORARY) as folder:
        video, labels = Path(folder) / target.name, Path(folder) / f"{target.stem}.csv"
        yield video, labels
        labels.replace(target.with_suffix(".csv"))
        video.replace(target)


def _write_labels(path: Path, labels: list[str]) -> None:
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(("start", "end", "label"))
        start = 1
        for label, stay in groupby(labels):
            count = len(list(stay))
            writer.writerow((start, start + count - 1, label))
            start += count


def _read_settings(name: str) -> dict[str, Any]:
    return _read(SETTINGS / f"{name}.yaml")


def _read(path: Path) -> dict[str, Any]:
    try:
        return yaml.safe_load(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise PlacecatError(f"{path} is missing: restore it from git") from None
    except yaml.YAMLError as error:
        raise PlacecatError(f"{path} is not valid YAML: {' '.join(str(error).split())}") from None
