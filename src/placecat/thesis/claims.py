"""The thesis's claims, read from data/thesis/findings. Each claim is a set of comparisons between results."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from placecat import paths, settings
from placecat.errors import PlacecatError

COMBINE = ("mean", "best", "last")
COMPARE = ("difference", "ratio")
# The range of a claim about individual homes, which are compared one by one.
BOTH_SIGNS = "both_signs"
# The range of a claim that compares a single side with a number.
ABOVE = "above"


@dataclass(frozen=True)
class Side:
    """One side of a comparison: a number computed from results.

    Attributes
    ----------
    label
        Readable name.
    results
        Names of the results.
    combine
        How to combine the results: ``mean``; ``best``, the result with the highest mean over all units; or
        ``last``, the last result that can be computed on this data set.
    place
        Name of the class whose accuracy is used; None for the mean over the classes present.
    error
        Whether to compare error rates (100 minus the accuracy) instead of accuracies.
    plain
        Whether to use the share of correct frames instead of the mean over classes.
    published
        Where the thesis prints each result's number; None if this follows from the result's name.
    """

    label: str
    results: tuple[str, ...]
    combine: str = "mean"
    place: str | None = None
    error: bool = False
    plain: bool = False
    published: tuple[Mapping[str, Any], ...] | None = None

    def only(self, results: Sequence[str]) -> "Side":
        """Return a copy of the side with only the given results and their published numbers."""
        published = self.published
        if published is not None and len(published) == len(self.results):
            published = tuple(
                one for name, one in zip(self.results, published, strict=True) if name in results
            )
        return replace(self, results=tuple(results), published=published)

    def renamed(self, parts: Mapping[str, str]) -> "Side":
        """Return a copy with `parts` of the results' names replaced; the published numbers stay the same."""
        results = tuple("/".join(parts.get(part, part) for part in name.split("/")) for name in self.results)
        published = self.published
        if published is None and self.place is None and not self.error:
            published = tuple({"result": name} for name in self.results)
        return replace(self, results=results, published=published)


@dataclass(frozen=True)
class Comparison:
    """A difference (left minus right) or ratio (left divided by right), with the claimed range.

    Attributes
    ----------
    left, right
        The two sides. If `right` is None, the left side is compared with the number given for the range
        ``above``.
    range
        A kind of range, and a number if that kind takes one (see
        :func:`placecat.thesis.rules.claimed_range`).
    compare
        ``difference`` or ``ratio``.
    published
        Where the thesis prints the difference; None if it follows from the sides.
    published_home
        The home whose published numbers are used if a table has several homes; None for the average.
    pooled
        Whether the frames of all test sequences are pooled, as in Tables 30 and 31.
    """

    left: Side
    range: tuple[str, float | None]
    right: Side | None = None
    compare: str = "difference"
    published: Mapping[str, Any] | None = None
    published_home: str | None = None
    pooled: bool = False

    @property
    def sides(self) -> tuple[Side, ...]:
        """The left side and, if there is one, the right side."""
        return (self.left,) if self.right is None else (self.left, self.right)


@dataclass(frozen=True)
class Finding:
    """A claim of the thesis, which holds only if all its comparisons do.

    Attributes
    ----------
    name
        The file's name, e.g. ``finding_04``.
    readings
        Other readings of the thesis, by name, e.g. ``as_printed``. Each reading maps parts of result names to
        their replacements.
    filters
        Names of information filters. The reason given for the verdict says what share of the frames each
        filter drops.
    """

    name: str
    number: int
    section: str
    claim: str
    comparisons: tuple[Comparison, ...]
    readings: Mapping[str, Mapping[str, str]] = field(default_factory=dict)
    filters: Sequence[str] = ()

    def read_as(self, reading: str) -> "Finding":
        """Return this claim under another reading of the thesis."""
        parts = self.readings[reading]
        comparisons = tuple(
            replace(one, left=one.left.renamed(parts), right=one.right and one.right.renamed(parts))
            for one in self.comparisons
        )
        return replace(self, comparisons=comparisons)


