"""Stage `findings`: judge the thesis's claims by the measurements."""

from placecat import files, paths, settings
from placecat.results.collect import read_results
from placecat.stages import run
from placecat.thesis import definitions
from placecat.thesis.findings import ledger
from placecat.thesis.published import Published


def main() -> None:
    """Write reports/findings.csv and reports/findings_comparisons.csv."""
    params = settings.load()
    findings, comparisons = ledger(
        definitions.findings(), settings.get(params, "verdict"), read_results(params), read_published()
    )
    files.write_csv(paths.FINDINGS, findings)
    files.write_csv(paths.COMPARISONS, comparisons)


def read_published() -> Published:
    """Read the numbers of the thesis's tables and text."""
    return Published(
        files.read_table(paths.PUBLISHED, ["group", "row", "column"]),
        files.read_table(paths.PUBLISHED_TEXT, ["name", "section", "quantity", "home", "quote"]),
    )


if __name__ == "__main__":
    run(main)
