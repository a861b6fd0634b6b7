import inspect

import pytest
from makers import names

from placecat.errors import PlacecatError
from placecat.vision.discovery import entry, load, parts_of, settings_of


def function(maps: int, *, gabor_size: int = 9, radii: tuple[int, ...], scales: object = None) -> None: ...


def other(*, use_residual: bool = True) -> None: ...


def test_settings_of() -> None:
    assert settings_of(function) == {"gabor_size": 9, "radii": inspect.Parameter.empty, "scales": None}


def test_settings_are_split_and_checked() -> None:
    settings = {"use_residual": False, "radii": [1]}
    assert parts_of("attention", settings, function, other) == [{"radii": [1]}, {"use_residual": False}]
    with pytest.raises(PlacecatError, match=r"attention has no setting 'scale'; did you mean 'scales'"):
        parts_of("attention", {"scale": [2]}, function)
    with pytest.raises(PlacecatError, match=r"attention\.gabor_size=8: it must be odd"):
        parts_of("attention", {"gabor_size": 8}, function)


def test_descriptors_of_the_thesis_are_found() -> None:
    assert {"centrist", "color_mv", "hog", "orientation_mv", "sift"} <= set(names("local"))
    assert {"centrist", "gist"} <= set(names("holistic"))


@pytest.mark.parametrize("name", ["surf", "concatenate", "", "hog.x", "../hog"])
def test_unknown_descriptor(name: str) -> None:
    with pytest.raises(
        PlacecatError, match=r"local descriptor .* does not exist.* centrist, color_mv, hog, orientation_mv"
    ):
        load("local", name)


def test_an_entry_is_a_module_or_a_variant_of_one() -> None:
    assert entry("local", "hog", {"border": "reflect"}) == (load("local", "hog"), {"border": "reflect"})
    given = {"descriptor": "centrist", "width": None}
    assert entry("holistic", "centrist_full", given) == (load("holistic", "centrist"), {"width": None})
    assert given == {"descriptor": "centrist", "width": None}
