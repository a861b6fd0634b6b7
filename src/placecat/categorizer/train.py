"""Train a system on homes whose features the stages have computed, to be applied to other footage."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from placecat import cue_training, files, listing, parallel, paths, settings, store
from placecat.categorizer import model_file
from placecat.categorizer.card import make_card
from placecat.categorizer.system import TrainedCue, TrainedSystem
from placecat.cues.codebook import Codebook, seed_of, settings_of
from placecat.errors import PlacecatError
from placecat.evaluation import protocol
from placecat.fusion import integrate, smoothing
from placecat.fusion.temperature import fit_temperature
from placecat.lockfile import data_version

Probabilities = dict[str, NDArray[np.float64]]


def train_command(system: str | None, without: str | None, seed: int | None, output: Path | None) -> int:
    """Train a system and write it: `placecat train`.

    Parameters
    ----------
    system
        One of conf/system; None for ``model.system``.
    without
        A home that is left out of all training; None to train on all.
    seed
        One of ``protocol.seeds``; None for ``model.seed``.
    output
        None for data/model.placecat, or data/models/SYSTEM-without-HOME.placecat with a home left out.

    Returns
    -------
    int
        0; mistakes raise PlacecatError.
    """
    params = settings.load()
    name = system if system is not None else str(settings.get(params, "model.system"))
    if output is None:
        is_default = system is None and without is None and seed is None
        parts = [
            name,
            *([f"without-{without}"] if without else []),
            *([f"seed-{seed}"] if seed is not None else []),
        ]
        output = paths.MODEL if is_default else paths.MODELS / f"{'-'.join(parts)}.placecat"
    files.check_file(output)
    trained = train(params, name, without=without, seed=seed)
    model_file.write(output, trained)
    print(f"{trained.card['title']}: {output}, {output.stat().st_size / 1e6:.1f} MB")
    print(f"`placecat predict SOURCE --model {output}` applies it to new footage.")
    return 0


def train(
    params: Mapping[str, Any], name: str, *, without: str | None = None, seed: int | None = None
) -> TrainedSystem:
    """Train a system on all homes, or on all but one.

    Without one home it is what the stages apply to that home, to the bit.

    Parameters
    ----------
    params
        All settings.
    name
        Of the system.
    without
        The home that is left out.
    seed
        As for :func:`train_command`.

    Raises
    ------
    PlacecatError
        An unknown system, home or seed; features that were not computed.
    """
    system = settings.get(params, f"systems.{name}")
    homes = list(settings.get(params, "dataset.homes"))
    classes = list(settings.get(params, "dataset.classes"))
    seed = int(settings.get(params, "model.seed")) if seed is None else seed
    seeds = settings.get(params, "protocol.seeds")
    if seed not in seeds:
        raise PlacecatError(f"seed {seed} is none of protocol.seeds: use one of {', '.join(map(str, seeds))}")
    if without is not None and without not in homes:
        raise PlacecatError(f"there is no home {without!r} to leave out: use one of {', '.join(homes)}")
    fold = _fold(homes, system["scheme"], without)
    sections = settings.get(params, "protocol")
    extra = [
        f"{sections['extra']['split']}/{sequence}"
        for sequence in (sections["extra"]["sequences"] if system["extra"] else [])
    ]
    tempered = bool(system["temperature"])
    tasks = [(params, cue, fold, seed, extra, classes, tempered) for cue in system["cues"]]
    done = parallel.in_parallel(_train_cue, tasks, f"training of {name}")
    cues = tuple(cue for cue, *_ in done)
    chosen = _integration_frames(params, fold, extra, classes)
    proba = {
        home: np.stack([one[home] for _, one, _ in done], axis=1)
        for home in (*fold.integration_homes, *extra)
    }
    trained = integrate.fit(
        proba,
        {home: labels for home, (_, labels) in chosen.items()},
        classes,
        temperatures=[one for *_, one in done] if tempered else None,
        **system["integrator"],
    )
    assert trained.cross_validated is not None
    walks, frame_rates = listing.walks(fold.integration_homes)
    options = {key: value for key, value in params["smoothing"].items() if key not in ("cues", "filtered")}
    model = smoothing.fit(
        walks,
        trained.cross_validated,
        trained.truth,
        len(classes),
        training_frame_rates=frame_rates,
        **options,
    )
    return TrainedSystem(
        card=_card(params, name, fold, seed, {home: len(rows) for home, (rows, _) in chosen.items()}),
        vision=_vision(params, cues),
        tracking=_tracking(params, cues),
        cues=cues,
        integrator=trained.integrator,
        smoothing=model,
    )


def _fold(homes: Sequence[str], scheme: str, without: str | None) -> protocol.Fold:
    if without is None:
        return protocol.fold_of_all(homes, scheme)
    (fold,) = [fold for fold in protocol.folds(homes, scheme) if fold.test == without]
    return fold


def _integration_frames(
    params: Mapping[str, Any], fold: protocol.Fold, extra: Sequence[str], classes: Sequence[str]
) -> dict[str, tuple[NDArray[np.int64], NDArray[np.int16]]]:
    """Frames of each home that train the integration, and their classes."""
    selection = settings.get(params, "protocol.integration_frames")
    labels = {home: listing.read_labels(home) for home in fold.integration_homes}
    for home in extra:
        split = home.partition("/")[0]
        own = settings.get(params, f"splits.{split}.dataset.classes")
        labels[home] = protocol.translate(listing.read_labels(home), own, classes)
    chosen = protocol.select_training(labels, **selection)
    return {home: (rows, labels[home][rows]) for home, rows in chosen.items()}


def _train_cue(
    params: Mapping[str, Any],
    name: str,
    fold: protocol.Fold,
    seed: int,
    extra: Sequence[str],
    classes: Sequence[str],
    tempered: bool,
) -> tuple[TrainedCue, Probabilities, float]:
    """Train one cue; give it, its distributions for the integration's frames, and its temperature."""
    cue = settings.get(params, f"cues.{name}")
    frames = settings.get(params, "protocol.cue_frames")
    codebook = None
    if cue["codebook"] is None:
        descriptor = cue["descriptor"]
    else:
        own = settings_of(params, cue["codebook"])
        descriptor = own["descriptor"]
        labels = {home: listing.read_labels(home) for home in fold.cue_homes}
        codebook = Codebook.fit(
            store.read_training(fold.cue_homes, descriptor, protocol.select_training(labels, **frames)),
            cells=own["cells"],
            seed=seed_of(params["dataset"]["name"], descriptor, own["cells"], fold.training_set, seed),
            tree=own["tree"],
        )
    trained = cue_training.train(
        fold.cue_homes,
        descriptor,
        classifier=cue["classifier"],
        codebook=codebook,
        frames=frames,
        classes=classes,
        cross_validate=tempered,
    )
    temperature = 1.0
    if trained.cross_validated is not None:
        temperature = fit_temperature(trained.cross_validated, trained.truth)
    proba = {
        home: trained.model.predict_proba(store.read_descriptors(home, descriptor, rows))
        for home, (rows, _) in _integration_frames(params, fold, extra, classes).items()
    }
    return TrainedCue(name, dict(descriptor), trained.model), proba, temperature


