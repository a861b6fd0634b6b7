"""Render a seed's homes into a folder, one by one. If a run is killed, the next one picks up from there."""

import hashlib
import shutil
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from importlib import metadata
from pathlib import Path
from typing import Any

import cv2
import yaml

from placecat import files, settings
from placecat.compute.parallel import in_parallel
from placecat.errors import PlacecatError
from placecat.footage.frames import read_frames
from placecat.runs import lock
from placecat.sequences import open_home
from placecat_homes import contact_sheet, render
from placecat_homes.drawn import homes
from placecat_homes.drawn.homes import Source
from placecat_homes.drawn.ranges import KINDS

RECORD = "homes.yaml"
"""File in the folder that records how the homes were made."""
PACKAGES = ("numpy", "scipy", "opencv-python-headless", "numba", "embreex", "av")
"""Libraries whose versions can change the bytes of a video."""

_LIMIT = 1000


def render_homes(
    count: int, seed: int, folder: Path, *, only_plans: bool = False, **video: int
) -> list[Path]:
    """Draw homes and render those that are not yet in the folder.

    Parameters
    ----------
    count
        Number of homes, from 1 to 1000. Home 7 is the same home whether 7 or 24 homes are made.
    seed
        Seed of the set of homes, from 0 to 2**32 - 1.
    folder
        Folder for files such as `home_7.mp4`, `home_7.csv`, `plans/home_7.yaml` and `plans/home_7.png` (a
        view from above).
    only_plans
        Draw the floor plans, but do not render videos.
    **video
        Values that override `video` in conf/drawn.yaml: width, height, frames, fps.

    Returns
    -------
    list of Path
        The videos, or the plans.

    Raises
    ------
    PlacecatError
        If a number is out of range, the folder contains other homes, another run is using the folder, or an
        extra is not installed.
    """
    if not 1 <= count <= _LIMIT:
        raise PlacecatError(f"--homes must be from 1 to {_LIMIT}, not {count}")
    if not 0 <= seed < 2**32:
        raise PlacecatError(f"--seed must be from 0 to {2**32 - 1}, not {seed}")
    source = Source.read(**video)
    render.require_extra()
    with _alone(folder):
        _claim(folder, seed, source)
        numbers = range(1, count + 1)
        missing = [(k, seed, folder, source) for k in numbers if not _has_plan(folder, k)]
        in_parallel(_plan, missing, "drawing plans", unit="homes", locally=True)
        if only_plans:
            return [_plan_path(folder, k) for k in numbers]
        missing = [(k, seed, folder, source) for k in numbers if not _has_video(folder, k)]
        in_parallel(_render, missing, "rendering homes", unit="homes", locally=True)
        _draw_contact_sheet(folder, count)
    return [_video_path(folder, k) for k in numbers]


def _plan(number: int, seed: int, folder: Path, source: Source) -> None:
    from placecat_homes.drawn.top_view import top_view

    home = homes.draw(number, seed, source)
    path = _plan_path(folder, number)
    with files.replacing(path.with_suffix(".png")) as temporary:
        temporary.write_bytes(cv2.imencode(".png", top_view(home.building, home.walk))[1].tobytes())
    files.write_text(path, home.text())


def _render(number: int, seed: int, folder: Path, source: Source) -> None:
    made = film(_plan_path(folder, number), source)
    with render.writing(_video_path(folder, number)) as (video, labels):
        render.write(made, video, labels, fps=source.video.fps)


def film(path: Path, source: Source, **changes: Any) -> "render.Film":
    """Make the film of a drawn home from its description file.

    Parameters
    ----------
    path
        `plans/home_7.yaml` in the folder.
    source
        Settings of the camera, the walk and the frame size.
    **changes
        Values that override settings in conf/finish.yaml.

    Returns
    -------
    Film
        The film, lit but not yet rendered.
    """
    content = settings.read_yaml(path, "remove the folder and run again")
    settings.refuse_unknown(content, ["shot", "plan"], str(path))
    shot = dict(content["shot"])
    name, plan = str(shot.pop("name")), content["plan"]
    of_video = {
        "walk": source.walk,
        "carriage": source.carriage,
        "camera": source.camera,
        "frames": source.video.frames,
        "fps": source.video.fps,
    }
    size = (source.video.width, source.video.height)
    return render.assemble(
        name, shot | of_video, str(plan["name"]), plan, where=f"{path} shot", size=size, **changes
    )


