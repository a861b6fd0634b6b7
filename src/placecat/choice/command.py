"""The command `python -m placecat.choice`."""

import itertools
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Annotated, Any

import pandas as pd
from annotated_types import Interval, MinLen

from placecat import files, paths, schema, settings
from placecat.choice.candidates import COLUMNS, NUMBERS, TEXT, choose, combinations, label
from placecat.choice.judging import (
    Judgement,
    judge_cue,
    judge_smoothing,
    judge_system,
    left_out,
    predict_unseen,
)
from placecat.compute import parallel
from placecat.config import conf_file
from placecat.errors import PlacecatError
from placecat.ranges import PartShare
from placecat.schema.base import Keys, Section
from placecat.training import fold_file
from placecat.training import plan as plans
from placecat.training.cue import Cue
from placecat.training.integration import smoothing_settings

SETTINGS = paths.CONF / "choice.yaml"
_TRIES = f"{SETTINGS} tries"
KINDS = ("cues", "systems", "smoothing")
_DECIMALS = {"accuracy": 2, "test_accuracy": 2, "log_loss": 4, "test_log_loss": 4}


class _Candidates(Section):
    """The cues or systems for which to choose settings, and the grids of settings to try."""

    names: Keys
    grids: list[dict[str, Annotated[list[Any], MinLen(1)]]]


class _Choice(Section):
    """The settings in conf/choice.yaml. `margin` is in points of accuracy."""

    margin: Annotated[float, Interval(ge=0, lt=100)]
    smallest: PartShare
    cues: _Candidates
    systems: _Candidates
    smoothing: _Candidates


def read_settings(path: Path = SETTINGS) -> dict[str, Any]:
    """Read conf/choice.yaml; raise PlacecatError if a setting is unknown, missing or invalid."""
    content = conf_file.read(path, list(_Choice.model_fields))
    schema.check(content, _Choice)
    return content


def run(kinds: Sequence[str] = KINDS, output: Path = paths.CROSS_VALIDATION) -> pd.DataFrame:
    """Judge every candidate on the data set in params.yaml, then choose based on all data sets in `output`.

    Replaces the rows for this data set and these kinds in `output`, and keeps the others. Returns the result
    of :func:`placecat.choice.candidates.choose`. Raises PlacecatError for invalid settings, or if features or
    cues have not been computed.
    """
    options, params = read_settings(), settings.load()
    data = str(settings.get(params, "dataset.title"))
    table = files.read_table(output, TEXT) if output.is_file() else pd.DataFrame(columns=COLUMNS)
    for kind in kinds:
        rows = _judge(data, kind, *_TASKS[kind](options, params))
        judged = pd.DataFrame(rows, columns=COLUMNS).round(_DECIMALS)
        others = table[(table["data"] != data) | (table["kind"] != kind)]
        table = judged if others.empty else pd.concat([others, judged])
        table = table.sort_values(["data", "kind"], kind="stable")
        files.write_csv(output, table)
    return choose(table, float(options["margin"]))


# The name of a cue or system, the label of a candidate, and the arguments of the function that judges it.
Task = tuple[str, str, tuple[Any, ...]]
Tasks = tuple[Callable[..., list[Judgement]], list[Task]]


def _judge(
    data: str, kind: str, function: Callable[..., list[Judgement]], tasks: Sequence[Task]
) -> list[tuple[Any, ...]]:
    done = parallel.in_parallel(function, [task for *_, task in tasks], f"candidates for {kind}")
    judged = [
        (name, candidate, *judgement)
        for (name, candidate, _), judgements in zip(tasks, done, strict=True)
        for judgement in judgements
    ]
    frame = pd.DataFrame(judged, columns=["name", "candidate", "test_home", "home", *NUMBERS])
    rows = []
    for (name, candidate, test), part in frame.groupby(["name", "candidate", "test_home"], sort=False):
        is_test = part["home"] == test
        training, tested = part[~is_test][NUMBERS].mean(), part[is_test][NUMBERS].mean()
        rows.append((data, kind, name, candidate, test, *training, *tested))
    return rows


