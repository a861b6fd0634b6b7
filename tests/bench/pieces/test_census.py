import numpy as np
import pytest

from placecat_bench.pieces import census

# With few grey levels, neighbours are often equal.
IMAGE = np.random.default_rng(0).integers(0, 6, (23, 31)).astype(np.uint8)


def naive(image, cells):
    """Return the shares of nearest-neighbour codes. A bit is set if the neighbour is >= the centre."""
    height, width = (length - 2 for length in image.shape)
    counts = np.zeros((cells, cells, 16))
    for y in range(height):
        for x in range(width):
            centre = image[y + 1, x + 1]
            around = (image[y + 1, x + 2], image[y, x + 1], image[y + 1, x], image[y + 2, x + 1])
            code = sum(int(value >= centre) << place for place, value in enumerate(around))
            row = next(r for r in range(cells) if y < (r + 1) * height // cells)
            column = next(c for c in range(cells) if x < (c + 1) * width // cells)
            counts[row, column, code] += 1
    return (counts / counts.sum(axis=2, keepdims=True)).reshape(-1, 16)


def test_codes_of_nearest_neighbours_match_a_naive_loop():
    found = census.of_straight(census.ours(255 - IMAGE, 2), census.OUR_STRAIGHT)
    np.testing.assert_allclose(found, naive(IMAGE, 2), atol=1e-6)


def test_scikit_image_matches_a_naive_loop():
    pytest.importorskip("skimage", reason="the peer is in the extra bench")
    found = census.of_straight(census.theirs(IMAGE, 2), census.THEIR_STRAIGHT)
    np.testing.assert_allclose(found, naive(IMAGE, 2))
    assert census.largest_difference(IMAGE, 2) < 1e-6


def test_entries_and_targets():
    timed, other, limit = census.entries(images=[IMAGE], cells=2)
    assert [(entry.input, entry.target) for entry in (timed, other, limit)] == [
        ("31x23, 2x2 cells", "at least 40x faster"),
        ("31x23, 2x2 cells", "at least 20x faster"),
        ("31x23, 2x2 cells", "at most 1e-06"),
    ]
    assert timed.ours()[0].shape == (4, 256)
    for part in timed.parts.values():
        part()


def test_a_difference_is_detected(monkeypatch):
    monkeypatch.setattr(census, "theirs", lambda image, cells: np.eye(4, 256))
    assert census.largest_difference(IMAGE, 2) > 0.5


def test_reduced_frames_are_small_grey_images(monkeypatch):
    color = np.random.default_rng(1).integers(0, 256, (36, 64, 3)).astype(np.uint8)
    monkeypatch.setattr(census, "prepared", lambda: (None, [color]))
    (image,) = census.reduced_frames()
    assert image.shape == (180, 320)
    assert image.dtype == np.uint8


def test_mahotas_counts_rotated_patterns_in_the_same_cells():
    pytest.importorskip("mahotas", reason="the peer is in the extra bench")
    assert census.by_mahotas(IMAGE, 2).shape == (4, 36)
