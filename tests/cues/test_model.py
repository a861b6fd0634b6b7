import numpy as np

from placecat.cues.descriptors import Descriptors
from placecat.cues.one_against_all import product_of_rows


def test_regions_multiply_and_a_frame_without_regions_is_uniform():
    proba = np.array([[0.5, 0.5], [0.9, 0.1], [0.2, 0.8], [0.6, 0.4]])
    frames = np.array([0, 0, 2, 2])
    result = product_of_rows(np.log(proba), frames, 3)
    expected = np.array([[0.45, 0.05], [1.0, 1.0], [0.12, 0.32]])
    np.testing.assert_allclose(result, expected / expected.sum(axis=1, keepdims=True))


def test_many_regions_do_not_underflow():
    result = product_of_rows(np.tile(np.log([[1e-30, 1e-31]]), (50, 1)), np.zeros(50, int), 1)
    np.testing.assert_allclose(result, [[1.0, 1e-50]])


def test_rows_skip_padding_and_have_a_frame_index():
    x = np.arange(12, dtype=np.float32).reshape(2, 3, 2)
    sets = Descriptors(x, np.array([1, 2]))
    assert sets.rows().tolist() == [[0, 1], [6, 7], [8, 9]]
    assert sets.frame_of_row().tolist() == [0, 1, 1]
    assert len(sets) == 2
    whole = Descriptors(x[:, 0])
    assert whole.rows() is whole.x
    assert whole.frame_of_row().tolist() == [0, 1]
