"""Visual attention: from a frame to its maps and salient regions (thesis 3.1.1)."""

from collections.abc import Collection, Sequence

import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError
from placecat.vision.center_surround import color_contrast, intensity_contrast
from placecat.vision.color import channels, check_frame, reduced_planes
from placecat.vision.maps import FIELDS, FloatArray, FrameMaps
from placecat.vision.orientation import orientation_maps
from placecat.vision.pyramid import check_scales, gaussian_pyramid, laplacian
from placecat.vision.regions import select_regions
from placecat.vision.saliency import saliency
from placecat.vision.spectral_residual import spectral_residual


def compute_maps(
    frame_bgr: NDArray[np.uint8],
    fields: Collection[str] = FIELDS,
    *,
    scales: Sequence[int] = (2, 3, 4, 5),
    radii: Sequence[int] = (1, 3),
    clip_color: bool = False,
    gabor_size: int = 9,
    gabor_sigma: float = 2.0,
    gabor_wavelength: float = 4.0,
    gabor_aspect: float = 1.0,
    gabor_phase: float | None = None,
    use_residual: bool = True,
    residual_box: int = 3,
    residual_sigma: float = 1.0,
    residual_width: int | None = None,
    residual_floor: float = 0.1,
) -> FrameMaps:
    """Compute the pyramids and feature maps of a frame (thesis 3.1.1.1 and 3.1.1.2).

    Parameters
    ----------
    frame_bgr
        (H, W, 3) uint8, BGR.
    fields
        The fields of `FrameMaps` that are needed; the others stay empty. It changes no value. `find_regions`
        needs all but ``color``.
    scales
        Pyramid levels in use, ascending, from 1 on; (2, 3, 4, 5) in the thesis.
    radii
        Radii of the centre-surround neighbourhoods in pixels of a level; 1 and 3 in the thesis (3x3, 7x7).
    clip_color
        Set negative colour values of single pixels to 0, as Itti et al. do. The thesis does not give this.
    gabor_size, gabor_sigma, gabor_wavelength, gabor_aspect, gabor_phase
        See `placecat.vision.orientation.orientation_maps`. The thesis does not give these.
    use_residual
        Compute the spectral residual; without it `residual` is empty.
    residual_box, residual_sigma, residual_width, residual_floor
        See `placecat.vision.spectral_residual.spectral_residual`. The thesis does not give these.

    Returns
    -------
    FrameMaps
        All maps, float32 and finite; black pixels have no colour (0).

    Raises
    ------
    TypeError
        The frame is not an array of uint8.
    PlacecatError
        The frame does not have the shape (H, W, 3) or is too small for the scales, or a setting is
        impossible.
    """
    frame = check_frame(frame_bgr)
    height, width = frame.shape[:2]
    levels = check_scales(tuple(scales), width, height)
    sizes = tuple(radii)
    if not sizes or any(r < 1 for r in sizes):
        raise PlacecatError(f"radii must be whole numbers from 1 on, such as (1, 3), not {sizes}")
    in_color = "color" in fields or "color_contrast" in fields
    total, planes = reduced_planes(frame, color=in_color, clip=clip_color)
    # The sum of the colours is whole, so a flat frame stays flat to the last bit; thirds only at the end.
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
            s: intensity_contrast(grey[s], sizes) for s in levels if "intensity_contrast" in fields
        },
        color_contrast={
            s: color_contrast([pyramid[s] for pyramid in pyramids], sizes)
            for s in levels
            if "color_contrast" in fields
        },
        orientation={
            s: orientation_maps(
                laplacian(grey, s),
                gabor_size=gabor_size,
                gabor_sigma=gabor_sigma,
                gabor_wavelength=gabor_wavelength,
                gabor_aspect=gabor_aspect,
                gabor_phase=gabor_phase,
            )
            for s in levels
            if "orientation" in fields
        },
        residual={
            s: spectral_residual(
                grey[s],
                residual_box=residual_box,
                residual_sigma=residual_sigma,
                residual_width=residual_width,
                residual_floor=residual_floor,
            )
            for s in levels
            if use_residual and "residual" in fields
        },
    )


def find_regions(
    maps: FrameMaps,
    *,
    max_regions: int = 25,
    fusion_scale: int = 2,
    use_residual: bool = True,
    maximum_window: int = 3,
    intensity_unit: float = 255.0,
    color_unit: float = 3.0,
    orientation_unit: float = 127.5,
    residual_unit: float = 4.0,
    scale_distance: float = 1 / 256,
    min_distance: float = 1 / 40,
) -> FloatArray:
    """Find the salient regions of a frame (thesis 3.1.1.3).

    Parameters
    ----------
    maps
        From `compute_maps`.
    max_regions
        Largest number of regions, 25 in the thesis.
    fusion_scale, use_residual, maximum_window, intensity_unit, color_unit, orientation_unit, residual_unit
        See `placecat.vision.saliency.saliency`. The thesis gives only that the residual is used.
    scale_distance, min_distance
        Factors of the acceptance inequality, 1/256 and 1/40 in the thesis; see
        `placecat.vision.regions.accept`.

    Returns
    -------
    ndarray
        (n, 4) float32: x, y of the centre in pixels of the frame, scale, saliency; saliency falling. Fewer
        than `max_regions` where the frame has no more; (0, 4) for a flat frame.

    Raises
    ------
    PlacecatError
        An impossible setting.
    """
    fused = saliency(
        maps,
        fusion_scale=fusion_scale,
        use_residual=use_residual,
        maximum_window=maximum_window,
        intensity_unit=intensity_unit,
        color_unit=color_unit,
        orientation_unit=orientation_unit,
        residual_unit=residual_unit,
    )
    return select_regions(
        maps,
        fused,
        max_regions=max_regions,
        maximum_window=maximum_window,
        scale_distance=scale_distance,
        min_distance=min_distance,
    )
