"""The order of the cabinets in a fitted kitchen."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from placecat_homes.furniture.blocks import choose


@dataclass(frozen=True)
class Unit:
    """One cabinet in a row.

    Attributes
    ----------
    kind
        ``sink``, ``cooker``, ``dishwasher``, ``doors``, ``drawers``, ``mixed``, ``open`` or ``corner``.
    x
        Position of the centre in metres.
    width
        Width in metres.
    """

    kind: str
    x: float
    width: float

    @property
    def left(self) -> float:
        """Smallest x in metres."""
        return self.x - self.width / 2

    @property
    def right(self) -> float:
        """Largest x in metres."""
        return self.x + self.width / 2


def row(
    rng: np.random.Generator,
    length: float,
    fixed: Sequence[tuple[str, float]],
    *,
    sink_at: float | None = None,
    corners: Sequence[int] = (),
    corner_width: float = 0.62,
) -> tuple[Unit, ...]:
    """Fill the given length with cabinets.

    Parameters
    ----------
    rng
        Random number generator.
    length
        Length in metres; x runs from -length / 2 to length / 2.
    fixed
        Kinds and widths of the required cabinets. If space is short, earlier ones take priority.
    sink_at
        Preferred position of the sink, for example in front of a window.
    corners
        Ends (-1 or 1) that are hidden in a corner behind another row.
    corner_width
        Width of the hidden part in metres.

    Returns
    -------
    tuple of Unit
        The cabinets in order of increasing x, with no gaps between them.
    """
    start, end = -length / 2, length / 2
    hidden = []
    for side in corners:
        hidden.append(Unit("corner", side * (length / 2 - corner_width / 2), corner_width))
        start, end = (start + corner_width, end) if side < 0 else (start, end - corner_width)
    space = end - start
    chosen: list[tuple[str, float]] = []
    for kind, width in fixed:
        if sum(w for _, w in chosen) + width <= space + 1e-6:
            chosen.append((kind, width))
    rest = space - sum(w for _, w in chosen)
    if rest < 0.2 and chosen:
        stretch = [k for k, (kind, _) in enumerate(chosen) if kind == "sink"] or [0]
        kind, width = chosen[stretch[0]]
        chosen[stretch[0]] = (kind, width + rest)
        rest = 0.0
    number = max(round(rest / float(rng.uniform(0.45, 0.62))), 1) if rest > 0 else 0
    shares = rng.dirichlet(np.full(number, 30.0)) * rest if number else np.zeros(0)
    chosen += [
        (choose(rng, ("doors", "drawers", "mixed", "open"), (4, 2.5, 3, 0.5)), float(w)) for w in shares
    ]
    best: tuple[float, tuple[Unit, ...]] | None = None
    for _ in range(60):
        order = rng.permutation(len(chosen))
        x, units = start, []
        for k in order:
            kind, width = chosen[k]
            units.append(Unit(kind, x + width / 2, width))
            x += width
        worth = _worth(units, start, end, sink_at, [side * length / 2 for side in corners]) + float(
            rng.uniform(0, 0.4)
        )
        if best is None or worth > best[0]:
            best = worth, tuple(units)
    units_chosen = best[1] if best else ()
    return tuple(sorted([*units_chosen, *hidden], key=lambda unit: unit.x))


def _worth(
    units: Sequence[Unit], start: float, end: float, sink_at: float | None, corners: Sequence[float]
) -> float:
    """Score an arrangement by the space beside the hob and sink and by where the sink and dishwasher are."""
    at = {unit.kind: unit for unit in units}
    worth = 0.0
    sink, cooker, washer = at.get("sink"), at.get("cooker"), at.get("dishwasher")
    if cooker is not None:
        margin = min(cooker.left - start, end - cooker.right)
        worth += min(margin, 0.3) * 6
        worth -= 2.0 * any(abs(cooker.x - corner) < 0.7 for corner in corners)
    if sink is not None and cooker is not None:
        worth += min(abs(sink.x - cooker.x) - (sink.width + cooker.width) / 2, 0.6) * 3
    if sink is not None:
        worth += min(sink.left - start, end - sink.right, 0.3)
        if sink_at is not None:
            worth -= 4 * abs(sink.x - sink_at)
        if washer is not None:
            worth += 0.8 * (abs(sink.x - washer.x) < (sink.width + washer.width) / 2 + 0.01)
    return worth


def sink_width(rng: np.random.Generator, length: float) -> float:
    """Choose the width of the sink cabinet in metres, given the length of the row."""
    if length < 1.7:
        return 0.5
    return float(rng.choice([0.6, 0.8, 0.9] if length > 2.4 else [0.5, 0.6]))
