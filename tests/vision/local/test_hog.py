import cv2
import numpy as np
import pytest
from makers import maps, regions

from placecat.vision.local.hog import INTERPOLATIONS, describe
from placecat.vision.patches import cut


@pytest.mark.parametrize("width", [96, 320, 641, 1280])
@pytest.mark.parametrize("interpolation", ["linear", "cubic"])
@pytest.mark.parametrize("count", [1, 13, 14, 25])
def test_equals_opencv_on_each_patch(width: int, interpolation: str, count: int) -> None:
    height = width * 9 // 16
    made, chosen = maps(width, height), regions(width, height, count)
    hog = cv2.HOGDescriptor(
        _winSize=(64, 64), _blockSize=(64, 64), _blockStride=(32, 32), _cellSize=(16, 16), _nbins=8
    )
    expected = []
    for patch in cut(made.grey, chosen, max(4, round(width / 64))):
        image = np.clip(np.round(patch), 0, 255).astype(np.uint8)
        image = cv2.resize(image, (64, 64), interpolation=INTERPOLATIONS[interpolation])
        expected.append(hog.compute(image).ravel())
    np.testing.assert_array_equal(describe(made, chosen, interpolation=interpolation), expected)


def test_unit_norm_and_range() -> None:
    found = describe(maps(), regions())
    assert found.shape == (25, 128)
    assert found.min() >= 0
    assert found.max() <= 1
    np.testing.assert_allclose(np.linalg.norm(found, axis=1), 1, atol=1e-2)