def read_finding(name: str, config: Mapping[str, Any]) -> Finding:
    """Read a finding from its settings.

    A comparison may have a key ``each``, a list of mappings. It then stands for one comparison per mapping,
    in whose text each ``{key}`` is replaced with the mapping's value. Raises PlacecatError if settings are
    unknown, missing or contradictory.
    """
    where = f"{paths.FINDING_DEFINITIONS / name}.yaml"
    finding: Finding = settings.call(Finding, name, settings=config, where=where)
    comparisons = []
    for one in config["comparisons"]:
        rest = {key: value for key, value in one.items() if key != "each"}
        comparisons += [_comparison(_substitute(rest, values), name) for values in one.get("each", [{}])]
    if not comparisons:
        raise PlacecatError(f"{name} contains no comparisons: add at least one")
    if len({one.range[0] == BOTH_SIGNS for one in comparisons}) > 1:
        raise PlacecatError(f"{name} mixes {BOTH_SIGNS} with other ranges: use it everywhere or nowhere")
    parts_compared = {
        part
        for one in comparisons
        for side in one.sides
        for result in side.results
        for part in result.split("/")
    }
    for reading, parts in finding.readings.items():
        if unknown := [part for part in parts if part not in parts_compared]:
            raise PlacecatError(
                f"the reading {reading} of {name} replaces {unknown[0]!r}, which no compared result contains"
            )
    return replace(finding, section=str(finding.section), comparisons=tuple(comparisons))


def _comparison(config: Mapping[str, Any], where: str) -> Comparison:
    read: Comparison = settings.call(Comparison, settings=config, where=where)
    kinds = config["range"] if isinstance(config["range"], Mapping) else {config["range"]: None}
    if len(kinds) != 1:
        raise PlacecatError(f"a range in {where} has {len(kinds)} kinds instead of one")
    ((kind, number),) = kinds.items()
    comparison = replace(
        read,
        left=_side(config["left"], where),
        right=_side(config["right"], where) if "right" in config else None,
        range=(kind, None if number is None else float(number)),
    )
    left, right = comparison.left, comparison.right
    if comparison.compare not in COMPARE:
        raise PlacecatError(f"{where} sets compare to {comparison.compare!r}: use {' or '.join(COMPARE)}")
    if (kind == ABOVE) != (right is None):
        raise PlacecatError(f"{where} needs either a right side or the range {ABOVE!r}, but not both")
    if right is None and comparison.compare == "ratio":
        raise PlacecatError(f"a ratio in {where} needs a right side")
    if wrong := [side.label for side in comparison.sides if side.plain and (side.place or side.error)]:
        raise PlacecatError(f"{wrong[0]!r} in {where} is plain, so it cannot have a place or an error")
    if kind == BOTH_SIGNS and right and len(left.results) != len(right.results):
        raise PlacecatError(f"{BOTH_SIGNS} in {where} needs as many results on the right as on the left")
    return comparison


def _side(config: Mapping[str, Any], where: str) -> Side:
    if ("result" in config) == ("results" in config):
        raise PlacecatError(f"a side in {where} needs either result or results, but not both")
    results = tuple([config["result"]] if "result" in config else config["results"])
    published = config.get("published")
    if published is not None:
        published = tuple(published) if isinstance(published, Sequence) else (published,)
    rest = {key: value for key, value in config.items() if key != "result"}
    options = {**rest, "results": results, "published": published}
    side: Side = settings.call(Side, settings=options, where=f"a side in {where}")
    if side.combine not in COMBINE:
        raise PlacecatError(f"{where} sets combine to {side.combine!r}: use one of {', '.join(COMBINE)}")
    if published is not None and side.combine != "mean" and len(published) != len(results):
        raise PlacecatError(f"{where} has {len(published)} published numbers for {len(results)} results")
    return side


def _substitute(value: Any, replacements: Mapping[str, Any]) -> Any:
    if isinstance(value, str):
        return value.format_map(replacements) if replacements else value
    if isinstance(value, Mapping):
        return {key: _substitute(one, replacements) for key, one in value.items()}
    if isinstance(value, Sequence):
        return [_substitute(one, replacements) for one in value]
    return value
