"""Reading the command line as Hydra will, and refusing wrong combinations before anything is computed."""

import difflib
import re
from argparse import Namespace
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from hydra import compose, initialize_config_dir
from hydra._internal.core_plugins.basic_sweeper import BasicSweeper
from hydra.core.global_hydra import GlobalHydra
from hydra.core.override_parser.overrides_parser import OverridesParser
from hydra.core.override_parser.types import IntervalSweep, Override
from hydra.errors import HydraException
from omegaconf import DictConfig, OmegaConf
from omegaconf.errors import OmegaConfBaseException

from placecat import paths, settings
from placecat.errors import PlacecatError
from placecat.experiment.options import CONFIG
from placecat.experiment.output import OVERRIDES
from placecat.search import requirements

VERSION_BASE = "1.3"
# Hydra's message for an unknown option of a group.
_NO_OPTION = (
    r"Could not find '([^']+)/([^'/]+)'.*?Available options in '[^']+': (.*?)(?: Config search path:|$)"
)
# As many refused combinations as a message lists.
_LISTED = 8


@dataclass(frozen=True)
class Wanted:
    """What the command line asks for.

    Attributes
    ----------
    is_sweep
        Whether it is several experiments.
    swept
        The keys with several values, in the order given.
    combinations
        The values of these keys for each experiment, in Hydra's order; None where a search chooses them.
    base
        The settings that all have in common, composed.
    """

    is_sweep: bool
    swept: tuple[str, ...]
    combinations: list[dict[str, str]] | None
    base: dict[str, Any]


def need_project_folder() -> None:
    """Refuse to run elsewhere than in the project's folder."""
    for path in (paths.CONF / f"{CONFIG}.yaml", paths.PARAMS):
        if not path.is_file():
            raise PlacecatError(f"{path} is missing here ({Path.cwd()}): run this in the project's folder")


def read(arguments: Namespace) -> Wanted:
    """Find out which experiments the command line asks for, and check every one.

    Parameters
    ----------
    arguments
        Of Hydra's own parser.

    Raises
    ------
    PlacecatError
        What is wrong; with several wrong combinations, each of them and those that are right.
    """
    name = arguments.config_name or CONFIG
    extra = []
    if arguments.config_dir is not None:
        extra = [f"hydra.searchpath=[file://{Path(arguments.config_dir).resolve()}]"]
    with _told_plainly(), initialize_config_dir(str(paths.CONF.resolve()), version_base=VERSION_BASE):
        loader = GlobalHydra.instance().config_loader()
        parser = OverridesParser.create(config_loader=loader)
        given = parser.parse_overrides(arguments.overrides)
        # Composed with Hydra's own settings once, which is slow.
        fixed = [one.input_line or "" for one in given if not one.is_sweep_override()]
        first = [
            *fixed,
            *(_first(one) for one in given if one.is_sweep_override() and not one.is_hydra_override()),
        ]
        try:
            whole = _composed(name, [*extra, *first], with_hydra=True)
        except PlacecatError:
            # The first combination is wrong; which others are is told below.
            of_hydra = [str(one.input_line) for one in given if one.is_hydra_override()]
            whole = _composed(name, [*extra, *of_hydra], with_hydra=True)
        hydra = whole.hydra
        is_sweep = bool(arguments.multirun) or str(hydra.mode).endswith("MULTIRUN")
        by_conf = hydra.sweeper.get("params") or {}
        if is_sweep:
            # What the command line says of a setting takes the place of what a file of conf/search says.
            said = {_key(one) for one in given}
            given = parser.parse_overrides([f"{k}={v}" for k, v in by_conf.items() if k not in said]) + given
        own = [one for one in given if not one.is_hydra_override()]
        swept = [one for one in own if one.is_sweep_override()]
        if swept and not is_sweep:
            raise PlacecatError(
                f"{swept[0].input_line} has several values: add -m to run an experiment with each"
            )
        searches = not str(hydra.sweeper["_target_"]).endswith(f".{BasicSweeper.__name__}")
        if is_sweep and searches:
            requirements.check(whole)
        lines = _lines(own, searches=searches) if is_sweep else [[str(one.input_line) for one in own]]
        _check_all(name, extra, lines, [_key(one) for one in swept])
    base = OmegaConf.to_container(_without_hydra(whole), resolve=True)
    assert isinstance(base, dict)
    keys = tuple(dict.fromkeys(_key(one) for one in swept))
    combinations = None if searches and is_sweep else [_values(line, keys) for line in lines]
    return Wanted(is_sweep, keys, combinations, {str(key): value for key, value in base.items()})


def _lines(overrides: Sequence[Override], *, searches: bool) -> list[list[str]]:
    """The overrides of each experiment; of a search those at the ends of what it may choose."""
    if not searches:
        for one in overrides:
            if one.is_sweep_override() and not one.is_discrete_sweep():
                raise PlacecatError(
                    f"{one.input_line} is an interval, from which only a search can choose: write e.g. "
                    f"{_key(one)}={','.join(_ends(one))}"
                )
        return BasicSweeper.split_arguments(list(overrides), None)[0]
    start = [_first(one) if one.is_sweep_override() else str(one.input_line) for one in overrides]
    lines = [start]
    for place, one in enumerate(overrides):
        if one.is_sweep_override():
            lines += [[*start[:place], f"{_key(one)}={end}", *start[place + 1 :]] for end in _ends(one)]
    return lines