def _cue_tasks(options: Mapping[str, Any], params: Mapping[str, Any]) -> Tasks:
    planned = [
        plans.without_homes(params, homes) for homes in left_out(settings.get(params, "dataset.homes"))
    ]
    tasks: list[Task] = []
    for name in options["cues"]["names"]:
        cue = _without_codebook(params, name)
        for overrides in combinations(options["cues"]["grids"]):
            own = settings.changed(cue, overrides, _TRIES, f"the cue {name}")
            candidate = Cue(own["descriptor"], own["classifier"])
            tasks += [
                (name, label(overrides), (plan, candidate, float(options["smallest"]))) for plan in planned
            ]
    return judge_cue, tasks


def _system_tasks(options: Mapping[str, Any], params: Mapping[str, Any]) -> Tasks:
    tasks: list[Task] = []
    for name in options["systems"]["names"]:
        system = settings.get(params, f"systems.{name}")
        for overrides in combinations(options["systems"]["grids"]):
            own = settings.changed(system, overrides, _TRIES, f"the system {name}")
            schema.check({"systems": {name: own}})
            tasks += [
                (name, label(overrides), (own | {"scheme": scheme}, plan, seed, float(options["smallest"])))
                for scheme in ("4-5-1", "5-5-1")
                for plan in plans.of_homes(params, scheme)
                for seed in settings.get(params, "protocol.seeds")
            ]
    return judge_system, tasks


def _smoothing_tasks(options: Mapping[str, Any], params: Mapping[str, Any]) -> Tasks:
    homes = list(settings.get(params, "dataset.homes"))
    model, smallest = smoothing_settings(params), float(options["smallest"])
    tasks: list[Task] = []
    for name in options["smoothing"]["names"]:
        own, scheme = _without_codebook(params, name), settings.get(params, f"cues.{name}.schemes")[0]
        cue, pairs = Cue(own["descriptor"], own["classifier"]), list(itertools.combinations(homes, 2))
        wanted = [(plans.without_homes(params, pair), cue) for pair in pairs]
        done = parallel.in_parallel(predict_unseen, wanted, f"cue {name} without two homes")
        unseen: dict[str, dict[str, Any]] = {home: {} for home in homes}
        for (first, second), proba in zip(pairs, done, strict=True):
            unseen[first][second], unseen[second][first] = proba[second], proba[first]
        for overrides in combinations(options["smoothing"]["grids"]):
            candidate = settings.changed(model, overrides, _TRIES, "the smoothing")
            schema.check({"smoothing": settings.get(params, "smoothing") | candidate})
            for plan in plans.of_homes(params, scheme):
                source = fold_file.seeded(paths.CUES / name / scheme, plan.test, None)
                task = candidate, source, plan, unseen[plan.test], smallest
                tasks.append((name, label(overrides), task))
    return judge_smoothing, tasks


def _without_codebook(params: Mapping[str, Any], name: str) -> Mapping[str, Any]:
    cue: Mapping[str, Any] = settings.get(params, f"cues.{name}")
    if cue["codebook"] is not None:
        raise PlacecatError(f"{SETTINGS}: the cue {name} has a codebook; list only cues without one")
    return cue


_TASKS = {"cues": _cue_tasks, "systems": _system_tasks, "smoothing": _smoothing_tasks}


def text(chosen: pd.DataFrame) -> str:
    """Format the chosen candidate for each cue and system, and the three runners-up."""
    lines = []
    for (kind, name), part in chosen.groupby(["kind", "name"], sort=False):
        ordered = part.sort_values(["chosen", "accuracy"], ascending=False)
        lines.append(f"{name} ({kind}, {len(part)} candidates)")
        for row in ordered.head(4).itertuples():
            mark = "chosen" if row.chosen else "      "
            lines.append(f"  {mark} {row.accuracy:6.2f}%  log-loss {row.log_loss:.3f}  {row.candidate}")
    return "\n".join(lines)
