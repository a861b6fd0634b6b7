"""Stage `splits`: everything from cues to smoothing on a fixed split of further data (thesis 4.9, 4.10)."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from placecat import cues, files, items, listing, parallel, paths, settings, store
from placecat.cues.codebook import Codebook, seed_of
from placecat.evaluation import protocol
from placecat.fusion.integrate import integrate
from placecat.fusion.smoothing import smooth
from placecat.stages import run

Part = tuple[str, np.ndarray, np.ndarray]


def main() -> None:
    """Train and test on every split."""
    params = settings.load()
    wanted = {}
    for split, own in settings.get(params, "splits").items():
        cues_of_split = dict.fromkeys(cue for system in own["systems"].values() for cue in system)
        used = {cue: _cue(params, cue) for cue in cues_of_split}
        others = [settings.get(params, name) for name in ("protocol.seeds", "protocol.cue_frames")]
        others += [settings.get(params, "protocol.integration_frames"), _smoothing(params)]
        names = [f"{split}/{sequence}" for sequence in own["dataset"]["homes"]]
        described = [
            path
            for home in names
            for descriptor, *_ in used.values()
            for path in store.files_of(home, descriptor)
        ]
        wanted[split] = items.Inputs([own, used, *others], (*map(paths.sequences, names), *described))
    items.refresh("splits", paths.SPLITS, wanted, lambda split, folder: make(split, folder, params))


def _smoothing(params: Mapping[str, Any]) -> dict[str, Any]:
    return {name: value for name, value in params["smoothing"].items() if name not in ("cues", "filtered")}


def make(split: str, folder: Path, params: Mapping[str, Any]) -> None:
    """Train on the split's training parts, test on its test sequences, once for each seed."""
    own = settings.get(params, f"splits.{split}")
    classes = list(own["dataset"]["classes"])
    names = list(dict.fromkeys(cue for system in own["systems"].values() for cue in system))
    seeds = list(settings.get(params, "protocol.seeds"))
    train = _parts(split, own["cue_parts"], classes, settings.get(params, "protocol.cue_frames"))
    fuse = _parts(
        split, own["integration_parts"], classes, settings.get(params, "protocol.integration_frames")
    )
    keys: list[tuple[str, int | None]] = [
        (name, seed)
        for name in names
        for seed in (seeds if settings.get(params, f"cues.{name}.codebook") is not None else [None])
    ]
    cue_tasks = [(split, own["test"], *_cue(params, name), seed, train, fuse, classes) for name, seed in keys]
    outputs = dict(zip(keys, parallel.in_parallel(apply_cue, cue_tasks, f"cues of {split}"), strict=True))
    options = _smoothing(params)
    system_keys = [(system, seed) for system in own["systems"] for seed in seeds]
    system_tasks = [
        (
            split,
            own,
            [outputs.get((cue, seed), outputs.get((cue, None))) for cue in own["systems"][system]],
            fuse,
            classes,
            options,
        )
        for system, seed in system_keys
    ]
    fused = parallel.in_parallel(apply_system, system_tasks, f"integration of {split}")
    for (name, seed), output in outputs.items():
        for sequence in own["test"]:
            place = folder / "cues" / name / sequence / protocol.seed_folder(seed)
            files.write_array(place / "test.npy", output[f"test_{sequence}"])
    for (system, seed), output in zip(system_keys, fused, strict=True):
        for sequence in own["test"]:
            place = Path(system, sequence, protocol.seed_folder(seed))
            files.write_array(folder / "integration" / place / "test.npy", output[sequence]["test"])
            for name in ("hmm", "delayed"):
                files.write_array(folder / "smoothing" / place / f"{name}.npy", output[sequence][name])


