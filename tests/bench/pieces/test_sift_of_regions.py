import cv2
import numpy as np
import pytest
from makers import frame

from placecat.vision.patches import region_side
from placecat_bench.frames import with_regions
from placecat_bench.pieces import sift_of_regions


def test_entry_and_target():
    entry, other = sift_of_regions.entries(frames=[frame(), frame(seed=3)], count=7)
    assert (entry.input, entry.target) == ("7 regions of 320x240", "at least 4x faster")
    assert (other.input, other.target) == ("7 regions of 320x240", "at least 2x faster")
    for ours, theirs in zip(entry.ours(), entry.theirs(), strict=True):
        assert ours.shape == theirs.shape == (7, 128)
    for part in entry.parts.values():
        assert len(part()) == 2


def test_opencv_describes_the_same_squares():
    ((maps, regions),) = with_regions([frame(1280, 960)], 25)
    # Regions near the border differ, because OpenCV leaves out the part beyond the border.
    margin = 1.5 * region_side(1280) * 2 ** regions[:, 2]
    inside = (regions[:, :2] >= margin[:, None]).all(axis=1) & (regions[:, 0] < 1280 - margin)
    regions = regions[inside & (regions[:, 1] < 960 - margin)]
    regions = regions[np.argsort(regions[:, 2], kind="stable")]
    assert len(regions) > 4
    (ours,) = sift_of_regions.ours([(maps, regions)])
    # Almost without blur, since our code does not blur. By default, there are 3 octave layers.
    sharp = cv2.SIFT.create(sigma=0.5)
    points = sift_of_regions.keypoints(maps, regions)
    theirs = np.concatenate([sharp.compute(level, some)[1] for level, some in points])
    similarity = (ours * theirs).sum(1) / np.linalg.norm(ours, axis=1) / np.linalg.norm(theirs, axis=1)
    assert similarity.min() > 0.99


def test_kornia_describes_the_same_patches():
    pytest.importorskip("kornia", reason="without the extra bench-torch")
    _, other = sift_of_regions.entries(frames=[frame()], count=7)
    (ours,), (theirs,) = other.ours(), other.theirs()
    assert ours.shape == theirs.shape
