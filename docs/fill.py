"""Update the numbers in README.md and docs/ from the result files: ``python docs/fill.py``.

An HTML comment, invisible to readers, states where a number or a table comes from:

- ``12.3<!-- = EXPRESSION -->`` is a number. It keeps its number of decimals.
- ``<!-- block: EXPRESSION -->`` and ``<!-- end -->`` enclose a table.

Expressions call the functions below. All paths are relative to the project's folder.
"""

import re
from collections.abc import Iterable, Sequence
from pathlib import Path

import numpy as np
import pandas as pd

from placecat.replication import needed, options
from placecat.report.benchmarks import times

ROOT = Path(__file__).resolve().parents[1]
PAGES = (
    "README.md",
    "data/README.md",
    *(f"docs/{path.name}" for path in sorted((ROOT / "docs").glob("*.md"))),
)
REAL = "docs/real_homes"
MORE = "reports/replication"
ALL = "5-5-1, all cues"
BEST = "5-5-1, HOG+SIFT+Centrist+Gist+holistic Centrist"

ALONE, CHOSEN = "embedding alone", "what each fold's training homes choose of these 13 by smoothed frames"
REGRESSION, BOTH = (
    "logistic regression on the features (outside the project)",
    "pool of both and the embedding",
)
OWN_SHAPE = "Lite2 462x260"
POOL, GAIN = "The same and embedding, logarithmic opinion pool", "Gain of HMM over HMM on embedding, points"

_NUMBER = re.compile(r"(-?\d[\d,]*(?:\.(\d+))?)<!-- = (.+?) -->")
_BLOCK = re.compile(r"<!-- block: (.+?) -->\n(.*?)<!-- end -->", re.DOTALL)


def fill(text: str) -> str:
    """Replace every number and table marked by a comment with its value from the result files."""

    def number(match: re.Match[str]) -> str:
        value, decimals = _value(match[3]), len(match[2] or "")
        return f"{value:,.{decimals}f}<!-- = {match[3]} -->"

    def block(match: re.Match[str]) -> str:
        return f"<!-- block: {match[1]} -->\n{_value(match[1])}\n<!-- end -->"

    return _NUMBER.sub(number, _BLOCK.sub(block, text))


def main() -> None:
    """Fill every page in place."""
    for page in PAGES:
        path = ROOT / page
        text = path.read_text(encoding="utf-8")
        if fill(text) != text:
            path.write_text(fill(text), encoding="utf-8")
            print(f"{page}: numbers filled")


def _value(expression: str) -> object:
    # The pages are trusted as much as the code.
    return eval(expression, dict(globals()))


def _read(path: str) -> pd.DataFrame:
    return pd.read_csv(ROOT / path, dtype={"column": str})


def _markdown(head: Sequence[str], rows: Iterable[Sequence[str]], texts: int = 1) -> str:
    """Format a Markdown table: text in the first `texts` columns, numbers in the others."""
    rule = "|" + "---|" * texts + "---:|" * (len(head) - texts)
    return "\n".join(["| " + " | ".join(head) + " |", rule, *("| " + " | ".join(row) + " |" for row in rows)])


def table(name: str, group: str, row: str, column: str = "Average", folder: str = "reports/tables") -> float:
    """Look up the measured value in a table cell."""
    cells = _read(f"{folder}/{name}.csv")
    chosen = cells[(cells["group"] == group) & (cells["row"] == row) & (cells["column"] == column)]
    return float(chosen["measured"].item())


def total(file: str, column: str) -> int:
    """Sum a column of a CSV file."""
    return int(_read(file)[column].sum())


def run_minutes() -> float:
    """Look up how many minutes a complete `make repro` took."""
    return pd.read_json(ROOT / "reports/times.json", typ="series")["total"] / 60


def verdicts(verdict: str, folder: str = "reports") -> int:
    """Count the findings with this verdict."""
    return int((_read(f"{folder}/findings.csv")["verdict"] == verdict).sum())