def _vision(params: Mapping[str, Any], cues: Sequence[TrainedCue]) -> dict[str, Any]:
    """The settings of the vision, with the descriptors that the cues need."""
    wanted: dict[str, dict[str, Any]] = {"local": {}, "holistic": {}}
    for cue in cues:
        kind = cue.descriptor["kind"]
        for name in filter(None, (cue.descriptor["name"], cue.descriptor.get("color"))):
            wanted[kind][name] = settings.get(params, f"descriptors.{kind}.{name}")
    sections = {name: settings.get(params, name) for name in ("attention", "regions", "information")}
    return sections | wanted


def _tracking(params: Mapping[str, Any], cues: Sequence[TrainedCue]) -> dict[str, Any] | None:
    if not any(cue.descriptor.get("tracked", False) for cue in cues):
        return None
    return {name: value for name, value in settings.get(params, "tracking").items() if name != "descriptors"}


def _card(
    params: Mapping[str, Any], name: str, fold: protocol.Fold, seed: int, fused: Mapping[str, int]
) -> dict[str, Any]:
    system = settings.get(params, f"systems.{name}")
    homes = list(fold.integration_homes)
    facts = [files.read_json(paths.sequences(home) / "home.json") for home in homes]
    selection = settings.get(params, "protocol.cue_frames")
    labels = {home: listing.read_labels(home) for home in fold.cue_homes}
    chosen = protocol.select_training(labels, **selection)
    dataset = settings.get(params, "dataset")
    cues = {cue: settings.get(params, f"cues.{cue}") for cue in system["cues"]}
    codebooks = {cue["codebook"] for cue in cues.values() if cue["codebook"] is not None}
    return make_card(
        title=f"{system['title']}, with smoothing; {dataset['title']}",
        data={
            "title": dataset["title"],
            "version": data_version(),
            "homes": homes,
            "left_out": fold.test,
            "frames": {"cues": sum(map(len, chosen.values())), "integration": sum(fused.values())},
        },
        classes=dataset["classes"],
        frame_sizes=sorted({(own["width"], own["height"]) for own in facts}),
        fps=sorted({own["fps"] for own in facts}),
        accuracy=_accuracy(name),
        settings={
            "system": {name: system},
            "seed": seed,
            "cues": cues,
            "codebooks": {key: settings.get(params, f"codebooks.{key}") for key in sorted(codebooks)},
            "protocol": settings.get(params, "protocol"),
            "smoothing": settings.get(params, "smoothing"),
        },
    )


def _accuracy(system: str) -> dict[str, float]:
    """Percent in each home by the systems of the same settings that left it out, if that was measured."""
    if not paths.ACCURACIES.is_file():
        return {}
    table = pd.read_csv(paths.ACCURACIES)
    own = table[(table["result"] == f"smoothing/{system}") & (table["place"] == "all")]
    return {str(home): float(value) for home, value in zip(own["home"], own["accuracy"], strict=True)}
