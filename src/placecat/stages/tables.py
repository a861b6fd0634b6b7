"""Stage `tables`: accuracies of everything in every home, and the thesis's tables filled with them."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from placecat import files, listing, paths, settings
from placecat.evaluation.accuracy import confusion_matrix
from placecat.reporting.markdown import table_markdown
from placecat.reporting.results import Results
from placecat.reporting.tables import fill_table
from placecat.stages import run


def main() -> None:
    """Write every table as CSV and Markdown, reports/accuracies.csv and reports/cross_validation.csv."""
    params = settings.load()
    dataset = settings.get(params, "dataset")
    homes = tuple(dataset["homes"])
    n_classes = len(dataset["classes"])
    labels = {home: listing.read_labels(home) for home in homes}
    confusion = {}
    for name, path_of in _results(params).items():
        decisions = [files.read_array(path_of(home), memory_map=False).argmax(axis=1) for home in homes]
        confusion[name] = np.stack(
            [
                confusion_matrix(labels[home], decision, n_classes)
                for home, decision in zip(homes, decisions, strict=True)
            ]
        )
    results = Results(homes, tuple(dataset["classes"]), confusion)
    published = pd.read_csv(paths.PUBLISHED, dtype={"group": str, "row": str, "column": str}).fillna(
        {"group": "", "row": "", "column": ""}
    )
    with files.replacing(paths.TABLES) as folder:
        for name, table in settings.get(params, "tables").items():
            filled = fill_table(table, results, published, dataset)
            files.write_csv(folder / f"{name}.csv", filled)
            files.write_text(folder / f"{name}.md", table_markdown(table, filled, dataset))
    files.write_csv(paths.ACCURACIES, results.long_table())
    files.write_csv(paths.CROSS_VALIDATION, _cross_validation(params))


def _cross_validation(params: dict[str, Any]) -> pd.DataFrame:
    """Accuracy on training homes that the model in question did not see: what settings may be chosen by."""
    homes = settings.get(params, "dataset.homes")
    folders = {
        f"cues/{cue}/{scheme}": paths.CUES / cue / scheme
        for cue, options in settings.get(params, "cues").items()
        for scheme in options["schemes"]
    }
    folders |= {
        f"integration/{system}": paths.INTEGRATION / system for system in settings.get(params, "systems")
    }
    rows = []
    for name, folder in folders.items():
        for test in homes:
            by_home = files.read_json(folder / test / "facts.json").get("cross_validated_accuracy", {})
            rows += [(name, test, home, accuracy) for home, accuracy in by_home.items()]
    return pd.DataFrame(rows, columns=["result", "test_home", "training_home", "accuracy"])


def _results(params: dict[str, Any]) -> dict[str, Callable[[str], Path]]:
    """Every result that the pipeline leaves on disk: its name, and where a home's distributions are."""
    found: dict[str, Callable[[str], Path]] = {}

    def add(name: str, folder: Path, array: str) -> None:
        found[name] = lambda home: folder / home / f"{array}.npy"

    for cue, options in settings.get(params, "cues").items():
        for scheme in options["schemes"]:
            add(f"cues/{cue}/{scheme}", paths.CUES / cue / scheme, "test")
    for system in settings.get(params, "systems"):
        add(f"integration/{system}", paths.INTEGRATION / system, "test")
    for name in [*settings.get(params, "systems"), *settings.get(params, "smoothing.cues")]:
        add(f"hmm/{name}", paths.SMOOTHING / name, "hmm")
        add(f"smoothing/{name}", paths.SMOOTHING / name, "delayed")
    return found


if __name__ == "__main__":
    run(main)
