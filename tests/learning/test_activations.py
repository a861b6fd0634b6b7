import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from placecat.errors import PlacecatError
from placecat.learning import activations as module
from placecat.learning.activations import activations, cell_codewords, region_codewords, region_mask
from placecat.learning.hierarchical_kmeans import HierarchicalKMeans


@given(st.lists(st.lists(st.integers(0, 8), max_size=5), max_size=12))
@settings(max_examples=60, deadline=None)
def test_padded_and_flat_against_a_loop(frames):
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
    flat = np.array([word for words in frames for word in words], int)
    np.testing.assert_array_equal(activations(flat, 9, offsets=np.r_[0, counts.cumsum()]), expected)


@pytest.mark.parametrize(
    ("codewords", "arguments", "message"),
    [
        ([[0, 3]], {"counts": [2]}, r"\[0, 3\], outside \[0, 3\)"),
        ([[0, -1]], {"counts": [2]}, "outside"),
        ([[0, 1]], {"counts": [3]}, r"counts\[0\]=3 does not fit the 2"),
        ([[0, 1]], {"counts": [-1]}, r"counts\[0\]=-1"),
        ([[0, 1]], {"counts": [1.5]}, "whole number"),
        ([[0, 1]], {"counts": [1, 1]}, "shape"),
        ([0, 1], {"offsets": [0, 1]}, "rise from 0 to the number of codewords, 2"),
        ([0, 1], {"offsets": [0, 2, 1, 2]}, "rise"),
        ([0, 1], {}, "either"),
        ([[0, 1]], {"counts": [1], "offsets": [0]}, "either"),
    ],
)
def test_wrong_input(codewords, arguments, message):
    with pytest.raises(PlacecatError, match=message):
        activations(codewords, 3, **arguments)


def test_region_mask():
    assert region_mask(np.array([0, 2], np.uint8), 2).tolist() == [[False, False], [True, True]]


def test_region_codewords(monkeypatch):
    rng = np.random.default_rng(0)
    X = rng.normal(size=(20, 4, 3)).astype(np.float32)
    counts = rng.integers(0, 5, 20)
    X[np.arange(4) >= counts[:, None]] = np.nan
    codebook = HierarchicalKMeans(max_clusters=31).fit(X[np.arange(4) < counts[:, None]])
    monkeypatch.setattr(module, "_BLOCK", 3 * X[:1].nbytes)
    found = region_codewords(codebook, X, counts, 16)
    assert found.dtype == np.int32
    for frame, count in enumerate(counts):
        assert found[frame, count:].tolist() == [-1] * (4 - count)
        np.testing.assert_array_equal(found[frame, :count], codebook.assign(X[frame, :count], 16))
    with pytest.raises(PlacecatError, match="are needed"):
        region_codewords(codebook, X[0], counts, 16)


def test_cell_codewords():
    X = np.random.default_rng(1).normal(size=(400, 3, 4)).astype(np.float32)
    codebooks = [HierarchicalKMeans(max_clusters=31, seed=cell).fit(X[:, cell]) for cell in range(3)]
    found = cell_codewords(codebooks, X, 31)
    assert found.shape == (400, 3)
    for cell in range(3):
        np.testing.assert_array_equal(found[:, cell], codebooks[cell].assign(X[:, cell], 31))
    with pytest.raises(PlacecatError, match="2 codebooks"):
        cell_codewords(codebooks[:2], X, 31)
