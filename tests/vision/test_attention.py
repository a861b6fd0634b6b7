import cv2
import numpy as np
import pytest
import reference_attention as reference
from hypothesis import given, settings
from hypothesis import strategies as st

from number_of_examples import examples
from placecat.errors import PlacecatError
from placecat.vision.attention import compute_maps, find_regions
from placecat.vision.maps import FIELDS, FrameMaps
from placecat.vision.saliency import saliency

DICTS = ("grey", "color", "intensity_contrast", "color_contrast", "orientation", "residual")


def flatten(maps: FrameMaps):
    return [getattr(maps, name)[s] for name in DICTS for s in maps.scales]


@pytest.mark.parametrize(("seed", "height", "width"), [(1, 90, 120), (2, 71, 101)])
def test_everything_equals_the_slow_transcription(seed, height, width):
    image = reference.frame(seed, height, width)
    maps = compute_maps(image)
    features = reference.feature_maps(image)
    for s in maps.scales:
        for c in range(2):
            np.testing.assert_allclose(
                maps.intensity_contrast[s][:, c], features["intensity"][c, s], atol=2e-3
            )
        for c in range(4):
            np.testing.assert_allclose(maps.color_contrast[s][:, c], features["color"][c, s], atol=5e-5)
            np.testing.assert_allclose(maps.orientation[s][c], features["orientation"][c, s][0], atol=2e-3)
        np.testing.assert_allclose(maps.residual[s], features["residual"][0, s][0], atol=5e-3)
        np.testing.assert_allclose(maps.grey[s], reference.level(image.mean(axis=2), s), atol=1e-3)
        for c, plane in enumerate(reference.opponent(image)):
            np.testing.assert_allclose(maps.color[s][c], reference.level(plane, s), atol=5e-6)
    units = {"intensity": 255, "color": 3, "orientation": 127.5, "residual": 4}
    total, _, _ = reference.fuse(features, maps.grey[2].shape, units)
    # If rounding makes or breaks a tie, the weight of one map changes slightly.
    np.testing.assert_allclose(saliency(maps).saliency, total, atol=0.05 * total.max())


def test_shapes_and_types():
    maps = compute_maps(reference.frame(3, 75, 101))
    assert (maps.width, maps.height, maps.scales) == (101, 75, (2, 3, 4, 5))
    for s, (height, width) in {2: (19, 26), 3: (10, 13), 4: (5, 7), 5: (3, 4)}.items():
        assert maps.grey[s].shape == (height, width)
        assert maps.color[s].shape == (4, height, width)
        assert maps.intensity_contrast[s].shape == (2, 2, height, width)
        assert maps.color_contrast[s].shape == (2, 4, height, width)
        assert maps.orientation[s].shape == (4, height, width)
        assert maps.residual[s].shape == (height, width)
    assert all(a.dtype == np.float32 and a.flags.c_contiguous for a in flatten(maps))


@pytest.mark.parametrize("clip", [False, True])
@pytest.mark.parametrize("fields", [(), *((name,) for name in DICTS), ("orientation", "color")])
def test_fields_not_asked_for_are_empty_and_change_no_other(fields, clip):
    image = reference.frame(3, 75, 101)
    every, some = (compute_maps(image, names, clip_color=clip) for names in (FIELDS, fields))
    assert (some.width, some.height, some.scales) == (every.width, every.height, every.scales)
    for name in DICTS:
        expected = {s: a.tobytes() for s, a in getattr(every, name).items()} if name in fields else {}
        assert {s: a.tobytes() for s, a in getattr(some, name).items()} == expected, name


def test_the_regions_need_every_field_but_the_colour():
    image = reference.frame(3, 75, 101)
    maps = compute_maps(image, [name for name in FIELDS if name != "color"])
    np.testing.assert_array_equal(find_regions(maps), find_regions(compute_maps(image)))


def test_other_scales_and_radii():
    image = reference.frame(3, 40, 50)
    maps = compute_maps(image, scales=[1, 3], radii=[2])
    assert maps.scales == (1, 3)
    assert list(maps.grey) == [1, 3]
    assert maps.intensity_contrast[3].shape == (1, 2, 5, 7)
    assert len(find_regions(maps, fusion_scale=1))


