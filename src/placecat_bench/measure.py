"""Measure the entries of a benchmark. Each entry produces one row."""

import statistics
import sys
from collections.abc import Callable, Mapping
from importlib.metadata import distributions
from typing import Any

from placecat.errors import PlacecatError
from placecat_bench.comparison import TORCH, Absent, Comparison, Entry, Peer
from placecat_bench.timing import median_seconds, time_in_turn

COLUMNS = [
    "piece",
    "input",
    "quantity",
    "ours",
    "peer",
    "peer_version",
    "theirs",
    "ratio",
    "low",
    "high",
    "target",
    "met",
    "spent",
]
# Replaces "yes" or "no" for a peer that cannot be measured.
ABSENT = "not measured"
_PART_REPEATS = 3


def measure(entry: Entry) -> dict[str, object]:
    """Measure one entry. Return a row with `COLUMNS`; missing values are None.

    ``ours`` and ``theirs`` are median seconds. For a `Limit`, ``ours`` is the measured number. ``ratio`` is
    the median ratio over the pairs, and ``low`` and ``high`` are the smallest and largest ratios. ``met`` is
    "yes", "no" or `ABSENT`. ``spent`` says where the time goes if the target is missed, or why a peer cannot
    be measured. Raises PlacecatError if a peer from the ``bench`` extra is not installed.
    """
    if isinstance(entry, Absent):
        return _absent(entry.piece, entry.input, entry.peer, entry.reason)
    peer, whole = entry.peer, None
    version = None if peer is None else _version(peer)
    if peer is not None and version is None:
        return _absent(entry.piece, entry.input, peer.name, f"without the extra {peer.extra}")
    row = dict.fromkeys(COLUMNS) | {
        "piece": entry.piece,
        "input": entry.input,
        "peer": None if peer is None else peer.name,
        "peer_version": version,
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


def _absent(piece: str, text: str, peer: str, reason: str) -> dict[str, object]:
    row = {"piece": piece, "input": text, "quantity": "seconds", "peer": peer, "met": ABSENT, "spent": reason}
    return dict.fromkeys(COLUMNS) | row


def _version(peer: Peer) -> str | None:
    """Return the version of a peer, or None if it is part of the `TORCH` extra and not installed."""
    folders = sys.path if peer.folder is None else [str(peer.folder)]
    for found in distributions(name=peer.package, path=folders):
        return found.version
    if peer.extra == TORCH:
        return None
    raise PlacecatError(
        f"{peer.package} is not installed, but {peer.name!r} needs it: run `make bench`, or "
        "pip install -e '.[bench]'; if it has no wheel for this machine, select only other pieces"
    )


def _spent(parts: Mapping[str, Callable[[], Any]], whole: float | None) -> str:
    """List parts, slowest first, with their shares of the total time, or with seconds if `whole` is None."""
    times = {name: median_seconds(part, _PART_REPEATS) for name, part in parts.items()}
    ordered = sorted(times.items(), key=lambda item: -item[1])
    if whole is None:
        return ", ".join(f"{name} {_rounded(time):g} s" for name, time in ordered)
    return ", ".join(f"{name} {time / whole:.0%}" for name, time in ordered)


def _rounded(value: float) -> float:
    """Round to four significant digits."""
    return float(f"{value:.4g}")
