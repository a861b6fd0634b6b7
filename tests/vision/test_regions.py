import numpy as np
import pytest
import reference_attention as reference
from hypothesis import given, settings
from hypothesis import strategies as st

from number_of_examples import examples
from placecat.vision import regions as module
from placecat.vision import saliency
from placecat.vision.attention import compute_maps

POINTS = st.lists(st.tuples(st.integers(0, 640), st.integers(0, 480), st.integers(2, 5)), max_size=60)


@given(POINTS, st.integers(1, 30))
@settings(max_examples=examples(150), deadline=None)
def test_acceptance_equals_brute_force(points, most):
    array = np.array(points, np.float32).reshape(-1, 3)
    assert module.accept(array, 640, max_regions=most).tolist() == reference.accept(points, 640, most)


@given(POINTS, st.integers(1, 30), st.integers(1, 7))
@settings(max_examples=examples(60), deadline=None)
def test_blocks_do_not_change_the_accepted_points(points, most, block):
    array = np.array(points, np.float32).reshape(-1, 3)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(module, "BLOCK", block)
        assert module.accept(array, 640, max_regions=most).tolist() == reference.accept(points, 640, most)


def test_acceptance_is_strict_and_uses_the_scale_of_the_new_point():
    # At width 640, the minimum distance is 16 pixels per scale, and one scale apart counts as 2.5 pixels.
    def both(first, second):
        return module.accept(np.array([first, second], np.float32), 640).tolist() == [0, 1]

    assert not both((0, 0, 2), (32, 0, 2))
    assert both((0, 0, 2), (33, 0, 2))
    assert not both((0, 0, 2), (33, 0, 3))
    assert both((0, 0, 3), (33, 0, 2))
    assert both((0, 0, 3), (32, 0, 2))
    assert not both((0, 0, 2), (0, 32, 2))


def test_radius():
    assert module.radius(np.array([2, 3, 4, 5], np.float32), 1280).tolist() == [40, 80, 160, 320]
    assert module.radius(2, 640).dtype == np.float32


@pytest.fixture(scope="module", params=[(6, 120, 160), (7, 97, 131)])
def prepared(request):
    image = reference.frame(*request.param)
    maps = compute_maps(image)
    return image, maps, saliency.saliency(maps)


def test_scales_and_regions_equal_transcription(prepared):
    _, maps, fused = prepared
    features = {
        channel: {
            (c, s): list(stack[:, c])
            for s, stack in saliency.feature_maps(maps, channel).items()
            for c in range(stack.shape[1])
        }
        for channel in saliency.CHANNELS
    }
    terms = {c: np.float32(one.weight) * one.conspicuity for c, one in fused.channels.items()}
    subterms = {
        c: dict(enumerate(one.subchannels * one.subchannel_weights[:, None, None]))
        for c, one in fused.channels.items()
    }
    expected = reference.regions(features, (fused.saliency, terms, subterms), maps.width)
    got = module.select_regions(maps, fused)
    assert len(got) > 5
    assert len(set(got[:, 2])) > 1
    np.testing.assert_array_equal(got, expected.astype(np.float32))


def test_regions_of_a_frame(prepared):
    image, maps, fused = prepared
    got = module.select_regions(maps, fused)
    assert got.dtype == np.float32
    assert (np.diff(got[:, 3]) <= 0).all()
    assert (got[:, 3] > 0).all()
    assert set(got[:, 2]) <= {2, 3, 4, 5}
    assert (got[:, 0] < image.shape[1]).all()
    assert (got[:, 1] < image.shape[0]).all()
    np.testing.assert_array_equal(module.select_regions(maps, fused, max_regions=1), got[:1])
    np.testing.assert_array_equal(module.select_regions(maps, fused, max_regions=7), got[:7])


def test_looking_at_more_points_only_when_needed(prepared):
    _, maps, fused = prepared
    points = saliency.local_maxima(fused.saliency)
    points = points[np.argsort(-fused.saliency.ravel()[points], kind="stable")]
    rows, columns = np.divmod(points, fused.saliency.shape[1])
    scales = module.find_scales(maps, fused, points)
    every = np.stack([4 * columns, 4 * rows, scales], axis=1)
    for most in (1, 3, 25):
        kept = reference.accept(every.tolist(), maps.width, most)
        got = module.select_regions(maps, fused, max_regions=most)
        np.testing.assert_array_equal(got[:, :3], every[kept])


def test_no_points():
    assert module.accept(np.zeros((0, 3), np.float32), 640).tolist() == []
