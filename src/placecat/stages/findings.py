"""Stage `findings`: what the thesis claims, judged on what was measured."""

from pathlib import Path

import pandas as pd

from placecat import files, paths, settings
from placecat.reporting.collect import read_results
from placecat.reporting.findings import ledger
from placecat.reporting.published import Published
from placecat.stages import run


def main() -> None:
    """Write reports/findings.csv and reports/findings_comparisons.csv."""
    params = settings.load()
    findings, comparisons = ledger(
        settings.get(params, "findings"),
        settings.get(params, "verdict"),
        read_results(params),
        read_published(),
    )
    files.write_csv(paths.FINDINGS, findings)
    files.write_csv(paths.COMPARISONS, comparisons)


def read_published() -> Published:
    """Read the numbers of the thesis's tables and of its text."""
    return Published(
        _read(paths.PUBLISHED, ["group", "row", "column"]),
        _read(paths.PUBLISHED_TEXT, ["name", "section", "quantity", "home", "quote"]),
    )


def _read(path: Path, text: list[str]) -> pd.DataFrame:
    """Read published numbers; an empty cell of a column of text is ""."""
    return pd.read_csv(path, dtype=dict.fromkeys(text, str)).fillna(dict.fromkeys(text, ""))


if __name__ == "__main__":
    run(main)