def _first(override: Override) -> str:
    return f"{_key(override)}={next(iter(_ends(override)))}"


def _ends(override: Override) -> Iterator[str]:
    """Every value of a choice; the ends of an interval."""
    if override.is_discrete_sweep():
        yield from override.sweep_string_iterator()
    else:
        interval = override.value()
        assert isinstance(interval, IntervalSweep)
        yield from (str(interval.start), str(interval.end))


def _key(override: Override) -> str:
    return override.get_key_element()


def _values(line: Sequence[str], keys: Sequence[str]) -> dict[str, str]:
    """The values of some keys among the overrides of an experiment."""
    split = dict(one.split("=", 1) for one in line if "=" in one)
    return {key: split[key] for key in keys if key in split}


def _check_all(name: str, extra: list[str], lines: list[list[str]], swept: list[str]) -> None:
    # Here, since it imports scikit-learn, which shell completion does without.
    from placecat.experiment.combination import resolve

    params = settings.load()
    refused: dict[str, list[str]] = {}
    right = []
    for line in lines:
        label = " ".join(f"{key}={value}" for key, value in _values(line, swept).items())
        try:
            config = OmegaConf.to_container(_composed(name, [*extra, *line]), resolve=True)
            assert isinstance(config, dict)
            resolve({str(key): value for key, value in config.items()}, params)
        except PlacecatError as error:
            refused.setdefault(str(error), []).append(label)
        else:
            right.append(label)
    if not refused:
        return
    if len(lines) == 1:
        raise PlacecatError(next(iter(refused)))
    count = sum(len(labels) for labels in refused.values())
    text = [f"{count} of {len(lines)} combinations are refused, nothing was computed:"]
    for message, labels in refused.items():
        text.append(f"- {message}")
        text += [f"    {label}" for label in _shortened(labels)]
    text.append("These are right:" if right else "None is right.")
    text += [f"    {label}" for label in _shortened(right)]
    raise PlacecatError("\n".join(text))


def _shortened(labels: list[str]) -> list[str]:
    if len(labels) <= _LISTED:
        return labels
    return [*labels[: _LISTED - 1], f"and {len(labels) - _LISTED + 1} more"]


def _composed(name: str, overrides: Sequence[str], *, with_hydra: bool = False) -> DictConfig:
    try:
        return compose(name, overrides=list(overrides), return_hydra_config=with_hydra)
    except (HydraException, OmegaConfBaseException) as error:
        raise PlacecatError(_why(error, name, overrides)) from None


def _why(error: Exception, name: str, overrides: Sequence[str]) -> str:
    """Hydra's message in one line, with what is valid instead."""
    text = " ".join(str(error).split())
    group = re.search(_NO_OPTION, text)
    if group:
        key, wanted, options = group[1], group[2], group[3].split()
        hint = _near(wanted, options)
        if wanted.startswith("submitit"):
            hint = ", or install it: pip install 'placecat[cluster]'"
        return f"{key}={wanted} does not exist: use one of {', '.join(options)}{hint}"
    unknown = re.search(r"Could not override '([^']+)'", text)
    if unknown:
        key = unknown[1]
        parent, _, last = key.rpartition(".")
        rest = [one for one in overrides if one.split("=", 1)[0] != key]
        chosen = [one for one in rest if one.split("=", 1)[0] == parent.split(".")[0]]
        try:
            config = compose(name, overrides=rest)
            found = OmegaConf.select(config, parent) if parent else config
            valid = [str(one) for one in found] if isinstance(found, DictConfig) else []
        except (HydraException, OmegaConfBaseException):
            valid = []
        where = " ".join(chosen) or parent or "an experiment"
        return f"{where} has no setting {last}: it has {', '.join(valid) or 'none'}{_near(last, valid)}"
    return f"the settings cannot be composed: {text}"


def _near(wanted: str, options: Sequence[str]) -> str:
    near = difflib.get_close_matches(wanted, options, n=1)
    return f" (did you mean {near[0]}?)" if near else ""


def _without_hydra(config: DictConfig) -> DictConfig:
    return OmegaConf.masked_copy(config, [str(key) for key in config if key != "hydra"])


@contextmanager
def _told_plainly() -> Iterator[None]:
    try:
        yield
    except (HydraException, OmegaConfBaseException) as error:
        raise PlacecatError(f"the command line cannot be read: {' '.join(str(error).split())}") from None


def values_in(folder: Path) -> Mapping[str, str]:
    """The overrides of the experiment in a folder, as Hydra wrote them."""
    path = folder / OVERRIDES
    given = OmegaConf.to_container(OmegaConf.load(path)) if path.is_file() else []
    assert isinstance(given, list)
    return dict(str(one).split("=", 1) for one in given if "=" in str(one))
