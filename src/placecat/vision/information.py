"""Measure the information in a view with a band-pass filter."""

import cv2

from placecat.errors import PlacecatError
from placecat.vision.maps import FrameMaps
from placecat.vision.pyramid import expand, level_size


def information(maps: FrameMaps, *, fine: int = 2, coarse: int | None = None, unit: float = 256 / 3) -> float:
    """Measure a frame's energy at intermediate frequencies (thesis 4.6).

    The measure is the mean absolute difference between two levels of the intensity pyramid: the level
    ``fine`` and the expanded level ``coarse``. The thesis does not state a unit. Its thresholds 0.09766 and
    0.13021 are 25 / 256 and 25 / 192. With intensities from 0 to 1, the threshold 0.09766 would reject nearly
    every indoor view. By default, 256 levels of the sum r + g + b count as 1, so that 0.09766 rejects a
    quarter of the views and 0.13021 rejects two fifths.

    Parameters
    ----------
    fine
        The finer level, which the thesis calls the "second" scale.
    coarse
        The coarser level, above ``fine``. None selects the last level.
    unit
        Number of grey levels of the intensity (r + g + b) / 3 that count as 1; must be positive. Use 256 for
        intensities from 0 to 1.

    Returns
    -------
    float
        A number from 0 to 255 / unit. Raises PlacecatError if a level is missing, or if `coarse` is not above
        `fine`.
    """
    last = maps.scales[-1] if coarse is None else coarse
    if fine not in maps.grey or last not in maps.grey or last <= fine:
        known = ", ".join(map(str, maps.scales))
        raise PlacecatError(
            f"the information measure needs two of the levels {known} in ascending order, not {fine} and "
            f"{last}"
        )
    expanded = maps.grey[last]
    for level in range(last - 1, fine - 1, -1):
        expanded = expand(expanded, *level_size(maps.width, maps.height, level))
    return cv2.norm(maps.grey[fine], expanded, cv2.NORM_L1) / (maps.grey[fine].size * unit)
