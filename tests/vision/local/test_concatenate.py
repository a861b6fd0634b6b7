import numpy as np
import pytest

from placecat.errors import PlacecatError
from placecat.vision.local.concatenate import concatenate

SHAPE = np.array([[2, 4], [6, 8]], np.float32)
Y = np.array([0.25, 1], np.float32)
COLOR = np.array([[10, 20, 30], [40, 50, 60]], np.float32)


def test_order_and_weights() -> None:
    found = concatenate(SHAPE, Y, COLOR, y_weight=2, color_weight=0.5, shape_spread=2, color_spread=10)
    np.testing.assert_allclose(found, [[1, 2, 0.5, 0.5, 1, 1.5], [3, 4, 2, 2, 2.5, 3]])
    assert found.dtype == np.float32


def test_parts_can_be_left_out() -> None:
    np.testing.assert_array_equal(concatenate(SHAPE, None), SHAPE)
    np.testing.assert_array_equal(concatenate(SHAPE, Y), [[2, 4, 0.25], [6, 8, 1]])
    assert concatenate(SHAPE, None, COLOR).shape == (2, 5)
    assert concatenate(SHAPE[:0], Y[:0], COLOR[:0]).shape == (0, 6)


def test_same_influence_at_any_magnitude() -> None:
    small = concatenate(SHAPE, Y, y_weight=3, shape_spread=0.5)
    large = concatenate(SHAPE * 512, Y, y_weight=3, shape_spread=256)
    np.testing.assert_allclose(small, large)


def test_refusals() -> None:
    with pytest.raises(PlacecatError, match="different numbers of regions: 2, 1"):
        concatenate(SHAPE, Y[:1])
    with pytest.raises(PlacecatError, match="y_weight is -1"):
        concatenate(SHAPE, Y, y_weight=-1)
    with pytest.raises(PlacecatError, match="shape_spread is 0"):
        concatenate(SHAPE, Y, shape_spread=0)
    with pytest.raises(PlacecatError, match="color_weight is nan"):
        concatenate(SHAPE, Y, COLOR, color_weight=float("nan"))
