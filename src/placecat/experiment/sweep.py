"""List the experiments of a sweep, and check all of them before the first one runs."""

import itertools
import sys
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from hydra import compose
from hydra.core.config_loader import ConfigLoader
from hydra.core.override_parser.overrides_parser import OverridesParser
from hydra.errors import HydraException
from omegaconf import DictConfig, OmegaConf
from omegaconf.errors import OmegaConfBaseException

from placecat import settings
from placecat.config.compose import refusal
from placecat.errors import PlacecatError
from placecat.experiment import output, summary
from placecat.experiment.combination import Experiment, resolve
from placecat.runs import lock

_REFUSALS = (PlacecatError, HydraException, OmegaConfBaseException)
# A message lists at most this many invalid combinations per reason.
_LISTED = 8


def grid(arguments: Sequence[str], loader: ConfigLoader) -> tuple[list[list[str]], list[dict[str, str]]]:
    """List all combinations of the values in Hydra overrides; ``glob`` needs Hydra's `loader`.

    Returns the overrides of each experiment, in Hydra's order, and its values for the swept keys. Raises
    PlacecatError for an interval, which only a search allows.
    """
    overrides = OverridesParser.create(config_loader=loader).parse_overrides(list(arguments))
    last = {one.get_key_element(): one for one in overrides}
    choices: list[list[tuple[str, dict[str, str]]]] = []
    for one in overrides:
        if one.is_sweep_override() and one is not last[one.get_key_element()]:
            # Hydra uses only the last override of a key.
            continue
        if not one.is_sweep_override():
            choices.append([(str(one.input_line), {})])
        elif one.is_discrete_sweep():
            key = one.get_key_element()
            choices.append([(f"{key}={value}", {key: value}) for value in one.sweep_string_iterator()])
        else:
            raise PlacecatError(
                f"{one.input_line} is an interval, which only a search allows: list single values"
            )
    lines, combinations = [], []
    for parts in itertools.product(*choices):
        lines.append([line for line, _ in parts])
        combinations.append({key: value for _, own in parts for key, value in own.items()})
    return lines, combinations


def check(
    config: DictConfig, lines: Sequence[Sequence[str]], combinations: Sequence[dict[str, str]]
) -> list[Experiment]:
    """Resolve each combination; raise a PlacecatError that lists the invalid ones, with reasons.

    `config` is the composed configuration of the sweep, including Hydra's settings. `lines` contains the
    overrides of each experiment; `combinations` contains its swept values, for messages.
    """
    params = settings.load()
    experiments: list[Experiment] = []
    refused: dict[str, list[str]] = {}
    for line, own in zip(lines, combinations, strict=True):
        try:
            experiments.append(_meant(config, line, params))
        except _REFUSALS as error:
            reason = error if isinstance(error, PlacecatError) else refusal(error)
            refused.setdefault(" ".join(str(reason).split()), []).append(summary.label(own))
    if refused:
        count = sum(map(len, refused.values()))
        text = [f"{count} of {len(lines)} combinations are invalid; nothing was computed:"]
        for message, labels in refused.items():
            text += [f"- {message}", *(f"    {label}" for label in labels[:_LISTED])]
            if len(labels) > _LISTED:
                text.append(f"    and {len(labels) - _LISTED} more")
        raise PlacecatError("\n".join(text))
    return experiments


def meant(config: DictConfig, line: Sequence[str]) -> Experiment | None:
    """Resolve one combination, or return None if it is invalid; see `check` for the parameters."""
    try:
        return _meant(config, line, settings.load())
    except _REFUSALS:
        return None


def _meant(config: DictConfig, line: Sequence[str], params: Mapping[str, Any]) -> Experiment:
    composed = compose(config.hydra.job.config_name, overrides=[*config.hydra.overrides.hydra, *line])
    return resolve(OmegaConf.to_container(composed, resolve=True), params)  # type: ignore[arg-type]


@contextmanager
def begun(config: DictConfig, combinations: Sequence[dict[str, str]]) -> Iterator[Path]:
    """Lock the sweep's folder, which may contain finished jobs, and yield it.

    Waits while another process holds the lock. If the block fails, reports the results so far; on Ctrl-C,
    prints how to resume.
    """
    folder = Path(config.hydra.sweep.dir)
    folder.mkdir(parents=True, exist_ok=True)
    with lock.waiting(folder / ".lock", f"Another process is running this sweep ({folder}): waiting for it."):
        # Remove the old summary, since some jobs may run again.
        (folder / output.SUMMARY).unlink(missing_ok=True)
        OmegaConf.save(config, folder / "multirun.yaml")
        try:
            yield folder
        except KeyboardInterrupt:
            print(f"placecat: stopped; the same command resumes {folder}", file=sys.stderr, flush=True)
            raise
        except Exception:
            # Do not log yet, since the same command resumes the sweep.
            summary.tell(folder, combinations, log=None)
            raise
