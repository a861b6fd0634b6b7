"""Stage `site_features`: the descriptors of every sequence of the further data sets (thesis 4.9 and 4.10)."""

from pathlib import Path

from placecat import items, paths, settings
from placecat.stages import run
from placecat.stages.features import describe_home, feature_options, inputs


def main() -> None:
    """Describe all frames of every sequence of the data set of every split."""
    params = settings.load()
    splits = settings.get(params, "splits")
    items.keep_only(paths.SITE_FEATURES, splits)
    for split, own in splits.items():
        wanted = {
            kind: {name: settings.get(params, f"descriptors.{kind}.{name}") for name in names}
            for kind, names in own["descriptors"].items()
        }
        options, root = feature_options(params, wanted), Path(own["dataset"]["root"])

        def make(sequence: str, folder: Path) -> None:
            describe_home(f"{split}/{sequence}", root, options, folder)  # noqa: B023  called in this turn

        sequences = {name: inputs(f"{split}/{name}", options) for name in own["dataset"]["homes"]}
        items.refresh("site_features", paths.SITE_FEATURES / split, sequences, make)


if __name__ == "__main__":
    run(main)
