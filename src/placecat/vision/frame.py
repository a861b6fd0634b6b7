"""Compute all features of a frame: maps, regions, descriptors, information."""

from collections.abc import Mapping
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError
from placecat.vision import holistic, local
from placecat.vision.attention import compute_maps, find_regions
from placecat.vision.discovery import check_settings
from placecat.vision.information import information
from placecat.vision.maps import FIELDS
from placecat.vision.variants import (
    SharedRegions,
    Wanted,
    check_variants,
    describe_variants,
    most_regions,
    padded,
    wanted_variants,
)

SECTIONS = ("attention", "regions", "local", "holistic", "information", "variants")

_Section = Mapping[str, Any]
# Maps each array's name to its module and settings.
_Entries = dict[str, tuple[ModuleType, dict[str, Any]]]


def check(settings: Mapping[str, _Section | None]) -> None:
    """Reject unknown sections, descriptors and settings before any frame is read.

    `settings` has the same form as in `describe_frame`. The PlacecatError names the unknown entry and the
    valid ones.
    """
    for section in settings:
        if section not in SECTIONS:
            raise PlacecatError(
                f"Unknown section '{section}' of the features: choose from {', '.join(SECTIONS)}."
            )
    for section, function in (
        ("attention", compute_maps),
        ("regions", find_regions),
        ("information", information),
    ):
        check_settings(function, settings.get(section) or {}, f"section '{section}' of the features")
    _entries(settings)
    check_variants(settings.get("variants") or {}, settings.get("local") or {})


def _entries(settings: Mapping[str, _Section | None]) -> tuple[_Entries, _Entries]:
    """Return the modules and settings of the local and holistic descriptors."""
    return (
        {name: local.entry(name, own or {}) for name, own in (settings.get("local") or {}).items()},
        {name: holistic.entry(name, own or {}) for name, own in (settings.get("holistic") or {}).items()},
    )


def describe_frame(
    frame_bgr: NDArray[np.uint8],
    settings: Mapping[str, _Section | None],
    *,
    regions: NDArray[np.float32] | None = None,
) -> dict[str, NDArray[Any]]:
    """Compute a frame's maps once, and all requested features from them (thesis 3.1, 3.2, 4.6).

    Parameters
    ----------
    frame_bgr
        (H, W, 3) uint8 BGR.
    settings
        Sections, each optional: ``attention`` (settings of `compute_maps`), ``regions`` (of `find_regions`),
        ``information`` (of `information`), ``local`` and ``holistic`` (each maps descriptor names to their
        settings; only these descriptors are computed). A descriptor's variant may have any name; its setting
        ``descriptor`` names the original: ``{"centrist_full": {"descriptor": "centrist", "width": None}}``.
        ``variants`` are region variants (`wanted_variants`); their descriptors must be in ``local``.
    regions
        (n, 4) float32 regions to describe, such as tracked regions (thesis 4.7); None to find them. If
        regions are passed, variants and maps that no descriptor reads are not computed.

    Returns
    -------
    Arrays that have the same shapes for every frame: ``count`` () int16, the number of regions;
    ``information`` () float32, see `placecat.vision.information.information`; ``regions`` (max_regions, 4)
    float32: x, y (frame pixels), scale, strength, strongest first; ``local_<name>`` (max_regions, D) float32;
    ``holistic_<name>`` (D,) float32; then the variants. Regions and their descriptors are zero from ``count``
    on.

    Raises
    ------
    PlacecatError
        If `check` rejects the settings, a value is invalid, or there are more than ``max_regions`` regions.
    """
    check(settings)
    own = {section: settings.get(section) or {} for section in SECTIONS}
    most = most_regions(own["regions"])
    locals_, holistics = _entries(settings)
    fields = set(FIELDS)
    if regions is not None:
        fields = {"grey"}.union(*(module.MAPS for module, _ in (*locals_.values(), *holistics.values())))
        if len(regions) > most:
            raise PlacecatError(f"{len(regions)} regions were given, but max_regions is {most}: raise it.")
    maps = compute_maps(frame_bgr, fields, **own["attention"])
    variants: dict[str, NDArray[Any]] = {}
    if regions is None:
        wanted = Wanted(None, own["regions"], tuple(locals_))
        others = wanted_variants(own["variants"], own["regions"])
        shared = SharedRegions(maps, [wanted, *others.values()], own["local"])
        variants = describe_variants(shared, others)
        # The regions are a feature themselves, so find them even if no descriptor needs them.
        regions = shared.find(wanted)
        described = {name: shared.describe(wanted, name) for name in locals_}
    else:
        described = {
            name: module.describe(maps, regions, **chosen) for name, (module, chosen) in locals_.items()
        }
    arrays: dict[str, NDArray[Any]] = {
        "count": np.array(len(regions), np.int16),
        "information": np.array(information(maps, **own["information"]), np.float32),
        "regions": padded(regions, most),
    }
    for name, rows in described.items():
        arrays[f"local_{name}"] = padded(rows, most)
    for name, (module, chosen) in holistics.items():
        arrays[f"holistic_{name}"] = module.describe(frame_bgr, maps, **chosen)
    return arrays | variants


def layout(settings: Mapping[str, _Section | None]) -> dict[str, tuple[tuple[int, ...], np.dtype[Any]]]:
    """Return the shape and dtype of every array that `describe_frame` returns, by name, in the same order.

    Both depend only on the settings. Settings and errors are the same as in `describe_frame`.
    """
    blank = np.zeros((256, 256, 3), np.uint8)
    return {name: (array.shape, array.dtype) for name, array in describe_frame(blank, settings).items()}
