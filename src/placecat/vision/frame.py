"""Compute all features of a frame: maps, regions, descriptors, information."""

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
    """Refuse unknown sections, descriptors and settings, and invalid values, before any frame is read.

    `features` has the form of the settings of `describe_frame`. The PlacecatError names the wrong setting,
    and lists the valid ones if it is unknown.
    """
    settings.refuse_unknown(features, list(SECTIONS), "the part of the settings for features")
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
    """Compute a frame's maps once, and all requested features from them (thesis 3.1, 3.2, 4.6).

    Parameters
    ----------
    frame_bgr
        (H, W, 3) uint8 BGR.
    settings
        Sections, each optional, that `check` accepts: ``attention`` (settings of `compute_maps`), ``regions``
        (of `find_regions`), ``information`` (of `information`), ``local`` and ``holistic`` (each maps
        descriptor names to their settings; only these descriptors are computed). A descriptor's variant may
        have any name; its setting ``descriptor`` names the original:
        ``{"centrist_full": {"descriptor": "centrist", "width": None}}``. ``variants`` maps names to region
        variants: ``scales`` (a subset of the maps' scales, None for all), ``regions`` (changed settings) and
        ``descriptors`` (names in ``local``).
    regions
        (n, 4) float32 regions to describe, at most ``max_regions``, such as tracked regions (thesis 4.7);
        None to find them. If regions are passed, variants and maps that no descriptor reads are not computed.

    Returns
    -------
    Arrays that have the same shapes for every frame: ``count`` () int16, the number of regions; ``regions``
    (max_regions, 4) float32: x, y (frame pixels), scale, strength, strongest first; ``local_<name>``
    (max_regions, D) float32; ``information`` () float32, see `placecat.vision.information.information`;
    ``holistic_<name>`` (D,) float32; then, for each variant, ``variant_<name>/count``, ``.../regions`` and
    ``.../local_<name>``. Regions and their descriptors are zero from ``count`` on.

    Raises
    ------
    PlacecatError
        If the settings do not fit the frame or each other.
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
