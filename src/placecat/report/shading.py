"""Shade cells by the difference between measured and published numbers."""

import itertools

# In points. Our choice: smaller differences may be due to the seed.
STEPS = (2.0, 5.0, 10.0, 20.0)


def shade(difference: float | None) -> str:
    """Return the name of a cell's shade for measured minus published in points; None means no comparison.

    The name is "above-1" to "above-4" or "below-1" to "below-4", higher for larger differences, or "" for a
    small or missing difference.
    """
    if difference is None:
        return ""
    level = sum(abs(difference) >= step for step in STEPS)
    return f"{'above' if difference > 0 else 'below'}-{level}" if level else ""


def legend() -> list[tuple[str, str]]:
    """List (shade, meaning) for every shade, from far below to far above."""
    bounds = [f"{low:g} to {high:g}" for low, high in itertools.pairwise(STEPS)]
    bounds.append(f"{STEPS[-1]:g} or more")
    below = [(f"below-{level}", f"{text} below") for level, text in enumerate(bounds, start=1)]
    above = [(f"above-{level}", f"{text} above") for level, text in enumerate(bounds, start=1)]
    return [*reversed(below), ("", f"within {STEPS[0]:g}"), *above]
