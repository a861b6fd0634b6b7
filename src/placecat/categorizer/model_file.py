"""Model files: archives that contain a trained system as JSON and arrays, with a human-readable card."""

import json
import zipfile
from pathlib import Path
from typing import Any

import numpy as np

from placecat import __version__
from placecat.categorizer import archive, checks
from placecat.categorizer.card import FORMAT, unknown_text
from placecat.categorizer.plain import from_plain, to_plain
from placecat.categorizer.system import TrainedCue, TrainedSystem
from placecat.errors import PlacecatError
from placecat.fusion.integrate import Integrator
from placecat.fusion.smoothing import SmoothingModel
from placecat.templates import environment

_CARD, _TEXT, _SYSTEM = "card.json", "card.md", "system.json"


def write(path: Path, system: TrainedSystem) -> None:
    """Write a trained system. Identical systems produce identical bytes."""
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
    members = {
        _CARD: json.dumps(system.card, indent=1),
        _TEXT: environment("placecat.categorizer")
        .get_template("model_card.md.j2")
        .render(card=system.card, unknown=unknown_text(system.card)),
        _SYSTEM: json.dumps(content | {"arrays": len(arrays)}),
    }
    archive.write(
        path,
        {name: text.encode() for name, text in members.items()}
        | {_array_name(number): archive.array_content(array) for number, array in enumerate(arrays)},
    )


def is_model(path: Path) -> bool:
    """Return whether a file looks like a trained system of any version, even if damaged."""
    try:
        with zipfile.ZipFile(path) as file:
            return _CARD in file.namelist()
    except (OSError, ValueError, zipfile.BadZipFile):
        return False


def read(path: Path) -> TrainedSystem:
    """Read a trained system. The file cannot execute code, and its content is checked before use.

    Raises PlacecatError if the file is missing, unreadable, damaged, not a model, or from another version.
    """
    with archive.opened(path) as members:
        card = _json(members, _CARD)
        _check_version(path, members, card)
        content = _json(members, _SYSTEM)
        try:
            checks.check_card(card)
            checks.check_content(content)
            names = [_array_name(number) for number in range(content["arrays"])]
            if set(members.names) != {_CARD, _TEXT, _SYSTEM, *names}:
                raise PlacecatError(f"it should have {len(names)} arrays and no other members")
            arrays = [members.array(name) for name in names]
            cues = tuple(
                TrainedCue(own["name"], own["descriptor"], from_plain(own["model"], arrays))
                for own in content["cues"]
            )
            integrator = from_plain(content["integrator"], arrays)
            smoothing = from_plain(content["smoothing"], arrays)
            if not isinstance(integrator, Integrator) or not isinstance(smoothing, SmoothingModel):
                raise PlacecatError("its parts have the wrong types")
            system = TrainedSystem(card, content["vision"], content["tracking"], cues, integrator, smoothing)
            checks.check_system(system)
        except (PlacecatError, RecursionError) as error:
            raise members.damaged(error) from None
    return system


def _array_name(number: int) -> str:
    return f"arrays/{number:04d}.npy"


def _json(members: archive.Archive, name: str) -> Any:
    content = members.content(name)
    try:
        return json.loads(content, parse_constant=_refuse)
    except (ValueError, RecursionError) as error:
        raise members.damaged(f"its member {name} cannot be read ({error})") from None


def _refuse(constant: str) -> None:
    raise ValueError(f"{constant} is not a number")


def _check_version(path: Path, members: archive.Archive, card: Any) -> None:
    if (
        not isinstance(card, dict)
        or type(card.get("format")) is not int
        or not isinstance(card.get("placecat"), str)
    ):
        raise members.damaged("its card has no version")
    stored, version = card["format"], card["placecat"]
    if stored != FORMAT or _series(version) != _series(__version__):
        raise PlacecatError(
            f"{path} was made by placecat {version[:40]} (format {stored}), but this is placecat "
            f"{__version__} (format {FORMAT}): {archive.TRAIN_AGAIN}, or use the version that made the file"
        )


def _series(version: str) -> list[str]:
    """Return the major and minor version.

    Features and models stay compatible until one of these changes.
    """
    return version.split(".")[:2]
