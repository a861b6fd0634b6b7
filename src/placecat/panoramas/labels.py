"""A home's label file, and a table of the panoramas that its frames show."""

from collections.abc import Mapping, Sequence
from itertools import groupby

import pandas as pd

from placecat.panoramas.plan import Look

_END = "-1\t-1\tend\n"


def segments(looks: Sequence[Look]) -> list[tuple[int, int, str]]:
    """Return the first frame, last frame and label of every stay on a floor."""
    stays = [list(stay) for _, stay in groupby(looks, key=lambda look: look.stay)]
    return [(stay[0].first, stay[-1].last, stay[0].panorama.label) for stay in stays]


def label_file(floors: Mapping[str, Sequence[Look]]) -> str:
    """Return the text of a home's ``label.txt``, for `placecat.sequences.vpc2009`."""
    text = ""
    for floor, looks in floors.items():
        lines = [f"{first}\t{last}\t{label}\n" for first, last, label in segments(looks)]
        text += f"{floor}/\n{looks[-1].last}\n{''.join(lines)}{_END}"
    return text + _END


def looks_table(floors: Mapping[str, Sequence[Look]]) -> pd.DataFrame:
    """Tabulate looks: floor, stay (from 1), frames, field of view in degrees, room, label, picture."""
    columns = ["floor", "stay", "start", "end", "fov", "room", "label", "panorama"]
    rows = [
        (
            *(floor, look.stay + 1, look.first, look.last, round(float(look.path[0, 2]), 2)),
            *(look.panorama.room, look.panorama.label, look.panorama.files[0]),
        )
        for floor, looks in floors.items()
        for look in looks
    ]
    return pd.DataFrame(rows, columns=columns)


def counts(floors: Mapping[str, Sequence[Look]]) -> dict[str, tuple[int, int]]:
    """Map each label in a home to its numbers of frames and stays."""
    found: dict[str, tuple[int, int]] = {}
    for looks in floors.values():
        for first, last, label in segments(looks):
            frames, stays = found.get(label, (0, 0))
            found[label] = (frames + last - first + 1, stays + 1)
    return dict(sorted(found.items()))
