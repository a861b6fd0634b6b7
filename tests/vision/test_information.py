import dataclasses

import numpy as np
import pytest
from makers import maps

from placecat.errors import PlacecatError
from placecat.vision.information import information


def test_flat_image_has_none() -> None:
    made = maps(200, 136)
    flat = dataclasses.replace(made, grey={s: np.full_like(g, 90) for s, g in made.grey.items()})
    assert information(flat) == pytest.approx(0, abs=1e-6)


@pytest.mark.parametrize("size", [(320, 240), (333, 217), (66, 50)])
def test_black_last_level_leaves_the_mean(size: tuple[int, int]) -> None:
    made = maps(*size)
    grey = dict(made.grey)
    grey[5] = np.zeros_like(grey[5])
    found = information(dataclasses.replace(made, grey=grey))
    assert found == pytest.approx(float(grey[2].mean()) * 3 / 256, rel=1e-5)
    assert information(dataclasses.replace(made, grey=grey), unit=255) == pytest.approx(
        float(grey[2].mean()) / 255, rel=1e-5
    )


def test_checkerboard_over_flat() -> None:
    made = maps(256, 256)
    grey = {s: np.full_like(g, 100) for s, g in made.grey.items()}
    grey[2] = grey[2] + np.where(np.indices(grey[2].shape).sum(0) % 2, 10, -10).astype(np.float32)
    assert information(dataclasses.replace(made, grey=grey), unit=100) == pytest.approx(0.1, rel=1e-4)


def test_brightness_does_not_count() -> None:
    made = maps()
    brighter = dataclasses.replace(made, grey={s: g + 40 for s, g in made.grey.items()})
    assert information(brighter) == pytest.approx(information(made), rel=1e-4)


def test_refusals() -> None:
    with pytest.raises(PlacecatError, match="two of the levels 2, 3, 4, 5 in ascending order, not 1 and 5"):
        information(maps(), fine=1)
    with pytest.raises(PlacecatError, match="not 4 and 3"):
        information(maps(), fine=4, coarse=3)
