"""Benchmarks in the report."""

from collections.abc import Mapping
from typing import Any

import pandas as pd

# Columns of text.
TEXT = ("module", "piece", "input", "quantity", "peer", "peer_version", "target", "met", "spent")
_SECONDS = "seconds"
_NUMBER = r"(\d+(?:\.\d+)?(?:e[+-]?\d+)?)"


def ratios_of(benchmarks: pd.DataFrame) -> pd.DataFrame:
    """The rows of :func:`placecat_bench.run.run` that have a ratio; missing numbers are NaN.

    The columns are the same, with ``met`` as a bool and ``target`` as a number, plus ``is_faster``: whether
    the target is a minimum speed-up instead of a maximum share of the peer's time.
    """
    rows = benchmarks[benchmarks["ratio"].notna()]
    return rows.assign(
        target=rows["target"].str.extract(_NUMBER, expand=False).astype(float),
        is_faster=rows["target"].str.contains("faster"),
        met=rows["met"] == "yes",
    )


def shown_speed(benchmarks: pd.DataFrame, facts: Mapping[str, str]) -> dict[str, Any]:
    """The benchmarks of :func:`placecat_bench.run.run` as text for a page; empty cells of text are "".

    Returns the ``facts`` (``processor``, ``python`` and ``packages`` of the measurement), and in ``rows`` the
    piece, input, ours, peer, theirs, ratio, target, met and spent of each row. Quantities other than
    seconds are named next to the piece.
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
    """A ratio with three digits, or with all digits before the point."""
    return f"{ratio:,.0f}" if ratio >= 1000 else f"{ratio:.3g}"


def _amount(value: float, quantity: str) -> str:
    """A number as text; times with a unit, milliseconds below a second."""
    if pd.isna(value):
        return ""
    if quantity != _SECONDS:
        return f"{value:.3g}"
    return f"{value:.3g} s" if value >= 1 else f"{value * 1000:.3g} ms"
