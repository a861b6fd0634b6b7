"""Stage `site_features`: describe every sequence in the data sets of the splits (thesis 4.9 and 4.10)."""

from pathlib import Path

from placecat import paths, settings
from placecat.runs import items
from placecat.stages import run
from placecat.stages.features import describe, feature_options, inputs, plan


def main() -> None:
    """Describe all frames of every sequence in the data sets of the splits."""
    params = settings.load()
    splits = settings.get(params, "splits")
    items.keep_only(paths.SITE_FEATURES, splits)
    for split, definition in splits.items():
        descriptors = {
            kind: {name: settings.get(params, f"descriptors.{kind}.{name}") for name in names}
            for kind, names in definition["descriptors"].items()
        }
        options, root = feature_options(params, descriptors), Path(definition["dataset"]["root"])

        def work(sequence: str) -> items.Work:
            return plan(f"{split}/{sequence}", root, options)  # noqa: B023  called in this iteration

        sequences = {name: inputs(f"{split}/{name}", options) for name in definition["dataset"]["homes"]}
        items.refresh_together("site_features", paths.SITE_FEATURES / split, sequences, describe, work)


if __name__ == "__main__":
    run(main)
