"""Track salient regions from frame to frame (thesis 4.7)."""

from functools import partial

import cv2
import numpy as np
from numpy.typing import NDArray

from placecat.vision.color import reduced_grey
from placecat.vision.maps import FloatArray
from placecat.vision.regions import accept


class RegionTracker:
    """Track salient regions through an uncut sequence until they leave the image (thesis 4.7).

    The thesis does not describe its tracker. This one applies the pyramidal Lucas-Kanade method to the grey
    frame at a reduced width. For every frame, it takes these steps:

    1. It moves each region. It drops a region if it is not found, if its centre leaves the image, or if
       tracking it back does not return it to its old position (forward-backward check). Within half a window
       of the border, a region may be lost shortly before its centre leaves.
    2. It tests the acceptance inequality of 3.1.1.3, first for tracked regions (longest tracked first), then
       for new regions (strongest first). A new region is therefore added only where none is tracked. If two
       tracked regions get too close, the newer one is dropped.
    3. It keeps at most `max_regions` regions. A tracked region is never replaced by a stronger new one,
       because an object file (Kahneman and Treisman) persists as long as its object is visible.

    A region keeps its initial scale and strength. Its appearance may change over time, because each frame is
    compared only with the previous one.

    Parameters
    ----------
    max_regions
        Maximum number of regions. The thesis uses 25.
    width
        Width in pixels to which a wider frame is reduced, preserving its aspect ratio.
    window
        Side length of the window to compare, in pixels of the reduced frame; must be odd and at least 3. At a
        width of 320, 21 is about the size of the smallest regions.
    levels
        Number of times the reduced frame is halved in order to find large motions. It is halved fewer times
        if a level would be smaller than the window.
    iterations, epsilon
        The search on each level ends after `iterations` steps, or after a step shorter than `epsilon` pixels.
    min_eigenvalue
        Minimum of the smaller eigenvalue of the gradient matrix, per window pixel. Regions with flatter
        windows are lost.
    forward_backward
        Maximum distance, in pixels of the reduced frame, between a region and the point where it ends up when
        tracked back.
    scale_distance, min_distance
        Factors in the acceptance inequality (see `placecat.vision.regions.accept`).

    Attributes
    ----------
    ages
        (m,) int64, the number of frames for which each region in the last frame has been tracked. It is 0 for
        a new region.

    References
    ----------
    J.-Y. Bouguet, Pyramidal implementation of the Lucas Kanade feature tracker, Intel 2000.
    Z. Kalal, K. Mikolajczyk and J. Matas, Forward-backward error, ICPR 2010.
    D. Kahneman, A. Treisman and B. Gibbs, The reviewing of object files, Cognitive Psychology 1992.
    """

    def __init__(
        self,
        *,
        max_regions: int = 25,
        width: int = 320,
        window: int = 21,
        levels: int = 3,
        iterations: int = 30,
        epsilon: float = 0.01,
        min_eigenvalue: float = 1e-4,
        forward_backward: float = 1.0,
        scale_distance: float = 1 / 256,
        min_distance: float = 1 / 40,
    ) -> None:
        self.width = width
        self.forward_backward = forward_backward
        self._accept = partial(
            accept, max_regions=max_regions, scale_distance=scale_distance, min_distance=min_distance
        )
        self._follow = partial(
            cv2.calcOpticalFlowPyrLK,
            winSize=(window, window),
            maxLevel=levels,
            criteria=(cv2.TERM_CRITERIA_COUNT + cv2.TERM_CRITERIA_EPS, iterations, epsilon),
            minEigThreshold=min_eigenvalue,
        )
        self._image: NDArray[np.uint8] | None = None
        self._regions = np.zeros((0, 4), np.float32)
        self.ages = np.zeros(0, np.int64)

    def step(self, frame: NDArray[np.uint8], found: FloatArray) -> FloatArray:
        """Track the regions into the next frame, and fill free slots with new regions.

        `frame` is (H, W, 3) uint8 BGR, and its size must be the same throughout a sequence. `found`, (n, 4)
        float32, contains the salient regions of the frame, sorted by decreasing strength. Its columns are x,
        y (in frame pixels), scale and strength.

        Returns an (m, 4) float32 array with the same columns, where m <= `max_regions`. Tracked regions come
        first, starting with the longest tracked. New regions follow, starting with the strongest.
        """
        image = reduced_grey(frame, self.width)
        size = np.array(frame.shape[1::-1])
        if self._image is not None and len(self._regions):
            self._move(self._image, image, size)
        candidates = np.concatenate([self._regions, np.asarray(found, np.float32).reshape(-1, 4)])
        ages = np.concatenate([self.ages, np.zeros(len(found), np.int64)])
        accepted = self._accept(candidates[:, :3], int(size[0]))
        self._image, self._regions, self.ages = image, candidates[accepted], ages[accepted]
        return self._regions.copy()

    def _move(self, last: NDArray[np.uint8], image: NDArray[np.uint8], size: NDArray[np.int64]) -> None:
        """Move the regions, and drop those that are lost or have left the image."""
        # Pixels are areas, so scale the positions of their centres, not of their corners.
        factor = np.array(image.shape[::-1]) / size
        points = ((self._regions[:, :2] + 0.5) * factor - 0.5).astype(np.float32)
        moved, seen = self._flow(last, image, points)
        back, seen_back = self._flow(image, last, moved)
        apart = np.linalg.norm(back - points, axis=1)
        places = (moved + 0.5) / factor - 0.5
        inside = ((places >= 0) & (places <= size - 1)).all(axis=1)
        kept = seen & seen_back & (apart <= self.forward_backward) & inside
        self._regions = self._regions[kept]
        self._regions[:, :2] = places[kept]
        self.ages = self.ages[kept] + 1

    def _flow(
        self, first: NDArray[np.uint8], second: NDArray[np.uint8], points: FloatArray
    ) -> tuple[FloatArray, NDArray[np.bool_]]:
        """Find (n, 2) points of one image in another; return their positions and whether they were found."""
        moved, status, _ = self._follow(first, second, points[:, None], np.empty_like(points[:, None]))
        return np.asarray(moved, np.float32).reshape(-1, 2), np.asarray(status).reshape(-1) == 1
