"""What the thesis claims, as comparisons of results: the files of conf/finding."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from placecat import settings
from placecat.errors import PlacecatError

COMBINE = ("mean", "best", "last")
COMPARE = ("difference", "ratio")
# The range of a claim about single homes: their results are compared one by one.
BOTH_SIGNS = "both_signs"
# The range of a claim about one side, with the number that it is compared with.
ABOVE = "above"


@dataclass(frozen=True)
class Side:
    """One side of a comparison: a number made of results.

    Attributes
    ----------
    label
        For people.
    results
        Names of results.
    combine
        ``mean``; ``best``, the one with the highest mean over all units; or ``last``, the last of those that
        could be measured on this data.
    place
        Name of the class whose accuracy counts; None for the mean over the classes present.
    error
        Whether 100 minus the accuracy counts.
    published
        Where the thesis has the number of each result; None if that follows from its name.
    """

    label: str
    results: tuple[str, ...]
    combine: str = "mean"
    place: str | None = None
    error: bool = False
    published: tuple[Mapping[str, Any], ...] | None = None


@dataclass(frozen=True)
class Comparison:
    """Left minus right, or left by right, and where the claim puts it.

    Attributes
    ----------
    left, right
        Without `right` the left is compared with the number of the range ``above``.
    range
        Name of a kind of range, and its number if it takes one, see
        :func:`placecat.reporting.rules.claimed_range`.
    compare
        ``difference`` or ``ratio``.
    published
        Where the thesis has the difference itself; None if it follows from the sides.
    published_home
        Whose published numbers are meant, where a table has those of several homes; None for their average.
    """

    left: Side
    right: Side | None
    range: tuple[str, float | None]
    compare: str = "difference"
    published: Mapping[str, Any] | None = None
    published_home: str | None = None

    @property
    def sides(self) -> tuple[Side, ...]:
        """One or two."""
        return (self.left,) if self.right is None else (self.left, self.right)


@dataclass(frozen=True)
class Finding:
    """One sentence of the thesis.

    Attributes
    ----------
    name
        Of its file, e.g. ``finding_04``.
    number
        In the list of findings.
    section
        Of the thesis.
    claim
        The sentence.
    comparisons
        What has to hold for it.
    """

    name: str
    number: int
    section: str
    claim: str
    comparisons: tuple[Comparison, ...]


def read_finding(name: str, config: Mapping[str, Any]) -> Finding:
    """Read the settings of one finding.

    A comparison with ``each``, a list of mappings, stands for one comparison a mapping, with ``{key}``
    replaced by the mapping's value in all its text.

    Raises
    ------
    PlacecatError
        For settings that are unknown, missing or contradictory.
    """
    _check(config, ["number", "section", "claim", "comparisons"], [], name)
    comparisons = []
    for one in config["comparisons"]:
        rest = {key: value for key, value in one.items() if key != "each"}
        comparisons += [_comparison(_substitute(rest, values), name) for values in one.get("each", [{}])]
    if not comparisons:
        raise PlacecatError(f"{name} makes no comparison")
    return Finding(
        name, int(config["number"]), str(config["section"]), str(config["claim"]), tuple(comparisons)
    )


def _comparison(config: Mapping[str, Any], where: str) -> Comparison:
    options = dict(config)
    _check(options, ["left", "range"], ["right", "compare", "published", "published_home"], where)
    left = _side(options.pop("left"), where)
    right = _side(options.pop("right"), where) if "right" in options else None
    kind = options.pop("range")
    if isinstance(kind, Mapping):
        if len(kind) != 1:
            raise PlacecatError(f"a range of {where} has {len(kind)} kinds, one is needed")
        ((name, number),) = kind.items()
        kind = (name, float(number))
    else:
        kind = (kind, None)
    comparison = Comparison(left, right, kind, **options)
    if comparison.compare not in COMPARE:
        raise PlacecatError(f"{where} compares by {comparison.compare!r}; choose {' or '.join(COMPARE)}")
    if (kind[0] == ABOVE) != (right is None):
        raise PlacecatError(f"{where} needs either a right side or the range {ABOVE!r}")
    if right is None and comparison.compare == "ratio":
        raise PlacecatError(f"a ratio of {where} has no right side")
    if kind[0] == BOTH_SIGNS and right and len(left.results) != len(right.results):
        raise PlacecatError(f"{BOTH_SIGNS} of {where} needs as many results on the right as on the left")
    return comparison


def _side(config: Mapping[str, Any], where: str) -> Side:
    options = dict(config)
    if ("result" in options) == ("results" in options):
        raise PlacecatError(f"a side of {where} needs either result or results")
    results = [options.pop("result")] if "result" in options else options.pop("results")
    published = options.pop("published", None)
    if published is not None:
        published = tuple(published) if isinstance(published, Sequence) else (published,)
    side: Side = settings.call(
        Side, settings=options | {"results": tuple(results)}, where=f"a side of {where}"
    )
    if side.combine not in COMBINE:
        raise PlacecatError(f"{where} combines by {side.combine!r}; choose one of {', '.join(COMBINE)}")
    if published is not None and side.combine != "mean" and len(published) != len(results):
        raise PlacecatError(f"{where} has {len(published)} published numbers of {len(results)} results")
    return replace(side, published=published)


def _substitute(value: Any, replacements: Mapping[str, Any]) -> Any:
    if isinstance(value, str):
        return value.format_map(replacements) if replacements else value
    if isinstance(value, Mapping):
        return {key: _substitute(one, replacements) for key, one in value.items()}
    if isinstance(value, Sequence):
        return [_substitute(one, replacements) for one in value]
    return value


def _check(config: Mapping[str, Any], needed: list[str], optional: list[str], where: str) -> None:
    settings.refuse_unknown(config, [*needed, *optional], where)
    for name in needed:
        if name not in config:
            raise PlacecatError(f"{where} has no setting {name!r}, which is needed")
