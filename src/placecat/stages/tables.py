"""Stage `tables`: write all accuracies, and compare the numbers of the thesis with those of this run."""

import pandas as pd

from placecat import files, paths, settings
from placecat.provenance.origins import to_json
from placecat.report.formats import table_latex, table_markdown
from placecat.results.collect import read_results
from placecat.results.quality import quality_table
from placecat.stages import run
from placecat.thesis import in_text, notes, tables
from placecat.thesis.metrics import chosen_averages, nested_metrics, plot_data
from placecat.thesis.tables import dataset_of, tables_of


def main() -> None:
    """Write the tables (CSV, Markdown and LaTeX), reports/*.csv, metrics.json, summary.json and plots/."""
    params = settings.load()
    results = read_results(params)
    filled = {}
    # DVC requires the folder even if there are no optional tables.
    paths.OPTIONAL_TABLES.mkdir(parents=True, exist_ok=True)
    with files.replacing(paths.TABLES) as folder:
        for name, table in tables_of(params).items():
            dataset = dataset_of(table, params)
            filled[name] = tables.fill(table, results, params)
            target = paths.OPTIONAL_TABLES if "needs" in table else folder
            files.write_csv(target / f"{name}.csv", filled[name][tables.COLUMNS])
            files.write_text(target / f"{name}.md", table_markdown(table, filled[name], dataset))
            files.write_text(target / f"{name}.tex", table_latex(table, filled[name], dataset))
    files.write_csv(paths.ACCURACIES, results.accuracy_table())
    files.write_csv(paths.PROBABILITIES, quality_table(results.quality))
    said = in_text.fill(results, params)
    files.write_csv(paths.IN_TEXT, said[in_text.COLUMNS])
    origins = {name: to_json(table, results) for name, table in filled.items()}
    files.write_json(paths.ORIGINS, origins | {in_text.NAME: to_json(said, results, in_text.KEY)})
    of_tables = [notes.to_rows(name, table) for name, table in filled.items()]
    files.write_csv(paths.NOTES, pd.concat([*of_tables, notes.to_rows(in_text.NAME, said, in_text.KEY)]))
    files.write_json(paths.METRICS, nested_metrics(filled))
    files.write_json(paths.SUMMARY, chosen_averages(results, settings.load(paths.METRIC_DEFINITIONS)))
    with files.replacing(paths.PLOTS) as folder:
        for name, rows in plot_data(results, settings.load(paths.PLOT_DEFINITIONS)).items():
            files.write_csv(folder / name, rows)


if __name__ == "__main__":
    run(main)
