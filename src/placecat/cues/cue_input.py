"""Assemble a cue's input from the features of one or more frames."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat import settings
from placecat.cues.descriptors import Descriptors
from placecat.errors import PlacecatError
from placecat.vision import discovery

SETTINGS = {
    "local": ("kind", "name", "y_pos", "y_weight", "color", "max_regions", "tracked", "variant"),
    "holistic": ("kind", "name"),
}


def check(descriptor: Mapping[str, Any]) -> None:
    """Raise an error that names the valid choices if a descriptor has an unknown kind or setting.

    A descriptor has the keys ``kind`` (local or holistic) and ``name``. A local descriptor also has
    ``y_pos``, ``y_weight``, ``color`` (the colour descriptor to append, or None) and ``max_regions``. If its
    regions are tracked, ``tracked`` is true. If they come from a variant in conf/region_variants, ``variant``
    names it.
    """
    kind, name = descriptor["kind"], descriptor["name"]
    if kind not in SETTINGS:
        raise PlacecatError(f"descriptor.kind must be local or holistic, not {kind!r}")
    settings.refuse_unknown(descriptor, list(SETTINGS[kind]), f"{kind} descriptor {name}")


def array_names(descriptor: Mapping[str, Any]) -> list[str]:
    """List the arrays from :func:`placecat.vision.frame.describe_frame` that :func:`assemble` needs."""
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
    """Assemble a descriptor for n frames. Raises PlacecatError if `arrays` has too few regions for it.

    The shape descriptor of a region is concatenated with the vertical position of its centre and with its
    colour descriptor (thesis 4.4.1). The position is 0 at the top and 1 at the bottom, and is multiplied by
    ``y_weight``. Descriptors have different ranges (up to 255 for SIFT, up to 1 for HOG), and the thesis does
    not say how to weight them. Each is therefore divided by the ``SPREAD`` of its module, so that all of them
    contribute equally to a distance.

    `descriptor` has the keys that :func:`check` describes. `arrays` contains the arrays that
    :func:`array_names` lists, with n frames along the first axis. `height` is the frame height in pixels.
    `modules` maps each region descriptor to its module in `placecat.vision.local`.
    """
    if descriptor["kind"] == "holistic":
        return Descriptors(np.array(arrays[f"holistic_{descriptor['name']}"], np.float32))
    name, limit = descriptor["name"], int(descriptor["max_regions"])
    there = arrays[f"local_{name}"].shape[1]
    if limit > there:
        raise PlacecatError(
            f"a cue uses {limit} regions (max_regions), but regions.max_regions is {there}: "
            "increase regions.max_regions"
        )

    def described(part: str) -> NDArray[np.float32]:
        spread = discovery.load("local", modules[part]).SPREAD
        return np.array(arrays[f"local_{part}"][:, :limit], np.float32) * np.float32(1 / spread)

    parts = [described(name)]
    if descriptor["y_pos"]:
        y = np.array(arrays["regions"][:, :limit, 1], np.float32) / np.float32(height)
        parts.append((y * np.float32(descriptor["y_weight"]))[:, :, None])
    if descriptor["color"]:
        parts.append(described(descriptor["color"]))
    x = np.concatenate(parts, axis=2)
    counts = np.minimum(arrays["count"], limit).astype(np.int64)
    x[np.arange(limit) >= counts[:, None]] = 0.0
    return Descriptors(x, counts)