def table_26(folder: str) -> str:
    """Tabulate the averages in Table 26, with one column per protocol and one row per result."""
    cells = _read(f"{folder}/table_26.csv")
    averages = cells[cells["column"] == "Average"].pivot(index="row", columns="group", values="measured")
    groups = {"4-5-1, all cues": "4-5-1", ALL: "5-5-1", BEST: "5-5-1, five best cues"}
    rows = (
        [
            row,
            *(
                "" if np.isnan(averages.at[row, group]) else f"{averages.at[row, group]:.2f}"
                for group in groups
            ),
        ]
        for row in cells["row"].unique()
    )
    return _markdown(["average over homes", *groups.values()], rows)


def findings() -> str:
    """Tabulate the number of findings per verdict, and list the findings if there are fewer than ten."""
    data = [_read(f"{folder}/findings.csv") for folder in ("reports", MORE, REAL)]

    def cell(ledger: pd.DataFrame, verdict: str) -> str:
        numbers = ledger.loc[ledger["verdict"] == verdict, "number"]
        return f"{len(numbers)}" + (": " + ", ".join(map(str, numbers)) if len(numbers) < 10 else "")

    rows = (
        [verdict, *(cell(one, verdict) for one in data)]
        for verdict in ("holds", "does not hold", "undecided")
    )
    return _markdown(["verdict", "six rendered homes", "24 rendered homes", "six real homes"], rows, 4)


def _options() -> options.Options:
    return options.read(ROOT / options.SETTINGS)


def power() -> str:
    """Tabulate the power of each finding with 24 homes, and the number of homes it needs."""
    return needed.markdown(needed.power_table(_read(str(needed.COMPARISONS)), 24, _options()))


def replicated() -> str:
    """Tabulate the verdicts on 6 and on 24 homes, and the number of homes that undecided findings need."""
    few, more = (_read(f"{folder}/findings.csv").set_index("number") for folder in ("reports", MORE))

    def row(number: int, one: pd.Series) -> list[str]:
        interval = f"{one['difference']:.2f} ({one['low']:.2f} to {one['high']:.2f})"
        verdict = one["verdict"] if one["replicated"] else "other data"
        shared = "" if np.isnan(one["shared"]) else f"{100 * one['shared']:.0f}%"
        homes = f"over {needed.MOST}" if np.isinf(_homes_needed(number)) else f"{_homes_needed(number):.0f}"
        is_open = one["verdict"] == "undecided" and not np.isnan(_homes_needed(number))
        return [
            str(number),
            few.at[number, "verdict"],
            verdict,
            interval,
            str(one["units"]),
            shared,
            homes if is_open else "",
        ]

    head = ["finding", "6 homes", "24 homes", "difference (interval)", "units", "shared", "homes needed"]
    return _markdown(head, (row(int(number), one) for number, one in more.iterrows()), len(head))


def _homes_needed(number: int) -> float:
    """Return the homes needed for a power of 0.8 if the measured difference is true; NaN if unknown."""
    of_findings = _read(f"{MORE}/power.csv").set_index("number")["needed_measured"]
    return float(of_findings.get(number, np.nan))


def too_small() -> int:
    """Count the undecided findings that need more than `needed.MOST` homes."""
    more = _read(f"{MORE}/findings.csv")
    return sum(
        np.isinf(_homes_needed(number)) for number in more.loc[more["verdict"] == "undecided", "number"]
    )


def marked() -> int:
    """Count the verdicts on 24 homes for which homes of the same group share more variance than allowed."""
    more = _read(f"{MORE}/findings.csv")
    return int(((more["verdict"] != "undecided") & (more["shared"] > _options().shared)).sum())


def averages(name: str) -> str:
    """Tabulate the averages over homes from a table's CSV file, group by group."""
    cells = _read(name)
    cells = cells[cells["column"] == "Average"]
    rows = ([line.group, line.row, f"{line.measured:.2f}"] for line in cells.itertuples(index=False))
    return _markdown(["", "", "average"], rows, 2)


def embedding() -> str:
    """Tabulate the results of the embedding cue and its integrations, averaged over six real homes."""
    lines = _read(f"{REAL}/embedding.csv")
    means = lines.groupby("system", sort=False).mean(numeric_only=True)
    digits = {"frames": 1, "stays": 1, "log_loss": 2, "covered": 1, "wrong": 0}
    rows = (
        [str(name), *("" if np.isnan(mean[key]) else f"{mean[key]:.{n}f}" for key, n in digits.items())]
        for name, mean in means.iterrows()
    )
    return _markdown(["", "frames", "stays", "log-loss", "covered", "of these wrong"], rows)


