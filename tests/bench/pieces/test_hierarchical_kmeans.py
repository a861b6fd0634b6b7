import numpy as np
import pytest

from placecat.errors import PlacecatError
from placecat_bench.pieces import hierarchical_kmeans
from project import ROOT

SMALL = {"points": 2000, "clusters": (16, 31), "homes": ROOT / hierarchical_kmeans.HOMES}


@pytest.fixture(scope="module")
def entries():
    return list(hierarchical_kmeans.entries(**SMALL))


@pytest.mark.slow
def test_entries_and_targets(entries):
    assert [(entry.input, entry.target) for entry in entries] == [
        ("2000 x 128, 16 clusters", "at least 2.5x faster"),
        ("2000 x 128, 16 clusters", "at most 1.02"),
        *[("2000 x 128, 16 clusters", "at least 1x faster"), ("2000 x 128, 16 clusters", "at most 1.02")] * 2,
        ("2000 x 128, 31 clusters", "at least 2x faster"),
        ("2000 x 128, 31 clusters", "at most 1.02"),
        *[("2000 x 128, 31 clusters", "at least 1x faster"), ("2000 x 128, 31 clusters", "at most 1.02")] * 2,
    ]
    for part in entries[0].parts.values():
        part()


def test_inertia_is_computed_from_the_timed_result(monkeypatch):
    points = hierarchical_kmeans.draw_descriptors(2000, SMALL["homes"])
    calls = []

    def one_center(points, n_clusters):
        calls.append(n_clusters)
        return points.mean(axis=0, keepdims=True)

    monkeypatch.setattr(hierarchical_kmeans, "theirs", one_center)
    timed, limit, *_ = hierarchical_kmeans.entries(**SMALL)
    timed.ours()
    timed.theirs()
    whole = np.square(points - points.mean(axis=0)).sum(dtype=np.float64)
    centers = hierarchical_kmeans.ours(points, 16)
    expected = hierarchical_kmeans.inertia(points, centers) / whole
    assert limit.measure() == pytest.approx(expected, rel=1e-5)
    assert 0.3 < expected < 0.95
    assert calls == [16]


def test_inertia_matches_a_full_distance_matrix():
    rng = np.random.default_rng(0)
    points, centers = (rng.random((n, 5), np.float32) for n in (40, 6))
    distances = np.square(points[:, None] - centers).sum(axis=2).min(axis=1)
    assert hierarchical_kmeans.inertia(points, centers) == pytest.approx(distances.sum(), rel=1e-5)


def test_descriptors_are_drawn_from_the_frames(tmp_path):
    found = hierarchical_kmeans.draw_descriptors(5000, SMALL["homes"])
    assert found.shape == (5000, 128)
    assert found.dtype == np.float32
    first = hierarchical_kmeans.draw_descriptors(3000, SMALL["homes"])
    np.testing.assert_array_equal(found[:3000], first)
    with pytest.raises(PlacecatError, match="too short for more than 0 descriptors"):
        hierarchical_kmeans.draw_descriptors(1, tmp_path)


@pytest.mark.parametrize(("package", "place"), [("pyflann_ibeis", 1), ("superkmeans", 3), ("faiss", 5)])
def test_peers_reach_a_similar_inertia(entries, package, place):
    pytest.importorskip(package, reason="without the extra bench")
    for limit in entries[place::6]:
        assert 0.85 < limit.measure() < 1.2
