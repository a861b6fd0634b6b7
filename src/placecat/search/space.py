"""A search space, read from Hydra overrides, and the settings that the search starts from."""

import importlib.util
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from hydra.core.override_parser.overrides_parser import OverridesParser
from hydra.core.override_parser.types import IntervalSweep, Override, RangeSweep
from omegaconf import DictConfig, OmegaConf

from placecat.errors import PlacecatError

if TYPE_CHECKING:
    from optuna.distributions import BaseDistribution

JUDGE = "training_homes"
# Source of the first start.
SETTINGS = "the settings without a search"
# Only the method's settings are searched; data, homes, seeds and judge belong to the measurement.
_OF_THE_METHOD = ("descriptor", "classifier", "codebook", "clustering")


@dataclass(frozen=True)
class Space:
    """A search space.

    `distributions` maps keys to Optuna distributions, in which choices are spelled as in Hydra. `starts` maps
    the source of each start, such as ``conf/cue/hog_y.yaml``, to its keys and values. `fixed` contains the
    overrides that all experiments share. `digits` is the number of significant digits for floats that Optuna
    chooses; starts are not rounded.
    """

    distributions: "dict[str, BaseDistribution]"
    starts: dict[str, dict[str, Any]]
    fixed: tuple[str, ...]
    digits: int

    def overrides(self, chosen: Mapping[str, Any]) -> tuple[str, ...]:
        """Return the overrides that set the values chosen by Optuna."""
        return tuple(f"{key}={self._written(key, chosen[key])}" for key in self.distributions)

    def _written(self, key: str, value: Any) -> Any:
        from optuna.distributions import FloatDistribution

        own = self.distributions[key]
        if not isinstance(own, FloatDistribution) or value in [one[key] for one in self.starts.values()]:
            return value
        return min(max(float(f"{value:.{self.digits}g}"), own.low), own.high)

    def ends(self) -> list[tuple[str, ...]]:
        """Return the overrides for the first starting point, then for its variants.

        Each variant sets one key to one of its limits or choices.
        """
        first = next(iter(self.starts.values()))
        found = [first]
        for key, own in self.distributions.items():
            limits = getattr(own, "choices", None) or (own.low, own.high)  # type: ignore[attr-defined]
            found += [first | {key: value} for value in limits]
        return [self.overrides(chosen) for chosen in found]


def check(config: Mapping[str, Any]) -> None:
    """Check that the search can run, and that its result will be meaningful.

    Raises PlacecatError if Optuna is not installed, if ``judge`` is not ``training_homes``, or if there is
    not exactly one test home.
    """
    if importlib.util.find_spec("optuna") is None:
        raise PlacecatError("a search needs Optuna: install it with `pip install -e .[search]`")
    judge, home = config["judge"], config["test_home"]
    if judge != JUDGE:
        raise PlacecatError(
            f"judge={judge}: a search is judged on training homes only, since choosing by accuracy on the "
            f"test home would make that accuracy too optimistic; use judge={JUDGE}"
        )
    if home == "all" or (not isinstance(home, str | int) and len(home) != 1):
        raise PlacecatError(
            f"test_home={home}: a search must leave out one test home, since choosing on all folds would use "
            "every home; set one, such as test_home=home_1, and search once for each"
        )


def values(overrides: Sequence[str]) -> dict[str, str]:
    """Map override keys to their values."""
    return dict(one.split("=", 1) for one in overrides)


def read(
    spans: Mapping[str, Any],
    arguments: Sequence[str],
    config: DictConfig,
    params: Mapping[str, Any],
    *,
    digits: int,
) -> Space:
    """Read the space from the configuration and the command line, which takes precedence.

    `spans` maps keys to spans as in conf/search, such as ``interval(0.1, 2)`` or ``choice(a, b)``.
    `arguments` are overrides; a key with a single value there is not searched. `config` is the first start:
    the experiment composed without the searched settings, including Hydra's own settings. `params` holds the
    contents of params.yaml; see :func:`find_starts`. Raises PlacecatError if nothing is searched, if a key
    does not belong to the method, or if a start lies outside the space.
    """
    parser = OverridesParser.create()
    written = [*(f"{key}={value}" for key, value in spans.items()), *arguments]
    by_key = {one.get_key_element(): one for one in parser.parse_overrides(written)}
    searched = {key: one for key, one in by_key.items() if one.is_sweep_override()}
    if not searched:
        raise PlacecatError(
            "there is nothing to search: list several values for a setting, for example "
            "'classifier.base.gamma=tag(log, interval(0.1, 10))'"
        )
    for key, one in searched.items():
        if key.split(".")[0].split("@")[0] not in _OF_THE_METHOD:
            raise PlacecatError(
                f"{one.input_line}: a search chooses only settings of {', '.join(_OF_THE_METHOD)}; {key} "
                "belongs to the measurement, so set it to a single value"
            )
    found = find_starts(list(searched), config, params)
    distributions = {}
    for key, one in searched.items():
        distributions[key], chosen = _distribution(
            one, {name: own[key] for name, own in found.items()}, parser
        )
        for name, own in found.items():
            own[key] = chosen[name]
    fixed = tuple(str(one.input_line) for one in by_key.values() if not one.is_sweep_override())
    return Space(distributions, found, fixed, digits)


