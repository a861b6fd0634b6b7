"""Stage `toy`: the parallel against the sequential scheme on the toy problem of thesis 4.8."""

from collections.abc import Mapping
from typing import Any

import numpy as np
import pandas as pd

from placecat import files, parallel, paths, seeds, settings
from placecat.cues import estimators
from placecat.evaluation.accuracy import confusion_matrix
from placecat.learning.toy_circles import NAMES, toy_circles
from placecat.reporting.results import SCORE_COLUMNS, Measured, score_rows
from placecat.stages import run


def main() -> None:
    """Train both schemes on each seed's points and test them on others."""
    toy = settings.get(settings.load(), "toy")
    tasks = [
        (toy["schemes"][scheme], toy["points"], toy["training"], toy["testing"], seed)
        for scheme in toy["schemes"]
        for seed in toy["seeds"]
    ]
    confusions = iter(parallel.in_parallel(compare, tasks, "toy problem"))
    rows = []
    names = tuple(f"seed-{seed}" for seed in toy["seeds"])
    for scheme in toy["schemes"]:
        counts = np.array([[next(confusions)] for _ in names])
        rows += score_rows(f"toy/{scheme}", Measured(("toy",), names, NAMES, counts))
    files.write_csv(paths.TOY, pd.DataFrame(rows, columns=SCORE_COLUMNS))


def compare(
    classifier: Mapping[str, Any], points: Mapping[str, float], training: int, testing: int, seed: int
) -> np.ndarray:
    """Confusion matrix of one scheme on the test points of one seed."""
    X, y = toy_circles(training, seeds.derive("toy", "training", seed), **points)
    X_test, y_test = toy_circles(testing, seeds.derive("toy", "testing", seed), **points)
    base = estimators.build(classifier["base"], "toy.base")
    model = estimators.build(classifier["scheme"], "toy.scheme", base=base).fit(X, y)
    return confusion_matrix(y_test, model.predict(X_test), len(NAMES))


if __name__ == "__main__":
    run(main)
