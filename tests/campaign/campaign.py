"""`make campaign`: try damaged inputs, killed runs, full disks and concurrent runs, for a given time.

The campaign has a seed, and continues where an earlier call with the same seed stopped. The outcome of each
case goes to data/campaign.csv, and the counts go to reports/robustness.csv.
"""

import argparse
import csv
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
import pandas as pd

ROOT = Path(__file__).resolve().parents[2]
CASES, REPORT = ROOT / "data/campaign.csv", ROOT / "reports/robustness.csv"
COLUMNS = ["seed", "part", "number", "outcome", "said"]
PARTS = ("models", "pictures", "videos", "labels", "settings", "kills", "two_at_once", "disk_full")
SHOWN = 200
"""Maximum number of characters of a message."""


def main(arguments=None):
    """Try every part for its share of the time. Print the counts and the errors."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seconds", type=float, default=1800, help="for all parts together")
    parser.add_argument("--most", type=int, default=1000, help="cases of each part")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument(
        "--parts", nargs="+", choices=PARTS, default=PARTS, metavar="PART", help=", ".join(PARTS)
    )
    parser.add_argument("--cases", type=Path, default=CASES, help=argparse.SUPPRESS)
    parser.add_argument("--report", type=Path, default=REPORT, help=argparse.SUPPRESS)
    parser.add_argument("--inside", action="store_true", help=argparse.SUPPRESS)
    options = parser.parse_args(arguments)
    if options.inside:
        _try(options.parts[0], options)
        return
    peaks = {part: _in_a_process(part, options) for part in options.parts}
    table = count(options.cases, options.seed, peaks)
    table.to_csv(options.report, index=False, lineterminator="\n")
    print(table.to_string(index=False))
    print(_bad(options.cases, options.seed))


def count(cases, seed, peaks):
    """Count the outcomes, one row per part. Include the peak memory in MB if it is known."""
    found = pd.read_csv(cases, dtype={"said": str})
    found = found[found["seed"] == seed]
    rows = []
    for part in PARTS:
        own = found[found["part"] == part]["outcome"].value_counts()
        if not own.empty:
            each = {name: int(own.get(name, 0)) for name in ("right", "message", "traceback", "wrong")}
            rows.append({"part": part, "tried": int(own.sum())} | each | {"peak_mb": peaks.get(part)})
    return pd.DataFrame(rows).assign(seed=seed)


def _in_a_process(part, options):
    """Try a part in a separate process. Start again after a crash. Return its peak memory in MB."""
    end = time.monotonic() + options.seconds / len(options.parts)
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
    while (left := end - time.monotonic()) > 0 and _done(part, options) < options.most:
        given = ["--seconds", left, "--most", options.most, "--seed", options.seed, "--cases", options.cases]
        command = [sys.executable, __file__, "--inside", *map(str, given), "--parts", part]
        done = subprocess.run(command, check=False)
        if done.returncode == 0:
            break
        _add(part, options, "traceback", f"the process ended with status {done.returncode}")
    after = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
    # This is the maximum over all processes so far.
    return after // 1024 if after > before else None


def _try(part, options):
    sys.path[:0] = [str(ROOT / "tests" / name) for name in (".", "categorizer", "runs")]
    # Imported only in this process, because these modules load everything that is tried.
    import damaged_inputs
    import disturbed_runs

    end = time.monotonic() + options.seconds
    with tempfile.TemporaryDirectory() as folder:
        try:
            kind = (damaged_inputs.KINDS | disturbed_runs.KINDS)[part](Path(folder) / part)
        except RuntimeError as error:
            print(f"{part} is left out: {error}")
            return
        while (number := _done(part, options)) < options.most and time.monotonic() < end:
            seed = [options.seed, PARTS.index(part), number]
            _add(part, options, *kind.attempt(np.random.default_rng(seed)))


def _done(part, options):
    """Return the number of cases of a part that earlier calls have tried."""
    if not options.cases.exists():
        return 0
    with options.cases.open(newline="", encoding="utf-8") as file:
        return sum(row[:2] == [str(options.seed), part] for row in csv.reader(file))


def _add(part, options, outcome, said):
    options.cases.parent.mkdir(parents=True, exist_ok=True)
    is_new = not options.cases.exists()
    row = [options.seed, part, _done(part, options), outcome, ascii(said)[:SHOWN]]
    with options.cases.open("a", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerows([COLUMNS, row] if is_new else [row])


def _bad(cases, seed):
    """Return the first cases of each part that ended in a traceback or a wrong result."""
    found = pd.read_csv(cases, dtype={"said": str})
    bad = found[(found["seed"] == seed) & found["outcome"].isin(["traceback", "wrong"])]
    return bad.groupby("part").head(5)[["part", "number", "outcome", "said"]].to_string(index=False)


if __name__ == "__main__":
    main()
