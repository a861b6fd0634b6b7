"""Stage `site_sequences`: list and check the sequences of one further data set (thesis 4.9 and 4.10)."""

from placecat import paths, settings
from placecat.stages import run
from placecat.stages.sequences import list_homes


def main(split: str) -> None:
    """Write frames.csv, labels.csv and home.json of every sequence of one split's data set."""
    where = f"splits.{split}.dataset"
    list_homes(settings.get(settings.load(), where), paths.SITES / split / "sequences", where)


if __name__ == "__main__":
    run(main, item="split")
