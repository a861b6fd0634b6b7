import functools
from pathlib import Path

import numpy as np
import pytest
import yaml
from makers import frame, installed

from placecat.errors import PlacecatError
from placecat.vision.attention import compute_maps, find_regions
from placecat.vision.discovery import entry, load, settings_of
from placecat.vision.frame import check, describe_frame
from placecat.vision.information import information
from placecat.vision.maps import FIELDS, FrameMaps

DESCRIPTORS = Path(__file__).resolve().parents[2] / "conf/descriptor"

ALL = {
    "local": {name: {} for name in installed("local")},
    "holistic": {name: {} for name in installed("holistic")},
}


def test_equals_the_parts() -> None:
    picture = frame()
    settings = {
        "attention": {"scales": [2, 3, 4]},
        "regions": {"max_regions": 7},
        "local": {"color_mv": {"grid": 0}, "hog": {}},
        "holistic": {"gist": {"color": False}},
        "information": {"unit": 255},
    }
    maps = compute_maps(picture, scales=[2, 3, 4])
    regions = find_regions(maps, max_regions=7)
    found = describe_frame(picture, settings)
    assert (found["count"], len(found["regions"])) == (len(regions), 7)
    np.testing.assert_array_equal(found["regions"][: len(regions)], regions)
    assert [name for name in found if name.startswith("local_")] == ["local_color_mv", "local_hog"]
    color = load("local", "color_mv").describe(maps, regions, grid=0)
    np.testing.assert_array_equal(found["local_color_mv"][: len(regions)], color)
    hog = load("local", "hog").describe(maps, regions)
    np.testing.assert_array_equal(found["local_hog"][: len(regions)], hog)
    gist = load("holistic", "gist").describe(picture, maps, color=False)
    np.testing.assert_array_equal(found["holistic_gist"], gist)
    assert found["information"] == np.float32(information(maps, unit=255))


def test_arrays_are_padded_with_zeros() -> None:
    found = describe_frame(frame(160, 120), {**ALL, "regions": {"max_regions": 200}})
    count = int(found["count"])
    assert 0 < count < 200
    for name in ("regions", *(f"local_{name}" for name in ALL["local"])):
        assert found[name].shape[0] == 200
        assert (found[name][count:] == 0).all()
        assert found[name][:count].any()


def test_flat_frame_has_no_regions() -> None:
    found = describe_frame(np.full((120, 160, 3), 90, np.uint8), ALL)
    assert found["count"] == 0
    assert found["information"] == 0
    assert found["local_hog"].shape == (25, 128)
    assert not found["local_hog"].any()
    assert all(np.isfinite(array).all() for array in found.values())


@pytest.mark.parametrize("size", [(160, 120), (333, 217)])
def test_shapes_and_types_are_those_of_every_frame(size: tuple[int, int]) -> None:
    found, blank = (
        {name: (array.shape, array.dtype) for name, array in describe_frame(image, ALL).items()}
        for image in (frame(*size), np.zeros((256, 256, 3), np.uint8))
    )
    assert found == blank
    assert found["local_sift"] == ((25, 128), np.dtype(np.float32))
    assert found["holistic_centrist"] == ((4096,), np.dtype(np.float32))
    assert found["count"] == ((), np.dtype(np.int16))


def test_deterministic_to_the_byte() -> None:
    first, second = describe_frame(frame(), ALL), describe_frame(frame(), ALL)
    assert list(first) == list(second)
    assert all(first[name].tobytes() == second[name].tobytes() for name in first)


def test_given_regions_are_described() -> None:
    picture = frame()
    tracked = find_regions(compute_maps(picture))[3:9] + np.array([2, 1, 0, 0], np.float32)
    found = describe_frame(picture, ALL, regions=tracked)
    assert found["count"] == 6
    np.testing.assert_array_equal(found["regions"][:6], tracked)
    assert found["local_sift"][:6].any(axis=1).all()
    assert not found["local_sift"][6:].any()


def test_a_variant_has_another_name_and_the_numbers_of_its_module() -> None:
    picture = frame()
    found = describe_frame(
        picture,
        {
            "local": {"centrist": {}, "edges": {"descriptor": "centrist", "image": "laplacian"}},
            "holistic": {"gist_raw": {"descriptor": "gist", "center_surround": False}},
        },
    )
    maps = compute_maps(picture)
    regions = find_regions(maps)
    assert list(found) == [
        "count",
        "regions",
        "local_centrist",
        "local_edges",
        "information",
        "holistic_gist_raw",
    ]
    edges = load("local", "centrist").describe(maps, regions, image="laplacian")
    np.testing.assert_array_equal(found["local_edges"][: len(edges)], edges)
    assert (found["local_edges"] != found["local_centrist"]).any()
    raw = load("holistic", "gist").describe(picture, maps, center_surround=False)
    np.testing.assert_array_equal(found["holistic_gist_raw"], raw)


