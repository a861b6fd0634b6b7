"""The COLD data base: ``<site>/<sequence>/localization/places.lst`` and images in ``<sequence>/std_cam``.

A line of the label file is ``t<seconds>.<microseconds>_x<m>_y<m>_a<rad>.jpeg LABEL``. The label stays a
code; which class it stands for is the data set's ``aliases`` setting.

A home is one sequence, named ``<site>-<sequence>``, since a slash cannot be part of a home's name. The name
of a site alone reads all its sequences as one home: they show the same rooms, so a fold by home that must not
train on the tested rooms has to take the site.

References
----------
A. Pronobis, B. Caputo, COLD: The CoSy Localization Database. IJRR 28(5), 2009.
"""

import os
import re
from pathlib import Path

import numpy as np

from placecat.errors import PlacecatError
from placecat.footage.pictures import read_image
from placecat.sequences.base import Home, frame_table
from placecat.sequences.folders import (
    data_folder,
    frame_rate,
    home_folder,
    inside,
    natural,
    relative,
    some_homes,
)
from placecat.sequences.labels import read_text, shown

LABEL_FILE = "localization/places.lst"
_IMAGE = re.compile(r"t([0-9]{1,12})\.([0-9]{6})[-+._0-9A-Za-z]{0,200}\.jpe?g")
_LABEL = re.compile(r"([0-9]*[A-Z]+)[0-9]*(-[AB])?")


def list_homes(root: Path) -> list[str]:
    """Name sequences with a ``places.lst`` as ``<site>-<sequence>``; see `placecat.sequences.list_homes`."""
    sites = [site for site in data_folder(root).iterdir() if site.is_dir()]
    folders = [folder for site in sites for folder in _sequences(site)]
    homes = [f"{folder.parent.name}-{folder.name}" for folder in folders]
    return some_homes(homes, root, f"<site>/<sequence>/{LABEL_FILE}")


def read_home(
    root: Path, name: str, *, fps: float | None = None, camera: str = "", images: str = "std_cam"
) -> Home:
    """Read one sequence, ``<site>-<sequence>``, or all of a ``<site>``; see `placecat.sequences.open_home`.

    Without `fps` the rate is that of the median time between frames; `images` is the folder of a sequence
    that holds the images. Times are those in the file names. Images that the label file does not list are
    left out.
    """
    relative(name, "dataset.homes")
    if "/" in name:
        raise PlacecatError(f"dataset.homes: {name!r} has a slash; write {name.replace('/', '-', 1)!r}.")
    folder = home_folder(root, name.replace("-", "/", 1))
    if (folder / LABEL_FILE).is_file():
        folders = [folder]
    else:
        folders = sorted(_sequences(folder), key=lambda path: natural(path.name))
    if not folders:
        raise PlacecatError(
            f"{folder / LABEL_FILE}: the label file is missing; correct dataset.homes or restore it."
        )
    sequences: list[str] = []
    sources: list[str] = []
    labels: list[str] = []
    lines: list[int] = []
    numbers: list[int] = []
    seconds: list[float] = []
    for sequence in folders:
        entries = read_places(sequence / LABEL_FILE)
        _check_images(sequence, images, entries)
        where = sequence.relative_to(root).as_posix()
        sequences += [sequence.name] * len(entries)
        sources += [f"{where}/{images}/{image}" for image, _, _, _ in entries]
        labels += [label for _, label, _, _ in entries]
        lines += [line for _, _, _, line in entries]
        numbers += range(1, len(entries) + 1)
        # Differences of whole microseconds: exact, unlike those of seconds since 1970.
        seconds += [(time - entries[0][2]) / 1e6 for _, _, time, _ in entries]
    steps = np.diff(seconds)[np.diff(numbers) > 0]
    rate = frame_rate(fps, name, 1.0 / float(np.median(steps)) if len(steps) else None)
    height, width = read_image(root / sources[0]).shape[:2]
    return Home(
        name=name,
        root=root,
        fps=rate,
        camera=camera,
        width=width,
        height=height,
        frames=frame_table(sequences, sources, -1, numbers, seconds, labels),
        label_files={path.name: f"{path.relative_to(root).as_posix()}/{LABEL_FILE}" for path in folders},
        label_lines=np.array(lines, dtype=np.int32),
    )


def code(label: str) -> str:
    """Strip the number and the suffix (``-A`` or ``-B``, the part of the building) off a label.

    ``2PO1-A`` gives ``2PO``, whose digit is its own (two-person office). ValueError if it is built otherwise.
    """
    match = _LABEL.fullmatch(label)
    if match is None:
        raise ValueError(f"not a COLD label: {label!r}")
    return match[1]


def read_places(file: Path) -> list[tuple[str, str, int, int]]:
    """Read a ``places.lst``.

    Returns
    -------
    list of tuple
        (image file name, code, microseconds, line), in the order of the file, times increasing.

    Raises
    ------
    PlacecatError
        If a line is not an image name and a label, or time does not increase, naming the line.
    """
    entries: list[tuple[str, str, int, int]] = []
    for line, text in enumerate(read_text(file).split("\n"), start=1):
        words = text.split()
        if not words:
            continue
        where = f"{file} line {line}"
        if len(words) != 2:
            raise PlacecatError(f"{where}: {shown(text.strip())} where an image name and a label belong.")
        image = _IMAGE.fullmatch(words[0])
        if image is None:
            raise PlacecatError(
                f"{where}: {shown(words[0])} is no image name of the form "
                "t<seconds>.<microseconds>_x_y_a.jpeg; correct it."
            )
        try:
            label = code(words[1])
        except ValueError:
            raise PlacecatError(
                f"{where}: {shown(words[1])} is no label of the form CODE, CODE1 or CODE1-A; correct it."
            ) from None
        time = int(image[1]) * 1_000_000 + int(image[2])
        if entries and time <= entries[-1][2]:
            raise PlacecatError(
                f"{where}: {words[0]!r} is not later than the image of line {entries[-1][3]}; put them in "
                "order."
            )
        entries.append((words[0], label, time, line))
    return entries


def _sequences(site: Path) -> list[Path]:
    # Not by glob, which passes over folders that it may not read.
    return [folder for folder in site.iterdir() if (folder / LABEL_FILE).is_file()]


def _check_images(sequence: Path, images: str, entries: list[tuple[str, str, int, int]]) -> None:
    folder = sequence / images
    if not folder.is_dir():
        raise PlacecatError(
            f"{folder}: the folder of images is missing; restore it, or correct dataset.images."
        )
    file = sequence / LABEL_FILE
    inside(folder, sequence, str(file))
    links = {entry.name: entry.is_symlink() for entry in os.scandir(folder)}
    for image, _, _, line in entries:
        if image not in links:
            raise PlacecatError(
                f"{folder / image}: the frame is missing ({file} line {line}); restore it, or remove the "
                "line."
            )
        if links[image]:
            inside(folder / image, sequence, f"{file} line {line}")