def embedding_by_home() -> str:
    """Tabulate the smoothed frame accuracy of the same systems in each home."""
    lines = _read(f"{REAL}/embedding.csv")
    lines = lines[lines["system"].str.endswith("smoothed")]
    homes = list(lines["home"].unique())
    rows = (
        [name.removesuffix(", smoothed"), *(f"{value:.1f}" for value in part["frames"])]
        for name, part in lines.groupby("system", sort=False)
    )
    return _markdown(["", *homes], rows)


def tried(candidate: str, column: str, networks: str = "Lite1") -> float:
    """Look up the result of a candidate from docs/embedding.md on six real homes."""
    lines = _read(f"{REAL}/embedding_tried.csv")
    chosen = lines[(lines["candidate"] == candidate) & (lines["networks"] == networks)]
    return float(chosen[column].item())


def several(column: str, largest: bool) -> float:
    """Return the highest or lowest result among the pools and votes of several networks."""
    lines = _read(f"{REAL}/embedding_tried.csv")
    values = lines.loc[lines["networks"].str.contains(",") & (lines["candidate"] != BOTH), column]
    return float(values.max() if largest else values.min())


def rendered_model() -> str:
    """Tabulate the accuracies of the supplied model on real homes."""
    lines = _read(f"{REAL}/rendered_model.csv").set_index("home").T
    lines["average"] = lines.mean(axis=1)
    titles = {"accuracy": "Smoothed", "frame_alone": "Each frame alone", "named": "Named, not unknown"}
    rows = ([title, *(f"{value:.1f}" for value in lines.loc[key])] for key, title in titles.items())
    return _markdown(["", *(home.replace("Home", "Home ") for home in lines)], rows)


def bench(piece: str, input_part: str, quantity_part: str) -> float:
    """Look up a value that `make bench` measured."""
    lines = _read("reports/benchmarks.csv")
    is_it = lines["input"].str.contains(input_part) & lines["quantity"].str.contains(quantity_part)
    return float(lines.loc[(lines["piece"] == piece) & is_it, "ours"].item())


def benchmarks() -> str:
    """Tabulate the speeds relative to the alternatives, with missed targets in bold."""
    rows = []
    for line in _read("reports/benchmarks.csv").itertuples(index=False):
        if "second" not in line.quantity and "frames/s" not in line.quantity:
            continue
        peer = "" if pd.isna(line.peer) else re.split(r"[:(]", line.peer)[0]
        peer = peer.replace("OneVsRestClassifier", "scikit-learn")
        if pd.isna(line.target):
            rows.append([line.piece, "", peer, "", f"not measured: {line.spent}"])
            continue
        target = line.target.replace("at least 1x faster", "faster")
        if "faster" in target:
            measured = f"{times(line.ratio)}x faster"
        elif "its time" in target:
            measured = f"{line.ratio:.1f}x its time"
        else:
            unit = "frames/s" if "frames/s" in line.quantity else "s"
            target, measured = f"{target} {unit}", f"{line.ours:.3g} {unit}"
        measured = measured if line.met == "yes" else f"**{measured}**"
        rows.append([line.piece, line.input, peer, target, measured])
    return _markdown(["piece", "input", "compared with", "target", "measured"], rows, 5)


def robustness() -> str:
    """Tabulate the outcomes of damaged inputs and disturbed runs."""
    counts = _read("reports/robustness.csv")
    columns = ["part", "tried", "right", "message", "traceback", "wrong"]
    rows = ([str(cell).replace("_", " ") for cell in row] for row in counts[columns].itertuples(index=False))
    return _markdown(columns, rows)


def scale(quantity: str) -> float:
    """Look up a quantity that `make bench-scale` measured at the largest size."""
    return pd.read_json(ROOT / "reports/scale.json", typ="series")["largest"][quantity]


