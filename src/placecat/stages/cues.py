"""Stage `cues`: train one cue for every fold and seed and apply it to the frames that later stages need."""

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from placecat import cue_training, cues, files, items, listing, parallel, paths, settings, store
from placecat.evaluation import protocol
from placecat.fusion.temperature import fit_temperature, temper
from placecat.stages import run


def main() -> None:
    """Train and apply every cue in every fold of every scheme that it is wanted for."""
    params = settings.load()
    homes = list(settings.get(params, "dataset.homes"))
    shared = [homes, settings.get(params, "dataset.classes"), settings.get(params, "protocol")]
    wanted = {
        name: items.Inputs([cue, *shared], tuple(_paths(cue, homes, params)))
        for name, cue in settings.get(params, "cues").items()
    }
    items.refresh("cues", paths.CUES, wanted, lambda name, folder: make(name, folder, params))


def _paths(cue: Mapping[str, Any], homes: Sequence[str], params: Mapping[str, Any]) -> Iterator[Path]:
    """What a cue reads."""
    if cue["codebook"] is None:
        descriptor = cue["descriptor"]
    else:
        descriptor = settings.get(params, f"codebooks.{cue['codebook']}.descriptor")
        yield paths.CODEBOOKS / cue["codebook"]
    for home in homes:
        yield paths.sequences(home) / "labels.csv"
    for home in [*homes, *(_extra_homes(params) if cue["extra"] else [])]:
        yield from store.files_of(home, descriptor)


def make(name: str, folder: Path, params: Mapping[str, Any]) -> None:
    """Train and apply one cue in every fold of every scheme that it is wanted for."""
    cue = settings.get(params, f"cues.{name}")
    homes = list(settings.get(params, "dataset.homes"))
    classes = settings.get(params, "dataset.classes")
    selections = settings.get(params, "protocol")
    seeds = selections["seeds"] if cue["codebook"] is not None else [None]
    extra = _extra_homes(params) if cue["extra"] else []
    tasks = [
        (cue, fold, seed, selections, classes, extra if fold.scheme == "5-5-1" else [])
        for scheme in cue["schemes"]
        for fold in protocol.folds(homes, scheme, settings.get(selections, "test_homes"))
        for seed in seeds
    ]
    results = parallel.in_parallel(apply, tasks, f"cue {name}")
    for (_, fold, seed, *_), result in zip(tasks, results, strict=True):
        place = folder / fold.scheme / fold.test / protocol.seed_folder(seed)
        files.write_json(place / "facts.json", result.pop("facts"))
        for array_name, array in result.items():
            files.write_array(place / f"{array_name}.npy", array)


def _extra_homes(params: Mapping[str, Any]) -> list[str]:
    """Sequences of another data set that the integration may train on in addition (thesis 4.5)."""
    extra = settings.get(params, "protocol.extra")
    return [f"{extra['split']}/{sequence}" for sequence in extra["sequences"]]


def apply(
    cue: Mapping[str, Any],
    fold: protocol.Fold,
    seed: int | None,
    selections: Mapping[str, Any],
    classes: Sequence[str],
    extra: Sequence[str],
) -> dict[str, Any]:
    """Train one cue on one fold's training homes; give its distributions for the frames of later stages."""
    labels = {home: listing.read_labels(home) for home in fold.integration_homes}
    other_frames = protocol.select_training(labels, **selections["integration_frames"])
    if seed is None:
        codebook, descriptor = None, cue["descriptor"]
    else:
        folder = paths.CODEBOOKS / cue["codebook"]
        file = folder / protocol.codebook_file(fold.training_set, seed)
        codebook = cues.Codebook.from_arrays(files.read_arrays(file))
        descriptor = files.read_json(folder / "descriptor.json")
    trained = cue_training.train(
        fold.cue_homes,
        descriptor,
        classifier=cue["classifier"],
        codebook=codebook,
        frames=selections["cue_frames"],
        classes=classes,
        cross_validate=cue["cross_validate"],
    )
    model = trained.model
    result: dict[str, Any] = {"facts": dict(model.facts)}
    result["test"] = model.predict_proba(store.read_descriptors(fold.test, descriptor))
    for home in fold.integration_homes:
        frames = store.read_descriptors(home, descriptor, other_frames[home])
        result[f"integration_{home}"] = model.predict_proba(frames)
    for home in extra:
        frames = store.read_descriptors(home, descriptor)
        result[f"extra_{home.rpartition('/')[2]}"] = model.predict_proba(frames)
    if trained.cross_validated is not None:
        result["cross_validated"] = trained.cross_validated
        result["cross_validated_truth"] = trained.truth
        temperature = fit_temperature(trained.cross_validated, trained.truth)
        result["facts"]["temperature"] = temperature
        result["tempered"] = temper(result["test"], temperature)
    return result


if __name__ == "__main__":
    run(main)
