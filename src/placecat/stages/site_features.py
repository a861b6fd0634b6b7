"""Stage `site_features`: the descriptors of every sequence of one further data set (thesis 4.9 and 4.10)."""

from pathlib import Path

from placecat import settings
from placecat.stages import run
from placecat.stages.features import describe_home, feature_options


def main(split: str) -> None:
    """Describe all frames of every sequence of one split's data set."""
    params = settings.load()
    own = settings.get(params, f"splits.{split}")
    wanted = {
        kind: {name: settings.get(params, f"descriptors.{kind}.{name}") for name in names}
        for kind, names in own["descriptors"].items()
    }
    options = feature_options(params, wanted)
    for sequence in own["dataset"]["homes"]:
        describe_home(f"{split}/{sequence}", Path(own["dataset"]["root"]), options)


if __name__ == "__main__":
    run(main, item="split")
