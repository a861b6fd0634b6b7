"""Stage `findings`: compare the claims of the thesis with the measurements."""

from placecat import files, paths, settings
from placecat.results.collect import read_results
from placecat.stages import run
from placecat.thesis import definitions
from placecat.thesis.findings import ledger
from placecat.thesis.published import read_published


def main() -> None:
    """Write reports/findings.csv and reports/findings_comparisons.csv."""
    params = settings.load()
    findings, comparisons, _ = ledger(
        definitions.findings(), settings.get(params, "verdict"), read_results(params), read_published()
    )
    files.write_csv(paths.FINDINGS, findings)
    files.write_csv(paths.COMPARISONS, comparisons)


if __name__ == "__main__":
    run(main)
