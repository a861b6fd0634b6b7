"""Create the files that accompany the frames: a label file and a table of looks per home, and a data card."""

from collections.abc import Mapping, Sequence
from itertools import groupby
from typing import Any

import pandas as pd
import yaml

from placecat import __version__
from placecat.errors import one_line
from placecat.panoramas.panorama import Panorama
from placecat.panoramas.plan import Look, Plans, seed, unseen
from placecat.templates import environment

CARD = "README.md"
"""File name of the card."""
_END = "-1\t-1\tend\n"


def label_file(floors: Mapping[str, Sequence[Look]]) -> str:
    """Return the text of a home's ``label.txt``, for `placecat.sequences.vpc2009`."""
    text = ""
    for floor, looks in floors.items():
        lines = [f"{first}\t{last}\t{label}\n" for first, last, label in _stays(looks)]
        text += f"{floor}/\n{looks[-1].last}\n{''.join(lines)}{_END}"
    return text + _END


def looks_table(floors: Mapping[str, Sequence[Look]]) -> pd.DataFrame:
    """Return a table with one row per look.

    Its columns are the floor, the stay number (counted from 1), the first and last frame, the field of view
    in degrees, the room, the label, and the panorama's first image.
    """
    columns = ["floor", "stay", "start", "end", "fov", "room", "label", "panorama"]
    rows = []
    for floor, looks in floors.items():
        for look in looks:
            shown, fov = look.panorama, round(float(look.path[0, 2]), 2)
            own = look.stay + 1, look.first, look.last, fov, shown.room, shown.label, shown.files[0]
            rows.append((floor, *own))
    return pd.DataFrame(rows, columns=columns)


def card(plans: Plans, panoramas: Sequence[Panorama], settings: Mapping[str, Any], folder: str) -> str:
    """Render the data card.

    `panoramas` lists all panoramas in the source, including unused ones. `settings` come from
    conf/panoramas.yaml. `folder` is the name of the source folder.
    """
    by_home = {_plain(home): counts(floors) for home, floors in plans.items()}
    places = [(home, floor) for home, floors in plans.items() for floor in floors]
    template = environment("placecat.panoramas").get_template("card.md.j2")
    return template.render(
        version=__version__,
        panoramas=len(panoramas),
        unseen=[_plain(one.files[0]) for one in unseen(panoramas, plans)],
        folder=_plain(folder),
        frames=sum(plans[home][floor][-1].last for home, floor in places),
        counts=by_home,
        labels=sorted({label for own in by_home.values() for label in own}),
        seeds=[(_plain(home), floor, seed(home, floor, settings["walk"])) for home, floor in places],
        settings=settings,
        settings_text=yaml.safe_dump(dict(settings), sort_keys=False, allow_unicode=True),
    )


def counts(floors: Mapping[str, Sequence[Look]]) -> dict[str, tuple[int, int]]:
    """Map each label in a home to its number of frames and number of stays."""
    found: dict[str, tuple[int, int]] = {}
    for looks in floors.values():
        for first, last, label in _stays(looks):
            frames, stays = found.get(label, (0, 0))
            found[label] = (frames + last - first + 1, stays + 1)
    return dict(sorted(found.items()))


def _stays(looks: Sequence[Look]) -> list[tuple[int, int, str]]:
    """Return the first frame, last frame and label of every stay on a floor."""
    stays = [list(stay) for _, stay in groupby(looks, key=lambda look: look.stay)]
    return [(stay[0].first, stay[-1].last, stay[0].panorama.label) for stay in stays]


def _plain(text: str) -> str:
    """Make a name safe for Markdown tables and code spans."""
    return one_line(text).replace("|", "/").replace("`", "'")
