"""What a search may choose, read from Hydra's overrides, and where it starts."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from hydra.core.override_parser.overrides_parser import OverridesParser
from hydra.core.override_parser.types import IntervalSweep, Override, RangeSweep
from omegaconf import DictConfig

from placecat.errors import PlacecatError
from placecat.search import starts

if TYPE_CHECKING:
    from optuna.distributions import BaseDistribution

# What describes the method. Data, homes, seeds and judge are how it is measured: choosing these is no search.
_OF_THE_METHOD = ("descriptor", "classifier", "codebook", "clustering")


@dataclass(frozen=True)
class Dimension:
    """A setting that the search chooses.

    Attributes
    ----------
    key
        The setting, e.g. ``classifier.base.gamma``.
    written
        Its override, for messages.
    starts
        Its values in the settings to start with.
    low, high
        Bounds of an interval or range, included; unused with `choices`.
    step
        Of a range; None for an interval.
    is_log
        Whether an interval is searched on a logarithmic scale.
    choices
        The values as Hydra writes them; empty for an interval or range.
    """

    key: str
    written: str
    starts: tuple[Any, ...]
    low: float = 0.0
    high: float = 0.0
    step: float | None = None
    is_log: bool = False
    choices: tuple[str, ...] = ()

    @property
    def is_whole(self) -> bool:
        """Whether its values are whole numbers."""
        return not self.choices and all(isinstance(one, int) for one in (self.low, self.high, self.step or 1))

    def distribution(self) -> "BaseDistribution":
        """As Optuna knows it."""
        from optuna.distributions import CategoricalDistribution, FloatDistribution, IntDistribution

        if self.choices:
            return CategoricalDistribution(self.choices)
        if self.is_whole:
            return IntDistribution(int(self.low), int(self.high), log=self.is_log, step=int(self.step or 1))
        return FloatDistribution(self.low, self.high, log=self.is_log, step=self.step)

    def override(self, value: Any, digits: int) -> str:
        """The override that sets it to a value that Optuna gave.

        Parameters
        ----------
        digits
            Significant digits of a number from an interval. Those of the starts are kept.
        """
        if self.choices or self.is_whole or value in self.starts:
            return f"{self.key}={value}"
        rounded = min(max(float(f"{value:.{digits}g}"), self.low), self.high)
        return f"{self.key}={rounded}"


@dataclass(frozen=True)
class Space:
    """What a search may choose.

    Attributes
    ----------
    dimensions
        The settings that it chooses.
    starts
        Where the settings to start with are from, e.g. ``conf/cue/hog_y.yaml``.
    fixed
        Overrides that all its experiments have.
    digits
        Significant digits of the numbers that it chooses from intervals.
    """

    dimensions: tuple[Dimension, ...]
    starts: tuple[str, ...]
    fixed: tuple[str, ...]
    digits: int

    def start_values(self) -> list[dict[str, Any]]:
        """Key to value of each setting to start with, for Optuna."""
        return [{one.key: one.starts[place] for one in self.dimensions} for place in range(len(self.starts))]

    def ends(self) -> list[tuple[str, ...]]:
        """Overrides that bring each setting to each of its ends, the others as in the first start."""
        first = self.start_values()[0]
        found = [first]
        for one in self.dimensions:
            found += [first | {one.key: value} for value in one.choices or (one.low, one.high)]
        return [self.overrides(values) for values in found]

    def distributions(self) -> "dict[str, BaseDistribution]":
        """Key to what may be chosen, as Optuna knows it."""
        return {one.key: one.distribution() for one in self.dimensions}

    def overrides(self, values: Mapping[str, Any]) -> tuple[str, ...]:
        """The overrides for the values that Optuna chose."""
        return tuple(one.override(values[one.key], self.digits) for one in self.dimensions)


def values(overrides: Sequence[str]) -> dict[str, str]:
    """Key to value of overrides."""
    return dict(one.split("=", 1) for one in overrides)


def read(
    spans: Mapping[str, Any],
    arguments: Sequence[str],
    config: DictConfig,
    params: Mapping[str, Any],
    *,
    digits: int,
) -> Space:
    """Read the space from the configuration and the command line, which goes first.

    Parameters
    ----------
    spans
        Key to what may be chosen, as conf/search writes it, e.g. ``interval(0.1, 2)`` or ``choice(a, b)``.
    arguments
        Overrides of the command line. What has one value there is not searched.
    config
        The experiment composed without what is searched, with Hydra's own settings: the first start.
    params
        params.yaml, see :func:`placecat.search.starts.find`.
    digits
        Significant digits of the numbers chosen from intervals.

    Raises
    ------
    PlacecatError
        Nothing is searched; a key is none of the method's; or the space does not hold a start.
    """
    parser = OverridesParser.create()
    by_key = {
        one.get_key_element(): one
        for one in parser.parse_overrides([*(f"{key}={value}" for key, value in spans.items()), *arguments])
    }
    searched = [one for one in by_key.values() if one.is_sweep_override()]
    if not searched:
        raise PlacecatError(
            "nothing is left to search: give a setting several values, e.g. "
            "'classifier.base.gamma=tag(log, interval(0.1, 10))'"
        )
    fixed = tuple(str(one.input_line) for one in by_key.values() if not one.is_sweep_override())
    keys = [one.get_key_element() for one in searched]
    for key, one in zip(keys, searched, strict=True):
        _need_of_the_method(key, str(one.input_line))
    found = starts.find(keys, config, params)
    dimensions = tuple(
        _dimension(one, {name: values[key] for name, values in found.items()}, parser)
        for key, one in zip(keys, searched, strict=True)
    )
    return Space(dimensions, tuple(found), fixed, digits)


def _need_of_the_method(key: str, written: str) -> None:
    if key.split(".")[0].split("@")[0] not in _OF_THE_METHOD:
        raise PlacecatError(
            f"{written}: a search chooses settings of {', '.join(_OF_THE_METHOD)} only; {key} belongs to how "
            "they are measured and has one value"
        )


def _dimension(override: Override, found: Mapping[str, Any], parser: OverridesParser) -> Dimension:
    """Read one; `found` is where a start is from to its value of this setting."""
    key, written = override.get_key_element(), str(override.input_line)
    values = tuple(found.values())
    value = override.value()
    if override.is_interval_sweep():
        assert isinstance(value, IntervalSweep)
        low, high = value.start, value.end
        assert low is not None
        assert high is not None
        is_log = "log" in value.tags
        if not low < high or (is_log and low <= 0):
            raise PlacecatError(f"{written}: the interval must grow{' and be above 0' if is_log else ''}")
        whole = isinstance(low, int) and isinstance(high, int)
        for name, start in found.items():
            inside = _is_number(start) and low <= start <= high and (not whole or start == int(start))
            _need_start(inside, written, name, start)
        return Dimension(key, written, values, low, high, is_log=is_log)
    if override.is_range_sweep():
        assert isinstance(value, RangeSweep)
        steps = list(value.range())
        if not steps or value.step <= 0:
            raise PlacecatError(f"{written}: the range must have values and grow")
        for name, start in found.items():
            inside = _is_number(start) and any(math.isclose(start, one) for one in steps)
            _need_start(inside, written, name, start)
        return Dimension(key, written, values, steps[0], steps[-1], value.step)
    texts = tuple(dict.fromkeys(override.sweep_string_iterator()))
    meaning = [parser.parse_override(f"{key}={text}").value() for text in texts]
    for name, start in found.items():
        _need_start(start in meaning, written, name, start)
    chosen = tuple(texts[meaning.index(start)] for start in values)
    return Dimension(key, written, chosen, choices=texts)


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _need_start(holds: bool, written: str, name: str, start: Any) -> None:
    if not holds:
        raise PlacecatError(
            f"{written} does not hold {start}, the value of {name}, which is tried first so that what "
            "is found is at least as good: widen it"
        )