def _video_path(folder: Path, number: int) -> Path:
    return folder / f"home_{number}.mp4"


def _plan_path(folder: Path, number: int) -> Path:
    return folder / "plans" / f"home_{number}.yaml"


def _has_plan(folder: Path, number: int) -> bool:
    path = _plan_path(folder, number)
    return path.is_file() and path.with_suffix(".png").is_file()


def _has_video(folder: Path, number: int) -> bool:
    path = _video_path(folder, number)
    return path.is_file() and path.with_suffix(".csv").is_file()


def _draw_contact_sheet(folder: Path, count: int) -> None:
    views = {}
    for name in (f"home_{number}" for number in range(1, count + 1)):
        home = open_home("video", folder, name)
        frames = read_frames(home.root, home.frames)
        views[name] = contact_sheet.sharpest(frames, list(home.frames["label"]), KINDS)
    picture = contact_sheet.draw(views, KINDS)
    with files.replacing(folder / "contact_sheet.jpg") as path:
        path.write_bytes(cv2.imencode(".jpg", picture, [cv2.IMWRITE_JPEG_QUALITY, 88])[1].tobytes())


@contextmanager
def _alone(folder: Path) -> Iterator[None]:
    """Lock a folder against other runs for the duration of a block, and clean up after any killed run."""
    with lock.of_folder(folder, "renders into"):
        for left in (*folder.glob(f"{render.TEMPORARY}*"), *folder.glob("**/.*.partial.*")):
            shutil.rmtree(left) if left.is_dir() else left.unlink()
        yield


def _claim(folder: Path, seed: int, source: Source) -> None:
    """Record how the homes in a folder were made, or check that an existing record matches."""
    record = {
        "seed": seed,
        "video": vars(source.video),
        "renderer": _checksum(homes.SETTINGS.parent),
        "versions": {name: metadata.version(name) for name in PACKAGES if _is_installed(name)},
    }
    path = folder / RECORD
    if not path.exists():
        if any(folder.glob("*.mp4")):
            raise PlacecatError(f"{folder} has videos but no {RECORD}: choose another folder (--to)")
        files.write_text(path, f"# Made by placecat-homes.\n{yaml.safe_dump(record, sort_keys=False)}")
        return
    written = settings.flatten(settings.read_yaml(path, "choose another folder (--to)"))
    for name, value in settings.flatten(record).items():
        if written.get(name) != value:
            raise PlacecatError(
                f"{folder} has homes with a different {name} ({written.get(name)}, now {value}): choose "
                "another folder (--to), or remove this one"
            )


def _is_installed(name: str) -> bool:
    return any(metadata.distributions(name=name))


def _checksum(package: Path) -> str:
    """Compute the SHA-256 checksum of a package's code and settings."""
    content = hashlib.sha256()
    for path in sorted((*package.rglob("*.py"), *package.rglob("*.yaml"))):
        content.update(f"{path.relative_to(package).as_posix()}\n".encode() + path.read_bytes())
    return content.hexdigest()


def dataset(folder: Path) -> Mapping[str, Any]:
    """Describe a folder of rendered homes as a data set, in the format of the files in conf/dataset.

    Raises PlacecatError if the folder has no homes.
    """
    names = sorted((path.stem for path in folder.glob("home_*.mp4")), key=lambda name: (len(name), name))
    if not names:
        raise PlacecatError(f"{folder} has no homes: render them with placecat-homes --homes 24 --seed 1")
    return {
        "layout": "video",
        "root": folder,
        "homes": names,
        "fps": None,
        "classes": list(KINDS),
        "ignored": ["transition", "corridor"],
        "aliases": {},
    }
