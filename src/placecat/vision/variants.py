"""Find salient regions in the same maps with other settings, for comparison (thesis 3.1.1, 4.4)."""

from collections.abc import Collection, Hashable, Iterable, Mapping, Sequence
from typing import Any, NamedTuple

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
    """Reject variants with unknown settings or descriptors.

    `variants` has the same form as in `wanted_variants`; `local_settings` maps every local descriptor to its
    settings. The PlacecatError names the unknown entry and the valid ones.
    """
    for name, own in variants.items():
        where = f"variant '{name}' of the regions"
        settings.refuse_unknown(own, ["scales", "regions", "descriptors"], where)
        check_settings(find_regions, own["regions"], where)
        for descriptor in own["descriptors"]:
            if descriptor not in local_settings:
                valid = ", ".join(local_settings) or "none"
                raise PlacecatError(f"{where}: there is no local descriptor {descriptor!r} (valid: {valid})")


class Wanted(NamedTuple):
    """Requested salient regions: scales (None for all), settings for `find_regions`, descriptors."""

    scales: Sequence[int] | None
    regions: _Section
    descriptors: Collection[str]

    @property
    def most(self) -> int:
        """The maximum number of regions."""
        return most_regions(self.regions)

    @property
    def others(self) -> Hashable:
        """All settings except the number of regions, and whether that number is below 1 (rejected later)."""
        others = {name: value for name, value in self.regions.items() if name != "max_regions"}
        return None if self.scales is None else tuple(self.scales), *sorted(others.items()), self.most < 1


class SharedRegions:
    """A frame's salient regions for several settings, and their descriptors, each computed once.

    With the same settings, a smaller set of regions is always the start of a larger one: weaker points do not
    affect stronger ones (`placecat.vision.regions.accept`), and a region's descriptor does not depend on
    other regions. So regions are found and described once, for the largest requested number.

    Parameters
    ----------
    maps
        The frame's maps, with all fields.
    wanted
        All requests that will be made.
    local_settings
        Maps each local descriptor's name to its settings.
    """

    def __init__(
        self, maps: FrameMaps, wanted: Iterable[Wanted], local_settings: Mapping[str, _Section | None]
    ) -> None:
        self._maps = maps
        self._local_settings = local_settings
        self._most: dict[Hashable, int] = {}
        self._known: dict[Hashable, Any] = {}
        for one in wanted:
            for key in (one.others, *((one.others, name) for name in one.descriptors)):
                self._most[key] = max(one.most, self._most.get(key, one.most))

    def find(self, wanted: Wanted) -> NDArray[np.float32]:
        """Return the requested regions; result and errors are those of `find_regions`."""
        return self._largest(wanted)[: wanted.most]

    def describe(self, wanted: Wanted, name: str) -> NDArray[np.float32]:
        """Return the requested regions' local descriptors, (n, D) float32."""
        key = (wanted.others, name)
        if key not in self._known:
            module, options = local.entry(name, self._local_settings[name] or {})
            found = self._largest(wanted)[: self._most[key]]
            self._known[key] = module.describe(self._at(wanted.scales), found, **options)
        described: NDArray[np.float32] = self._known[key][: wanted.most]
        return described

    def _largest(self, wanted: Wanted) -> NDArray[np.float32]:
        key = wanted.others
        if key not in self._known:
            settings = {**wanted.regions, "max_regions": self._most[key]}
            self._known[key] = find_regions(self._at(wanted.scales), **settings)
        found: NDArray[np.float32] = self._known[key]
        return found

    def _at(self, scales: Sequence[int] | None) -> FrameMaps:
        if scales is None:
            return self._maps
        key = ("scales", *scales)
        if key not in self._known:
            self._known[key] = self._maps.at_scales(scales)
        maps: FrameMaps = self._known[key]
        return maps


def most_regions(regions: _Section) -> int:
    """Return the maximum number of regions in settings for `find_regions`."""
    return int(regions.get("max_regions", settings_of(find_regions)["max_regions"]))


def wanted_variants(variants: Mapping[str, _Section], regions: _Section) -> dict[str, Wanted]:
    """Map each region variant's name to the regions that it requests.

    Parameters
    ----------
    variants
        Maps each name to ``scales`` (a subset of the maps' scales, None for all), ``regions`` (changed
        settings for `find_regions`) and ``descriptors`` (names of local descriptors).
    regions
        Settings for `find_regions`, which the variants change.
    """
    return {
        name: Wanted(own["scales"], {**regions, **own["regions"]}, own["descriptors"])
        for name, own in variants.items()
    }


def describe_variants(shared: SharedRegions, variants: Mapping[str, Wanted]) -> dict[str, NDArray[Any]]:
    """Find and describe a frame's salient regions with other settings.

    Parameters
    ----------
    shared
        The frame's regions; they must cover all `variants`.
    variants
        The result of `wanted_variants`. A scale without maps or an invalid setting raises PlacecatError.

    Returns
    -------
    ``variant_NAME/count``, ``variant_NAME/regions`` and ``variant_NAME/local_DESCRIPTOR``, as in
    `placecat.vision.frame.describe_frame`.
    """
    result: dict[str, NDArray[Any]] = {}
    for name, wanted in variants.items():
        folder = paths.VARIANT.format(name)
        found = shared.find(wanted)
        result[f"{folder}/count"] = np.array(len(found), np.int16)
        result[f"{folder}/regions"] = padded(found, wanted.most)
        for descriptor in wanted.descriptors:
            described = shared.describe(wanted, descriptor)
            result[f"{folder}/local_{descriptor}"] = padded(described, wanted.most)
    return result


def padded(rows: NDArray[np.float32], most: int) -> NDArray[np.float32]:
    """Pad rows of regions with zeros to ``(most, D)``."""
    result = np.zeros((most, rows.shape[1]), np.float32)
    result[: len(rows)] = rows
    return result
