"""The command ``placecat import panoramas``."""

import shlex
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from placecat import files, paths, schema
from placecat.compute import parallel
from placecat.config import conf_file, overrides
from placecat.errors import PlacecatError, one_line
from placecat.panoramas import sources, texts
from placecat.panoramas.panorama import Panorama
from placecat.panoramas.plan import Plans, plan, unseen
from placecat.panoramas.render import render
from placecat.schema.panoramas import Panoramas
from placecat.sequences.vpc2009 import LABEL_FILE
from placecat.settings import read_yaml

SETTINGS = paths.CONF / "panoramas.yaml"
LOOKS = "looks.csv"
# The data set configuration in conf/dataset that reads these homes.
DATASET = "my_homes"
# Maximum number of unused panoramas listed on the terminal. The data card lists all of them.
_NAMED = 5


def read_settings(changes: Sequence[str] = (), path: Path = SETTINGS) -> dict[str, Any]:
    """Read conf/panoramas.yaml, and apply Hydra overrides such as ``fps=10.0``.

    Raises PlacecatError if the file is missing, or if a setting is unknown, missing or invalid.
    """
    content = conf_file.read(path, list(Panoramas.model_fields), changes)
    schema.check(content, Panoramas)
    return content


def import_command(source: Path, destination: Path, changes: Sequence[str]) -> int:
    """Turn the panoramas in a folder into homes, and print the next command to run.

    `destination` is a new folder, which appears only once it is complete. `changes` are Hydra overrides.
    Returns 0. User errors raise PlacecatError and leave nothing behind.
    """
    settings = read_settings(changes)
    classes = read_yaml(paths.CONF / "dataset" / f"{DATASET}.yaml")["classes"]
    _refuse_existing(destination)
    panoramas = sources.read(source, settings)
    homes = dict.fromkeys(one.home for one in panoramas)
    plans = {home: plan([one for one in panoramas if one.home == home], settings) for home in homes}
    with files.replacing(destination) as temporary:
        temporary.mkdir()
        _write_frames(temporary, source, plans, settings)
        for home, floors in plans.items():
            files.write_text(temporary / home / LABEL_FILE, texts.label_file(floors))
            files.write_csv(temporary / home / LOOKS, texts.looks_table(floors))
        text = texts.card(plans, panoramas, settings, source.resolve().name)
        files.write_text(temporary / texts.CARD, text)
        # Another program may have created the folder in the meantime.
        _refuse_existing(destination)
    _print(destination, plans, classes, settings, panoramas)
    return 0


def _refuse_existing(destination: Path) -> None:
    files.check_target(destination)
    if destination.exists() or destination.is_symlink():
        raise PlacecatError(f"{destination} already exists: choose another name, or move it elsewhere")


def _write_frames(folder: Path, source: Path, plans: Plans, settings: Mapping[str, Any]) -> None:
    """Write the frames of all homes."""
    looks = [
        (folder / home / floor, look)
        for home, floors in plans.items()
        for floor, own in floors.items()
        for look in own
    ]
    for place in dict.fromkeys(place for place, _ in looks):
        place.mkdir(parents=True)
    options = tuple(settings[name] for name in ("width", "height", "quality"))
    tasks = [
        (tuple(source / file for file in look.panorama.files), look.panorama.origin, look.path, *options)
        for _, look in looks
    ]
    rendered = parallel.stream(render, tasks, "panoramas", unit="looks", locally=True)
    for (place, look), frames in zip(looks, rendered, strict=True):
        for number, frame in enumerate(frames, start=look.first):
            (place / f"{number:08d}.jpg").write_bytes(frame)


def _print(
    destination: Path,
    plans: Plans,
    classes: Sequence[str],
    settings: Mapping[str, Any],
    panoramas: Sequence[Panorama],
) -> None:
    lacking = {}
    for home, floors in plans.items():
        by_label = texts.counts(floors)
        frames, stays = (sum(column) for column in zip(*by_label.values(), strict=True))
        sizes = [_number(frames, "frame"), _number(stays, "stay"), _number(len(floors), "floor")]
        print(f"{one_line(home)}: {', '.join(sizes)}")
        if absent := [name for name in classes if name not in by_label]:
            lacking[home] = absent
    for home, absent in lacking.items():
        print(f"{one_line(home)} lacks {', '.join(absent)}.")
    if absent := [one_line(one.files[0]) for one in unseen(panoramas, plans)]:
        some = ", ".join(absent[:_NAMED]) + (", ..." if len(absent) > _NAMED else "")
        verb = "does" if len(absent) == 1 else "do"
        print(
            f"{len(absent)} of {_number(len(panoramas), 'panorama')} {verb} not appear in any frame: {some}"
        )
        print("To show more of them, raise visits or lower longest_look.")
    print(f"{one_line(destination)}/{texts.CARD} describes how the frames were made.")
    # One home is used for testing, one is left out, and at least two are used for training.
    if len(plans) < 4:
        print("Training and testing need at least four homes: add more.")
    else:
        print(
            f"\nNext, run:\n\n  {_next(destination, list(plans), settings['fps'], is_complete=not lacking)}"
        )


def _number(count: int, what: str) -> str:
    return f"{count} {what}" if count == 1 else f"{count} {what}s"


def _next(destination: Path, homes: Sequence[str], fps: float, *, is_complete: bool) -> str:
    """Return the command that computes all tables for these homes."""
    chosen = [
        f"dataset={DATASET}",
        f"dataset.root={overrides.text(str(destination))}",
        f"dataset.homes=[{','.join(map(overrides.text, homes))}]",
        f"dataset.fps={float(fps)}",
    ]
    if not is_complete:
        chosen.append("dataset.require_all_classes=false")
    words = " ".join(shlex.quote(one) for one in chosen)
    # make passes SET to a shell, which would interpret these characters.
    return f"placecat repro {words}" if set(words) & set('"$`\\') else f'make repro SET="{words}"'
