import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from number_of_examples import examples
from placecat.errors import PlacecatError
from placecat.learning.activations import activations, region_mask


@given(st.lists(st.lists(st.integers(0, 8), max_size=5), max_size=12))
@settings(max_examples=examples(60), deadline=None)
def test_padded_against_a_loop(frames):
    expected = np.zeros((len(frames), 9), int)
    padded = np.full((len(frames), 5), 77)
    for number, words in enumerate(frames):
        padded[number, : len(words)] = words
        for word in words:
            expected[number, word] = 1
    counts = np.array([len(words) for words in frames], int)
    found = activations(padded, 9, counts=counts)
    assert found.dtype == np.uint8
    np.testing.assert_array_equal(found, expected)


@pytest.mark.parametrize(
    ("codewords", "arguments", "message"),
    [
        ([[0, 3]], {"counts": [2]}, r"from 0 to 3, not within \[0, 3\)"),
        ([[0, -1]], {"counts": [2]}, "from -1 to 0, not within"),
        ([[0, 1]], {"counts": [3]}, r"counts\[0\]=3 is invalid: a frame has 0 to 2 regions"),
        ([[0, 1]], {"counts": [-1]}, r"counts\[0\]=-1"),
        ([[0, 1]], {"counts": [1.5]}, "whole number"),
        ([[0, 1]], {"counts": [1, 1]}, "shape"),
    ],
)
def test_wrong_input(codewords, arguments, message):
    with pytest.raises(PlacecatError, match=message):
        activations(np.array(codewords), 3, **arguments)


def test_region_mask():
    assert region_mask(np.array([0, 2], np.uint8), 2).tolist() == [[False, False], [True, True]]
