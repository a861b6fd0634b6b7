"""The maps of one frame, computed once and shared by every descriptor."""

from __future__ import annotations

from collections.abc import Callable, Collection, Hashable
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError

FloatArray = NDArray[np.float32]

FIELDS = ("grey", "color", "intensity_contrast", "color_contrast", "orientation", "residual")
"""The fields of `FrameMaps` that hold maps."""


@dataclass(frozen=True)
class FrameMaps:
    """Pyramids and feature maps of one frame (thesis 3.1.1); all arrays float32.

    Level ``s`` has size (ceil(height / 2**s), ceil(width / 2**s)). Fields that were not requested are empty.

    Attributes
    ----------
    width, height
        Size of the frame in pixels (level 0).
    scales
        Pyramid levels in use, ascending; (2, 3, 4, 5) in the thesis. They are the keys of every dict below.
    grey
        (h_s, w_s), the intensity pyramid, 0 to 255.
    color
        (4, h_s, w_s), the channels R, G, B, Y of intensity-normalised colour, dimensionless.
    intensity_contrast
        (2 radii, 2, h_s, w_s), centre-surround of the intensity for the 3x3 and the 7x7 neighbourhood;
        sub-channels on (bright spot) and off (dark spot), both >= 0.
    color_contrast
        (2 radii, 4, h_s, w_s), centre-surround of R, G, B, Y, centre above surround, >= 0.
    orientation
        (4, h_s, w_s), Gabor magnitude at 0, 45, 90, 135 degrees on the Laplacian pyramid, >= 0.
    residual
        (h_s, w_s), spectral residual saliency of the intensity (3.1.1.2), >= 0.
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
    _kept: dict[tuple[Any, ...], tuple[Any, Any]] = field(
        default_factory=dict, init=False, repr=False, compare=False
    )

    def at_scales(self, scales: Collection[int]) -> FrameMaps:
        """Return the maps at some scales only, as if no other scales had been computed.

        Raises PlacecatError if `scales` is empty or has a scale without maps.
        """
        wanted = tuple(scale for scale in self.scales if scale in scales)
        if not wanted or len(wanted) < len(set(scales)):
            there = ", ".join(map(str, self.scales))
            raise PlacecatError(f"there are only maps of the scales {there}, not of all of {list(scales)}")
        some: dict[str, Any] = {
            name: {scale: own[scale] for scale in wanted if scale in own}
            for name, own in ((name, getattr(self, name)) for name in FIELDS)
        }
        return replace(self, scales=wanted, **some)

    def once(self, function: Callable[..., Any], array: NDArray[Any], *arguments: Any) -> Any:
        """Return ``function(array, *arguments)``, computed once per frame.

        Parameters
        ----------
        function
            A module-level function without side effects.
        array
            The frame or one of the maps; it must not change.
        *arguments
            Further arguments, hashable.

        Returns
        -------
        The result. All descriptors share this object: do not write into it.
        """
        key = (function, id(array), *arguments)
        # Store the array too, so no other array can get its id.
        known, result = self._kept.get(key, (None, None))
        if known is not array:
            result = function(array, *arguments)
            self._kept[key] = array, result
        return result

    def remembered(self, key: tuple[Hashable, ...], compute: Callable[[], Any]) -> Any:
        """Return the result of `compute`, computed once per frame and key; do not write into it."""
        if key not in self._kept:
            self._kept[key] = None, compute()
        return self._kept[key][1]
