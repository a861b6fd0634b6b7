"""Rules that translate a claim's words, such as "better" or "about", into ranges."""

from dataclasses import dataclass

import numpy as np

from placecat.errors import PlacecatError
from placecat.evaluation.verdict import Range
from placecat.thesis.claims import ABOVE, BOTH_SIGNS


@dataclass(frozen=True)
class Rules:
    """Rules for judging claims; conf/verdict explains each rule and its unit."""

    level: float
    resamples: int
    minimum_units: int
    few_homes: int
    about: float
    margin: float
    noticeable: float
    rare: float


def claimed_range(kind: tuple[str, float | None], published_difference: float, rules: Rules) -> Range | None:
    """Return the range that a claim allows for a difference; None for ``both_signs``, which ignores the mean.

    ``better`` means above 0, and ``worse`` below 0. ``about`` means within a tolerance of the published
    difference. ``little`` means closer to 0 than the margin, and ``no_better`` means below the margin.
    ``within`` takes a number, and means closer to 0 than that number. ``above`` also takes a number, and
    means that the left side exceeds it; the range is that of their difference. ``both_signs`` means that
    neither noticeable losses nor noticeable gains are rare. Raises PlacecatError if the kind is unknown, if a
    number is missing or unexpected, or if ``about`` has no published difference.
    """
    name, number = kind
    known = {
        "better": Range(0.0, np.inf),
        "worse": Range(-np.inf, 0.0),
        "little": Range(-rules.margin, rules.margin),
        "no_better": Range(-np.inf, rules.margin),
        BOTH_SIGNS: None,
    }
    if name in ("within", ABOVE):
        if number is None:
            raise PlacecatError(f"range {name!r} needs a number")
        return Range(-number, number) if name == "within" else Range(0.0, np.inf)
    if number is not None:
        raise PlacecatError(f"range {name!r} takes no number")
    if name == "about":
        if np.isnan(published_difference):
            raise PlacecatError("range 'about' needs a published difference")
        low, high = sorted(published_difference * (1.0 + share) for share in (-rules.about, rules.about))
        return Range(round(low, 2), round(high, 2))
    if name not in known:
        raise PlacecatError(
            f"unknown range {name!r}; choose one of {', '.join([*known, 'about', 'within', ABOVE])}"
        )
    return known[name]
