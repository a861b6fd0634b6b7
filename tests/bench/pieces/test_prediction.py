import pytest
from made_system import frames, make_system

from placecat import paths
from placecat.categorizer import model_file
from placecat.errors import PlacecatError
from placecat_bench.frames import consecutive, size
from placecat_bench.pieces import prediction


def test_entries_and_targets(tmp_path, monkeypatch):
    model = tmp_path / "model.placecat"
    model_file.write(model, make_system(tracked=True))
    monkeypatch.setattr(paths, "MODEL", model)
    # Comparisons require five pairs. Everything else is measured once.
    monkeypatch.setattr(prediction, "REPEATS", 1)
    given = frames(8)
    whole, rate, *latencies, start = prediction.entries(frames=given)
    assert whole.input == "320x180 JPEG"
    assert [len(whole.ours()), len(whole.theirs())] == [8, 8]
    assert whole.ours()[-1].seconds == pytest.approx(7 / 5), "from a reset"
    median, almost_all, worst = (entry.measure() for entry in latencies)
    assert 0 < median <= almost_all <= worst
    assert rate.measure() > 0
    assert start.measure() > 0.1
    assert [entry.target for entry in (whole, rate, *latencies, start)] == [
        "at most 12x its time",
        "at least 30",
        *["at most 0.033"] * 3,
        "at most 2",
    ]


def test_a_missing_model_raises_an_error(tmp_path, monkeypatch):
    monkeypatch.setattr(paths, "MODEL", tmp_path / "model.placecat")
    with pytest.raises(PlacecatError, match="does not exist: run `make repro`"):
        next(prediction.entries())


@pytest.mark.slow
def test_consecutive_frames_differ():
    first, second = consecutive(2)
    assert size(first) == size(second) == "1280x720"
    assert (first != second).any()
