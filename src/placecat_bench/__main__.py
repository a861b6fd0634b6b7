"""``python -m placecat_bench [PIECE ...]``: measure pieces and write reports/benchmarks.csv."""

import argparse
import os
from collections.abc import Sequence

import placecat.stages  # noqa: F401 before NumPy: chooses the OpenBLAS kernels
from placecat import paths
from placecat.errors import exiting


def main(arguments: Sequence[str] | None = None) -> None:
    """Measure the named pieces or, by default, all pieces."""
    parser = argparse.ArgumentParser(
        prog="python -m placecat_bench",
        description="Time each piece against its best alternative, on one thread, and write "
        f"{paths.BENCHMARKS}. If pieces are named, only their rows are replaced.",
    )
    parser.add_argument("pieces", nargs="*", metavar="PIECE", help="a piece to measure (default: all pieces)")
    options = parser.parse_args(arguments)
    # Some libraries, such as the OpenMP that peers use, read this variable on import.
    os.environ["OMP_NUM_THREADS"] = "1"
    from placecat_bench.run import run

    with exiting():
        run(options.pieces)


if __name__ == "__main__":
    main()
