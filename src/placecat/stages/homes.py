"""Stage `homes`: draw the stand-in homes that the project runs on where there are no others."""

from pathlib import Path

from placecat import settings
from placecat.sequences.sketch import draw_homes
from placecat.stages import run


def main() -> None:
    """Draw data/homes."""
    settings.call(
        draw_homes, Path("data/homes"), settings=settings.get(settings.load(), "sketch"), where="sketch"
    )


if __name__ == "__main__":
    run(main)
