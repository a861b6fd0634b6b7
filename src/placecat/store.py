"""The descriptors of a home, as the stages `features` and `tracks` left them."""

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

LOCAL = {"kind", "name", "y_pos", "y_weight", "color", "max_regions", "tracked"}
HOLISTIC = {"kind", "name"}


def read_descriptors(
    home: str, descriptor: Mapping[str, Any], rows: NDArray[np.int64] | None = None
) -> Descriptors:
    """Read one descriptor of one home as a cue wants it.

    Parameters
    ----------
    home
        As for :func:`placecat.paths.features`.
    descriptor
        ``kind`` (local or holistic) and ``name``; for local ones also ``y_pos``, ``y_weight``, ``color`` (the
        colour descriptor to append, or None), ``max_regions`` and, for tracked regions, ``tracked: true``.
    rows
        Frame indices; None for all.

    Raises
    ------
    PlacecatError
        An unknown setting, more regions than there are, or a descriptor that was not computed.
    """
    kind, name = descriptor["kind"], descriptor["name"]
    valid = {"local": LOCAL, "holistic": HOLISTIC}.get(kind)
    if valid is None:
        raise PlacecatError(f"descriptor.kind must be local or holistic, not {kind!r}")
    unknown = sorted(set(descriptor) - valid)
    if unknown:
        raise PlacecatError(
            f"{kind} descriptor {name} has no setting {unknown[0]!r} (valid: {', '.join(sorted(valid))})"
        )
    if kind == "holistic":
        return Descriptors(_rows(paths.features(home) / f"holistic_{name}.npy", rows))
    return _read_local(home, descriptor, rows)


def _read_local(home: str, descriptor: Mapping[str, Any], rows: NDArray[np.int64] | None) -> Descriptors:
    folder = paths.TRACKS / home if descriptor.get("tracked", False) else paths.features(home)
    name, color_name = descriptor["name"], descriptor["color"]
    x = _rows(folder / f"local_{name}.npy", rows)
    limit = int(descriptor["max_regions"])
    if limit > x.shape[1]:
        raise PlacecatError(
            f"a cue asks for max_regions {limit}, but regions.max_regions is {x.shape[1]}: raise the latter"
        )
    counts = np.minimum(files.read_array(folder / "count.npy", memory_map=False), limit).astype(np.int64)
    counts = counts if rows is None else counts[rows]
    x = x[:, :limit]
    n, m, _ = x.shape
    y = color = None
    if descriptor["y_pos"]:
        height = files.read_json(paths.sequences(home) / "home.json")["height"]
        y = (_rows(folder / "regions.npy", rows)[:, :limit, 1] / height).reshape(-1)
    modules = files.read_json(folder / "descriptors.json")
    if color_name:
        color = _rows(folder / f"local_{color_name}.npy", rows)[:, :limit].reshape(n * m, -1)
    joined = concatenate(
        x.reshape(n * m, -1),
        y,
        color,
        y_weight=float(descriptor["y_weight"]),
        shape_spread=local.load(modules[name]).SPREAD,
        color_spread=local.load(modules[color_name]).SPREAD if color_name else 1.0,
    )
    joined = joined.reshape(n, m, -1)
    joined[np.arange(m)[None, :] >= counts[:, None]] = 0.0
    return Descriptors(joined, counts)


def _rows(path: Path, rows: NDArray[np.int64] | None) -> NDArray[np.float32]:
    if not path.exists():
        raise PlacecatError(f"{path} is missing: name the descriptor in conf/config.yaml and run `dvc repro`")
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
