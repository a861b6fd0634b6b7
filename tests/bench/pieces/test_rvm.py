import pytest

from placecat_bench.pieces import rvm


@pytest.fixture(scope="module")
def entries():
    return list(rvm.entries(few=100, many=120, features=16))


def test_its_entries_and_targets(entries):
    assert [(entry.input, entry.target) for entry in entries] == [
        ("100 x 16", "at least 1x faster"),
        ("100 x 16", "at most 1"),
        ("120 x 16", "at most 60"),
    ]
    assert 0 < entries[2].measure() < 5
    for entry in (entries[0], entries[2]):
        for part in entry.parts.values():
            part()


def test_fastrvm_learns_as_well(entries):
    pytest.importorskip("fastrvm", reason="without the extra bench")
    time, accuracy, _ = entries
    time.ours()
    time.theirs()
    assert abs(accuracy.measure()) < 5
