import pytest

from placecat.errors import PlacecatError
from placecat.vision import holistic, local
from placecat.vision.discovery import check_settings, settings_of


def function(maps: int, *, image: str = "intensity", width: int | None = None) -> None: ...


def test_settings_of() -> None:
    assert settings_of(function) == {"image": "intensity", "width": None}


def test_unknown_setting_names_owner_setting_and_valid_ones() -> None:
    with pytest.raises(
        PlacecatError,
        match=r"local descriptor 'x' has no setting 'images'; did you mean 'image'.*image, width",
    ):
        check_settings(function, {"image": "a", "images": 1}, "local descriptor 'x'")
    check_settings(function, {"image": "a"}, "local descriptor 'x'")


def test_positional_parameters_are_no_settings() -> None:
    with pytest.raises(PlacecatError, match="no setting 'maps'"):
        check_settings(function, {"maps": 1}, "x")
    with pytest.raises(PlacecatError, match="valid: none"):
        check_settings(len, {"a": 1}, "x")


def test_descriptors_of_the_thesis_are_found() -> None:
    assert {"centrist", "color_mv", "hog", "orientation_mv", "sift"} <= set(local.names())
    assert {"centrist", "gist"} <= set(holistic.names())


@pytest.mark.parametrize("name", ["surf", "concatenate", "", "hog.x", "../hog"])
def test_unknown_descriptor(name: str) -> None:
    with pytest.raises(
        PlacecatError, match=r"local descriptor .* does not exist.* centrist, color_mv, hog, orientation_mv"
    ):
        local.load(name)


def test_refusal_names_the_descriptor() -> None:
    with pytest.raises(PlacecatError, match=r"local descriptor 'hog' has no setting 'cells'.*interpolation"):
        local.entry("hog", {"cells": 3})
    with pytest.raises(PlacecatError, match=r"holistic descriptor 'gist' has no setting 'colour'.*color, "):
        holistic.entry("gist", {"colour": False})


def test_an_entry_is_a_module_or_a_variant_of_one() -> None:
    assert local.entry("hog", {"border": "reflect"}) == (local.load("hog"), {"border": "reflect"})
    given = {"descriptor": "centrist", "width": None}
    assert holistic.entry("centrist_full", given) == (holistic.load("centrist"), {"width": None})
    assert given == {"descriptor": "centrist", "width": None}


def test_refusal_names_the_variant() -> None:
    with pytest.raises(PlacecatError, match=r"local descriptor 'short' has no setting 'cells'.*grid"):
        local.entry("short", {"descriptor": "color_mv", "cells": 0})
    with pytest.raises(
        PlacecatError, match=r"entry 'short': local descriptor 'surf' does not exist: use one"
    ):
        local.entry("short", {"descriptor": "surf"})
    with pytest.raises(PlacecatError, match=r"entry 'x': holistic descriptor None does not exist"):
        holistic.entry("x", {"descriptor": None})
