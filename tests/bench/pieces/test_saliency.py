import numpy as np
from makers import frame

from placecat.vision.attention import compute_maps, find_regions
from placecat_bench import frames
from placecat_bench.pieces import saliency


def test_entry_and_target():
    entry, *others, absent = saliency.entries(frames=[frame()])
    assert [other.target for other in others] == ["at least 2x faster"] * 2
    assert absent.peer == "VOCUS2"
    assert (entry.input, entry.target) == ("320x240 JPEG", "at most 4.5x its time")
    assert len(entry.ours()) == len(entry.theirs()) == 1
    for part in entry.parts.values():
        part()


def test_the_timed_map_is_the_one_used_to_find_regions():
    own = frames.options()
    found = saliency.saliency_of(frame(), own)
    regions = find_regions(compute_maps(frame(), **own["attention"]), **own["regions"])
    step = 2**found.scale
    columns, rows = (regions[:, axis].astype(int) // step for axis in (0, 1))
    np.testing.assert_array_equal(found.saliency[rows, columns], regions[:, 3])
