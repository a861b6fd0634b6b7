"""Read the descriptors of a home, as written by the `features` and `tracks` stages."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat import files, paths
from placecat.cues import cue_input
from placecat.cues.descriptors import Descriptors
from placecat.errors import PlacecatError


def read_descriptors(
    home: str, descriptor: Mapping[str, Any], rows: NDArray[np.int64] | None = None
) -> Descriptors:
    """Read a cue's descriptor for the frames `rows` of one home, or for all its frames.

    `home` is as in :func:`placecat.paths.features`, and `descriptor` is as in
    :func:`placecat.cues.cue_input.check`. Raises PlacecatError if a setting is unknown, if there are too many
    regions, or if the descriptor was not computed for these frames.
    """
    cue_input.check(descriptor)
    folder = folder_of(home, descriptor)
    if "variant" in descriptor:
        rows = _rows(folder, rows)
    arrays = {}
    for name in cue_input.array_names(descriptor):
        path = folder / f"{name}.npy"
        if not path.exists():
            raise PlacecatError(
                f"{path} is missing: add the descriptor to a file in conf/cue, then run `placecat params` "
                "and `dvc repro`"
            )
        array = files.read_array(path)
        arrays[name] = array if rows is None else array[rows]
    is_local = descriptor["kind"] == "local"
    return cue_input.assemble(
        descriptor,
        arrays,
        height=files.read_json(paths.sequences(home) / "home.json")["height"] if is_local else 0,
        modules=files.read_json(folder / "descriptors.json") if is_local else {},
    )


def files_of(home: str, descriptor: Mapping[str, Any]) -> list[Path]:
    """Return the paths of all files read by :func:`read_descriptors` for a home, including missing ones."""
    folder = folder_of(home, descriptor)
    names = [f"{name}.npy" for name in cue_input.array_names(descriptor)]
    if "variant" in descriptor:
        names.append(paths.VARIANT_FRAMES)
    if descriptor["kind"] == "local":
        names.append("descriptors.json")
    return [paths.sequences(home) / "home.json", *(folder / name for name in names)]


def described(home: str, descriptor: Mapping[str, Any], rows: NDArray[np.int64]) -> NDArray[np.int64]:
    """Return the frames in `rows` that have a descriptor, in temporal order.

    Region variants lack some frames.
    """
    if "variant" not in descriptor:
        return rows
    return np.intersect1d(rows, _described(folder_of(home, descriptor)))


def folder_of(home: str, descriptor: Mapping[str, Any]) -> Path:
    """Return the folder with a descriptor's arrays. See :func:`read_descriptors` for the parameters."""
    if descriptor.get("tracked", False):
        return paths.TRACKS / home
    folder = paths.features(home)
    return folder / paths.VARIANT.format(descriptor["variant"]) if "variant" in descriptor else folder


def _described(folder: Path) -> NDArray[np.int64]:
    path = folder / paths.VARIANT_FRAMES
    if not path.is_file():
        raise PlacecatError(f"{path} is missing: add the variant to conf/region_variants and run `dvc repro`")
    return files.read_array(path, memory_map=False)


def _rows(folder: Path, frames: NDArray[np.int64] | None) -> NDArray[np.int64]:
    there = _described(folder)
    if frames is None or not np.isin(frames, there).all():
        raise PlacecatError(
            f"{folder} covers only the frames in region_variants.frames: use region variants only in trials"
        )
    return np.searchsorted(there, frames)


def read_training(descriptor: Mapping[str, Any], selection: Mapping[str, NDArray[np.int64]]) -> Descriptors:
    """Read a descriptor for the selected frames of several homes, in the order of `selection`."""
    parts = [read_descriptors(home, descriptor, rows) for home, rows in selection.items()]
    x = np.concatenate([part.x for part in parts])
    if parts[0].counts is None:
        return Descriptors(x)
    return Descriptors(x, np.concatenate([part.counts for part in parts if part.counts is not None]))
