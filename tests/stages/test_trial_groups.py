"""Trials of several studies that share computations."""

import json

from made_features import HOMES, PARAMS

from placecat.compute import parallel
from placecat.evaluation.trials import Trial
from placecat.stages.trials import Outcomes

GIST = {"kind": "holistic", "name": "gist"}


def clustered(clusters, cells=1):
    classifier = {"model": "knn", "clusters": clusters}
    return {
        "descriptor": GIST,
        "classifier": classifier,
        "codebook": {"cells": cells, "tree": {"name": "it"}},
    }


def machines(nu, scaling="none", exclusive=True):
    base, scheme = {"name": "nu_svm", "nu": nu}, {"name": "one_against_all", "exclusive": exclusive}
    classifier = {"model": "one_against_all", "base": base, "scheme": scheme, "scaling": scaling}
    return {"descriptor": GIST, "classifier": classifier}


def test_equal_clusters_or_samples_are_one_task_across_studies(monkeypatch):
    tasks = []

    def stream(function, given, description):
        tasks.extend(given)
        for plan, cues, seed in given:
            yield [(f"{plan.test} {json.dumps(cue.classifier, sort_keys=True)} {seed}", {}) for cue in cues]

    monkeypatch.setattr(parallel, "stream", stream)
    one_home = HOMES[:1]
    studies = [
        [Trial("a", clustered(4), one_home), Trial("b", machines(0.1), one_home)],
        [
            Trial("c", clustered(7), HOMES),
            Trial("d", clustered(4), HOMES),
            Trial("e", clustered(4, 2), one_home),
        ],
        [Trial("f", machines(0.2, exclusive=False), HOMES), Trial("g", machines(0.1, "unit"), one_home)],
    ]
    outcomes = Outcomes(PARAMS)
    outcomes.plan(studies)
    seeds = PARAMS["protocol"]["seeds"]
    for trial in (trial for trials in studies for trial in trials):
        found = outcomes.of(trial)
        of_seeds = seeds if "codebook" in trial.settings else [None]
        assert list(found) == [(trial.key(), home, seed) for home in trial.homes for seed in of_seeds]
        for (_, home, seed), (text, _) in found.items():
            assert text == f"{home} {json.dumps(trial.settings['classifier'], sort_keys=True)} {seed}"
    outcomes.end()
    # Per seed, there is a task for the clusters of each home and one for the clusters with two cells. Without
    # seeds, there is a task for the machines of each home and one for another scaling.
    assert len(tasks) == len(seeds) * (len(HOMES) + 1) + len(HOMES) + 1
    assert [len(cues) for _, cues, _ in tasks[: len(seeds) + 1]] == [2] * (len(seeds) + 1)
