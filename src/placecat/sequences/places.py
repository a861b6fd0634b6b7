"""Convert label names to class numbers."""

import difflib
from collections.abc import Mapping, Sequence

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from placecat.errors import PlacecatError
from placecat.sequences.base import Home


def place_labels(
    labels: pd.Series,
    classes: Sequence[str],
    ignored: Sequence[str],
    aliases: Mapping[str, str],
    *,
    home: Home | None = None,
) -> NDArray[np.int16]:
    """Convert label names to class numbers, (len(labels),) int16, with -1 for unlabelled frames.

    Frames without a label, or with a label in `ignored` (``transition``, ``corridor``, ...), stay in the
    sequence as unlabelled frames. They are not used for scoring or training, but the smoothing filter does
    not skip them (thesis 3.3.2). Raises PlacecatError if a label is not a class, an ignored label or an
    alias, or if an alias does not stand for a class or an ignored label.

    Parameters
    ----------
    labels
        The ``label`` column of `Home.frames`, or some rows of it, with the original index. A missing value is
        treated as an empty label, because pandas reads empty cells as missing values.
    classes, ignored
        The classes, numbered by their position, and the labels that have no class.
    aliases
        Maps other spellings and codes to classes or ignored labels. An alias overrides a class of the same
        name.
    home
        The home that the labels belong to, used in messages.
    """
    if not classes:
        raise PlacecatError("dataset.classes is empty; list at least one class.")
    for alias, name in aliases.items():
        if name not in classes and name not in ignored:
            raise PlacecatError(
                f"dataset.aliases: {alias!r} stands for {name!r}, which is neither in dataset.classes nor in "
                f"dataset.ignored{_nearest(name, [*classes, *ignored])}; correct it, or add it to "
                "dataset.ignored."
            )
    numbers = {name: number for number, name in enumerate(classes)} | dict.fromkeys(ignored, -1)
    numbers |= {alias: numbers[name] for alias, name in aliases.items()} | {"": -1}
    found, where = np.unique(labels.fillna("").to_numpy(dtype=str), return_inverse=True)
    unknown = [name for name in found if name not in numbers]
    if unknown:
        row = int(np.flatnonzero(np.isin(found, unknown)[where])[0])
        name = str(found[where[row]])
        raise PlacecatError(_unknown_label(name, labels.index[row], [*classes, *ignored, *aliases], home))
    return np.array([numbers[name] for name in found], dtype=np.int16)[where]


def require_classes(labels: NDArray[np.int16], classes: Sequence[str], home: str) -> None:
    """Check that a home has frames of every class.

    `labels` is (frames,) int16 from `place_labels`, and `home` is the name of the home. Raises PlacecatError
    with the names of the missing classes.
    """
    present = np.bincount(labels[labels >= 0], minlength=len(classes)) > 0
    absent = [name for name, there in zip(classes, present, strict=True) if not there]
    if absent:
        raise PlacecatError(
            f"{home}: no frame is labelled {' or '.join(absent)}; label some, remove the home from "
            "dataset.homes or the class from dataset.classes, or set dataset.require_all_classes=false "
            "to score the home only on the classes that it has."
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
        f"{place}: unknown label {name!r}{_nearest(name, known)}; correct it, add it to dataset.ignored to "
        "leave such frames unlabelled, or add it to dataset.aliases if it is another name for a class."
    )
