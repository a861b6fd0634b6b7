"""The Zillow Indoor Dataset: ``HOME/zind_data.json`` and the equirectangular images that it lists.

A home is named ``zind_HOME``, because YAML would read an all-digit name as a number. The data set divides
homes into complete rooms, and a complete room may have parts with different labels. Each such part becomes a
room: an open kitchen with a dining area is one complete room in the data set, but two rooms here.

References
----------
S. Cruz et al., Zillow Indoor Dataset: Annotated Floor Plans With 360° Panoramas and 3D Room Layouts. CVPR
2021; the format: github.com/zillow/zind, data_organization.md.
"""

import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from placecat.errors import PlacecatError
from placecat.footage.names import natural, relative
from placecat.panoramas.panorama import FLOOR, Panorama, kind, labels_by_kind

DATA = "zind_data.json"
MOST_BYTES = 64 << 20
"""Maximum size of a data file in bytes. This limit is our choice. The data set's sample file is 0.1 MB."""
_LEVELS = ("floor", "complete room", "partial room", "panorama")


def read(root: Path, settings: Mapping[str, Any]) -> list[Panorama]:
    """List the panoramas of all homes in a folder; see `placecat.panoramas.sources.read`."""
    folders = [folder for folder in root.iterdir() if (folder / DATA).is_file()]
    if not folders:
        raise PlacecatError(f"{root} contains no homes; expected HOME/{DATA}. Correct SOURCE.")
    found = []
    for folder in sorted(folders, key=lambda path: natural(path.name)):
        found += list(_home(folder, settings["zind"], labels_by_kind(settings["labels"])))
    return found


def _home(folder: Path, settings: Mapping[str, Any], labels: Mapping[str, str]) -> Iterator[Panorama]:
    path = folder / DATA
    for names, content in _panoramas(path, _load(path)):
        where = f"{path}: {'.'.join(names)}"
        room, image = (content.get(name) for name in ("label", "image_path"))
        if not isinstance(room, str) or not isinstance(image, str):
            raise PlacecatError(f"{where}: label and image_path must be text; download the file again.")
        if settings["inside_only"] and content.get("is_inside") is False:
            continue
        label = labels.get(kind(room), settings["others"])
        if label is None:
            continue
        floor, complete_room = names[1], names[2]
        if not FLOOR.fullmatch(floor):
            raise PlacecatError(f"{where}: {floor!r} is not a valid floor name; download the file again.")
        file = f"{folder.name}/{relative(image, where)}"
        yield Panorama(f"zind_{folder.name}", floor, f"{complete_room}_{label}", label, (file,), where)


def _load(path: Path) -> Any:
    if path.stat().st_size > MOST_BYTES:
        raise PlacecatError(f"{path} is larger than {MOST_BYTES >> 20} MB, which is too large for one home.")
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except json.JSONDecodeError as error:
        raise PlacecatError(
            f"{path} line {error.lineno} is not valid JSON ({error.msg}); download the file again."
        ) from None
    except (UnicodeDecodeError, RecursionError) as error:
        raise PlacecatError(
            f"{path} is not valid JSON ({type(error).__name__}); download it again."
        ) from None


def _panoramas(path: Path, content: Any) -> Iterator[tuple[list[str], dict[str, Any]]]:
    """Yield each panorama together with the path of keys that leads to it."""
    merger = content.get("merger") if isinstance(content, dict) else None
    level = [(["merger"], merger)]
    for what in _LEVELS:
        deeper = []
        for names, holder in level:
            if not isinstance(holder, dict):
                raise PlacecatError(f"{path}: {'.'.join(names)} has no {what}; download the file again.")
            deeper += [([*names, name], inner) for name, inner in holder.items()]
        level = deeper
    for names, panorama in level:
        if not isinstance(panorama, dict):
            raise PlacecatError(f"{path}: {'.'.join(names)} is not a panorama; download the file again.")
        yield names, panorama
