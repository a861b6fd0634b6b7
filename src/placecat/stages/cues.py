"""Stage `cues`: train each cue for every fold and seed, and apply it to the frames that later stages need."""

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from placecat import cues, files, paths, settings
from placecat.fusion.temperature import temper
from placecat.runs import items
from placecat.stages import run
from placecat.training import fold_file, store
from placecat.training import plan as plans
from placecat.training.cue import Cue, fit, read_frames


def main() -> None:
    """Train and apply every cue in every fold of its schemes."""
    params = settings.load()
    homes = list(settings.get(params, "dataset.homes"))
    shared = [homes, settings.get(params, "dataset.classes"), settings.get(params, "protocol")]
    wanted = {
        name: items.Inputs([cue, *shared], tuple(_paths(cue, homes, params)))
        for name, cue in settings.get(params, "cues").items()
    }
    items.refresh_together("cues", paths.CUES, wanted, apply, lambda name: plan(name, params))


def _paths(cue: Mapping[str, Any], homes: Sequence[str], params: Mapping[str, Any]) -> Iterator[Path]:
    """Yield the files that a cue reads."""
    if cue["codebook"] is None:
        descriptor = cue["descriptor"]
    else:
        descriptor = settings.get(params, f"codebooks.{cue['codebook']}.descriptor")
        yield paths.CODEBOOKS / cue["codebook"]
    for home in homes:
        yield paths.sequences(home) / "labels.csv"
    extra = settings.get(params, "protocol.extra") if cue["extra"] else {"sequences": []}
    for home in [*homes, *(f"{extra['split']}/{sequence}" for sequence in extra["sequences"])]:
        yield from store.files_of(home, descriptor)


def tasks(name: str, params: Mapping[str, Any]) -> dict[tuple[str, str, str], tuple[Any, ...]]:
    """Map every (scheme, test home, seed name) of a cue to the arguments of :func:`apply`."""
    own, cue = settings.get(params, f"cues.{name}"), Cue.of(params, name)
    tested = settings.get(params, "protocol.test_homes")
    seeds = settings.get(params, "protocol.seeds") if cue.codebook is not None else [None]
    found: dict[tuple[str, str, str], tuple[Any, ...]] = {}
    for scheme in own["schemes"]:
        extra = own["extra"] and scheme == "5-5-1"
        for fold in plans.of_homes(params, scheme, tested, extra=extra):
            for seed in seeds:
                clusters = None
                if seed is not None:
                    clusters = paths.codebook(own["codebook"], fold.training_set, seed)
                place = scheme, fold.test, paths.seed_name(seed)
                found[place] = fold, cue, clusters, own["cross_validate"]
    return found


def plan(name: str, params: Mapping[str, Any]) -> items.Work:
    """Plan the training of one cue in every fold of its schemes, and name its result files."""
    of_cue = tasks(name, params)

    def write(folder: Path, results: list[dict[str, Any]]) -> None:
        for (scheme, test, seed_name), result in zip(of_cue, results, strict=True):
            facts = result.pop("facts")
            fold_file.write(fold_file.path_of(folder / scheme, test, seed_name), result, facts)

    return list(of_cue.values()), write


def apply(plan: plans.Plan, cue: Cue, clusters: Path | None, cross_validate: bool) -> dict[str, Any]:
    """Train one cue as planned; return its distributions for the frames that later stages need.

    `clusters` is the cue's codebook file, or None if it has no codebook.
    """
    codebook = None if clusters is None else cues.Codebook.from_arrays(files.read_arrays(clusters))
    frames = read_frames(plan.cues, cue.descriptor)
    trained = fit(frames, cue, plan.classes, codebook, cross_validate=cross_validate)
    result: dict[str, Any] = {"facts": dict(trained.model.facts), "test": trained.predict(plan.test)}
    for home, proba in trained.predict_chosen(plan.integration).items():
        result[f"integration_{home}"] = proba
    for part in plan.extra:
        result[f"extra_{part.sequence}"] = trained.predict(part.home)
    if trained.cross_validated is not None:
        result["cross_validated"] = trained.cross_validated
        result["cross_validated_truth"] = trained.truth
        result["facts"]["temperature"] = trained.temperature
        result["tempered"] = temper(result["test"], trained.temperature)
    return result


if __name__ == "__main__":
    run(main)
