"""Stage `tables`: accuracies of everything, and the numbers of the thesis beside those of this run."""

import shutil
from pathlib import Path
from typing import Any

import pandas as pd

from placecat import files, paths, settings
from placecat.reporting.collect import read_results
from placecat.reporting.in_text import in_text
from placecat.reporting.latex import table_latex
from placecat.reporting.markdown import table_markdown
from placecat.reporting.metrics import chosen_averages, nested_metrics, plot_data
from placecat.reporting.quality import quality_table
from placecat.reporting.results import Results
from placecat.reporting.sources import sources
from placecat.reporting.tables import dataset_of, fill_table, tables_of
from placecat.stages import run

# Results whose models were judged on training homes, in facts.json beside their distributions.
TRAINED = ("cues/", "integration/")
FORMS = ("csv", "md", "tex")


def main() -> None:
    """Write every table as CSV, Markdown and LaTeX, and reports/*.csv, metrics.json, summary.json, plots/."""
    params = settings.load()
    results = read_results(params)
    published = files.read_table(paths.PUBLISHED, ["group", "row", "column"])
    filled = {}
    with files.replacing(paths.TABLES) as folder:
        for name, table in tables_of(params).items():
            dataset = dataset_of(table, params)
            filled[name] = fill_table(table, results, published, dataset)
            files.write_csv(folder / f"{name}.csv", filled[name])
            files.write_text(folder / f"{name}.md", table_markdown(table, filled[name], dataset))
            files.write_text(folder / f"{name}.tex", table_latex(table, filled[name], dataset))
        for name in params.get("optional_tables", []):
            if name not in filled:
                _keep(name, folder)
    files.write_csv(paths.ACCURACIES, results.accuracy_table())
    files.write_csv(paths.CROSS_VALIDATION, _cross_validation(params))
    files.write_csv(paths.PROBABILITIES, quality_table(results.quality))
    files.write_csv(paths.IN_TEXT, _in_text(params, results))
    files.write_json(paths.METRICS, nested_metrics(filled))
    files.write_json(paths.SUMMARY, chosen_averages(results, settings.get(params, "metrics")))
    with files.replacing(paths.PLOTS) as folder:
        for name, rows in plot_data(results, settings.get(params, "plots")).items():
            files.write_csv(folder / name, rows)


def _keep(name: str, folder: Path) -> None:
    """Take over a table that another run has left: git keeps it, and this run cannot fill it."""
    for form in FORMS:
        path = paths.TABLES / f"{name}.{form}"
        if path.is_file():
            shutil.copyfile(path, folder / path.name)


def _in_text(params: dict[str, Any], results: Results) -> pd.DataFrame:
    entries = settings.get(params, "in_text")
    published = files.read_table(paths.PUBLISHED_TEXT, ["name", "section", "quantity", "home", "quote"])
    return in_text(entries, results, published, settings.get(params, "dataset"))


def _cross_validation(params: dict[str, Any]) -> pd.DataFrame:
    """Accuracy on training homes that the model in question did not see: what settings may be chosen by."""
    rows = [
        (name, test, seed, home, accuracy)
        for name, source in sources(params).items()
        if name.startswith(TRAINED)
        for test in source.homes
        for seed in source.seeds()
        for home, accuracy in files.read_json(source.folder / test / seed / "facts.json")
        .get("cross_validated_accuracy", {})
        .items()
    ]
    return pd.DataFrame(rows, columns=["result", "test_home", "seed", "training_home", "accuracy"])


if __name__ == "__main__":
    run(main)
