import numpy as np
import pytest
from makers import SCALES, frame, maps

from placecat.vision.holistic.gist import describe


def cell_mean(image: np.ndarray, row: int, column: int) -> float:
    """Average a cell whose borders cut pixels, after enlarging the image by 4 so that they do not."""
    big = np.repeat(np.repeat(image.astype(float), 4, axis=0), 4, axis=1)
    height, width = image.shape
    return float(big[row * height : (row + 1) * height, column * width : (column + 1) * width].mean())


@pytest.mark.parametrize("shape", [(320, 240), (330, 217)])
def test_equals_loops_over_cells(shape: tuple[int, int]) -> None:
    made = maps(*shape)
    expected = []
    for row in range(4):
        for column in range(4):
            planes = [
                made.intensity_contrast[s][r, sub] for sub in range(2) for s in SCALES for r in range(2)
            ]
            planes += [made.color_contrast[s][r, sub] for sub in range(4) for s in SCALES for r in range(2)]
            planes += [made.orientation[s][sub] for sub in range(4) for s in SCALES]
            assert len(planes) == 64
            expected += [cell_mean(plane, row, column) for plane in planes]
    np.testing.assert_allclose(describe(frame(*shape), made), expected, rtol=1e-4)


def test_raw_pyramids() -> None:
    made = maps()
    expected = []
    for row in range(4):
        for column in range(4):
            planes = [made.grey[s] for s in SCALES]
            planes += [made.color[s][sub] for sub in range(4) for s in SCALES]
            planes += [made.orientation[s][sub] for sub in range(4) for s in SCALES]
            expected += [cell_mean(plane, row, column) for plane in planes]
    found = describe(frame(), made, center_surround=False)
    np.testing.assert_allclose(found, expected, rtol=1e-3, atol=1e-4)


@pytest.mark.parametrize("center_surround", [True, False])
def test_without_color_is_a_part(center_surround: bool) -> None:
    made = maps()
    full = describe(frame(), made, center_surround=center_surround).reshape(16, -1)
    less = describe(frame(), made, center_surround=center_surround, color=False)
    assert less.shape == (512 if center_surround else 16 * 4 * 5,)
    lead = 16 if center_surround else 4
    np.testing.assert_array_equal(less.reshape(16, -1), np.hstack([full[:, :lead], full[:, -16:]]))


def test_a_cell_is_one_block() -> None:
    made = maps()
    for levels in (made.intensity_contrast, made.color_contrast, made.orientation):
        for level in levels.values():
            level[...] = 0
            height, width = level.shape[-2:]
            level[..., : -(-height // 4), width // 2 : -(-3 * width // 4)] = 1
    blocks = describe(frame(), made).reshape(16, 64)
    assert (blocks[2] > 0.9).all()
    assert (blocks[[0, 5, 8, 12, 15]] == 0).all()
