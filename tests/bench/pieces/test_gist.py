import pytest
from makers import frame

from placecat_bench.pieces import gist


@pytest.fixture
def entry():
    (entry,) = gist.entries(frames=[frame()])
    return entry


def test_entry_and_target(entry):
    assert (entry.input, entry.target) == ("320x240", "at least 5x faster")
    assert entry.ours()[0].shape == (1024,)
    for part in entry.parts.values():
        part()


def test_torchgist_describes_the_frame(entry):
    pytest.importorskip("torchgist", reason="without the extra bench-torch")
    (found,) = entry.theirs()
    assert found.shape == (512,)
