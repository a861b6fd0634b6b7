"""Tests of every local descriptor. A new descriptor needs no new test."""

import dataclasses

import numpy as np
import pytest
from makers import every, maps, regions

from placecat.errors import PlacecatError
from placecat.vision.discovery import load
from placecat.vision.frame import check
from placecat.vision.maps import FIELDS

EVERY = pytest.mark.parametrize("name", every("local"))


def length(name: str) -> int:
    return load("local", name).describe(maps(), regions()).shape[1]


@EVERY
@pytest.mark.parametrize("width", [96, 320, 641, 1280])
def test_shape_type_and_values(name: str, width: int) -> None:
    height = width * 9 // 16
    module = load("local", name)
    found = module.describe(maps(width, height), regions(width, height))
    assert found.shape == (25, length(name))
    assert found.dtype == np.float32
    assert np.isfinite(found).all()
    assert found.std() > 0


@EVERY
def test_patch_of_64_pixels(name: str) -> None:
    found = load("local", name).describe(maps(4096, 2304), regions(4096, 2304, 5))
    assert found.shape == (5, length(name))
    assert np.isfinite(found).all()


@EVERY
def test_deterministic_and_free_of_side_effects(name: str) -> None:
    made, chosen = maps(), regions()
    before = chosen.copy()
    first = load("local", name).describe(made, chosen)
    np.testing.assert_array_equal(first, load("local", name).describe(maps(), regions()))
    np.testing.assert_array_equal(before, chosen)
    for key, level in maps().grey.items():
        np.testing.assert_array_equal(level, made.grey[key])


@EVERY
def test_regions_do_not_influence_each_other(name: str) -> None:
    module, made, chosen = load("local", name), maps(), regions(count=30)
    together = module.describe(made, chosen)
    single = np.concatenate([module.describe(made, chosen[i : i + 1]) for i in range(30)])
    np.testing.assert_allclose(together, single, rtol=1e-5, atol=1e-5)


@EVERY
def test_no_regions(name: str) -> None:
    assert load("local", name).describe(maps(), np.zeros((0, 4), np.float32)).shape == (0, length(name))


@EVERY
def test_flat_image_gives_finite_values(name: str) -> None:
    made = maps()
    flat = dataclasses.replace(
        made,
        grey={s: np.full_like(g, 77) for s, g in made.grey.items()},
        color={s: np.zeros_like(g) for s, g in made.color.items()},
        orientation={s: np.zeros_like(g) for s, g in made.orientation.items()},
    )
    found = load("local", name).describe(flat, regions())
    assert np.isfinite(found).all()
    np.testing.assert_array_equal(found, np.broadcast_to(found[0], found.shape))


@EVERY
def test_reads_the_maps_it_names_only(name: str) -> None:
    module, made, chosen = load("local", name), maps(), regions()
    others = {field: {} for field in FIELDS if field not in module.MAPS}
    bare = dataclasses.replace(made, **others)
    np.testing.assert_array_equal(module.describe(bare, chosen), module.describe(made, chosen))
    for field in module.MAPS:
        with pytest.raises((PlacecatError, StopIteration)):
            module.describe(dataclasses.replace(made, **{field: {}}), chosen)


@EVERY
def test_border_is_a_setting(name: str) -> None:
    module, made, chosen = load("local", name), maps(), regions()
    assert np.isfinite(module.describe(made, chosen, border="reflect")).all()
    with pytest.raises(PlacecatError, match="border=wrap"):
        check({"local": {name: {"border": "wrap"}}})
        # A descriptor whose setting has no fixed choices rejects it only here.
        module.describe(made, chosen, border="wrap")


@EVERY
def test_spread_is_a_positive_unit(name: str) -> None:
    assert load("local", name).SPREAD > 0
