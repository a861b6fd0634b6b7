import cv2
import numpy as np
import pytest
from makers import frame, maps

from placecat.vision.holistic.centrist import describe


def naive(image: np.ndarray) -> np.ndarray:
    height, width = image.shape[0] - 2, image.shape[1] - 2
    counts = np.zeros((4, 4, 256))
    for y in range(height):
        for x in range(width):
            code = 0
            for dy, dx in ((-1, -1), (-1, 0), (-1, 1), (0, -1), (0, 1), (1, -1), (1, 0), (1, 1)):
                code = 2 * code + int(image[y + 1, x + 1] >= image[y + 1 + dy, x + 1 + dx])
            row = next(r for r in range(4) if y < (r + 1) * height // 4)
            column = next(c for c in range(4) if x < (c + 1) * width // 4)
            counts[row, column, code] += 1
    return (counts / counts.sum(axis=2, keepdims=True)).ravel()


@pytest.mark.parametrize("image", ["laplacian", "intensity"])
@pytest.mark.parametrize("shape", [(62, 46), (71, 53)])
def test_full_size_equals_a_naive_loop(image: str, shape: tuple[int, int]) -> None:
    picture = frame(*shape)
    grey = cv2.cvtColor(picture, cv2.COLOR_BGR2GRAY)
    if image == "laplacian":
        around = np.pad(grey.astype(int), 1, mode="reflect")
        grey = (
            around[:-2, 1:-1]
            + around[2:, 1:-1]
            + around[1:-1, :-2]
            + around[1:-1, 2:]
            - 4 * around[1:-1, 1:-1]
        )
    found = describe(picture, maps(), width=None, image=image)
    np.testing.assert_allclose(found, naive(grey), atol=1e-6)


def test_reduced_to_width() -> None:
    picture = frame(640, 360)
    small = cv2.resize(cv2.cvtColor(picture, cv2.COLOR_BGR2GRAY), (320, 180), interpolation=cv2.INTER_AREA)
    grey_frame = np.repeat(small[:, :, None], 3, axis=2)
    np.testing.assert_array_equal(describe(picture, maps()), describe(grey_frame, maps(), width=None))
    assert (describe(picture, maps()) != describe(picture, maps(), width=None)).any()


def test_narrow_frame_is_unchanged() -> None:
    picture = frame(200, 150)
    np.testing.assert_array_equal(describe(picture, maps()), describe(picture, maps(), width=None))


def test_each_cell_has_sum_one() -> None:
    np.testing.assert_allclose(describe(frame(), maps()).reshape(16, 256).sum(axis=1), 1, rtol=1e-5)


@pytest.mark.parametrize("image", ["laplacian", "intensity"])
def test_unchanged_by_an_added_constant(image: str) -> None:
    dark = np.repeat(frame()[:, :, :1] // 2, 3, axis=2)
    np.testing.assert_array_equal(
        describe(dark, maps(), width=None, image=image), describe(dark + 100, maps(), width=None, image=image)
    )
