"""Runs over every holistic descriptor that is found; a new one is tested without a new test."""

import numpy as np
import pytest
from makers import frame, maps

from placecat.vision import holistic

EVERY = pytest.mark.parametrize("name", holistic.names())
SIZES = pytest.mark.parametrize("size", [(320, 240), (640, 360), (333, 217), (66, 50)])


@EVERY
@SIZES
def test_shape_type_and_values(name: str, size: tuple[int, int]) -> None:
    module = holistic.load(name)
    found = module.describe(frame(*size), maps(*size))
    assert found.shape == (module.size(),)
    assert found.dtype == np.float32
    assert found.flags.c_contiguous
    assert np.isfinite(found).all()
    assert found.std() > 0


@EVERY
def test_deterministic_and_free_of_side_effects(name: str) -> None:
    image = frame()
    first = holistic.load(name).describe(image, maps())
    np.testing.assert_array_equal(first, holistic.load(name).describe(frame(), maps()))
    np.testing.assert_array_equal(image, frame())


@EVERY
def test_black_frame(name: str) -> None:
    found = holistic.load(name).describe(np.zeros_like(frame()), maps())
    assert np.isfinite(found).all()
