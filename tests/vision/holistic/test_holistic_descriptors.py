"""Tests of every holistic descriptor. A new descriptor needs no new test."""

import dataclasses
import itertools

import numpy as np
import pytest
from makers import every, frame, maps

from placecat.vision.discovery import load, settings_of
from placecat.vision.maps import FIELDS

EVERY = pytest.mark.parametrize("name", every("holistic"))
SIZES = pytest.mark.parametrize("size", [(320, 240), (640, 360), (333, 217), (66, 50)])


@EVERY
@SIZES
def test_shape_type_and_values(name: str, size: tuple[int, int]) -> None:
    module = load("holistic", name)
    found = module.describe(frame(*size), maps(*size))
    assert found.shape == module.describe(frame(), maps()).shape
    assert found.dtype == np.float32
    assert found.flags.c_contiguous
    assert np.isfinite(found).all()
    assert found.std() > 0


@EVERY
def test_deterministic_and_free_of_side_effects(name: str) -> None:
    image = frame()
    first = load("holistic", name).describe(image, maps())
    np.testing.assert_array_equal(first, load("holistic", name).describe(frame(), maps()))
    np.testing.assert_array_equal(image, frame())


@EVERY
def test_reads_the_maps_it_names_only(name: str) -> None:
    module, made = load("holistic", name), maps()
    others = {field: {} for field in FIELDS if field not in module.MAPS}
    bare = dataclasses.replace(made, **others)
    booleans = [key for key, value in settings_of(module.describe).items() if isinstance(value, bool)]
    for values in itertools.product([False, True], repeat=len(booleans)):
        chosen = dict(zip(booleans, values, strict=True))
        found = module.describe(frame(), bare, **chosen)
        np.testing.assert_array_equal(found, module.describe(frame(), made, **chosen))


@EVERY
def test_black_frame(name: str) -> None:
    found = load("holistic", name).describe(np.zeros_like(frame()), maps())
    assert np.isfinite(found).all()