def _distribution(
    override: Override, found: Mapping[str, Any], parser: OverridesParser
) -> "tuple[BaseDistribution, dict[str, Any]]":
    """Return the distribution of a setting, and its value in each start as Optuna represents it."""
    from optuna.distributions import CategoricalDistribution, FloatDistribution, IntDistribution
    from optuna.trial import create_trial

    key, span = override.get_key_element(), override.value()
    distribution: BaseDistribution
    as_known: dict[str, Any] = dict(found)
    if isinstance(span, IntervalSweep | RangeSweep):
        ends: list[Any] = list(span.range()) if isinstance(span, RangeSweep) else [span.start, span.end]
        step = span.step if isinstance(span, RangeSweep) else None
        whole = all(isinstance(one, int) for one in (*ends, step or 1))
        kind, options = (
            (IntDistribution, {"step": step or 1}) if whole else (FloatDistribution, {"step": step})
        )
        try:
            distribution = kind(ends[0], ends[-1], log="log" in span.tags, **options)
        except (ValueError, IndexError) as error:
            raise PlacecatError(f"{override.input_line} is not a valid span: {error}") from None
    else:
        texts = list(dict.fromkeys(override.sweep_string_iterator()))
        meaning = [parser.parse_override(f"{key}={text}").value() for text in texts]
        distribution = CategoricalDistribution(texts)
        as_known = {
            name: texts[meaning.index(value)] if value in meaning else None for name, value in found.items()
        }
    for name, value in as_known.items():
        try:
            # Optuna checks that the distribution contains the value.
            create_trial(params={key: value}, distributions={key: distribution}, value=0.0)
        except ValueError:
            raise PlacecatError(
                f"{override.input_line} does not contain {found[name]}, the value of {name}: widen "
                "the range, since this value is tried first"
            ) from None
    return distribution, as_known


def find_starts(
    keys: Sequence[str], config: DictConfig, params: Mapping[str, Any]
) -> dict[str, dict[str, Any]]:
    """Find the settings with which a search starts.

    Maps the source of each start to its values for the searched keys. `config` is the first start: the
    experiment composed without the searched settings, including Hydra's own settings. Raises PlacecatError
    for a key that `config` lacks. Cues in `params` that have the same descriptor and classifier as the
    experiment but different settings are also starts, since conf/cue contains the best settings in the
    thesis.
    """
    first = {key: _value(key, config) for key in keys}
    found = {SETTINGS: first}
    for name, cue in params.get("cues", {}).items():
        own = first | _of_cue(cue, params, config, keys)
        if own not in found.values():
            found[f"conf/cue/{name}.yaml"] = own
    return found


def _value(key: str, config: DictConfig) -> Any:
    """Return the value of a setting, or the chosen option of a group."""
    choices = config.hydra.runtime.choices
    if key in choices:
        return choices[key]
    missing = object()
    found = OmegaConf.select(config, key, default=missing)
    if found is missing:
        raise PlacecatError(f"{key} cannot be searched: the experiment has no such setting")
    return OmegaConf.to_container(found) if OmegaConf.is_config(found) else found


def _of_cue(
    cue: Mapping[str, Any], params: Mapping[str, Any], config: DictConfig, keys: Sequence[str]
) -> dict[str, Any]:
    """Return the searched classifier settings of a cue; {} if it has another descriptor or classifier."""
    codebook = cue.get("codebook")
    descriptor = cue["descriptor"] if codebook is None else params["codebooks"][codebook]["descriptor"]
    wanted = {f"descriptor.{name}": value for name, value in descriptor.items()}
    if descriptor["kind"] == "local":
        wanted["descriptor.tracked"] = descriptor.get("tracked", False)
    wanted["classifier.model"] = cue["classifier"]["model"]
    wanted["classifier.base.name"] = cue["classifier"]["base"]["name"]
    if any(OmegaConf.select(config, key) != value for key, value in wanted.items()):
        return {}
    own = OmegaConf.create({"classifier": cue["classifier"]})
    found = {key: OmegaConf.select(own, key) for key in keys if key.startswith("classifier.")}
    return {key: value for key, value in found.items() if value is not None}
