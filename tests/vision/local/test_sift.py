import dataclasses

import cv2
import numpy as np
import pytest
from makers import SCALES, maps, regions

from placecat.vision.local.sift import _gradients, describe, dominant_angles
from placecat.vision.maps import FrameMaps
from placecat.vision.patches import cut, to_bytes


def whole_levels(width: int, height: int) -> FrameMaps:
    """Return maps with whole grey levels, so that OpenCV gets the same image."""
    made = maps(width, height)
    return dataclasses.replace(made, grey={s: to_bytes(g).astype(np.float32) for s, g in made.grey.items()})


def inner_regions(width: int, height: int) -> np.ndarray:
    """Return regions whose support lies inside the image, because OpenCV has no gradients outside."""
    chosen = regions(width, height, 60)
    reach = (1.8 * width / 128 * 2 ** chosen[:, 2:3] + 2 * 2 ** chosen[:, 2:3])[:, 0]
    inside = (chosen[:, 0] > reach) & (chosen[:, 0] < width - reach)
    inside &= (chosen[:, 1] > reach) & (chosen[:, 1] < height - reach)
    return chosen[inside]


def opencv(made: FrameMaps, chosen: np.ndarray, side: int, angles: np.ndarray) -> np.ndarray:
    """Return OpenCV's descriptors on the pyramid levels, with little blur (sigma) and cells of side / 4."""
    sift = cv2.SIFT_create(sigma=0.5)
    rows = []
    for (x, y, scale, _), angle in zip(chosen.tolist(), angles, strict=True):
        level = made.grey[int(scale)].astype(np.uint8)
        centre = (np.floor(x / 2**scale + 0.5), np.floor(y / 2**scale + 0.5))
        point = cv2.KeyPoint(*map(float, centre), side / 6, float(-np.degrees(angle) % 360), 1, 0)
        rows.append(sift.compute(level, [point])[1][0])
    return np.array(rows)


@pytest.mark.parametrize(("width", "side"), [(640, 10), (1280, 20), (1152, 18)])
@pytest.mark.parametrize("orientation", ["upright", "dominant"])
def test_close_to_opencv(width: int, side: int, orientation: str) -> None:
    made, chosen = whole_levels(width, width), inner_regions(width, width)
    assert len(chosen) > 10
    angles = np.zeros(len(chosen))
    if orientation == "dominant":
        margin = round(2.5 * np.sqrt(2) * side / 4)
        gradients = _gradients(cut(made.grey, chosen, 2 * margin + 3))
        angles = dominant_angles(*gradients, side / 12)
        assert np.ptp(angles) > 1
    found = describe(made, chosen, orientation=orientation)
    expected = opencv(made, chosen, side, angles)
    # OpenCV blurs slightly (sigma is at least 0.1) and rounds exponentials, so values differ by a few units
    # of 512.
    similarity = (found * expected).sum(1) / np.linalg.norm(found, axis=1) / np.linalg.norm(expected, axis=1)
    assert similarity.min() > 0.9995
    assert np.abs(found - expected).max() <= 6
    assert np.abs(found - expected).mean() < 0.6


def naive_upright(image: np.ndarray, row: int, column: int, side: int) -> np.ndarray:
    cell = side / 4
    histogram = np.zeros((4, 4, 8))
    reach = int(3 * cell)
    for dy in range(-reach, reach + 1):
        for dx in range(-reach, reach + 1):
            y, x = row + dy, column + dx
            right = image[y, x + 1] - image[y, x - 1]
            up = image[y - 1, x] - image[y + 1, x]
            vote = np.hypot(right, up) * np.exp(-(dy**2 + dx**2) / (2 * (side / 2) ** 2))
            bin_ = np.arctan2(up, right) / (2 * np.pi) * 8
            for r in range(4):
                for c in range(4):
                    share = max(0, 1 - abs(dy / cell + 1.5 - r)) * max(0, 1 - abs(dx / cell + 1.5 - c))
                    for b in range(8):
                        apart = abs((bin_ - b + 4) % 8 - 4)
                        histogram[r, c, b] += vote * share * max(0, 1 - apart)
    flat = histogram.ravel()
    flat = np.minimum(flat, 0.2 * np.linalg.norm(flat))
    return np.minimum(flat / np.linalg.norm(flat) * 512, 255)


