"""Compute the maps and salient regions of a frame with a model of visual attention (thesis 3.1.1)."""

from collections.abc import Collection, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat.vision.center_surround import color_contrast, intensity_contrast
from placecat.vision.color import channels, check_frame, reduced_planes
from placecat.vision.discovery import parts_of
from placecat.vision.maps import FIELDS, FloatArray, FrameMaps
from placecat.vision.orientation import orientation_maps
from placecat.vision.pyramid import check_scales, gaussian_pyramid, laplacian
from placecat.vision.regions import accept, select_regions
from placecat.vision.saliency import saliency
from placecat.vision.spectral_residual import spectral_residual


def compute_maps(
    frame_bgr: NDArray[np.uint8],
    fields: Collection[str] = FIELDS,
    *,
    scales: Sequence[int] = (2, 3, 4, 5),
    radii: Sequence[int] = (1, 3),
    clip_color: bool = False,
    use_residual: bool = True,
    **settings: Any,
) -> FrameMaps:
    """Compute a frame's pyramids and feature maps (thesis 3.1.1.1 and 3.1.1.2).

    Parameters
    ----------
    frame_bgr
        (H, W, 3) uint8, BGR.
    fields
        Fields of `FrameMaps` to compute. All other fields stay empty. The values of a field do not depend on
        this choice. `find_regions` needs all fields except ``color``.
    scales
        Pyramid levels to use, each at least 1, in ascending order. The thesis uses (2, 3, 4, 5).
    radii
        Radii of the centre-surround neighbourhoods, in pixels at each level. The thesis uses 1 and 3 (3x3 and
        7x7 pixels).
    clip_color
        Whether to set negative colour values to 0 in each pixel, as Itti et al. do. The thesis does not
        specify this.
    use_residual
        Whether to compute the spectral residual. If false, `residual` is empty.
    **settings
        Settings of `placecat.vision.orientation.orientation_maps`, such as ``gabor_size``, and of
        `placecat.vision.spectral_residual.spectral_residual`, such as ``residual_box``.

    Returns
    -------
    The requested maps, all float32 and finite. Black pixels have no colour, so their colour values are 0.

    Raises
    ------
    TypeError
        If the frame is not a uint8 array.
    PlacecatError
        If the frame's shape is not (H, W, 3), if it is too small for the scales, or if a setting is invalid.
    """
    checked = {**settings, "scales": list(scales), "radii": list(radii)}
    gabor, residual = parts_of("attention", checked, orientation_maps, spectral_residual)
    frame = check_frame(frame_bgr)
    height, width = frame.shape[:2]
    levels = tuple(scales)
    check_scales(levels, width, height)
    in_color = "color" in fields or "color_contrast" in fields
    total, planes = reduced_planes(frame, color=in_color, clip=clip_color)
    # The sum of the colour channels is an integer, so dividing by 3 last keeps a flat frame exactly flat.
    totals = gaussian_pyramid(total, 1, levels[-1] + 1)
    grey = {s: totals[s] / np.float32(3) for s in sorted({*levels, *(s + 1 for s in levels)})}
    pyramids = [gaussian_pyramid(plane, 1, levels[-1]) for plane in planes]
    return FrameMaps(
        width=width,
        height=height,
        scales=levels,
        grey={s: grey[s] for s in levels if "grey" in fields},
        color={s: channels([pyramid[s] for pyramid in pyramids]) for s in levels if "color" in fields},
        intensity_contrast={
            s: intensity_contrast(grey[s], radii) for s in levels if "intensity_contrast" in fields
        },
        color_contrast={
            s: color_contrast([pyramid[s] for pyramid in pyramids], radii)
            for s in levels
            if "color_contrast" in fields
        },
        orientation={
            s: orientation_maps(laplacian(grey, s), **gabor) for s in levels if "orientation" in fields
        },
        residual={
            s: spectral_residual(grey[s], **residual) for s in levels if use_residual and "residual" in fields
        },
    )


def find_regions(maps: FrameMaps, **settings: Any) -> FloatArray:
    """Find a frame's salient regions (thesis 3.1.1.3).

    `maps` is the result of `compute_maps`. Valid settings are those of
    `placecat.vision.regions.select_regions`, such as ``max_regions``, and of
    `placecat.vision.saliency.saliency`, such as ``use_residual``. Raises PlacecatError if a setting is
    invalid.

    Returns an (n, 4) float32 array. Its columns are the x and y of the centre in frame pixels, the scale and
    the saliency, and its rows are sorted by decreasing saliency. n is at most ``max_regions``, and 0 for a
    flat frame.
    """
    selection, distances, fusion = parts_of("regions", settings, select_regions, accept, saliency)
    return select_regions(maps, saliency(maps, **fusion), **selection | distances)
