"""The stage `smoothing` uses the frame rates from the stage `sequences`."""

import json
import shutil

import numpy as np
import pytest
from made_features import HOMES, PARAMS, ran_once

from placecat.fusion.smoothing import apply, fit
from placecat.sequences import listing
from placecat.training import fold_file, protocol
from placecat.training.cue import Cue
from placecat.training.plan import of_homes, without_homes

MODEL = {name: value for name, value in PARAMS["smoothing"].items() if name not in ("cues", "filtered")}


@pytest.fixture(scope="module")
def project(tmp_path_factory):
    """A copy of the project after all stages; tests change its frame rates."""
    return shutil.copytree(ran_once(tmp_path_factory), tmp_path_factory.mktemp("project") / "copy")


def smooth(proba, frame_rate, **training):
    return apply(fit(**training), proba, [slice(0, 50), slice(50, 90)], frame_rate=frame_rate)


def smoothed(rates):
    """Smooth the first home after setting the frame rates of all homes."""
    from placecat import paths
    from placecat.training.saved import smooth_home

    for home, rate in zip(HOMES, rates, strict=True):
        facts = paths.sequences(home) / "home.json"
        facts.write_text(json.dumps(json.loads(facts.read_text()) | {"fps": rate}))
    plan = of_homes(PARAMS, "5-5-1")[0]
    return smooth_home(paths.CUES / f"gist/5-5-1/{plan.test}.no-seed.npz", plan, MODEL)


@pytest.mark.slow
def test_frame_rates_come_from_the_homes(project, monkeypatch):
    from placecat import paths
    from placecat.sequences import listing

    monkeypatch.chdir(project)
    place = paths.CUES / "gist/5-5-1/H1.no-seed.npz"
    walks = [listing.read_labels(home)[part] for home in HOMES[1:] for part in (slice(0, 50), slice(50, 90))]
    expected = smooth(
        fold_file.read(place, "test"),
        frame_rate=25.0,
        training_sequences=walks,
        training_frame_rates=[5.0, 5.0, 10.0, 10.0, 5.0, 5.0],
        training_proba=fold_file.read(place, "cross_validated"),
        training_truth=fold_file.read(place, "cross_validated_truth"),
        n_classes=3,
        **MODEL,
    )
    result = smoothed([25.0, 5.0, 10.0, 5.0])
    for name in ("hmm", "delayed"):
        np.testing.assert_array_equal(result[name], expected[name])
    # If all homes have the same rate, it affects only the delay, since transitions are per frame.
    slow, fast = smoothed([5.0] * 4), smoothed([30.0] * 4)
    np.testing.assert_array_equal(slow["hmm"], fast["hmm"])
    assert not np.allclose(slow["delayed"], fast["delayed"])
    assert not np.allclose(slow["hmm"], result["hmm"])


def test_a_training_home_is_smoothed_with_statistics_of_the_others(project, monkeypatch):
    """The result equals a direct call of `smooth` without this home and the test home."""
    from placecat import paths
    from placecat.choice.judging import judge_home, judge_smoothing, predict_unseen
    from placecat.errors import PlacecatError

    monkeypatch.chdir(project)
    smoothed([5.0] * 4)
    plan = of_homes(PARAMS, "5-5-1")[0]
    source = paths.CUES / f"gist/5-5-1/{plan.test}.no-seed.npz"
    frames, cue = PARAMS["protocol"]["cue_frames"], Cue.of(PARAMS, "gist")
    pairs = {home: (plan.test, home) for home in HOMES[1:]}
    unseen = {home: predict_unseen(without_homes(PARAMS, pair), cue)[home] for home, pair in pairs.items()}

    def judge():
        return judge_smoothing(MODEL, source, plan, unseen, 1e-6)

    judged = judge()
    assert [(test, home) for test, home, *_ in judged] == [
        (HOMES[0], home) for home in (*HOMES[1:], HOMES[0])
    ]
    last = HOMES[3]
    held_out, truth = (fold_file.read(source, name) for name in ("cross_validated", "cross_validated_truth"))
    others = len(truth) - len(protocol.select_frames(listing.read_labels(last), **frames))
    expected = smooth(
        unseen[last],
        frame_rate=5.0,
        training_sequences=[
            listing.read_labels(h)[p] for h in HOMES[1:3] for p in (slice(0, 50), slice(50, 90))
        ],
        training_frame_rates=[5.0] * 4,
        training_proba=held_out[:others],
        training_truth=truth[:others],
        n_classes=3,
        **MODEL,
    )
    assert judged[2][2:] == judge_home(last, expected["delayed"], 1e-6)
    tested = smoothed([5.0] * 4)["delayed"]
    assert judged[3][2:] == judge_home(plan.test, tested, 1e-6)
    fold_file.write(source, {"test": fold_file.read(source, "test")})
    with pytest.raises(PlacecatError, match="has no array cross_validated"):
        judge()
