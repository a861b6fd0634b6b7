"""Prepare benchmarks for the report."""

from collections.abc import Mapping
from typing import Any

import pandas as pd

# Text columns of the benchmarks.
TEXT = ("module", "piece", "input", "quantity", "peer", "peer_version", "target", "met", "spent")
_SECONDS = "seconds"
_NUMBER = r"(\d+(?:\.\d+)?(?:e[+-]?\d+)?)"


def ratios_of(benchmarks: pd.DataFrame) -> pd.DataFrame:
    """Return the rows of :func:`placecat_bench.run.run` that have a ratio; missing numbers are NaN.

    ``met`` becomes a bool and ``target`` a number; the new column ``is_faster`` says whether the target is a
    minimum speed-up instead of a maximum share of the peer's time.
    """
    rows = benchmarks[benchmarks["ratio"].notna()]
    return rows.assign(
        target=rows["target"].str.extract(_NUMBER, expand=False).astype(float),
        is_faster=rows["target"].str.contains("faster"),
        met=rows["met"] == "yes",
    )


def shown_speed(benchmarks: pd.DataFrame, facts: Mapping[str, str]) -> dict[str, Any]:
    """Format the rows of :func:`placecat_bench.run.run` for a page; their empty text cells must be "".

    Returns ``facts`` (the measurement's ``processor``, ``python`` and ``packages``), and ``rows``, each with
    piece, input, ours, peer, theirs, ratio, target, met and spent. A quantity other than seconds follows the
    piece's name.
    """
    return {"facts": facts, "rows": [_shown_row(row) for row in benchmarks.to_dict("records")]}


def _shown_row(row: Mapping[Any, Any]) -> dict[str, Any]:
    return {
        "piece": row["piece"] if row["quantity"] == _SECONDS else f"{row['piece']}: {row['quantity']}",
        "input": row["input"],
        "ours": _amount(row["ours"], row["quantity"]),
        "peer": " ".join(filter(None, (row["peer"], row["peer_version"]))),
        "theirs": _amount(row["theirs"], row["quantity"]),
        "ratio": ""
        if pd.isna(row["ratio"])
        else f"{times(row['ratio'])} ({times(row['low'])} to {times(row['high'])})",
        "target": row["target"],
        "met": row["met"],
        "spent": f"spent on: {row['spent']}" if row["met"] == "no" else row["spent"],
    }


def times(ratio: float) -> str:
    """Format a ratio with three significant digits, or from 1000 on as a whole number."""
    return f"{ratio:,.0f}" if ratio >= 1000 else f"{ratio:.3g}"


def _amount(value: float, quantity: str) -> str:
    """Format a number; times have a unit, milliseconds below one second."""
    if pd.isna(value):
        return ""
    if quantity != _SECONDS:
        return f"{value:.3g}"
    return f"{value:.3g} s" if value >= 1 else f"{value * 1000:.3g} ms"
