"""Train a system for new footage, on the homes for which the stages have computed features."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from placecat import files, paths, settings
from placecat.categorizer import held_out, model_file
from placecat.categorizer.card import make_card, unknown_text
from placecat.categorizer.system import TrainedCue, TrainedSystem
from placecat.errors import PlacecatError
from placecat.runs.lockfile import check_data, data_version
from placecat.training import plan as plans
from placecat.training import system as systems
from placecat.training.integration import fused_parts


def train_command(system: str | None, without: Sequence[str], seed: int | None, output: Path | None) -> int:
    """Run `placecat train`: train a system, measure it in unseen homes, and write it to a file.

    `system` is the name of a system in conf/system, by default ``model.system``. `seed` is one of
    ``protocol.seeds``, by default ``model.seed``. The homes in `without` are left out of all training. By
    default, `output` is data/model.placecat, or, if any other option is given, a file in data/models named
    after the options, such as SYSTEM-without-HOME.placecat. Returns 0. User errors raise PlacecatError.
    """
    params = settings.load()
    name = system if system is not None else str(settings.get(params, "model.system"))
    without = list(dict.fromkeys(without))
    if output is None:
        is_default = system is None and not without and seed is None
        left_out = "".join(f"-without-{home}" for home in without)
        seeded = f"-seed-{seed}" if seed is not None else ""
        output = paths.MODEL if is_default else paths.MODELS / f"{name}{left_out}{seeded}.placecat"
    files.check_writable(output)
    if output.exists() and not model_file.is_model(output):
        raise PlacecatError(
            f"{output} already exists and is not a model, so it will not be overwritten: choose another "
            "--output"
        )
    check_data(params)
    for home in settings.get(params, "dataset.homes"):
        if not (paths.FEATURES / home).is_dir():
            raise PlacecatError(f"{paths.FEATURES / home} is missing: run `placecat repro` first")
    trained = train(params, name, without=without, seed=seed)
    print(
        "The system has been trained. To measure it in unseen homes, training is now repeated with each home "
        "left out.",
        flush=True,
    )
    trained = measured(
        trained, params, held_out.by_training(params, name, without, trained.card["settings"]["seed"])
    )
    model_file.write(output, trained)
    print(f"{trained.card['title']}: {output}, {output.stat().st_size / 1e6:.1f} MB")
    print(unknown_text(trained.card))
    print(f"`placecat predict SOURCE --model {output}` applies it to new footage.")
    return 0


def train(
    params: Mapping[str, Any], name: str, *, without: Sequence[str] = (), seed: int | None = None
) -> TrainedSystem:
    """Train the system `name` on all homes not in `without`. For `seed`, see :func:`train_command`.

    If `without` contains a single home, the system is identical to the one that the stages apply to that
    home. Its card has no measurements; :func:`measured` adds them. Raises PlacecatError for an unknown
    system, home or seed, for too few homes, and for missing features.
    """
    seed = int(settings.get(params, "model.seed")) if seed is None else seed
    seeds = settings.get(params, "protocol.seeds")
    if seed not in seeds:
        raise PlacecatError(
            f"seed {seed} is not one of protocol.seeds: use one of {', '.join(map(str, seeds))}"
        )
    system, scheme = systems.System.of(params, name), settings.get(params, f"systems.{name}.scheme")
    plan = plans.of_release(params, scheme, without, extra=system.extra)
    return assemble(params, system, systems.train(plan, system, seed), _card(params, name, plan, seed))


def assemble(
    params: Mapping[str, Any], system: systems.System, trained: systems.Trained, card: dict[str, Any]
) -> TrainedSystem:
    """Combine the trained parts of a system with its vision settings and its card."""
    sections = {section: settings.get(params, section) for section in ("attention", "regions", "information")}
    cues = tuple(TrainedCue(cue, dict(own.descriptor), own.model) for cue, own in trained.cues.items())
    tracking = None
    if any(cue.is_tracked for cue in cues):
        own = settings.get(params, "tracking")
        tracking = {name: value for name, value in own.items() if name != "descriptors"}
    return TrainedSystem(
        card=card,
        vision=sections | system.descriptors(params),
        tracking=tracking,
        cues=cues,
        integrator=trained.integrator,
        smoothing=trained.smoothing,
    )


def measured(system: TrainedSystem, params: Mapping[str, Any], decisions: held_out.HeldOut) -> TrainedSystem:
    """Add measurements to the card. `decisions` come from systems with the same settings in unseen homes."""
    risk, shown = (settings.get(params, f"model.{setting}") for setting in ("risk", "risks_shown"))
    facts = {
        "accuracy": held_out.accuracies(decisions),
        "unknown": held_out.unknown(decisions, risk, shown),
    }
    return replace(system, card=system.card | facts)


def _card(params: Mapping[str, Any], name: str, plan: plans.Plan, seed: int) -> dict[str, Any]:
    system = settings.get(params, f"systems.{name}")
    homes = [part.home for part in plan.integration]
    facts = [files.read_json(paths.sequences(home) / "home.json") for home in homes]
    fused = fused_parts(plan, method=system["integrator"]["method"], extra=system["extra"])
    trained_on = {"cues": plan.cues, "integration": fused}
    frames = {kind: sum(len(part.chosen()[0]) for part in parts) for kind, parts in trained_on.items()}
    dataset = settings.get(params, "dataset")
    cues = {cue: settings.get(params, f"cues.{cue}") for cue in system["cues"]}
    codebooks = {cue["codebook"] for cue in cues.values() if cue["codebook"] is not None}
    return make_card(
        title=f"{system['title']}, with smoothing; {dataset['title']}",
        data={
            "title": dataset["title"],
            "note": dataset.get("note"),
            "version": data_version(),
            "homes": homes,
            "left_out": [part.home for part in plan.tested],
            "frames": frames,
        },
        classes=dataset["classes"],
        frame_sizes=sorted({(home["width"], home["height"]) for home in facts}),
        fps=sorted({home["fps"] for home in facts}),
        accuracy={},
        unknown=None,
        settings={
            "system": {name: system},
            "seed": seed,
            "cues": cues,
            "codebooks": {key: settings.get(params, f"codebooks.{key}") for key in sorted(codebooks)},
            "protocol": settings.get(params, "protocol"),
            "smoothing": settings.get(params, "smoothing"),
        },
    )
