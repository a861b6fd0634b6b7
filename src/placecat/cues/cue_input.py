"""Assemble a cue's input from the features of one or more frames."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat.cues.descriptors import Descriptors
from placecat.errors import PlacecatError
from placecat.vision import local
from placecat.vision.local.concatenate import concatenate

LOCAL = {"kind", "name", "y_pos", "y_weight", "color", "max_regions", "tracked", "variant"}
HOLISTIC = {"kind", "name"}


def check(descriptor: Mapping[str, Any]) -> None:
    """Refuse a descriptor of an unknown kind or with an unknown setting; the error names the valid ones.

    A descriptor has ``kind`` (local or holistic) and ``name``; a local one also has ``y_pos``, ``y_weight``,
    ``color`` (the colour descriptor to append, or None) and ``max_regions``. For tracked regions,
    ``tracked`` is true; for a variant in conf/region_variants, ``variant`` is its name.
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


def array_names(descriptor: Mapping[str, Any]) -> list[str]:
    """Name the arrays from :func:`placecat.vision.frame.describe_frame` that :func:`assemble` needs."""
    if descriptor["kind"] == "holistic":
        return [f"holistic_{descriptor['name']}"]
    names = [f"local_{descriptor['name']}", "count"]
    if descriptor["y_pos"]:
        names.append("regions")
    return [*names, f"local_{descriptor['color']}"] if descriptor["color"] else names


def assemble(
    descriptor: Mapping[str, Any],
    arrays: Mapping[str, NDArray[Any]],
    *,
    height: int,
    modules: Mapping[str, str],
) -> Descriptors:
    """Assemble one descriptor of n frames; PlacecatError if `arrays` have fewer than ``max_regions`` regions.

    `descriptor` is as for :func:`check`. `arrays` holds the arrays that :func:`array_names` lists, with n
    frames along the first axis. `height` is the frame height in pixels. `modules` maps each region
    descriptor to its module in `placecat.vision.local`.
    """
    if descriptor["kind"] == "holistic":
        return Descriptors(np.array(arrays[f"holistic_{descriptor['name']}"], np.float32))
    name, color_name, limit = descriptor["name"], descriptor["color"], int(descriptor["max_regions"])
    found = arrays[f"local_{name}"]
    if limit > found.shape[1]:
        raise PlacecatError(
            f"a cue uses {limit} regions (max_regions), but regions.max_regions is {found.shape[1]}: "
            "increase regions.max_regions"
        )
    counts = np.minimum(arrays["count"], limit).astype(np.int64)
    x = np.array(found[:, :limit], np.float32)
    n, m, _ = x.shape
    y = color = None
    if descriptor["y_pos"]:
        y = (np.array(arrays["regions"][:, :limit, 1], np.float32) / np.float32(height)).reshape(-1)
    if color_name:
        color = np.array(arrays[f"local_{color_name}"][:, :limit], np.float32).reshape(n * m, -1)
    weights: dict[str, float] = {
        "y_weight": float(descriptor["y_weight"]),
        "shape_spread": local.load(modules[name]).SPREAD,
        "color_spread": local.load(modules[color_name]).SPREAD if color_name else 1.0,
    }
    joined = concatenate(x.reshape(n * m, -1), y, color, **weights).reshape(n, m, -1)
    joined[np.arange(m)[None, :] >= counts[:, None]] = 0.0
    return Descriptors(joined, counts)
