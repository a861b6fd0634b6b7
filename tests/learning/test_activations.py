import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from number_of_examples import examples
from placecat.learning.activations import activations


@given(st.lists(st.lists(st.integers(0, 8), max_size=5), max_size=12))
@settings(max_examples=examples(60), deadline=None)
def test_padded_against_a_loop(frames):
    expected = np.zeros((len(frames), 9), int)
    padded = np.full((len(frames), 5), -1)
    for number, words in enumerate(frames):
        padded[number, : len(words)] = words
        for word in words:
            expected[number, word] = 1
    found = activations(padded, 9)
    assert found.dtype == np.uint8
    np.testing.assert_array_equal(found, expected)
