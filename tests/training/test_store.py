import numpy as np
import pytest
from made_features import make

from placecat import files
from placecat.errors import PlacecatError
from placecat.sequences import listing
from placecat.training import store
from placecat.vision.discovery import load

HOG = {
    "kind": "local",
    "name": "hog",
    "y_pos": True,
    "y_weight": 2.0,
    "color": None,
    "max_regions": 3,
}


@pytest.fixture
def folder(tmp_path, monkeypatch):
    make(tmp_path)
    monkeypatch.chdir(tmp_path)
    return tmp_path / "data/features/H1"


def test_shape_and_position_are_concatenated(folder):
    read = store.read_descriptors("H1", HOG)
    hog, regions = np.load(folder / "local_hog.npy"), np.load(folder / "regions.npy")
    counts = np.minimum(np.load(folder / "count.npy"), 3)
    assert read.x.shape == (90, 3, 7)
    np.testing.assert_array_equal(read.counts, counts)
    frame = int(np.flatnonzero(counts == 2)[0])
    expected = hog[frame, :2] / np.float32(load("local", "hog").SPREAD)
    np.testing.assert_allclose(read.x[frame, :2, :6], expected, rtol=1e-6)
    np.testing.assert_allclose(read.x[frame, :2, 6], 2 * regions[frame, :2, 1] / 360, rtol=1e-6)
    assert (read.x[frame, 2] == 0).all()


def test_only_requested_rows_are_read(folder):
    some = np.array([4, 40, 7])
    np.testing.assert_array_equal(
        store.read_descriptors("H1", HOG, some).x, store.read_descriptors("H1", HOG).x[some]
    )


def test_colour_is_appended(folder):
    read = store.read_descriptors("H1", HOG | {"color": "color_mv", "y_pos": False})
    assert read.x.shape == (90, 3, 8)
    color = np.load(folder / "local_color_mv.npy")[:, :3] / np.float32(load("local", "color_mv").SPREAD)
    color[np.arange(3)[None, :] >= read.counts[:, None]] = 0
    np.testing.assert_allclose(read.x[:, :, 6:], color, rtol=1e-6)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"colour": "color_mv"}, "no setting 'colour'"),
        ({"kind": "global"}, "local or holistic, not 'global'"),
        ({"kind": "holistic"}, "no setting"),
    ],
)
def test_unknown_descriptor_settings_are_rejected(folder, change, message):
    with pytest.raises(PlacecatError, match=message):
        store.read_descriptors("H1", HOG | change)


def test_too_many_regions_are_rejected(folder):
    with pytest.raises(PlacecatError, match=r"9 regions.*regions\.max_regions is 4"):
        store.read_descriptors("H1", HOG | {"max_regions": 9})


def test_a_missing_descriptor_names_its_file(folder):
    with pytest.raises(PlacecatError, match=r"holistic_surf\.npy is missing"):
        store.read_descriptors("H1", {"kind": "holistic", "name": "surf"})


def test_sequences_are_cut_where_the_name_changes(folder):
    assert listing.sequence_slices("H1") == [slice(0, 50), slice(50, 90)]


VARIANT = HOG | {"variant": "other"}


@pytest.fixture
def variant(folder):
    """Write a variant for every third frame, with the regions of the frame after it."""
    rows = np.arange(0, 90, 3)
    for name in ("count", "regions", "local_hog"):
        files.write_array(folder / f"variant_other/{name}.npy", np.load(folder / f"{name}.npy")[rows + 1])
    files.write_array(folder / "variant_other/frames.npy", rows)
    files.write_json(folder / "variant_other/descriptors.json", files.read_json(folder / "descriptors.json"))


@pytest.mark.usefixtures("variant")
def test_a_variant_has_its_own_regions_and_frames(folder):
    read = store.read_descriptors("H1", VARIANT, np.array([3, 60]))
    same = store.read_descriptors("H1", HOG, np.array([4, 61]))
    np.testing.assert_array_equal(read.x, same.x)
    np.testing.assert_array_equal(read.counts, same.counts)
    np.testing.assert_array_equal(store.described("H1", VARIANT, np.arange(5, 12)), [6, 9])
    np.testing.assert_array_equal(store.described("H1", HOG, np.arange(5, 12)), np.arange(5, 12))


@pytest.mark.usefixtures("variant")
@pytest.mark.parametrize("rows", [None, np.array([3, 4])])
def test_frames_missing_from_a_variant_are_rejected(rows):
    with pytest.raises(PlacecatError, match="use region variants only in trials"):
        store.read_descriptors("H1", VARIANT, rows)


def test_an_unknown_variant_is_rejected(folder):
    with pytest.raises(PlacecatError, match=r"variant_other/frames.npy is missing: add the variant"):
        store.described("H1", VARIANT, np.arange(3))
