"""One file for a trained system: a zip archive of JSON and arrays, with a card that people can read."""

import io
import json
import zipfile
from pathlib import Path
from typing import Any

import numpy as np

from placecat import __version__, cue_input, files
from placecat.categorizer.plain import from_plain, to_plain
from placecat.categorizer.system import TrainedCue, TrainedSystem
from placecat.errors import PlacecatError
from placecat.fusion.integrate import Integrator
from placecat.fusion.smoothing import SmoothingModel
from placecat.templates import environment

# Raise it when what is stored changes its meaning.
FORMAT = 2
_CARD, _TEXT, _SYSTEM = "card.json", "card.md", "system.json"


def write(path: Path, system: TrainedSystem) -> None:
    """Write a trained system; the same system gives the same bytes."""
    arrays: list[np.ndarray] = []
    content = {
        "vision": system.vision,
        "tracking": system.tracking,
        "cues": [
            {"name": cue.name, "descriptor": cue.descriptor, "model": to_plain(cue.model, arrays)}
            for cue in system.cues
        ],
        "integrator": to_plain(system.integrator, arrays),
        "smoothing": to_plain(system.smoothing, arrays),
    }
    texts = {
        _CARD: json.dumps(system.card, indent=1),
        _TEXT: environment("placecat.categorizer").get_template("model_card.md.j2").render(card=system.card),
        _SYSTEM: json.dumps(content | {"arrays": len(arrays)}),
    }
    with files.replacing(path) as temporary, zipfile.ZipFile(temporary, "w") as archive:
        for name, text in texts.items():
            archive.writestr(zipfile.ZipInfo(name), text)
        for number, array in enumerate(arrays):
            buffer = io.BytesIO()
            np.lib.format.write_array(
                buffer, np.ascontiguousarray(array).reshape(array.shape), allow_pickle=False
            )
            archive.writestr(zipfile.ZipInfo(_array_name(number)), buffer.getvalue())


def read(path: Path) -> TrainedSystem:
    """Read a trained system. Nothing in the file is executed.

    Raises
    ------
    PlacecatError
        If the file is missing, damaged, no model, or of another version.
    """
    with _open(path) as archive:
        card = _card(path, archive)
        try:
            content = json.loads(_member(archive, _SYSTEM))
            arrays = [
                np.lib.format.read_array(
                    io.BytesIO(_member(archive, _array_name(number))), allow_pickle=False
                )
                for number in range(int(content["arrays"]))
            ]
            cues = tuple(
                TrainedCue(own["name"], own["descriptor"], from_plain(own["model"], arrays))
                for own in content["cues"]
            )
            for cue in cues:
                cue_input.check(cue.descriptor)
            system = TrainedSystem(
                card,
                content["vision"],
                content["tracking"],
                cues,
                from_plain(content["integrator"], arrays),
                from_plain(content["smoothing"], arrays),
            )
        except (PlacecatError, KeyError, TypeError, ValueError) as error:
            raise PlacecatError(f"{path} is damaged, or no model of placecat: {error}") from None
    if not isinstance(system.integrator, Integrator) or not isinstance(system.smoothing, SmoothingModel):
        raise PlacecatError(f"{path} is damaged, or no model of placecat: its parts are of other kinds")
    return system


def _array_name(number: int) -> str:
    return f"arrays/{number:04d}.npy"


def _open(path: Path) -> zipfile.ZipFile:
    if not path.is_file():
        raise PlacecatError(f"there is no model {path}: `make repro` or `placecat train` makes one")
    try:
        return zipfile.ZipFile(path)
    except (zipfile.BadZipFile, OSError) as error:
        raise PlacecatError(f"{path} is no model of placecat, or damaged: {error}") from None


def _member(archive: zipfile.ZipFile, name: str) -> bytes:
    try:
        # Stored as it is, so that a small file cannot unpack to a huge one.
        if archive.getinfo(name).compress_type != zipfile.ZIP_STORED:
            raise PlacecatError(f"its member {name} is compressed")
        return archive.read(name)
    except KeyError:
        raise PlacecatError(f"it has no member {name}") from None
    except (zipfile.BadZipFile, EOFError, OSError) as error:
        raise PlacecatError(f"its member {name} cannot be read ({error})") from None


def _card(path: Path, archive: zipfile.ZipFile) -> dict[str, Any]:
    try:
        card = json.loads(_member(archive, _CARD))
        stored, version = card["format"], str(card["placecat"])
    except (PlacecatError, KeyError, TypeError, ValueError) as error:
        raise PlacecatError(f"{path} is no model of placecat, or damaged: {error}") from None
    if stored != FORMAT or _series(version) != _series(__version__):
        raise PlacecatError(
            f"{path} was made by placecat {version} (format {stored}), this is placecat {__version__} "
            f"(format {FORMAT}): train it again with `placecat train`, or use the version that made it"
        )
    return card


def _series(version: str) -> list[str]:
    """Features and models keep their meaning within a minor version."""
    return version.split(".")[:2]
