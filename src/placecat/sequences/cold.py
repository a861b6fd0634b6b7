"""The COLD database: ``<site>/<sequence>/localization/places.lst`` and images in ``<sequence>/std_cam``.

Each line of the label file has the form ``t<seconds>.<microseconds>_x<m>_y<m>_a<rad>.jpeg LABEL``. Labels are
left as codes. The data set's ``aliases`` setting maps each code to a class.

A home is one sequence, named ``<site>-<sequence>`` because home names cannot contain a slash. A site name on
its own stands for a home with all sequences from that site. Sequences from one site show the same rooms, so
only folds by site keep the test rooms out of training.

References
----------
A. Pronobis, B. Caputo, COLD: The CoSy Localization Database. IJRR 28(5), 2009.
"""

import re
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pandas as pd

from placecat.errors import PlacecatError
from placecat.sequences.base import Home, frame_table, home_of_pictures
from placecat.sequences.folders import (
    check_listed,
    frame_rate,
    home_folder,
    natural,
    relative,
)
from placecat.sequences.labels import read_text, shown

LABEL_FILE = "localization/places.lst"
_IMAGE = re.compile(r"t([0-9]{1,12})\.([0-9]{6})[-+._0-9A-Za-z]{0,200}\.jpe?g")
_LABEL = re.compile(r"([0-9]*[A-Z]+)[0-9]*(-[AB])?")


def read_home(
    root: Path, name: str, *, fps: float | None = None, camera: str = "", images: str = "std_cam"
) -> Home:
    """Read a sequence, ``<site>-<sequence>``, or all sequences from a site, ``<site>``.

    See `placecat.sequences.open_home`. Times come from the file names. Without `fps`, the rate is computed
    from the median time between frames. `images` is the name of the image folder in each sequence. Images
    that the label file does not list are skipped.
    """
    relative(name, "dataset.homes")
    if "/" in name:
        raise PlacecatError(f"dataset.homes: {name!r} contains a slash; write {name.replace('/', '-', 1)!r}.")
    folder = home_folder(root, name.replace("-", "/", 1))
    is_sequence = (folder / LABEL_FILE).is_file()
    folders = [folder] if is_sequence else sorted(_sequences(folder), key=lambda path: natural(path.name))
    if not folders:
        raise PlacecatError(
            f"{folder / LABEL_FILE}: the label file is missing; restore it, or correct dataset.homes."
        )
    tables, lines = [], []
    for sequence in folders:
        folder, file = sequence / images, sequence / LABEL_FILE
        entries = read_places(file)
        if not folder.is_dir():
            raise PlacecatError(
                f"{folder}: the image folder is missing; restore it, or correct dataset.images."
            )
        listed = {one.image: f"{file} line {one.line}" for one in entries}
        check_listed(folder, sequence, str(file), listed, "restore it, or remove the line")
        where = sequence.relative_to(root).as_posix()
        sources = [f"{where}/{images}/{one.image}" for one in entries]
        # Subtracting whole microseconds is exact, unlike subtracting seconds since 1970.
        seconds = [(one.time - entries[0].time) / 1e6 for one in entries]
        numbers, labels = range(1, len(entries) + 1), [one.code for one in entries]
        tables.append(frame_table(sequence.name, sources, -1, numbers, seconds, labels))
        lines += [one.line for one in entries]
    frames = pd.concat(tables, ignore_index=True)
    steps = np.diff(frames["seconds"])[np.diff(frames["number"]) > 0]
    rate = frame_rate(fps, name, 1.0 / float(np.median(steps)) if len(steps) else None)
    label_files = {path.name: f"{path.relative_to(root).as_posix()}/{LABEL_FILE}" for path in folders}
    return home_of_pictures(name, root, rate, camera, frames, label_files, lines)


class Entry(NamedTuple):
    """A line of a ``places.lst``, with its image name, code, time in microseconds, and line number."""

    image: str
    code: str
    time: int
    line: int


def code(label: str) -> str | None:
    """Return the code of a label, without the trailing number and building (``-A`` or ``-B``).

    ``2PO1-A`` becomes ``2PO``, a two-person office. Returns None for labels that are not from COLD.
    """
    match = _LABEL.fullmatch(label)
    return match[1] if match else None


def read_places(file: Path) -> list[Entry]:
    """Read the entries of a ``places.lst``. Their times must increase from line to line.

    Raises PlacecatError with the line number if a line does not consist of an image name and a label, or if
    its image is not later than the previous one.
    """
    entries: list[Entry] = []
    for line, text in enumerate(read_text(file).split("\n"), start=1):
        words = text.split()
        if not words:
            continue
        where = f"{file} line {line}"
        if len(words) != 2:
            raise PlacecatError(f"{where}: {shown(text.strip())} must consist of an image name and a label.")
        image = _IMAGE.fullmatch(words[0])
        if image is None:
            raise PlacecatError(
                f"{where}: {shown(words[0])} is not an image name of the form "
                "t<seconds>.<microseconds>_x_y_a.jpeg; correct it."
            )
        label = code(words[1])
        if label is None:
            raise PlacecatError(
                f"{where}: {shown(words[1])} is not a label of the form CODE, CODE1 or CODE1-A; correct it."
            )
        time = int(image[1]) * 1_000_000 + int(image[2])
        if entries and time <= entries[-1].time:
            raise PlacecatError(
                f"{where}: {words[0]!r} is not later than the image on line {entries[-1].line}; sort the "
                "lines by time."
            )
        entries.append(Entry(words[0], label, time, line))
    return entries


def _sequences(site: Path) -> list[Path]:
    # Avoid glob: it silently skips unreadable folders.
    return [folder for folder in site.iterdir() if (folder / LABEL_FILE).is_file()]
