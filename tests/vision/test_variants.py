"""Tests that variants of salient regions equal the regions that attention finds with the same settings."""

import functools

import numpy as np
import pytest
from makers import frame

from placecat.errors import PlacecatError
from placecat.vision import saliency, variants
from placecat.vision.attention import compute_maps, find_regions
from placecat.vision.discovery import load
from placecat.vision.frame import describe_frame
from placecat.vision.maps import FIELDS

SETTINGS = {"regions": {"max_regions": 38}, "local": {"hog": {}, "sift": {}}, "holistic": {"gist": {}}}
VARIANTS = {
    "as_used": {"scales": None, "regions": {"max_regions": 25}, "descriptors": ["hog"]},
    "no_residual": {"scales": None, "regions": {"use_residual": False}, "descriptors": ["hog"]},
    "fewer_scales": {"scales": [2, 3], "regions": {}, "descriptors": ["hog", "sift"]},
    "more": {"scales": None, "regions": {"max_regions": 50}, "descriptors": []},
}
PICTURE = frame(640, 360)


@pytest.fixture(scope="module")
def found():
    return describe_frame(PICTURE, {**SETTINGS, "variants": VARIANTS})


def test_variants_do_not_change_other_features(found):
    alone = describe_frame(PICTURE, SETTINGS)
    assert list(found)[: len(alone)] == list(alone)
    assert all(found[name].tobytes() == array.tobytes() for name, array in alone.items())
    assert {name.split("/")[0] for name in found if name not in alone} == {
        f"variant_{one}" for one in VARIANTS
    }


@pytest.mark.parametrize(
    ("name", "attention", "regions"),
    [
        ("as_used", {}, {"max_regions": 25}),
        ("no_residual", {"use_residual": False}, {"max_regions": 38, "use_residual": False}),
        ("fewer_scales", {"scales": (2, 3)}, {"max_regions": 38}),
        ("more", {}, {"max_regions": 50}),
    ],
)
def test_a_variant_is_the_attention_with_its_settings(found, name, attention, regions):
    maps = compute_maps(PICTURE, **attention)
    expected = find_regions(maps, **regions)
    count = int(found[f"variant_{name}/count"])
    assert count == len(expected) > 0
    assert found[f"variant_{name}/regions"].shape == (regions["max_regions"], 4)
    np.testing.assert_array_equal(found[f"variant_{name}/regions"][:count], expected)
    assert not found[f"variant_{name}/regions"][count:].any()
    for descriptor in VARIANTS[name]["descriptors"]:
        described = found[f"variant_{name}/local_{descriptor}"]
        np.testing.assert_array_equal(described[:count], load("local", descriptor).describe(maps, expected))


def test_variants_differ_where_they_should(found):
    def points(name):
        return found[f"variant_{name}/regions"][:, :3].tolist()

    assert points("as_used") == found["regions"][:25, :3].tolist()
    assert points("no_residual") != found["regions"][:, :3].tolist()
    assert max(scale for _, _, scale in points("fewer_scales")) == 3
    assert points("more")[:38] == found["regions"][:, :3].tolist()


def test_maps_of_some_scales_are_the_same_maps():
    maps = compute_maps(PICTURE)
    some = maps.at_scales([4, 2])
    assert some.scales == (2, 4)
    for name in FIELDS:
        assert list(getattr(some, name)) == [2, 4]
        assert all(getattr(some, name)[scale] is getattr(maps, name)[scale] for scale in (2, 4))


@pytest.mark.parametrize("scales", [[], [2, 6]])
def test_scales_that_there_are_not_are_refused(scales):
    with pytest.raises(PlacecatError, match="maps exist only for the scales 2, 3, 4, 5"):
        compute_maps(PICTURE).at_scales(scales)


def test_equal_parts_are_computed_once(monkeypatch):
    fused, found, described = [], [], []

    def noted(function, calls, number):
        @functools.wraps(function)
        def call(*arguments, **settings):
            calls.append(arguments[number])
            return function(*arguments, **settings)

        return call

    monkeypatch.setattr(saliency, "_fuse", noted(saliency._fuse, fused, 1))
    monkeypatch.setattr(variants, "find_regions", noted(find_regions, found, 0))
    hog = load("local", "hog")
    monkeypatch.setattr(hog, "describe", noted(hog.describe, described, 1))
    describe_frame(PICTURE, {**SETTINGS, "variants": VARIANTS})
    # Regions are found with all scales, without the residual, and with two scales.
    assert len(found) == 3
    assert sorted(fused) == sorted(2 * ["intensity", "color", "orientation", "residual"])
    assert sorted(map(len, described)) == [38, 38, 38]