def test_upright_equals_a_naive_loop() -> None:
    made = maps(640, 640)
    chosen = np.array([[320, 300, 2, 1], [288, 344, 3, 1]], np.float32)
    found = describe(made, chosen)
    for row, (x, y, scale, _) in zip(found, chosen.astype(int).tolist(), strict=True):
        expected = naive_upright(made.grey[scale].astype(float), y >> scale, x >> scale, 10)
        # OpenCV's angles are accurate to 0.3 degrees.
        np.testing.assert_allclose(row, expected, atol=1.5)


def test_dominant_angle_of_a_ramp() -> None:
    for angle in (0.0, 0.5, 2.0, 4.0, 6.1):
        magnitude = np.ones((1, 15, 15), np.float32)
        found = dominant_angles(magnitude, np.full((1, 15, 15), angle, np.float32), 1.67)
        assert abs((found[0] - angle + np.pi) % (2 * np.pi) - np.pi) < np.radians(5)


def test_dominant_angle_is_the_strongest() -> None:
    angle = np.full((1, 9, 9), np.pi / 2, np.float32)
    angle[0, :4] = np.pi
    magnitude = np.where(angle > 2, 1, 5).astype(np.float32)
    np.testing.assert_allclose(dominant_angles(magnitude, angle, 1.0), np.pi / 2, atol=1e-6)
    np.testing.assert_array_equal(dominant_angles(np.zeros_like(magnitude), angle, 1.0), 0)


def test_dominant_angle_between_two_bins() -> None:
    angle, magnitude = np.zeros((2, 1, 9, 9), np.float32)
    angle[0, 4, 3], magnitude[0, 4, 3] = np.radians(50), 1
    angle[0, 4, 5], magnitude[0, 4, 5] = np.radians(60), 0.6
    # Smoothing with 1 4 6 4 1 yields 0.2875, 0.525 and 0.475 at 40, 50 and 60 degrees, so the peak lies 0.326
    # bins after 50 degrees.
    np.testing.assert_allclose(np.degrees(dominant_angles(magnitude, angle, 1.0)), 53.2609, atol=1e-3)


def test_dominant_follows_a_quarter_turn() -> None:
    made = maps(640, 640)
    size_of = {s: made.grey[s].shape[0] for s in SCALES}
    turned = dataclasses.replace(
        made, grey={s: np.ascontiguousarray(np.rot90(g)) for s, g in made.grey.items()}
    )
    chosen = inner_regions(640, 640)
    chosen[:, :2] = np.round(chosen[:, :2] / 2 ** chosen[:, 2:3]) * 2 ** chosen[:, 2:3]
    moved = chosen.copy()
    moved[:, 0] = chosen[:, 1]
    last = np.array([size_of[int(s)] - 1 for s in chosen[:, 2]])
    moved[:, 1] = last * 2 ** chosen[:, 2] - chosen[:, 0]
    same = describe(made, chosen, orientation="dominant") - describe(turned, moved, orientation="dominant")
    assert np.abs(same).max() <= 6
    upright = describe(made, chosen) - describe(turned, moved)
    assert np.abs(upright).mean() > 10


def test_unchanged_by_brightness_and_contrast() -> None:
    made = maps()
    other = dataclasses.replace(made, grey={s: 20 + g / 2 for s, g in made.grey.items()})
    np.testing.assert_allclose(describe(made, regions()), describe(other, regions()), atol=1)


def test_whole_numbers_in_range() -> None:
    found = describe(maps(), regions())
    assert found.shape == (25, 128)
    np.testing.assert_array_equal(found, np.round(found))
    assert found.min() >= 0
    assert found.max() <= 255
