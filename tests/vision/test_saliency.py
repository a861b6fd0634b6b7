import numpy as np
import pytest
import reference_attention as reference
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

from number_of_examples import examples
from placecat.errors import PlacecatError
from placecat.vision import saliency as module
from placecat.vision.attention import compute_maps


@given(
    hnp.arrays(
        np.float32, st.tuples(st.integers(1, 9), st.integers(1, 9)), elements=st.integers(0, 3).map(float)
    ),
    st.sampled_from([3, 5]),
)
@settings(max_examples=examples(300), deadline=None)
def test_local_maxima_equal_flooding(plane, window):
    assert module.local_maxima(plane, window).tolist() == reference.local_maxima(plane, window)


def test_local_maxima_of_drawn_planes():
    plane = np.array([[5, 1, 0, 2, 2], [1, 1, 0, 2, 2], [0, 0, 0, 0, 0], [3, 3, 4, 0, -1]], np.float32)
    assert module.local_maxima(plane).tolist() == [0, 3, 17]
    assert module.local_maxima(np.full((4, 4), 7, np.float32)).size == 0
    assert module.local_maxima(np.full((4, 4), -7, np.float32)).size == 0


@pytest.mark.parametrize(
    ("peaks", "expected"),
    [
        ([], 0),
        ([3], 0),
        ([2, 2, 2], 0),
        ([1, 2], 1),
        ([1, 2, 3], 1),
        ([1, 1, 1, 9], 1),
        ([4, 1, 3, 2], 2**-0.5),
        (list(range(9)), 0.5),
    ],
)
def test_weight(peaks, expected):
    assert module.weight(np.array(peaks, np.float32)) == expected


def test_across_scale_addition_equals_direct_interpolation():
    rng = np.random.default_rng(1)
    levels = {
        2: rng.random((2, 23, 37), np.float32),
        3: rng.random((2, 12, 19), np.float32),
        5: rng.random((2, 3, 5), np.float32),
    }
    got = module.add_across_scales(levels, 147, 91, 2)
    for k in range(2):
        expected = sum(reference.expand_to(p[k].astype(float), s - 2, (23, 37)) for s, p in levels.items())
        np.testing.assert_allclose(got[k], expected, atol=1e-5)
    assert module.add_across_scales(levels, 147, 91, 0).shape == (2, 91, 147)


def test_stretch():
    plane = np.array([[1, 3], [2, 5]], np.float32)
    assert module.stretch(plane, 8.0).tolist() == [[0, 4], [2, 8]]
    assert not module.stretch(np.ones((2, 2), np.float32), 8.0).any()


@pytest.fixture(scope="module")
def maps():
    return compute_maps(reference.frame(5, 120, 160))


def test_fusion_equals_transcription(maps):
    features = {
        channel: {
            (c, s): [plane.astype(float) for plane in stack[:, c]]
            for s, stack in module.feature_maps(maps, channel).items()
            for c in range(stack.shape[1])
        }
        for channel in module.CHANNELS
    }
    units = {"intensity": 255, "color": 3, "orientation": 127.5, "residual": 4}
    got = module.saliency(maps)
    total, terms, _ = reference.fuse(features, got.saliency.shape, units)
    for channel, one in got.channels.items():
        np.testing.assert_allclose(one.conspicuity * one.weight, terms[channel], atol=1e-5)
    np.testing.assert_allclose(got.saliency, total, atol=1e-5)
    assert total.max() > 0.1


def test_ranges(maps):
    got = module.saliency(maps)
    assert got.saliency.shape == (30, 40)
    assert got.saliency.dtype == np.float32
    assert {name: len(one.subchannels) for name, one in got.channels.items()} == {
        "intensity": 2,
        "color": 4,
        "orientation": 4,
        "residual": 1,
    }
    for channel, unit in zip(module.CHANNELS, (255, 3, 127.5, 4), strict=True):
        plane = got.channels[channel].conspicuity
        peaks = [p.ravel()[module.local_maxima(p)].max() for p in got.channels[channel].subchannels]
        assert plane.min() == 0
        np.testing.assert_allclose(plane.max(), max(peaks) / unit, rtol=1e-5)


def test_settings_take_effect(maps):
    whole = module.saliency(maps)
    without = module.saliency(maps, use_residual=False)
    assert list(without.channels) == ["intensity", "color", "orientation"]
    residual = whole.channels["residual"]
    np.testing.assert_allclose(
        whole.saliency - residual.weight * residual.conspicuity, without.saliency, atol=1e-6
    )
    assert module.saliency(maps, fusion_scale=1).saliency.shape == (60, 80)
    wide, halved = (module.saliency(maps, **own) for own in ({"maximum_window": 7}, {"color_unit": 6}))
    color = whole.channels["color"]
    assert wide.channels["color"].weight > color.weight
    np.testing.assert_allclose(2 * halved.channels["color"].conspicuity, color.conspicuity, rtol=1e-5)


def test_impossible_settings(maps):
    with pytest.raises(PlacecatError, match="fusion_scale"):
        module.saliency(maps, fusion_scale=3)
    bare = compute_maps(reference.frame(5, 64, 64), use_residual=False)
    with pytest.raises(PlacecatError, match="use_residual"):
        module.saliency(bare)
    assert module.saliency(bare, use_residual=False).saliency.max() > 0
