import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from placecat.vision.patches import cut, region_side, to_bytes


def region(x: float, y: float, scale: float = 0) -> np.ndarray:
    return np.array([[x, y, scale, 1]], np.float32)


LEVEL = np.arange(20, dtype=np.float32).reshape(4, 5)


@pytest.mark.parametrize(("width", "side"), [(1280, 20), (640, 10), (320, 5), (100, 4), (4096, 64)])
def test_side_is_the_diameter(width: int, side: int) -> None:
    assert region_side(width) == side


def test_odd_side_is_centred_on_the_pixel() -> None:
    np.testing.assert_array_equal(cut({0: LEVEL}, region(2, 1), 3)[0], [[1, 2, 3], [6, 7, 8], [11, 12, 13]])


def test_even_side_is_centred_on_the_corner() -> None:
    np.testing.assert_array_equal(cut({0: LEVEL}, region(2.5, 1.5), 2)[0], [[7, 8], [12, 13]])


def test_position_is_halved_with_each_level() -> None:
    np.testing.assert_array_equal(cut({2: LEVEL}, region(8, 4, 2), 1)[0], [[7]])


def test_replicated_border() -> None:
    np.testing.assert_array_equal(cut({0: LEVEL}, region(0, 0), 3)[0], [[0, 0, 1], [0, 0, 1], [5, 5, 6]])


def test_reflected_border() -> None:
    found = cut({0: LEVEL}, region(4, 3), 3, border="reflect")[0]
    np.testing.assert_array_equal(found, [[13, 14, 13], [18, 19, 18], [13, 14, 13]])


@given(
    x=st.floats(0, 30),
    y=st.floats(0, 20),
    scale=st.sampled_from([0, 1]),
    side=st.integers(1, 40),
    border=st.sampled_from([("replicate", "edge"), ("reflect", "reflect")]),
)
def test_equals_a_padded_slice(x: float, y: float, scale: int, side: int, border: tuple[str, str]) -> None:
    rng = np.random.default_rng(3)
    levels = {0: rng.random((2, 21, 31), np.float32), 1: rng.random((2, 11, 16), np.float32)}
    rows = np.concatenate([region(x, y, scale), region(5, 5, 0)])
    pad = 60
    padded = np.pad(levels[scale], ((0, 0), (pad, pad), (pad, pad)), mode=border[1])
    left, top = (int(np.floor(float(np.float32(c)) / 2**scale - (side - 1) / 2 + 0.5)) + pad for c in (x, y))
    found = cut(levels, rows, side, border=border[0])
    assert found.shape == (2, 2, side, side)
    np.testing.assert_array_equal(found[0], padded[:, top : top + side, left : left + side])


def test_order_of_regions_is_kept() -> None:
    rows = np.concatenate([region(4, 0, 1), region(1, 1, 0), region(0, 0, 1), region(2, 2, 0)])
    found = cut({0: LEVEL, 1: LEVEL + 100}, rows, 1).ravel()
    np.testing.assert_array_equal(found, [102, 6, 100, 12])


def test_no_regions() -> None:
    assert cut({0: LEVEL}, np.zeros((0, 4), np.float32), 3).shape == (0, 3, 3)


def test_to_bytes_rounds_and_clips() -> None:
    found = to_bytes(np.array([-3, 0.4, 0.6, 254.6, 300], np.float32))
    np.testing.assert_array_equal(found, np.array([0, 0, 1, 255, 255], np.uint8))
    assert found.dtype == np.uint8
