"""Recompute a cell by repeating the last steps, starting from the files of earlier stages."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from placecat import files, paths, settings
from placecat.errors import PlacecatError
from placecat.evaluation.trials import AXES
from placecat.provenance import numbering
from placecat.provenance.origins import from_json, measurement
from placecat.results.collect import read_results
from placecat.results.measured import Measured, Results
from placecat.results.quality import QUALITY_COLUMNS, from_rows, quality_rows
from placecat.results.sources import Source, sources
from placecat.stages import cues, filtering, integration, smoothing, splits, toy
from placecat.stages.scores import measure
from placecat.thesis import in_text, tables
from placecat.thesis.number import Number, Origin
from placecat.thesis.records import RECORD, trials_of
from placecat.training import fold_file
from placecat.training import plan as plans
from placecat.training.cue import Cue
from placecat.training.integration import smoothing_settings
from placecat.training.saved import smooth_home
from placecat.training.trial import judge, of_settings

Key = tuple[str, str, str]
Array = NDArray[np.float64]
# Maps (home, seed) to counts of decisions.
Counts = dict[tuple[str, str], NDArray[np.int64]]


@dataclass(frozen=True)
class _Recomputed(Source):
    """Recomputed distributions for some or all homes of a result."""

    arrays: Mapping[tuple[str, str], Array] = field(default_factory=dict)

    def array(self, home: str, seed: str) -> Array:
        return self.arrays[home, seed]


def compute(number: str) -> tuple[bool, str]:
    """Recompute a cell by its number, such as ``table_26.9.3``, and compare it with the stored cell.

    Smoothed, filtered and integrated results are recomputed from the files of the previous step. Cues are
    retrained on their stored features and codebook; trials and splits reuse only the features. Returns
    whether all bits match, and a description of the comparison. Raises PlacecatError if an earlier stage has
    not run.
    """
    params = settings.load()
    table = number.partition(".")[0]
    if not paths.ORIGINS.is_file():
        raise PlacecatError(f"{paths.ORIGINS} is missing, so nothing can be recomputed: run `dvc repro`")
    kept = from_json(files.read_json(paths.ORIGINS)[table])
    results = read_results(params)
    before = _numbers(table, params, results)
    key = before[number][0]
    steps: list[str] = []
    for origin in kept[key].origins:
        if not origin.result.startswith(RECORD):
            results = _recompute(origin, results, params, steps)
    values = measurement(_numbers(table, params, results)[number][1], results).values
    done = "; ".join(dict.fromkeys(steps)) or "read again"
    if values == kept[key].values:
        return True, f"{done}: all bits match"
    texts = [", ".join(map(repr, of)) or "no number" for of in (values, kept[key].values)]
    return False, f"{done}: the bits do NOT match: {texts[0]} instead of {texts[1]}"


def _numbers(table: str, params: Mapping[str, Any], results: Results) -> dict[str, tuple[Key, Number]]:
    """Compute a table from the results, and map each cell's number to its labels and value."""
    if table == in_text.NAME:
        filled, key = in_text.fill(results, params), in_text.KEY
    else:
        filled, key = tables.fill(tables.tables_of(params)[table], results, params), [*AXES]
    ids = numbering.numbers(filled, table)
    rows = filled[[*key, "number"]].itertuples(index=False, name=None)
    return {ids[first, second, third]: ((first, second, third), one) for first, second, third, one in rows}


def _recompute(origin: Origin, results: Results, params: Mapping[str, Any], steps: list[str]) -> Results:
    """Recompute an origin's result for its homes, and return all results."""
    name = origin.result
    if name not in results.measured:
        return results
    if name.startswith(("trials/", "toy/")):
        steps.append("retrained and retested")
        counts = _trial if name.startswith("trials/") else _toy
        return _with_counts(results, name, counts(name, origin.homes, results.measured[name], params))
    source = sources(params)[name]
    homes = tuple(home for home in source.homes if not origin.homes or home in origin.homes)
    source = replace(source, homes=homes)
    found = dict(_distributions(name, source, params, steps))
    recomputed = _Recomputed(source.folder, source.name, homes, source.site, source.classes, found)
    measured, quality = measure(recomputed, settings.get(params, "probabilities"))
    counts_of = {
        (home, seed): of_home
        for seed, of_seed in zip(measured.seeds, measured.confusion, strict=True)
        for home, of_home in zip(homes, of_seed, strict=True)
    }
    results = _with_counts(results, name, counts_of)
    # Converting to rows and back rounds numbers as the stage's file does. If several rows have the same
    # labels, the last one wins.
    rows = [*quality_rows(name, results.quality[name]), *quality_rows(name, quality)]
    rounded = from_rows(pd.DataFrame(rows, columns=QUALITY_COLUMNS))
    return replace(results, quality={**results.quality, **rounded})


def _with_counts(results: Results, name: str, counts: Counts) -> Results:
    one = results.measured[name]
    confusion = one.confusion.copy()
    for (home, seed), of_home in counts.items():
        confusion[one.seeds.index(seed), one.homes.index(home)] = of_home
    return replace(results, measured=results.measured | {name: replace(one, confusion=confusion)})


