"""`python -m placecat.choice [KIND ...]`: choose settings on training homes (conf/choice.yaml)."""

import sys

import placecat.stages  # noqa: F401 before NumPy: chooses the OpenBLAS kernels
from placecat import compute
from placecat.choice.command import KINDS, run, text
from placecat.errors import exiting


def main() -> None:
    """Judge the candidates of the named kinds or, by default, of all kinds."""
    kinds = tuple(sys.argv[1:]) or KINDS
    for kind in kinds:
        if kind not in KINDS:
            sys.exit(f"placecat: {kind!r} does not exist: choose from {', '.join(KINDS)}")
    with exiting(), compute.as_set():
        print(text(run(kinds)))


if __name__ == "__main__":
    main()