@given(st.tuples(*[st.integers(0, 255)] * 3), st.integers(33, 90), st.integers(33, 90))
@settings(max_examples=examples(40), deadline=None)
def test_flat_frames_have_no_regions(bgr, height, width):
    maps = compute_maps(np.full((height, width, 3), bgr, np.uint8))
    assert not any(getattr(maps, name)[s].any() for name in DICTS[2:] for s in maps.scales)
    np.testing.assert_allclose(maps.grey[5], sum(bgr) / 3, atol=1e-3)
    assert find_regions(maps).shape == (0, 4)


@given(st.integers(0, 10**6), st.integers(33, 120), st.integers(33, 120), st.sampled_from([1, 5, 25]))
@settings(max_examples=examples(25), deadline=None)
def test_any_frame(seed, height, width, most):
    rng = np.random.default_rng(seed)
    image = (rng.integers(0, 2, (height, width, 3)) * rng.integers(0, 256)).astype(np.uint8)
    maps = compute_maps(image)
    assert all(np.isfinite(a).all() for a in flatten(maps))
    assert all(getattr(maps, name)[s].min() >= 0 for name in DICTS[2:] for s in maps.scales)
    got = find_regions(maps, max_regions=most)
    assert len(got) <= most
    assert reference.accept(got[:, :3].astype(float).tolist(), width, most) == list(range(len(got)))


def test_brighter_frames_have_the_same_intensity_contrast():
    image = np.clip(reference.frame(4, 80, 100, black=False), 20, 150)
    before, after = compute_maps(image), compute_maps(image + np.uint8(100))
    for s in before.scales:
        np.testing.assert_allclose(after.intensity_contrast[s], before.intensity_contrast[s], atol=2e-3)
        np.testing.assert_allclose(after.orientation[s], before.orientation[s], atol=2e-3)
        np.testing.assert_allclose(after.grey[s], before.grey[s] + 100, atol=1e-3)


def test_brighter_light_leaves_the_colours():
    image = reference.frame(4, 80, 100) // 2
    before, after = compute_maps(image), compute_maps(image * 2)
    for s in before.scales:
        np.testing.assert_allclose(after.color[s], before.color[s], atol=1e-6)


def test_patches_on_a_wall_are_found():
    image = np.full((360, 480, 3), 120, np.uint8)
    noise = np.random.default_rng(1).integers(-3, 4, image.shape)
    centres = [(100, 90), (350, 100), (230, 270)]
    for (x, y), colour in zip(centres, [(30, 30, 220), (240, 240, 240), (20, 200, 30)], strict=True):
        cv2.circle(image, (x, y), 14, colour, -1)
    got = find_regions(compute_maps((image + noise).astype(np.uint8)), max_regions=12)
    for x, y in centres:
        assert np.hypot(got[:6, 0] - x, got[:6, 1] - y).min() < 20


def test_same_frame_same_bytes_for_any_number_of_threads():
    image = reference.frame(9, 200, 300)
    before = cv2.getNumThreads()
    results, kept = set(), []
    try:
        for threads in (1, 2, 1, 4, 1):
            cv2.setNumThreads(threads)
            maps = compute_maps(image)
            # Arrays that stay alive force later arrays to other addresses.
            kept += [maps, np.empty(1000 + 4 * len(kept), np.uint8)]
            results.add(b"".join(a.tobytes() for a in [*flatten(maps), find_regions(maps)]))
    finally:
        cv2.setNumThreads(before)
    assert len(results) == 1


def test_clipping_changes_the_colours_only():
    image = reference.frame(4, 80, 100)
    plain, clipped = compute_maps(image), compute_maps(image, clip_color=True)
    assert clipped.color[2].min() >= 0 > plain.color[2].min()
    np.testing.assert_array_equal(clipped.grey[2], plain.grey[2])


def test_refusals():
    with pytest.raises(PlacecatError, match=r"32x40 .*\(2, 3, 4, 5\)"):
        compute_maps(np.zeros((40, 32, 3), np.uint8))
    with pytest.raises(TypeError, match="float64"):
        compute_maps(np.zeros((64, 64, 3)))
    with pytest.raises(PlacecatError, match="shape"):
        compute_maps(np.zeros((64, 64), np.uint8))
    with pytest.raises(PlacecatError, match="radii"):
        compute_maps(np.zeros((64, 64, 3), np.uint8), radii=())
