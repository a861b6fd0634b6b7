"""The data that figures read from a finished run."""

import numpy as np
import pytest

import made_run
from made_run import CUES, FRAMES, HOMES, LABELS, POOR, RICHEST
from placecat.errors import PlacecatError
from placecat.report.run import Run


def test_a_run_reads_the_outputs_of_the_stages(made):
    run = Run(made)
    assert run.homes == HOMES and run.classes == made_run.CLASSES
    np.testing.assert_array_equal(run.labels("flat_2"), LABELS)
    np.testing.assert_array_equal(run.frame("flat_2", 3), made_run.draw("flat_2", 3))
    assert run.sequence_slices("flat_1") == [slice(0, 5), slice(5, 8)]
    assert run.training_frames("flat_1").tolist() == [0, 3, 6]
    assert run.information("flat_1")[POOR[1]] == run.information("flat_1").min()
    regions = run.regions("flat_2", 3)
    assert len(regions) > 10 and (np.diff(regions[:, 3]) <= 0).all() and regions[:, 3].min() > 0
    assert run.descriptors("flat_2", "hog_y", [3]).counts.tolist() == [min(len(regions), 25)]
    assert run.codebook("hog_y", "flat_1").trees[0].centers(16).shape == (16, 129)


def test_frames_are_ordered_and_unique(made):
    run = Run(made)
    found = list(run.frames("flat_3", [5, 1, 5]))
    assert [index for index, _ in found] == [1, 5]
    for index, frame in found:
        np.testing.assert_array_equal(frame, run.frame("flat_3", index))
    with pytest.raises(PlacecatError, match="has frames 0 to 7"):
        run.frame("flat_3", FRAMES)


def test_saliency_matches_the_regions(made):
    run = Run(made)
    fused, regions = run.saliency("flat_1", 0), run.regions("flat_1", 0)
    x, y = (regions[:, :2] / 2**fused.scale).astype(int).T
    np.testing.assert_array_equal(fused.saliency[y, x], regions[:, 3])


def test_distributions_come_from_the_first_seed(made):
    run = Run(made)
    for cue in CUES:
        np.testing.assert_array_equal(run.proba(f"cues/{cue}/5-5-1", "flat_3"), made_run.proba("flat_3", cue))
    with pytest.raises(PlacecatError, match=r"no distributions of 'cues/gis/5-5-1'"):
        run.proba("cues/gis/5-5-1", "flat_3")
    with pytest.raises(PlacecatError, match=r"was not computed: run `dvc repro`"):
        run.proba("integration/das_551_best", "flat_3")
    with pytest.raises(PlacecatError, match=r"has no test home 'flat_9'"):
        run.proba("cues/gist/5-5-1", "flat_9")


def test_the_example_is_the_most_informative_frame_by_default(made):
    assert Run(made).example == RICHEST
    for own, expected in (
        ({"home": 2}, RICHEST),
        ({"home": 1, "frame": 6}, POOR),
        ({"home": 99, "frame": 0}, ("flat_3", 0)),
    ):
        made["figures"]["example"] = own
        assert Run(made).example == expected
    made["figures"]["example"] = {"home": 1, "frame": FRAMES}
    with pytest.raises(PlacecatError, match=r"figures\.example\.frame must be 0 to 7, not 8"):
        _ = Run(made).example
