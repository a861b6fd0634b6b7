"""Salient regions of the same maps found with other settings, to compare these (thesis 3.1.1, 4.4)."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat import paths, settings
from placecat.errors import PlacecatError
from placecat.vision import local
from placecat.vision.attention import find_regions
from placecat.vision.discovery import check_settings, settings_of
from placecat.vision.maps import FrameMaps

_Section = Mapping[str, Any]


def check_variants(variants: Mapping[str, _Section], local_settings: Mapping[str, _Section]) -> None:
    """Refuse variants with unknown settings or descriptors.

    `variants` are as for `describe_variants`; `local_settings` are those of every local descriptor. The
    PlacecatError names the unknown and the valid names.
    """
    for name, own in variants.items():
        where = f"variant '{name}' of the regions"
        settings.refuse_unknown(own, ["scales", "regions", "descriptors"], where)
        check_settings(find_regions, own["regions"], where)
        for descriptor in own["descriptors"]:
            if descriptor not in local_settings:
                valid = ", ".join(local_settings) or "none"
                raise PlacecatError(f"{where}: there is no local descriptor {descriptor!r} (valid: {valid})")


def describe_variants(
    maps: FrameMaps,
    variants: Mapping[str, _Section],
    *,
    regions: _Section,
    local_settings: Mapping[str, _Section],
) -> dict[str, NDArray[Any]]:
    """Find and describe the salient regions of a frame with other settings.

    Parameters
    ----------
    maps
        Of the frame, all fields.
    variants
        Name to ``scales`` (some of those of the maps, None for all), ``regions`` (settings of `find_regions`
        to change) and ``descriptors`` (names of local descriptors). A scale without maps, or an impossible
        setting, raises PlacecatError.
    regions
        Settings of `find_regions` that variants start from.
    local_settings
        Settings of the local descriptors by name.

    Returns
    -------
    ``variant_NAME/count``, ``variant_NAME/regions`` and ``variant_NAME/local_DESCRIPTOR``, in the form of
    `placecat.vision.frame.describe_frame`.
    """
    result: dict[str, NDArray[Any]] = {}
    for name, own in variants.items():
        seen = maps if own["scales"] is None else maps.at_scales(own["scales"])
        chosen = {**regions, **own["regions"]}
        most = int(chosen.get("max_regions", settings_of(find_regions)["max_regions"]))
        found = find_regions(seen, **chosen)
        folder = paths.VARIANT.format(name)
        result[f"{folder}/count"] = np.array(len(found), np.int16)
        result[f"{folder}/regions"] = padded(found, most)
        for descriptor in own["descriptors"]:
            module, options = local.entry(descriptor, local_settings[descriptor])
            result[f"{folder}/local_{descriptor}"] = padded(module.describe(seen, found, **options), most)
    return result


def padded(rows: NDArray[np.float32], most: int) -> NDArray[np.float32]:
    """Rows of regions followed by zeros, ``(most, D)``."""
    result = np.zeros((most, rows.shape[1]), np.float32)
    result[: len(rows)] = rows
    return result
