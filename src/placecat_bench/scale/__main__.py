"""The command line ``python -m placecat_bench.scale``, to be run in the project's folder."""

import argparse
from pathlib import Path

import placecat.stages  # noqa: F401 before NumPy: chooses the OpenBLAS kernels
from placecat.errors import exiting


def main() -> None:
    """Run the command. On a user error, print a message and exit with status 1."""
    from placecat import paths

    parser = argparse.ArgumentParser(
        prog="python -m placecat_bench.scale",
        description="Run the stages on as many frames as the thesis's home database has, with features drawn "
        "from the outputs of `make repro`. Write the time that each stage takes, how it grows, and the "
        "memory used.",
    )
    parser.add_argument(
        "--sizes",
        nargs="+",
        type=float,
        metavar="PART",
        help="fractions of the number of frames; default: those in conf/scale.yaml",
    )
    parser.add_argument("--stages", nargs="+", metavar="STAGE", help="default: conf/scale.yaml")
    parser.add_argument(
        "--folder", type=Path, default=paths.SCALE, help=f"working folder, {paths.SCALE} by default"
    )
    parser.add_argument(
        "--add", action="store_true", help="keep the rows of other sizes in scale.csv, and fit them too"
    )
    parser.add_argument("--keep", action="store_true", help="keep the folders of all sizes")
    parser.add_argument("--output", type=Path, default=paths.REPORTS, help=f"{paths.REPORTS} by default")
    options = parser.parse_args()
    with exiting():
        from placecat_bench.scale import command

        command.run(**vars(options))


if __name__ == "__main__":
    main()
