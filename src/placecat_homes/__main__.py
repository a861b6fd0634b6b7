"""``python -m placecat_homes [VIDEO ...]``: render the videos that come with the project."""

import argparse
import sys
from collections.abc import Sequence

import placecat.stages  # noqa: F401  before NumPy: it chooses the kernels of OpenBLAS
from placecat.errors import PlacecatError


def main(arguments: Sequence[str] | None = None) -> None:
    """Render the videos named, or all; a mistake of the user's ends with its message and status 1."""
    parser = argparse.ArgumentParser(
        prog="python -m placecat_homes",
        description="Render videos of data/ again, which takes an hour or more for all, and draw the contact "
        "sheet. Needs the optional extra: pip install -e '.[render]'.",
    )
    parser.add_argument("videos", nargs="*", metavar="VIDEO", help="e.g. homes/home_1; by default all")
    options = parser.parse_args(arguments)
    try:
        from placecat_homes.render import render

        render(options.videos)
    except PlacecatError as error:
        sys.exit(f"placecat: {error}")
    except KeyboardInterrupt:
        sys.exit(130)


if __name__ == "__main__":
    main()
