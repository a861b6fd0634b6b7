from math import log

import numpy as np
import pytest

from placecat.evaluation.smoothed_homes import TrainingHome, judge_smoothing
from placecat.fusion.smoothing import Smoother, fit

SMOOTHING = {
    "delay_seconds": 3.0,
    "evidence": "hard",
    "evidence_seconds": 1.0,
    "reliability": "hard",
    "transition_counts": 1.0,
    "emission_counts": 1.0,
}


def home(seed, frame_rate=5.0):
    rng = np.random.default_rng(seed)
    labels = np.repeat(rng.permutation([0, 1, 2, -1, 0, 2, 1, -1]), rng.integers(5, 15, 8)).astype(np.int16)
    taken = np.arange(0, len(labels), 3)
    rows = taken[labels[taken] >= 0]
    proba = 0.4 * rng.dirichlet(np.ones(3), len(rows)) + 0.6 * np.eye(3)[labels[rows]]
    cut = len(labels) // 2
    parts = [slice(0, cut), slice(cut, len(labels))]
    return TrainingHome(labels, parts, frame_rate, rows, 3, proba)


@pytest.fixture
def homes():
    return {name: home(seed) for seed, name in enumerate("abc")}


def judge(homes, **changes):
    return judge_smoothing(homes, 3, smoothing=SMOOTHING | changes, smallest=1e-15)


def test_each_home_is_smoothed_with_statistics_of_the_others_in_the_time_that_was_filmed(homes):
    """Against the smoother of single frames, fed by hand."""
    accuracy, log_loss = judge(homes, delay_seconds=2.0)["b"]
    own, others = homes["b"], [homes["a"], homes["c"]]
    model = fit(
        [other.labels[part] for other in others for part in other.sequences],
        np.vstack([other.proba for other in others]),
        np.hstack([other.labels[other.rows] for other in others]),
        3,
        training_frame_rates=[5.0] * 4,
        **(SMOOTHING | {"delay_seconds": 2.0}),
    )
    right, losses = {0: [], 1: [], 2: []}, {0: [], 1: [], 2: []}
    for part in own.sequences:
        smoother, last = Smoother(model), None
        for n, row in enumerate(own.rows):
            if not part.start <= row < part.stop:
                continue
            seconds = 0.6 if last is None else (row - last) / 5.0
            _, result = smoother.step(own.proba[n], seconds)
            right[own.labels[row]].append(result.argmax() == own.labels[row])
            losses[own.labels[row]].append(-log(result[own.labels[row]]))
            last = row
    assert accuracy == pytest.approx(100 * np.mean([np.mean(v) for v in right.values()]))
    assert log_loss == pytest.approx(np.mean([np.mean(v) for v in losses.values()]))


def test_a_home_has_no_part_in_the_model_that_it_is_judged_by(homes):
    """Its other frames' labels change the transitions that the others are judged by, and only those."""
    labels = homes["a"].labels.copy()
    others = np.setdiff1d(np.arange(len(labels)), homes["a"].rows)
    labels[others] = np.random.default_rng(0).integers(0, 3, len(others))
    changed = homes | {"a": TrainingHome(**(vars(homes["a"]) | {"labels": labels}))}
    before, after = judge(homes), judge(changed)
    assert before["a"] == after["a"]
    for other in "bc":
        assert not np.isclose(before[other][1], after[other][1])


def test_homes_of_other_frame_rates_are_judged_in_seconds(homes):
    """The same frames, filmed twice as fast, with half the time constant."""
    fast = {name: TrainingHome(**(vars(one) | {"frame_rate": 10.0})) for name, one in homes.items()}
    for slow, quick in ((4.0, 2.0), (0.0, 0.0)):
        # The time that a frame is evidence for halves as well.
        judged = judge(homes, delay_seconds=slow, evidence_seconds=1.0)
        halved = judge(fast, delay_seconds=quick, evidence_seconds=0.5)
        for name in homes:
            np.testing.assert_allclose(judged[name], halved[name], rtol=1e-9)
