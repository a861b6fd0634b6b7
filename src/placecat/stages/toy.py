"""Stage `toy`: compare the parallel and sequential schemes on the toy problem of thesis 4.8."""

import copy
from collections.abc import Mapping
from typing import Any

import numpy as np
import pandas as pd

from placecat import files, paths, seeds, settings
from placecat.compute import parallel
from placecat.cues import estimators
from placecat.evaluation.accuracy import confusion_matrix
from placecat.learning.toy_circles import NAMES, toy_circles
from placecat.results.measured import SCORE_COLUMNS, Measured, score_rows
from placecat.stages import run


def main() -> None:
    """For each seed, train the schemes on random points and test them on new points.

    The results are named ``toy/parallel`` and ``toy/sequential``. Those in ``toy/last/...`` count only points
    of the class that the sequential scheme decides last. Results with other radii and decision rules are
    named ``toy/RADIUS/parallel`` and ``toy/RADIUS/sequential/DECISION``.
    """
    toy = settings.get(settings.load(), "toy")
    numbers = toy["training"], toy["testing"]
    tasks = [(toy["schemes"], toy["points"], *numbers, seed) for seed in toy["seeds"]]
    for radius in toy["sensitivity"]["radii"]:
        own = _deciding(toy["schemes"], toy["sensitivity"]["decisions"], float(radius))
        points = toy["points"] | {"radius": radius}
        tasks += [(own, points, *numbers, seed) for seed in toy["sensitivity"]["seeds"]]
    found: dict[str, dict[str, np.ndarray]] = {}
    done = parallel.in_parallel(compare, tasks, "toy problem")
    for (schemes, *_, number), confusions in zip(tasks, done, strict=True):
        for name, counts in confusions.items():
            if schemes is toy["schemes"] or not name.startswith("last/"):
                found.setdefault(f"toy/{name}", {})[paths.seed_name(number)] = counts
    rows = []
    for name, of_seeds in found.items():
        counts = np.array(list(of_seeds.values()))[:, None]
        rows += score_rows(name, Measured(("toy",), tuple(of_seeds), NAMES, counts))
    files.write_csv(paths.TOY, pd.DataFrame(rows, columns=SCORE_COLUMNS))


def _deciding(schemes: Mapping[str, Any], decisions: list[str], radius: float) -> dict[str, Any]:
    """Return the parallel scheme, and the sequential one with each decision rule, named after the radius."""
    found = {f"{radius:g}/parallel": schemes["parallel"]}
    for decision in decisions:
        found[name := f"{radius:g}/sequential/{decision}"] = copy.deepcopy(schemes["sequential"])
        found[name]["scheme"]["decision"] = decision
    return found


def compare(
    schemes: Mapping[str, Any], points: Mapping[str, float], training: int, testing: int, seed: int
) -> dict[str, np.ndarray]:
    """Return the confusion matrix of each scheme on the test points of a seed.

    ``last/SCHEME`` counts only points of the class that the sequential scheme decides last.
    """
    X, y = toy_circles(training, seeds.derive("toy", "training", seed), **points)
    X_test, y_test = toy_circles(testing, seeds.derive("toy", "testing", seed), **points)
    found, last = {}, -1
    for name, classifier in schemes.items():
        base = estimators.build(classifier["base"], "toy.base")
        model = estimators.build(classifier["scheme"], "toy.scheme", base=base).fit(X, y)
        found[name] = confusion_matrix(y_test, model.predict(X_test), len(NAMES))
        if hasattr(model, "order_"):
            last = int(model.order_[-1])
    of_last = (np.arange(len(NAMES)) == last)[:, None]
    both = ({name: counts, f"last/{name}": counts * of_last} for name, counts in found.items())
    return {name: counts for pair in both for name, counts in pair.items()}


if __name__ == "__main__":
    run(main)
