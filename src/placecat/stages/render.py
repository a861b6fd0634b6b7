"""Stage `render`: make the videos that come with the project. Frozen; needs the optional extra `render`."""

import csv
import tempfile
from itertools import groupby
from pathlib import Path
from typing import TYPE_CHECKING, Any

import cv2
import yaml

from placecat import files, paths, settings
from placecat.errors import PlacecatError
from placecat.parallel import in_parallel
from placecat.reporting import contact_sheet
from placecat.sequences import open_home
from placecat.sequences.base import read_frames
from placecat.stages import run

if TYPE_CHECKING:
    from placecat.rendering.film import Film

FOLDER = Path("conf/rendering")


def main(*names: str) -> None:
    """Render all videos, or those named, e.g. ``homes/home_1``."""
    videos = listed()
    wanted = names or tuple(videos)
    for name in wanted:
        if name not in videos:
            where = FOLDER / "videos.yaml"
            raise PlacecatError(f"{where} has no video {name!r} (valid: {', '.join(videos)})")
    in_parallel(_render, [(name,) for name in wanted], "rendering videos", locally=True)
    draw_contact_sheet()


def draw_contact_sheet() -> None:
    """Draw a view of every place of each home into data/contact_sheet.jpg."""
    dataset = yaml.safe_load((paths.CONF / "dataset/homes.yaml").read_text(encoding="utf-8"))
    chosen = _read("contact_sheet")
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
        ``data set/name`` to settings.
    """
    return {
        f"{folder}/{name}": video
        for folder, group in _read("videos").items()
        for name, video in group.items()
    }


def film(name: str, **changes: Any) -> "Film":
    """Make the film of one video from its settings.

    Parameters
    ----------
    name
        ``data set/name``.
    **changes
        To the settings in conf/rendering/finish.yaml.

    Returns
    -------
    Film
        Lit, not yet rendered.

    Raises
    ------
    PlacecatError
        If the optional extra is missing, or a setting is unknown.
    """
    try:
        from placecat.rendering.bake import Quality
        from placecat.rendering.film import Film, Finish, Shot
    except ImportError as error:
        raise PlacecatError(
            f"rendering needs the optional extra ({error.name} is missing): pip install -e '.[render]'"
        ) from None
    from placecat.rendering.floorplan import FloorPlan
    from placecat.rendering.sensor import Sensor
    from placecat.rendering.view import Lens
    from placecat.rendering.walking.carriage import Carriage
    from placecat.rendering.walking.walk_statistics import Statistics

    video = dict(listed()[name])
    where = f"{FOLDER / 'videos.yaml'} {name}"
    plan, walk, carriage, camera = (video.pop(key) for key in ("plan", "walk", "carriage", "camera"))
    if "rooms" in video:
        video["rooms"] = tuple(video["rooms"])
    lens_and_sensor = _read(f"camera/{camera}")
    finish = _read("finish") | changes
    finish.pop("video", None)
    light = settings.call(Quality, settings=finish.pop("light"), where=f"{FOLDER}/finish.yaml light")
    gains = lens_and_sensor["sensor"] | {"gains": tuple(lens_and_sensor["sensor"]["gains"])}
    return Film(
        settings.call(Shot, name, settings=video, where=where),
        FloorPlan.from_dict(plan, _read(f"plan/{plan}")),
        Statistics.of(_read(f"walk/{walk}")),
        Carriage.of(_read(f"carriage/{carriage}")),
        settings.call(Lens, settings=lens_and_sensor["lens"], where=f"{FOLDER}/camera/{camera}.yaml lens"),
        settings.call(Sensor, settings=gains, where=f"{FOLDER}/camera/{camera}.yaml sensor"),
        settings.call(Finish, settings=finish | {"light": light}, where=f"{FOLDER}/finish.yaml"),
    )


def _render(name: str) -> None:
    from placecat.rendering.encode import write_video

    made = film(name)
    target = paths.DATA / f"{name}.mp4"
    target.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=target.parent) as folder:
        video, labels = Path(folder) / target.name, Path(folder) / f"{target.stem}.csv"
        write_video(video, made.frames(), fps=listed()[name]["fps"], **_read("finish")["video"])
        _write_labels(labels, made.labels)
        video.replace(target)
        labels.replace(target.with_suffix(".csv"))


def _write_labels(path: Path, labels: list[str]) -> None:
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(("start", "end", "label"))
        start = 1
        for label, stay in groupby(labels):
            count = len(list(stay))
            writer.writerow((start, start + count - 1, label))
            start += count


def _read(name: str) -> dict[str, Any]:
    path = FOLDER / f"{name}.yaml"
    try:
        return yaml.safe_load(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise PlacecatError(f"{path} is missing; run in the project's folder") from None
    except yaml.YAMLError as error:
        raise PlacecatError(f"{path} is no valid YAML: {' '.join(str(error).split())}") from None


if __name__ == "__main__":
    run(main, items="video")
