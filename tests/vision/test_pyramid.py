import numpy as np
import pytest
import reference_attention as reference
from hypothesis import given, settings
from hypothesis import strategies as st

from number_of_examples import examples
from placecat.errors import PlacecatError
from placecat.vision import pyramid


@pytest.mark.parametrize("shape", [(7, 10), (8, 5), (2, 2), (1, 9), (45, 80)])
def test_reduce_equals_transcription(shape):
    plane = np.random.default_rng(1).uniform(0, 255, shape).astype(np.float32)
    padded = np.pad(plane.astype(float), 2, mode="reflect")
    expected = np.zeros((-(-shape[0] // 2), -(-shape[1] // 2)))
    for y, x in np.ndindex(expected.shape):
        expected[y, x] = reference.KERNEL @ padded[2 * y : 2 * y + 5, 2 * x : 2 * x + 5] @ reference.KERNEL
    reduced = pyramid.reduce(plane)
    assert reduced.dtype == np.float32
    np.testing.assert_allclose(reduced, expected, atol=1e-4)


def test_reduce_of_a_dot_is_the_kernel():
    plane = np.zeros((9, 9), np.float32)
    plane[4, 4] = 256
    assert pyramid.reduce(plane).tolist() == [
        [0, 0, 0, 0, 0],
        [0, 1, 6, 1, 0],
        [0, 6, 36, 6, 0],
        [0, 1, 6, 1, 0],
        [0, 0, 0, 0, 0],
    ]


@pytest.mark.parametrize("shape", [(7, 10), (8, 5), (45, 80), (3, 2), (12, 20)])
def test_laplacian_equals_transcription(shape):
    plane = np.random.default_rng(2).uniform(0, 255, shape).astype(np.float32)
    levels = pyramid.gaussian_pyramid(plane, 3, 4)
    expected = plane - reference.expand(reference.reduce(plane.astype(float)), *shape)
    np.testing.assert_allclose(pyramid.laplacian(levels, 3), expected, atol=1e-4)


def test_gaussian_pyramid_numbers_its_levels():
    levels = pyramid.gaussian_pyramid(np.zeros((11, 20), np.float32), 1, 4)
    assert {s: p.shape for s, p in levels.items()} == {1: (11, 20), 2: (6, 10), 3: (3, 5), 4: (2, 3)}


@given(st.integers(1, 300), st.integers(1, 300), st.integers(0, 6))
@settings(max_examples=examples(50), deadline=None)
def test_level_size_equals_repeated_reduction(width, height, level):
    plane = np.zeros((height, width), np.float32)
    assert pyramid.gaussian_pyramid(plane, 0, level)[level].shape[::-1] == pyramid.level_size(
        width, height, level
    )


def test_check_scales_names_size_and_scales():
    with pytest.raises(PlacecatError, match=r"24x32 pixels .* \(2, 3, 4, 5\).* 33 pixels"):
        pyramid.check_scales((2, 3, 4, 5), 24, 32)
    pyramid.check_scales((2, 3, 4, 5), 33, 33)
    pyramid.check_scales((1, 3), 9, 9)