def _distributions(
    name: str, source: Source, params: Mapping[str, Any], steps: list[str]
) -> Iterator[tuple[tuple[str, str], Array]]:
    """Yield each (home, seed) with its recomputed distributions."""
    kind, _, rest = name.partition("/")
    if kind == "splits":
        steps.append("the complete split retrained from its features")
        yield from _of_split(rest, source, params)
        return
    step, function = _STEPS[kind]
    steps.append(step)
    for home in source.homes:
        for seed in source.seeds():
            yield (home, seed), function(rest, source, home, seed, params)


def _plan(params: Mapping[str, Any], scheme: str, home: str, *, extra: bool = False) -> plans.Plan:
    return plans.of_homes(params, scheme, [home], extra=extra)[0]


def _seed(name: str) -> int | None:
    return None if name == paths.NO_SEED else int(name.removeprefix("seed-"))


def _cue(rest: str, source: Source, home: str, seed: str, params: Mapping[str, Any]) -> Array:
    name, scheme = source.folder.parent.name, source.folder.name
    plan, cue, clusters, _ = cues.tasks(name, params)[scheme, home, seed]
    alone = replace(plan, integration=(), extra=())
    found: Array = cues.apply(alone, cue, clusters, cross_validate=source.name == "tempered")[source.name]
    return found


def _integration(name: str, source: Source, home: str, seed: str, params: Mapping[str, Any]) -> Array:
    system = settings.get(params, f"systems.{name}")
    plan = _plan(params, system["scheme"], home, extra=system["extra"])
    found: Array = integration.apply(system, plan, _seed(seed))["test"]
    return found


def _filtered(rest: str, source: Source, home: str, seed: str, params: Mapping[str, Any]) -> Array:
    name, _, result = rest.partition("/")
    homes = settings.get(params, "dataset.homes")
    options = settings.get(params, f"filters.{name}")
    threshold = filtering._threshold(options, [other for other in homes if other != home])
    saved = fold_file.path_of(filtering._sources(params, options)[result], home, seed)
    return filtering.filter_home(saved, home, threshold)["test"]


def _smoothed(rest: str, source: Source, home: str, seed: str, params: Mapping[str, Any]) -> Array:
    folder, scheme = smoothing.sources(params)[rest]
    saved, plan = fold_file.path_of(folder, home, seed), _plan(params, scheme, home)
    return smooth_home(saved, plan, smoothing_settings(params))[source.name]


_STEPS = {
    "cues": ("the cue retrained from its features and codebook", _cue),
    "tempered": ("the cue retrained from its features and codebook", _cue),
    "integration": ("integrated again from the distributions of its cues", _integration),
    "filtered": ("filtered again", _filtered),
    "hmm": ("smoothed again", _smoothed),
    "smoothing": ("smoothed again", _smoothed),
}


def _of_split(
    rest: str, source: Source, params: Mapping[str, Any]
) -> Iterator[tuple[tuple[str, str], Array]]:
    split, kind, name = rest.split("/", 2)
    own, plan = settings.get(params, f"splits.{split}"), plans.of_split(params, split)
    names = [name] if kind == "cues" else own["systems"][name]
    used = {cue: Cue.of(params, cue) for cue in names}
    for seed in source.seeds():
        number = _seed(seed)
        seeds = [None if cue.codebook is None else number for cue in used.values()]
        outputs = [splits.apply_cue(plan, cue, one) for cue, one in zip(used.values(), seeds, strict=True)]
        if kind == "cues":
            by_home = {home: {"test": proba} for home, proba in outputs[0][1].items()}
        else:
            by_home = splits.apply_system(plan, outputs, own["integrator"], smoothing_settings(params))
        for part in plan.tested:
            yield (part.sequence, seed), by_home[part.home][source.name]


def _trial(name: str, homes: Sequence[str], one: Measured, params: Mapping[str, Any]) -> Counts:
    cue = of_settings(trials_of(params)[name].settings)
    found = {}
    for home in homes:
        for seed in one.seeds:
            ((counts, _),) = judge(_plan(params, "5-5-1", home), [cue], _seed(seed))
            if not isinstance(counts, str):
                found[home, seed] = counts
    return found


def _toy(name: str, homes: Sequence[str], one: Measured, params: Mapping[str, Any]) -> Counts:
    options = settings.get(params, "toy")
    label = name.removeprefix("toy/")
    schemes, points = options["schemes"], options["points"]
    if label.removeprefix("last/") not in schemes:
        radius = float(label.partition("/")[0])
        points = points | {"radius": radius}
        # This function is private so that no stage depends on it.
        schemes = toy._deciding(schemes, options["sensitivity"]["decisions"], radius)
    found = {}
    for seed in one.seeds:
        number = int(seed.removeprefix("seed-"))
        counts = toy.compare(schemes, points, options["training"], options["testing"], number)
        found[one.homes[0], seed] = counts[label]
    return found