def growth(column: str) -> float:
    """Look up how the cost of all stages together grows with the number of frames."""
    lines = _read("reports/scale_growth.csv")
    return float(lines.loc[lines["stage"] == "all", column].item())


def full_run_hours() -> float:
    """Look up the estimated duration, in hours, of a complete run on VPC-2009."""
    return pd.read_json(ROOT / "reports/scale.json", typ="series")["full_run"]["hours"]


def sweep() -> str:
    """Tabulate the results of the sweep in README.md; the same trials are in Table 12."""
    clusters, homes = ("46", "196", "496"), {"Home 1": "home_1", "Home 6": "home_6", "Average": "average"}
    rows = [
        [name, homes[home], *(f"{table('table_12', group, home, column):.2f}" for column in clusters)]
        for name, group in (("hog", "HOG + y-Pos"), ("sift", "SIFT + y-Pos"))
        for home in homes
    ]
    return _markdown(["descriptor", "test_home", *(f"{column} clusters" for column in clusters)], rows, 2)


def _judged(kind: str, name: str, candidate: str) -> dict[str, str]:
    """Format a candidate's means over the real homes and over the rendered homes."""
    lines = _read("reports/cross_validation.csv")
    lines = lines[(lines["kind"] == kind) & (lines["name"] == name) & (lines["candidate"] == candidate)]
    means = lines.groupby("data").mean(numeric_only=True).loc[["own homes", "rendered homes"]]
    digits = {"accuracy": 2, "log_loss": 3, "test_accuracy": 2}
    return {column: " / ".join(f"{value:.{n}f}" for value in means[column]) for column, n in digits.items()}


_JUDGED = ["training homes, real / rendered", "log-loss there", "test homes, real / rendered"]


def chosen_cues() -> str:
    """Tabulate the candidates for the whole-frame cues, with the chosen ones first."""
    by_home = "homes_centred {0} 1.0, homes_averaged {0} 1.0, samples distance 1.0, samples standard"
    candidates = {
        "gist": f"samples standard 0.7, consecutive standard 0.7, {by_home.format('standard')} 2.0",
        "spatial_pact": f"samples root 1.4, consecutive root 1.4, {by_home.format('root')} 1.0",
    }
    rows = []
    for name, title in (("gist", "Gist"), ("spatial_pact", "Centrist")):
        for number, candidate in enumerate(candidates[name].split(", ")):
            calibration, scaling, gamma = candidate.split()
            settings = f"calibration={calibration}, scaling={scaling}, gamma_scale={gamma}"
            mark = " (chosen)" if number == 0 else ""
            judged = _judged("cues", name, settings)
            rows.append([f"{title}: `{calibration}`, `{scaling}`, {gamma}{mark}", *judged.values()])
    return _markdown(["cue", *_JUDGED], rows)


def chosen_systems() -> str:
    """Tabulate the candidates for the integration."""
    rows = []
    for title, name, temperature, calibrations in (
        ("all cues", "das_551_all", False, ("samples", "consecutive", "homes_centred", "homes_averaged")),
        ("five best", "das_551_best", False, ("samples", "homes_averaged")),
        ("five best, temperatures", "das_551_best", True, ("samples", "homes_averaged")),
    ):
        for calibration in calibrations:
            settings = f"calibration={calibration}, scaling=standard, gamma_scale=1.0"
            judged = _judged("systems", name, f"temperature={temperature}, {settings}")
            mark = " (chosen)" if calibration == "homes_averaged" else ""
            rows.append([f"{title}: `{calibration}`{mark}", *judged.values()])
    return _markdown(["system", *_JUDGED], rows)


def chosen_delays() -> str:
    """Tabulate the candidates for the delay."""
    rows = []
    for name, title in (("gist", "Gist"), ("spatial_pact", "Centrist")):
        for seconds in (0.0, 1.0, 2.0, 4.0, 8.0):
            mark = " (chosen)" if seconds == 2 else ""
            judged = _judged("smoothing", name, f"delay_seconds={seconds}")
            rows.append([f"{title}: {seconds:g} s{mark}", *judged.values()])
    return _markdown(["cue and delay", *_JUDGED], rows)


if __name__ == "__main__":
    main()
