import numpy as np

from placecat_bench.gist_like import CLASSES, draw_frames


def test_every_home_visits_every_place_several_times():
    frames = draw_frames(503, 7, range(3))
    assert frames.descriptors.shape == (503, 7)
    assert frames.descriptors.dtype == np.float32
    for place in np.split(frames.place, [168, 336]):
        assert np.unique(place).tolist() == list(range(CLASSES))
        # Four rounds through the rooms.
        assert np.count_nonzero(np.diff(place)) == 4 * CLASSES - 1


def test_a_home_does_not_depend_on_the_others():
    alone, among = draw_frames(60, 7, [1]), draw_frames(120, 7, [0, 1])
    np.testing.assert_allclose(alone.descriptors, among.descriptors[60:], rtol=1e-5)
    other = draw_frames(60, 7, [2])
    assert not np.allclose(alone.descriptors, other.descriptors)


def test_consecutive_frames_are_similar_and_features_are_correlated():
    frames = draw_frames(2000, 40, range(2)).descriptors
    step = np.square(np.diff(frames, axis=0)).mean()
    assert step < 0.6 * np.square(frames[500:] - frames[:-500]).mean()
    variances = np.linalg.eigvalsh(np.corrcoef(frames.T))[::-1] / 40
    assert variances[:5].sum() > 0.4
