"""Run the benchmark: measure the pieces one by one and write the results to a file."""

import platform
from collections.abc import Sequence
from importlib.metadata import version
from pathlib import Path

import pandas as pd
from tqdm import tqdm

from placecat import files, paths
from placecat.compute.parallel import single_threaded
from placecat.errors import PlacecatError
from placecat.report.benchmarks import TEXT
from placecat_bench import pieces
from placecat_bench.measure import ABSENT, COLUMNS, measure

_MODULE = "module"


def run(chosen: Sequence[str], target: Path = paths.BENCHMARKS) -> pd.DataFrame:
    """Measure pieces on one thread. Rows are written after each piece; the rows of other pieces are kept.

    `chosen` lists names of modules in :mod:`placecat_bench.pieces`; if empty, all are measured. `target` is
    the CSV file; facts about the machine and packages go to a JSON file of the same name. Returns the
    contents of the CSV file, which has the columns ``module`` and :data:`placecat_bench.measure.COLUMNS`.
    Raises PlacecatError if a piece is unknown, a peer is missing, or kept rows were measured on another
    machine or with other packages.
    """
    all_names, facts, facts_file = pieces.names(), _facts(), target.with_suffix(".json")
    generators = {name: pieces.load(name) for name in dict.fromkeys(chosen or all_names)}
    table = pd.DataFrame(columns=[_MODULE, *COLUMNS])
    if target.is_file() and set(all_names) - set(generators):
        if files.read_json(facts_file) != facts:
            raise PlacecatError(
                f"{target} was measured on another machine or with other packages (see {facts_file}): "
                "measure all pieces"
            )
        before = files.read_table(target, TEXT)
        table = before[before[_MODULE].isin(all_names)]
    for name, entries in generators.items():
        rows = pd.DataFrame(single_threaded(_measure_piece, (name, entries)), columns=table.columns)
        others = table[table[_MODULE] != name]
        # Sort by piece, but keep the order of rows within a piece.
        table = pd.concat([others, rows]) if len(others) else rows
        table = table.sort_values(_MODULE, kind="stable", ignore_index=True)
        files.write_csv(target, table)
        files.write_json(facts_file, facts)
    return table


def _measure_piece(name: str, entries: pieces.Entries) -> list[dict[str, object]]:
    rows = []
    for entry in tqdm(entries(), desc=name, unit="entry"):
        row = {_MODULE: name} | measure(entry)
        tqdm.write(summary(row))
        rows.append(row)
    return rows


def summary(row: dict[str, object]) -> str:
    """Summarise a measured row on one line."""
    what = ", ".join(str(row[name]) for name in ("piece", "input") if row[name])
    if row["met"] == ABSENT:
        return f"{what}: {row['peer']} {ABSENT}: {row['spent']}"
    if row["ratio"] is None:
        value = f"{row['quantity']} {row['ours']}"
    else:
        value = (
            f"{row['ours']} s, {row['peer']} {row['peer_version']} {row['theirs']} s, ratio {row['ratio']}"
        )
    return f"{what}: {value} (target: {row['target']}, {'met' if row['met'] == 'yes' else 'MISSED'})"


def _facts() -> dict[str, str]:
    """Return the facts that the numbers depend on, except peer versions."""
    processor = Path("/proc/cpuinfo")
    lines = processor.read_text(encoding="utf-8").splitlines() if processor.exists() else []
    model = next((line.partition(":")[2].strip() for line in lines if line.startswith("model name")), "")
    packages = ("numpy", "opencv-python-headless", "scikit-learn", "scipy")
    return {
        "processor": model or platform.processor(),
        "python": platform.python_version(),
        "packages": ", ".join(f"{name} {version(name)}" for name in packages),
    }
