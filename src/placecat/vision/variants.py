"""Find and describe salient regions in the same maps with different settings (thesis 3.1.1, 4.4)."""

from collections.abc import Collection, Hashable, Mapping, Sequence
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from placecat.vision import discovery
from placecat.vision.attention import find_regions
from placecat.vision.maps import FrameMaps
from placecat.vision.regions import select_regions


class Request(NamedTuple):
    """Requested regions: their scales (None for all), settings for `find_regions`, and local descriptors."""

    scales: Sequence[int] | None
    regions: Mapping[str, Any]
    descriptors: Collection[str]

    @property
    def most(self) -> int:
        """The maximum number of regions."""
        return most_regions(self.regions)

    @property
    def others(self) -> Hashable:
        """All settings except the number of regions."""
        others = {name: value for name, value in self.regions.items() if name != "max_regions"}
        return None if self.scales is None else tuple(self.scales), *sorted(others.items())


def most_regions(regions: Mapping[str, Any]) -> int:
    """Return the maximum number of regions in settings for `find_regions`."""
    return int(regions.get("max_regions", discovery.settings_of(select_regions)["max_regions"]))


def describe_requested(
    maps: FrameMaps, requests: Mapping[str, Request], local: Mapping[str, Mapping[str, Any]]
) -> dict[str, dict[str, NDArray[Any]]]:
    """Find and describe the regions of each request; return their `region_arrays` by request name.

    With the same settings, a smaller set of regions is always a prefix of a larger one, because weaker
    points do not affect stronger ones (see `placecat.vision.regions.accept`). The descriptor of a region does
    not depend on other regions. Regions are therefore found and described only once, for the largest number
    requested.

    `maps` must have all fields, and `local` maps each local descriptor to its settings. Raises PlacecatError
    if a scale has no maps.
    """
    groups: dict[Hashable, list[Request]] = {}
    for request in requests.values():
        groups.setdefault(request.others, []).append(request)
    found: dict[Hashable, NDArray[np.float32]] = {}
    described: dict[Hashable, dict[str, NDArray[np.float32]]] = {}
    for key, group in groups.items():
        scales, settings, _ = group[0]
        own = maps
        if scales is not None:
            own = maps.remembered(("scales", *scales), partial(maps.at_scales, scales))
        found[key] = find_regions(own, **{**settings, "max_regions": max(one.most for one in group)})
        described[key] = {}
        for name in dict.fromkeys(name for one in group for name in one.descriptors):
            most = max(one.most for one in group if name in one.descriptors)
            module, options = discovery.entry("local", name, local[name])
            described[key][name] = module.describe(own, found[key][:most], **options)
    return {
        name: region_arrays(
            found[one.others][: one.most],
            {other: described[one.others][other][: one.most] for other in one.descriptors},
            one.most,
        )
        for name, one in requests.items()
    }


def region_arrays(
    regions: NDArray[np.float32], described: Mapping[str, NDArray[np.float32]], most: int
) -> dict[str, NDArray[Any]]:
    """Return ``count``, ``regions`` and ``local_<name>`` as in `placecat.vision.frame.describe_frame`.

    `described` maps each descriptor to the (n, D) descriptors of the (n, 4) regions. The arrays are padded
    with zeros to `most` rows.
    """
    arrays: dict[str, NDArray[Any]] = {"count": np.array(len(regions), np.int16)}
    for name, rows in {
        "regions": regions,
        **{f"local_{name}": rows for name, rows in described.items()},
    }.items():
        arrays[name] = np.zeros((most, rows.shape[1]), np.float32)
        arrays[name][: len(rows)] = rows
    return arrays