@pytest.mark.parametrize(
    "settings",
    [
        {"local": {name: {} for name in ("hog", "sift", "centrist")}},
        {"local": {"color_mv": {}}, "information": {"unit": 255}},
        {"local": {"orientation_mv": {}}, "attention": {"use_residual": False}},
        {"holistic": ALL["holistic"]},
        {},
    ],
)
def test_maps_that_nothing_reads_are_left_out_without_a_change(
    settings: dict, monkeypatch: pytest.MonkeyPatch
) -> None:
    picture = frame()
    regions = find_regions(compute_maps(picture))
    fewer = describe_frame(picture, settings, regions=regions)

    @functools.wraps(compute_maps)
    def compute_all(image: np.ndarray, fields: set[str], **own: object) -> FrameMaps:
        assert fields < set(FIELDS)
        return compute_maps(image, **own)

    monkeypatch.setattr("placecat.vision.frame.compute_maps", compute_all)
    every = describe_frame(picture, settings, regions=regions)
    assert {name: array.tobytes() for name, array in fewer.items()} == {
        name: array.tobytes() for name, array in every.items()
    }


@pytest.mark.parametrize(
    ("kind", "path"), [(path.parent.name, path) for path in sorted(DESCRIPTORS.glob("*/*.yaml"))]
)
def test_every_descriptor_of_the_configuration_is_valid_and_complete(kind: str, path: Path) -> None:
    settings = yaml.safe_load(path.read_text())
    check({kind: {path.stem: settings}})
    module, own = entry(kind, path.stem, settings)
    assert set(own) == set(settings_of(module.describe))
    name = module.__name__.rpartition(".")[2]
    if name != path.stem:
        assert path.stem.startswith(f"{name}_")
        base = yaml.safe_load(path.with_name(f"{name}.yaml").read_text())
        assert len([key for key in own if own[key] != base[key]]) == 1


def test_only_requested_features_are_computed() -> None:
    assert list(describe_frame(frame(), {})) == ["count", "regions", "information"]
    assert list(describe_frame(frame(), {"holistic": {"gist": {}}}))[3:] == ["holistic_gist"]


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"locals": {}}, "no setting 'locals'.*attention, regions, local, holistic, information"),
        ({"attention": {"scale": 2}}, "attention has no setting 'scale'.*scales"),
        ({"regions": {"maps": 2}}, "regions has no setting 'maps'.*max_regions"),
        ({"information": {"level": 2}}, "information has no setting 'level'.*fine"),
        ({"local": {"surf": {}}}, "local descriptor 'surf' does not exist"),
        ({"local": {"sift": {"upright": True}}}, "local.sift has no setting 'upright'.*orientation"),
        ({"holistic": {"gist": {"cells": 3}}}, "holistic.gist has no setting 'cells'"),
        (
            {"holistic": {"gist_raw": {"descriptor": "gist", "raw": True}}},
            "holistic.gist_raw has no setting 'raw'",
        ),
        ({"local": {"mine": {"descriptor": "surf"}}}, "local.mine: local descriptor 'surf' does not exist"),
        ({"holistic": {"x": {"descriptor": None}}}, "holistic descriptor None does not exist"),
    ],
)
def test_refusals(settings: dict, message: str) -> None:
    with pytest.raises(PlacecatError, match=message):
        check(settings)


@pytest.mark.parametrize(
    ("section", "settings"),
    [
        ("attention", {"scales": []}),
        ("attention", {"scales": [3, 2]}),
        ("attention", {"radii": []}),
        ("attention", {"gabor_size": 4}),
        ("attention", {"gabor_sigma": 0}),
        ("attention", {"residual_box": 2}),
        ("attention", {"residual_sigma": -1}),
        ("attention", {"residual_width": 1}),
        ("attention", {"residual_floor": 0}),
        ("regions", {"max_regions": 0}),
        ("regions", {"fusion_scale": -1}),
        ("regions", {"color_unit": 0}),
        ("regions", {"maximum_window": 2}),
        ("regions", {"maximum_window": 4}),
        ("information", {"unit": 0}),
        ("information", {"unit": float("nan")}),
        ("local.centrist", {"image": "sobel"}),
        ("local.centrist", {"kernel": "big"}),
        ("local.color_mv", {"grid": -1}),
        ("local.orientation_mv", {"grid": -1}),
        ("local.hog", {"interpolation": "lanczos"}),
        ("local.sift", {"orientation": "north"}),
        ("holistic.centrist", {"width": 15}),
        ("holistic.centrist", {"image": "sobel"}),
        ("holistic.centrist", {"kernel": "sobel"}),
        ("holistic.centrist", {"interpolation": "cubic"}),
        ("holistic.embedding", {"width": 0}),
        ("holistic.embedding", {"mean": [0.5]}),
        ("holistic.embedding", {"std": [1.0, 0.0, 1.0]}),
        ("holistic.embedding", {"pool": "max"}),
    ],
)
def test_values_out_of_range_are_refused(section: str, settings: dict) -> None:
    *kind, name = section.split(".")
    (setting,) = settings
    with pytest.raises(PlacecatError, match=rf"{section}\.{setting}.*: "):
        check({kind[0]: {name: settings}} if kind else {name: settings})
