"""Store the results of a cue or system for one test home and seed.

Arrays go in one file, and facts in another. A result has no folder of its own, because DVC takes about a
millisecond per folder.
"""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat import files, paths


def path_of(folder: Path, home: str, seed: str) -> Path:
    """Return the file in a results folder for a test home and a seed, such as ``seed-0``."""
    return folder / f"{home}.{seed}.npz"


def seeded(folder: Path, home: str, seed: int | None) -> Path:
    """Return the file for one seed, or the only file if the result is not random."""
    fixed = path_of(folder, home, paths.NO_SEED)
    return fixed if fixed.exists() else path_of(folder, home, paths.seed_name(seed))


def seeds_in(folder: Path, home: str) -> list[str]:
    """List the seeds that have results for a test home: ``seed-0``, ``seed-1`` ..., or only ``no-seed``."""
    parts = [path.stem.rpartition(".") for path in folder.glob("*.npz")]
    return sorted(seed for of, _, seed in parts if of == home)


def write(path: Path, arrays: Mapping[str, NDArray[Any]], facts: Mapping[str, Any] | None = None) -> None:
    """Write the arrays, and the facts unless they are None."""
    files.write_arrays(path, arrays)
    if facts is not None:
        files.write_json(path.with_suffix(".json"), facts)


def has(path: Path, name: str) -> bool:
    """Return whether the file exists and contains an array with this name."""
    if not path.exists():
        return False
    with np.load(path, allow_pickle=False) as archive:
        return name in archive


def read(path: Path, name: str) -> NDArray[Any]:
    """Read one array. Raise FileNotFoundError or KeyError if `has` returns False."""
    with np.load(path, allow_pickle=False) as archive:
        return archive[name]


def read_facts(path: Path) -> dict[str, Any]:
    """Read the facts stored by :func:`write`."""
    return files.read_json(path.with_suffix(".json"))
