from types import ModuleType

import numpy as np
import pytest
from makers import maps, regions

from placecat.vision.local import color_mv, orientation_mv
from placecat.vision.patches import cut

BOTH = pytest.mark.parametrize(("module", "field"), [(orientation_mv, "orientation"), (color_mv, "color")])


@BOTH
def test_equals_numpy_where_cells_are_whole_pixels(module: ModuleType, field: str) -> None:
    width = 768
    made, chosen = maps(width, width), regions(width, width, 6)
    found = module.describe(made, chosen)
    for row, patch in zip(found, cut(getattr(made, field), chosen, 12).astype(float), strict=True):
        areas = [patch]
        areas += [patch[:, 4 * r : 4 * r + 4, 4 * c : 4 * c + 4] for r in range(3) for c in range(3)]
        expected = [v for area in areas for v in (*area.mean(axis=(1, 2)), *area.var(axis=(1, 2)))]
        np.testing.assert_allclose(row, expected, rtol=1e-5, atol=1e-6)


@BOTH
@pytest.mark.parametrize(("grid", "length"), [(0, 8), (1, 16), (2, 40), (3, 80)])
def test_short_variant_is_the_start_of_the_long(
    module: ModuleType, field: str, grid: int, length: int
) -> None:
    found = module.describe(maps(), regions(), grid=grid)
    assert found.shape == (25, length)
    np.testing.assert_array_equal(found[:, :8], module.describe(maps(), regions())[:, :8])


@BOTH
@pytest.mark.parametrize("width", [96, 320, 1280])
def test_variances_are_not_negative(module: ModuleType, field: str, width: int) -> None:
    found = module.describe(maps(width, width), regions(width, width)).reshape(25, 10, 2, 4)
    assert (found[:, :, 1] >= 0).all()


@BOTH
def test_whole_mean_is_the_mean_of_the_cells(module: ModuleType, field: str) -> None:
    found = module.describe(maps(), regions()).reshape(25, 10, 2, 4)
    np.testing.assert_allclose(found[:, 1:, 0].mean(axis=1), found[:, 0, 0], rtol=1e-4, atol=1e-5)