def _parts(
    split: str, parts: Sequence[Mapping[str, Any]], classes: Sequence[str], selection: Mapping[str, int]
) -> list[Part]:
    """Each training part: its sequence, labels of all frames (-1 where they do not count), chosen frames."""
    found = []
    for part in parts:
        home = f"{split}/{part['sequence']}"
        labels = listing.read_labels(home)
        if part["places"] is not None:
            kept = [place for place in classes if place in part["places"]]
            labels = protocol.translate(protocol.translate(labels, classes, kept), kept, classes)
        found.append((home, labels, protocol.select_frames(labels, **selection)))
    return found


def _cue(
    params: Mapping[str, Any], name: str
) -> tuple[Mapping[str, Any], Mapping[str, Any], Mapping[str, Any] | None]:
    """Descriptor, classifier and codebook settings of a cue of the main pipeline."""
    cue = settings.get(params, f"cues.{name}")
    if cue["codebook"] is None:
        return cue["descriptor"], cue["classifier"], None
    codebook = settings.get(params, f"codebooks.{cue['codebook']}")
    return codebook["descriptor"], cue["classifier"], codebook


def apply_cue(
    split: str,
    test: Sequence[str],
    descriptor: Mapping[str, Any],
    classifier: Mapping[str, Any],
    codebook: Mapping[str, Any] | None,
    seed: int | None,
    train: Sequence[Part],
    fuse: Sequence[Part],
    classes: Sequence[str],
) -> dict[str, np.ndarray]:
    """Train one cue; give its distributions for the integration's frames and for every test frame."""
    homes = tuple(home for home, _, _ in train)
    described = store.read_training(homes, descriptor, {home: rows for home, _, rows in train})
    truth = np.concatenate([labels[rows] for _, labels, rows in train])
    home_of_frame = np.concatenate([np.full(len(rows), home) for home, _, rows in train])
    clusters = None
    if codebook is not None:
        assert seed is not None
        clusters = Codebook.fit(
            described,
            cells=codebook["cells"],
            seed=seed_of(split, descriptor, codebook["cells"], split, seed),
            tree=codebook["tree"],
            numbers=[classifier["clusters"]],
        )
    model = cues.fit(
        described, truth, home_of_frame, classifier=classifier, classes=classes, codebook=clusters
    )
    result = {
        f"fuse_{home}": model.predict_proba(store.read_descriptors(home, descriptor, rows))
        for home, _, rows in fuse
    }
    for sequence in test:
        frames = store.read_descriptors(f"{split}/{sequence}", descriptor)
        result[f"test_{sequence}"] = model.predict_proba(frames)
    return result


def apply_system(
    split: str,
    own: Mapping[str, Any],
    outputs: Sequence[Mapping[str, np.ndarray]],
    fuse: Sequence[Part],
    classes: Sequence[str],
    smoothing: Mapping[str, Any],
) -> dict[str, dict[str, np.ndarray]]:
    """Integrate some cues' outputs and smooth the decisions, for every test sequence."""
    train = {home: np.stack([one[f"fuse_{home}"] for one in outputs], axis=1) for home, _, _ in fuse}
    truth = {home: labels[rows] for home, labels, rows in fuse}
    walks = [
        (labels[part], listing.frame_rate(home))
        for home, labels, _ in fuse
        for part in listing.sequence_slices(home)
    ]
    tests = [np.stack([one[f"test_{sequence}"] for one in outputs], axis=1) for sequence in own["test"]]
    fused = integrate(train, truth, np.concatenate(tests), classes, **own["integrator"])
    parts = np.split(fused["test"], np.cumsum([len(test) for test in tests])[:-1])
    return {
        sequence: {"test": proba}
        | smooth(
            proba,
            listing.sequence_slices(f"{split}/{sequence}"),
            frame_rate=listing.frame_rate(f"{split}/{sequence}"),
            training_sequences=[labels for labels, _ in walks],
            training_frame_rates=[rate for _, rate in walks],
            training_proba=fused["cross_validated"],
            training_truth=fused["cross_validated_truth"],
            n_classes=len(classes),
            **smoothing,
        )
        for sequence, proba in zip(own["test"], parts, strict=True)
    }


if __name__ == "__main__":
    run(main)
