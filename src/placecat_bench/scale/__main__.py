"""The command line: ``python -m placecat_bench.scale``, in the project's folder."""

import argparse
from pathlib import Path

import placecat.stages  # noqa: F401  before NumPy: it chooses the kernels of OpenBLAS
from placecat.errors import exiting


def main() -> None:
    """Build, run, measure and report; exit with a message and status 1 on a user error."""
    from placecat import paths

    parser = argparse.ArgumentParser(
        prog="python -m placecat_bench.scale",
        description="Run the stages on features of the size of the thesis's home database, drawn from those "
        "that `make repro` left, and write their time, their memory, and how both grow.",
    )
    parser.add_argument(
        "--sizes", nargs="+", type=float, metavar="PART", help="instead of the sizes in conf/scale.yaml"
    )
    parser.add_argument("--stages", nargs="+", metavar="STAGE", help="default: conf/scale.yaml")
    parser.add_argument(
        "--folder", type=Path, default=paths.SCALE, help=f"working folder, {paths.SCALE} by default"
    )
    parser.add_argument(
        "--add", action="store_true", help="keep the rows of other sizes in scale.csv, for the exponents"
    )
    parser.add_argument("--keep", action="store_true", help="keep the folders of all sizes")
    parser.add_argument("--output", type=Path, default=paths.REPORTS, help=f"{paths.REPORTS} by default")
    options = parser.parse_args()
    with exiting():
        from placecat_bench.scale import command

        command.run(**vars(options))


if __name__ == "__main__":
    main()
