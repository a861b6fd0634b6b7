import pytest

from placecat_bench.pieces import rvm


@pytest.fixture(scope="module")
def entries():
    return list(rvm.entries(fewest=60, few=100, many=120, features=16))


@pytest.mark.slow
def test_entries_and_targets(entries):
    assert [(entry.input, entry.target) for entry in entries] == [
        ("60 x 16", "at least 10x faster"),
        ("60 x 16", "at most 1"),
        ("100 x 16", "at least 1x faster"),
        ("100 x 16", "at most 1"),
        ("120 x 16", "at most 60"),
    ]
    assert 0 < entries[4].measure() < 5
    for entry in (entries[0], entries[4]):
        for part in entry.parts.values():
            part()


@pytest.mark.parametrize(("package", "place"), [("sklearn_rvm", 0), ("fastrvm", 2)])
def test_peers_are_about_as_accurate(entries, package, place):
    pytest.importorskip(package, reason="without the extra bench")
    time, accuracy = entries[place : place + 2]
    time.ours()
    time.theirs()
    assert abs(accuracy.measure()) < 5
