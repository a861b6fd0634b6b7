import dataclasses

import numpy as np
import pytest
from makers import maps, regions

from placecat.vision.census import LAPLACIANS
from placecat.vision.local.centrist import describe
from placecat.vision.patches import cut


def naive(patch: np.ndarray) -> np.ndarray:
    height, width = patch.shape
    counts = np.zeros(256)
    for y in range(1, height - 1):
        for x in range(1, width - 1):
            code = 0
            for dy, dx in ((-1, -1), (-1, 0), (-1, 1), (0, -1), (0, 1), (1, -1), (1, 0), (1, 1)):
                code = 2 * code + int(patch[y, x] >= patch[y + dy, x + dx])
            counts[code] += 1
    return counts / counts.sum()


@pytest.mark.parametrize("width", [200, 640])
@pytest.mark.parametrize("quantise", [True, False])
def test_intensity_equals_a_naive_loop(width: int, quantise: bool) -> None:
    made, chosen = maps(width, width), regions(width, width, 8)
    patches = cut(made.grey, chosen, max(4, round(width / 64)))
    expected = [naive(np.round(patch) if quantise else patch) for patch in patches]
    np.testing.assert_allclose(describe(made, chosen, quantise=quantise), expected, atol=1e-6)


@pytest.mark.parametrize("kernel", list(LAPLACIANS))
def test_laplacian_equals_a_naive_loop(kernel: str) -> None:
    made, chosen = maps(640, 640), regions(640, 640, 8)
    expected = []
    for patch in np.round(cut(made.grey, chosen, 12)).astype(int):
        filtered = np.zeros((10, 10), int)
        for y in range(10):
            for x in range(10):
                filtered[y, x] = (patch[y : y + 3, x : x + 3] * LAPLACIANS[kernel].astype(int)).sum()
        expected.append(naive(filtered))
    np.testing.assert_allclose(describe(made, chosen, image="laplacian", kernel=kernel), expected, atol=1e-6)


def test_rows_sum_to_one() -> None:
    np.testing.assert_allclose(describe(maps(), regions()).sum(axis=1), 1, rtol=1e-6)


@pytest.mark.parametrize("image", ["intensity", "laplacian"])
def test_unchanged_by_an_added_constant(image: str) -> None:
    made = maps()
    low = dataclasses.replace(made, grey={s: np.round(g / 2) for s, g in made.grey.items()})
    high = dataclasses.replace(low, grey={s: g + 100 for s, g in low.grey.items()})
    np.testing.assert_array_equal(
        describe(low, regions(), image=image), describe(high, regions(), image=image)
    )


def test_flat_area_with_noise_is_all_ties() -> None:
    made = maps()
    rng = np.random.default_rng(0)
    noisy = {s: 80 + rng.uniform(-0.3, 0.3, g.shape).astype(np.float32) for s, g in made.grey.items()}
    flat = dataclasses.replace(made, grey=noisy)
    assert (describe(flat, regions())[:, 255] == 1).all()
    assert (describe(flat, regions(), quantise=False)[:, 255] < 1).all()
