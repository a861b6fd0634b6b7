"""The descriptors of a home, as the stage `features` left them."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat import files, paths
from placecat.cues.descriptors import Descriptors
from placecat.errors import PlacecatError
from placecat.vision import local
from placecat.vision.local.concatenate import concatenate


def feature_path(home: str, kind: str, name: str) -> Path:
    """The array of one descriptor of one home."""
    return paths.FEATURES / home / f"{kind}_{name}.npy"


def read_descriptors(
    home: str, descriptor: Mapping[str, Any], rows: NDArray[np.int64] | None = None
) -> Descriptors:
    """Read one descriptor of one home as a cue wants it.

    Parameters
    ----------
    descriptor
        ``kind`` (local or holistic) and ``name``; for local ones also ``y_pos``, ``y_weight``, ``color`` and
        ``max_regions``.
    rows
        Frame indices; None for all.
    """
    kind, name = descriptor["kind"], descriptor["name"]
    x = _rows(home, kind, name, rows)
    if kind == "holistic":
        return Descriptors(x)
    limit = int(descriptor["max_regions"])
    if limit > x.shape[1]:
        raise PlacecatError(
            f"a cue asks for max_regions {limit}, but regions.max_regions is {x.shape[1]}: raise the latter"
        )
    counts = np.minimum(files.read_array(paths.FEATURES / home / "count.npy", memory_map=False), limit)
    counts = counts.astype(np.int64) if rows is None else counts[rows].astype(np.int64)
    x = x[:, :limit]
    n, m, _ = x.shape
    y = None
    if descriptor["y_pos"]:
        regions = _rows(home, "regions", None, rows)[:, :limit]
        height = files.read_json(paths.SEQUENCES / home / "home.json")["height"]
        y = (regions[:, :, 1] / height).reshape(-1)
    color = (
        _rows(home, "local", "color_mv", rows)[:, :limit].reshape(n * m, -1) if descriptor["color"] else None
    )
    joined = concatenate(
        x.reshape(n * m, -1),
        y,
        color,
        y_weight=float(descriptor["y_weight"]),
        shape_spread=local.load(name).SPREAD,
        color_spread=local.load("color_mv").SPREAD,
    )
    joined = joined.reshape(n, m, -1)
    joined[np.arange(m)[None, :] >= counts[:, None]] = 0.0
    return Descriptors(joined, counts)


def _rows(home: str, kind: str, name: str | None, rows: NDArray[np.int64] | None) -> NDArray[np.float32]:
    path = paths.FEATURES / home / "regions.npy" if name is None else feature_path(home, kind, name)
    if not path.exists():
        raise PlacecatError(f"{path} is missing: name the descriptor in conf/descriptor and run `dvc repro`")
    array = files.read_array(path)
    return np.array(array if rows is None else array[rows], dtype=np.float32)


def read_training(
    homes: tuple[str, ...], descriptor: Mapping[str, Any], selection: Mapping[str, NDArray[np.int64]]
) -> Descriptors:
    """Descriptors of the selected frames of several homes, below each other in the order of `homes`."""
    parts = [read_descriptors(home, descriptor, selection[home]) for home in homes]
    x = np.concatenate([part.x for part in parts])
    if parts[0].counts is None:
        return Descriptors(x)
    return Descriptors(x, np.concatenate([part.counts for part in parts if part.counts is not None]))
