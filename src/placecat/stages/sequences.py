"""Stage `sequences`: read and check the frames and label files of the data set."""

import contextlib
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from placecat import files, paths, settings
from placecat.compute import parallel
from placecat.errors import PlacecatError
from placecat.sequences import Home, open_home_of, place_labels, require_classes
from placecat.stages import run


def main() -> None:
    """Write frames.csv, labels.csv and home.json for every home."""
    list_homes(settings.get(settings.load(), "dataset"), paths.SEQUENCES, "dataset")


def list_homes(dataset: Mapping[str, Any], target: Path, setting: str) -> None:
    """Check the homes of a data set (`setting` in messages), and list their frames in `target`."""
    root = Path(dataset["root"])
    if not root.is_dir():
        raise PlacecatError(
            f"{setting}.root is {root}, but this folder does not exist: put the homes there, or choose other "
            f"data with `make repro SET='dataset=my_homes {setting}.root=PATH'`"
        )
    if not dataset["homes"]:
        raise PlacecatError(f"{setting}.homes is empty: name the homes to use")
    # A video must be decoded to find out which of its frames are readable.
    tasks = [(Path.cwd(), dataset, name) for name in dataset["homes"]]
    with files.replacing(target) as folder:
        homes = parallel.stream(_open, tasks, "sequences", unit="homes", locally=True)
        for name, home in zip(dataset["homes"], homes, strict=True):
            if home.note:
                print(f"placecat: note: {home.note}", file=sys.stderr)
            _write(folder / name, home, dataset)


def _open(folder: Path, dataset: Mapping[str, Any], name: str) -> Home:
    # A worker stays in the folder where it was started, but messages show paths as the user wrote them.
    with contextlib.chdir(folder):
        return open_home_of(dataset, name)


def _write(folder: Path, home: Home, dataset: Mapping[str, Any]) -> None:
    classes = list(dataset["classes"])
    labels = place_labels(
        home.frames["label"], classes, list(dataset["ignored"]), dict(dataset["aliases"]), home=home
    )
    if dataset["require_all_classes"]:
        require_classes(labels, classes, home.name)
    elif not (labels >= 0).any():
        raise PlacecatError(f"{home.name} has no frames of any class: remove it from dataset.homes")
    folder.mkdir(parents=True)
    files.write_csv(folder / "frames.csv", home.frames.drop(columns="label"))
    table = pd.DataFrame({"label": home.frames["label"], "class": labels.astype(np.int64)})
    files.write_csv(folder / "labels.csv", table)
    files.write_csv(folder / "sources.csv", _checksums(home))
    facts = {"fps": home.fps, "camera": home.camera, "width": home.width, "height": home.height}
    # These are written only for footage that is damaged or has a variable frame rate.
    odd = {"lost_frames": list(home.lost), "damaged_frames": list(home.damaged)}
    facts |= {name: value for name, value in odd.items() if value}
    if not home.is_even:
        facts["is_even"] = False
    files.write_json(folder / "home.json", facts)


def _checksums(home: Home) -> pd.DataFrame:
    """Return the SHA-256 checksum of each source file of a home, in frame order; a bag may be a folder."""
    sources = [home.root / source for source in dict.fromkeys(home.frames["source"])]
    listed = [file for path in sources for file in (sorted(path.iterdir()) if path.is_dir() else [path])]
    rows = [(path.relative_to(home.root).as_posix(), files.checksum(path)) for path in listed]
    return pd.DataFrame(rows, columns=["source", "sha256"])


if __name__ == "__main__":
    run(main)
