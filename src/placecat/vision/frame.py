"""Compute all features of a frame: its maps, regions, descriptors and information."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat import paths, settings
from placecat.schema import signatures
from placecat.vision import discovery
from placecat.vision.attention import compute_maps
from placecat.vision.information import information
from placecat.vision.maps import FIELDS
from placecat.vision.variants import Request, describe_requested, most_regions, region_arrays

SECTIONS = ("attention", "regions", "local", "holistic", "information", "variants")


def check(features: Mapping[str, Mapping[str, Any]]) -> None:
    """Check sections, descriptors, settings and their values before any frame is read.

    `features` has the same form as `settings` in `describe_frame`. Raises a PlacecatError that names the
    setting if anything is unknown or invalid. For an unknown setting, the error lists the valid ones.
    """
    settings.refuse_unknown(features, list(SECTIONS), "the features section")
    for section in ("attention", "regions", "information"):
        signatures.check_vision(section, features.get(section, {}), section)
    for kind in ("local", "holistic"):
        for name, own in features.get(kind, {}).items():
            signatures.check_descriptor(kind, name, own)


def describe_frame(
    frame_bgr: NDArray[np.uint8],
    settings: Mapping[str, Mapping[str, Any]],
    *,
    regions: NDArray[np.float32] | None = None,
) -> dict[str, NDArray[Any]]:
    """Compute a frame's maps once, and derive all requested features from them (thesis 3.1, 3.2, 4.6).

    Parameters
    ----------
    frame_bgr
        (H, W, 3) uint8 BGR.
    settings
        Optional sections that `check` accepts. ``attention``, ``regions`` and ``information`` contain the
        settings of `compute_maps`, `find_regions` and `information`. ``local`` and ``holistic`` map each
        requested descriptor to its settings. A variant of a descriptor may have any name, and its
        ``descriptor`` setting names the original, as in ``{"centrist_full": {"descriptor": "centrist",
        "width": None}}``. ``variants`` maps names to variants of the regions. Each variant has ``scales``
        (some of the maps' scales, or None for all), ``regions`` (overridden settings) and ``descriptors``
        (names in ``local``).
    regions
        (n, 4) float32 regions to describe, at most ``max_regions`` of them, such as tracked regions (thesis
        4.7). If None, the regions are found in the frame. If regions are passed, variants are not computed,
        nor are maps that no descriptor reads.

    Returns
    -------
    Arrays whose shapes are the same for every frame. ``count``, the number of regions, is an int16 scalar.
    ``regions``, (max_regions, 4) float32, has the columns x, y (in frame pixels), scale and strength, with
    the strongest region first. ``local_<name>`` is (max_regions, D) float32, and ``holistic_<name>`` is (D,)
    float32. ``information`` is a float32 scalar (see `placecat.vision.information.information`). Each variant
    adds ``variant_<name>/count``, ``.../regions`` and ``.../local_<name>``. In the arrays of regions and of
    their descriptors, the rows from ``count`` onwards are zero.

    Raises
    ------
    PlacecatError
        If the settings contradict each other or do not fit the frame.
    """
    own = {section: settings.get(section, {}) for section in SECTIONS}
    most = most_regions(own["regions"])
    local = {name: discovery.entry("local", name, given) for name, given in own["local"].items()}
    holistic = {name: discovery.entry("holistic", name, given) for name, given in own["holistic"].items()}
    fields = set(FIELDS)
    if regions is not None:
        fields = {"grey"}.union(*(module.MAPS for module, _ in (*local.values(), *holistic.values())))
    maps = compute_maps(frame_bgr, fields, **own["attention"])
    variants: dict[str, dict[str, NDArray[Any]]] = {}
    if regions is None:
        requests = {"": Request(None, own["regions"], tuple(local))}
        for name, one in own["variants"].items():
            changed = {**own["regions"], **one["regions"]}
            requests[paths.VARIANT.format(name)] = Request(one["scales"], changed, one["descriptors"])
        variants = describe_requested(maps, requests, own["local"])
        arrays = variants.pop("")
    else:
        described = {
            name: module.describe(maps, regions, **chosen) for name, (module, chosen) in local.items()
        }
        arrays = region_arrays(regions, described, most)
    arrays["information"] = np.array(information(maps, **own["information"]), np.float32)
    for name, (module, chosen) in holistic.items():
        arrays[f"holistic_{name}"] = module.describe(frame_bgr, maps, **chosen)
    for folder, parts in variants.items():
        arrays |= {f"{folder}/{name}": array for name, array in parts.items()}
    return arrays
