"""Stage `site_sequences`: list and check the sequences in the data sets of the splits (thesis 4.9, 4.10)."""

from placecat import files, paths, settings
from placecat.stages import run
from placecat.stages.sequences import list_homes


def main() -> None:
    """Write frames.csv, labels.csv and home.json for every sequence in the data sets of the splits."""
    with files.replacing(paths.SITE_SEQUENCES) as folder:
        for split, own in settings.get(settings.load(), "splits").items():
            list_homes(own["dataset"], folder / split, f"splits.{split}.dataset")


if __name__ == "__main__":
    run(main)
