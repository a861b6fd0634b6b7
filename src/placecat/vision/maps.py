"""The maps of a frame, computed once and shared by all descriptors."""

from __future__ import annotations

from collections.abc import Callable, Collection, Hashable
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError

FloatArray = NDArray[np.float32]

FIELDS = ("grey", "color", "intensity_contrast", "color_contrast", "orientation", "residual")
"""The fields of `FrameMaps` that contain maps."""


@dataclass(frozen=True)
class FrameMaps:
    """A frame's pyramids and feature maps (thesis 3.1.1), all in float32.

    Level ``s`` has the shape (ceil(height / 2**s), ceil(width / 2**s)). Fields that were not requested are
    empty.

    Attributes
    ----------
    width, height
        Size of the frame in pixels (level 0).
    scales
        Pyramid levels in use, in ascending order. The thesis uses (2, 3, 4, 5). Every dict below has these
        keys.
    grey
        (h_s, w_s), the intensity pyramid, from 0 to 255.
    color
        (4, h_s, w_s), the channels R, G, B, Y of intensity-normalised colour, dimensionless.
    intensity_contrast
        (2 radii, 2, h_s, w_s), the centre-surround responses of the intensity in 3x3 and 7x7 neighbourhoods.
        The sub-channels are on (bright spot) and off (dark spot), both >= 0.
    color_contrast
        (2 radii, 4, h_s, w_s), by how much R, G, B, Y in the centre exceed the surround, >= 0.
    orientation
        (4, h_s, w_s), Gabor magnitudes at 0, 45, 90, 135 degrees on the Laplacian pyramid, >= 0.
    residual
        (h_s, w_s), the spectral residual saliency of the intensity (3.1.1.2), >= 0.
    """

    width: int
    height: int
    scales: tuple[int, ...]
    grey: dict[int, FloatArray]
    color: dict[int, FloatArray]
    intensity_contrast: dict[int, FloatArray]
    color_contrast: dict[int, FloatArray]
    orientation: dict[int, FloatArray]
    residual: dict[int, FloatArray]
    _kept: dict[tuple[Hashable, ...], Any] = field(
        default_factory=dict, init=False, repr=False, compare=False
    )

    def at_scales(self, scales: Collection[int]) -> FrameMaps:
        """Return only the maps at the given scales, as if no others had been computed.

        Raises PlacecatError if `scales` is empty or contains a scale without maps.
        """
        wanted = tuple(scale for scale in self.scales if scale in scales)
        if not wanted or len(wanted) < len(set(scales)):
            there = ", ".join(map(str, self.scales))
            raise PlacecatError(f"maps exist only for the scales {there}, not for all of {list(scales)}")
        some: dict[str, Any] = {
            name: {scale: own[scale] for scale in wanted if scale in own}
            for name, own in ((name, getattr(self, name)) for name in FIELDS)
        }
        return replace(self, scales=wanted, **some)

    def remembered(self, key: tuple[Hashable, ...], compute: Callable[[], Any]) -> Any:
        """Return the result of `compute`, which runs only once per frame and key. Do not modify it."""
        if key not in self._kept:
            self._kept[key] = compute()
        return self._kept[key]
