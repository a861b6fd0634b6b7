"""Measuring entries, one row each."""

import statistics
from collections.abc import Callable, Mapping
from importlib.metadata import PackageNotFoundError, version
from typing import Any

from placecat.errors import PlacecatError
from placecat_bench.comparison import Comparison, Limit, Peer
from placecat_bench.timing import median_seconds, time_in_turn

COLUMNS = ["piece", "input", "quantity", "ours", "peer", "peer_version", "theirs", "ratio", "low", "high"]
COLUMNS += ["target", "met", "spent"]
_PART_REPEATS = 3


def measure(entry: Comparison | Limit) -> dict[str, object]:
    """Measure one entry: a row by `COLUMNS`, with None where there is no value.

    ``ours`` and ``theirs`` are medians of seconds, or the number of a `Limit`; ``ratio`` is the median of the
    pairs' ratios, ``low`` and ``high`` the least and the greatest; ``met`` is "yes" or "no"; ``spent`` says
    where the time goes if the target is missed. Raises PlacecatError if the peer is not installed.
    """
    peer, whole = entry.peer, None
    row = dict.fromkeys(COLUMNS) | {
        "piece": entry.piece,
        "input": entry.input,
        "peer": None if peer is None else peer.name,
        "peer_version": None if peer is None else _version(peer),
        "target": entry.target,
    }
    if isinstance(entry, Comparison):
        ours, theirs = time_in_turn(entry.ours, entry.theirs, repeats=entry.repeats, warm_up=entry.warm_up)
        ratios = [entry.ratio(*pair) for pair in zip(ours, theirs, strict=True)]
        whole, value = statistics.median(ours), statistics.median(ratios)
        row |= {"quantity": "seconds", "ours": _rounded(whole), "theirs": _rounded(statistics.median(theirs))}
        row |= {"ratio": _rounded(value), "low": _rounded(min(ratios)), "high": _rounded(max(ratios))}
    else:
        value = float(entry.measure())
        row |= {"quantity": entry.quantity, "ours": _rounded(value)}
    is_met = entry.is_met(value)
    return row | {"met": "yes" if is_met else "no", "spent": None if is_met else _spent(entry.parts, whole)}


def _version(peer: Peer) -> str:
    try:
        return version(peer.package)
    except PackageNotFoundError:
        raise PlacecatError(
            f"{peer.package} is not installed, with which {peer.name!r} is measured: run `make bench`, or "
            "pip install -e '.[bench]'; where it has no wheel, name the other pieces"
        ) from None


def _spent(parts: Mapping[str, Callable[[], Any]], whole: float | None) -> str:
    """Parts and their share of a whole (seconds), or their seconds where there is none; the largest first."""
    times = {name: median_seconds(part, _PART_REPEATS) for name, part in parts.items()}
    ordered = sorted(times.items(), key=lambda item: -item[1])
    if whole is None:
        return ", ".join(f"{name} {_rounded(time):g} s" for name, time in ordered)
    return ", ".join(f"{name} {time / whole:.0%}" for name, time in ordered)


def _rounded(value: float) -> float:
    """Four significant digits."""
    return float(f"{value:.4g}")
