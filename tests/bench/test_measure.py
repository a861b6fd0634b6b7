from importlib.metadata import version

import pytest

from placecat.errors import PlacecatError
from placecat_bench import measure as module
from placecat_bench.comparison import TORCH, Absent, Comparison, Limit, Peer
from placecat_bench.measure import ABSENT, COLUMNS, measure
from placecat_bench.timing import time_in_turn

PEER = Peer("NumPy: sort", "numpy")


class Clock:
    """A clock that every call advances by its duration."""

    def __init__(self, monkeypatch):
        self.now = 0.0
        self.calls = []
        monkeypatch.setattr("placecat_bench.timing.time.perf_counter", lambda: self.now)
        # Skip garbage collection, since earlier tests may have left a lot of garbage.
        monkeypatch.setattr("placecat_bench.timing.gc.collect", lambda: None)

    def call(self, name, *durations):
        queue = list(durations)

        def spend():
            self.calls.append(name)
            self.now += queue.pop(0) if len(queue) > 1 else queue[0]

        return spend


def test_pairs_are_timed_in_alternating_order_after_a_warm_up(monkeypatch):
    clock = Clock(monkeypatch)
    times = time_in_turn(clock.call("a", 100, 1, 2, 3), clock.call("b", 100, 4, 5, 6), repeats=3)
    assert clock.calls == ["a", "b", "a", "b", "b", "a", "a", "b"]
    assert times == ([1, 2, 3], [4, 5, 6])


def test_without_warm_up_the_first_calls_count(monkeypatch):
    clock = Clock(monkeypatch)
    assert time_in_turn(clock.call("a", 7), clock.call("b", 8), repeats=1, warm_up=False) == ([7], [8])
    assert clock.calls == ["a", "b"]


def test_the_ratio_is_the_median_of_the_pairs_not_the_ratio_of_the_medians(monkeypatch):
    clock = Clock(monkeypatch)
    ours = clock.call("a", 1, 1, 2, 4, 8, 16)
    theirs = clock.call("b", 1, 20, 20, 80, 40, 160)  # ratios 20, 10, 20, 5, 10
    row = measure(Comparison("Sorting", "numbers", PEER, ours, theirs, faster=10))
    assert list(row) == COLUMNS
    assert (row["ratio"], row["low"], row["high"]) == (10, 5, 20)
    assert (row["ours"], row["theirs"], row["met"], row["spent"]) == (4, 40, "yes", None)
    assert row["peer_version"] == version("numpy")


def test_a_missed_target_shows_where_the_time_goes(monkeypatch):
    clock = Clock(monkeypatch)
    parts = {"comparing": clock.call("c", 0.5), "moving": clock.call("d", 1.25)}
    entry = Comparison("Sorting", "", PEER, clock.call("a", 2), clock.call("b", 3), faster=10, parts=parts)
    row = measure(entry)
    assert (row["met"], row["spent"]) == ("no", "moving 62%, comparing 25%")
    limit = Limit("Sorting", "", "seconds", lambda: 2.0, at_most=1, parts=parts)
    assert measure(limit)["spent"] == "moving 1.25 s, comparing 0.5 s"


def test_a_limit_is_measured_once(monkeypatch):
    asked = []
    row = measure(Limit("Sorting", "", "difference", lambda: asked.append(1) or 0.00123456, at_most=0.01))
    assert (row["ours"], row["met"], row["ratio"], row["peer"]) == (0.001235, "yes", None, None)
    assert asked == [1]


def test_a_missing_peer_raises_an_error_before_anything_is_timed():
    entry = Comparison("Sorting", "", Peer("it", "no-such-peer"), lambda: 1 / 0, lambda: 1 / 0, faster=2)
    with pytest.raises(PlacecatError, match=r"no-such-peer is not installed.*\[bench\]"):
        measure(entry)


def test_garbage_is_collected_before_the_clock_starts(monkeypatch):
    order = []
    monkeypatch.setattr("placecat_bench.timing.gc.collect", lambda: order.append("collect"))
    monkeypatch.setattr("placecat_bench.timing.time.perf_counter", lambda: order.append("clock") or 0.0)
    module.median_seconds(lambda: order.append("call"), 1)
    assert order == ["collect", "clock", "call", "clock"]


def test_a_peer_that_cannot_be_measured_gets_a_row_with_the_reason():
    row = measure(Absent("Sorting", "numbers", "another", "it needs CUDA 9"))
    assert list(row) == COLUMNS
    assert (row["peer"], row["met"], row["spent"]) == ("another", ABSENT, "it needs CUDA 9")
    assert row["ours"] is row["ratio"] is None


def test_a_missing_peer_of_another_extra_is_skipped():
    peer = Peer("it", "no-such-peer", extra=TORCH)
    row = measure(Comparison("Sorting", "", peer, lambda: 1 / 0, lambda: 1 / 0, faster=2))
    assert (row["met"], row["spent"]) == (ABSENT, "without the extra bench-torch")


def test_the_version_comes_from_the_folder_of_the_peer(tmp_path):
    (tmp_path / "numpy-0.1.dist-info").mkdir()
    (tmp_path / "numpy-0.1.dist-info/METADATA").write_text("Name: numpy\nVersion: 0.1\n")
    peer = Peer("it", "numpy", tmp_path)
    assert measure(Limit("Sorting", "", "swaps", lambda: 1.0, at_most=2, peer=peer))["peer_version"] == "0.1"
