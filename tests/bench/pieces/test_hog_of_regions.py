import numpy as np
import pytest
from makers import frame

from placecat_bench.pieces import hog_of_regions


@pytest.fixture
def entries():
    return list(hog_of_regions.entries(frames=[frame(), frame(seed=3)], count=7))


def test_entries_and_targets(entries):
    assert [(entry.input, entry.target) for entry in entries[:2]] == [
        ("7 regions of 320x240", "at least 2x faster"),
        ("7 regions of 320x240", "at most 0"),
    ]
    for part in entries[0].parts.values():
        part()


def test_the_descriptors_are_identical(entries, monkeypatch):
    timed, limit, absent = entries
    assert "no wheel" in absent.reason
    for ours, theirs in zip(timed.ours(), timed.theirs(), strict=True):
        assert ours.shape == (7, 128)
        assert ours.any(axis=1).all()
        np.testing.assert_array_equal(ours, theirs)
    assert limit.measure() == 0
    monkeypatch.setattr(hog_of_regions, "ours", lambda given: [ours + np.float32(1e-7)] * 2)
    assert limit.measure() > 0
