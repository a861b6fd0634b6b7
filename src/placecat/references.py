"""Check that settings that name other settings name existing ones."""

from collections.abc import Collection, Iterator, Mapping
from typing import Any

from placecat import paths
from placecat.errors import PlacecatError, did_you_mean

# Place of a reference, kind of its target, the name, and the existing names.
_Reference = tuple[str, str, str, Collection[str]]
_SECTIONS = (
    *("cues", "codebooks", "systems", "filters", "splits"),
    *("descriptors", "smoothing", "tracking", "protocol", "dataset", "model"),
)


def check(params: Mapping[str, Any]) -> None:
    """Refuse settings that name a cue, codebook, descriptor, scheme, system or split that does not exist.

    `params` are all settings. The PlacecatError names the file, the name and the existing ones.
    """
    for where, kind, name, valid in _references(params):
        if str(name) not in valid:
            question, there = did_you_mean(name, valid), ", ".join(valid) or "none"
            raise PlacecatError(f"{where}: there is no {kind} {name!r}{question} (there are: {there})")


def _references(params: Mapping[str, Any]) -> Iterator[_Reference]:
    # A missing section has no references and is no target; the stage that reads it reports it.
    cues, codebooks, systems, filters, splits, descriptors, smoothing, tracking, protocol, dataset, model = (
        params.get(name) or {} for name in _SECTIONS
    )
    for name, cue in cues.items():
        where = _file("cue", name)
        codebook = cue["codebook"]
        if codebook is None:
            yield from _of_descriptor(where, cue.get("descriptor"), descriptors)
        else:
            yield where, "codebook", codebook, codebooks
            for scheme in cue["schemes"]:
                yield where, f"codebook {codebook} for the scheme", scheme, codebooks[codebook]["schemes"]
    for name, codebook in codebooks.items():
        yield from _of_descriptor(_file("codebook", name), codebook.get("descriptor"), descriptors)
    for name, system in systems.items():
        judged = [cue for cue in cues if cues[cue]["cross_validate"]]
        why = [
            reason
            for reason, is_so in (
                ("temperature: true", system["temperature"]),
                ("method: log_pool", system["integrator"]["method"] == "log_pool"),
            )
            if is_so
        ]
        for cue in system["cues"]:
            yield _file("system", name), "cue", cue, cues
            for reason in why:
                yield f"{_file('system', name)} has {reason}", "cue with cross_validate", cue, judged
            yield _file("system", name), f"cue {cue} with the scheme", system["scheme"], cues[cue]["schemes"]
    for name, own in filters.items():
        for cue in own["cues"]:
            yield _file("filter", name), "cue", cue, cues
        for system in own["systems"]:
            yield _file("filter", name), "system", system, systems
    for cue in smoothing.get("cues", []):
        yield "smoothing.cues", "cue", cue, cues
        yield "smoothing.cues", "cue with cross_validate", cue, [c for c in cues if cues[c]["cross_validate"]]
    filtered = [
        f"{name}/{result}" for name, own in filters.items() for result in own["cues"] + own["systems"]
    ]
    for result in smoothing.get("filtered", []):
        yield "smoothing.filtered", "filtered result", result, filtered
    for descriptor in tracking.get("descriptors", []):
        yield "tracking.descriptors", "local descriptor", descriptor, descriptors.get("local", {})
    for name, split in splits.items():
        where = _file("split", name)
        for kind, names in split["descriptors"].items():
            for descriptor in names:
                yield where, f"{kind} descriptor", descriptor, descriptors.get(kind, {})
        for cue in dict.fromkeys(cue for system in split["systems"].values() for cue in system):
            yield where, "cue", cue, cues
            own = cues[cue] if cues[cue]["codebook"] is None else codebooks[cues[cue]["codebook"]]
            yield from _of_descriptor(
                f"{where} integrates the cue {cue}, but in its descriptors",
                own["descriptor"],
                split["descriptors"],
            )
    extra = (protocol.get("extra") or {}).get("split") if "splits" in params else None
    if extra is not None:
        yield "protocol.extra.split", "split", extra, splits
    if "systems" in params and model:
        yield "model.system", "system", model["system"], systems
    if protocol and model:
        yield "model.seed", "seed of protocol.seeds", model["seed"], [str(seed) for seed in protocol["seeds"]]
    tested = protocol.get("test_homes", "all")
    for home in [tested] if isinstance(tested, str) else tested:
        yield "protocol.test_homes", "home", home, ["all", *dataset.get("homes", [])]
    for name, cue in cues.items():
        if cue["extra"] and extra is not None:
            own = cue if cue["codebook"] is None else codebooks[cue["codebook"]]
            where = f"{_file('cue', name)} has extra: true, but in the descriptors of {_file('split', extra)}"
            yield from _of_descriptor(where, own["descriptor"], splits[extra]["descriptors"])


def _file(group: str, name: str) -> str:
    return f"{paths.CONF / group / name}.yaml"


def _of_descriptor(
    where: str, descriptor: Mapping[str, Any] | None, computed: Mapping[str, Collection[str]]
) -> Iterator[_Reference]:
    """The descriptor of a cue or a codebook, and the colour descriptor that it appends."""
    if not isinstance(descriptor, Mapping) or not {"kind", "name"} <= set(descriptor):
        raise PlacecatError(f"{where}: descriptor needs kind (local or holistic) and name")
    yield where, "kind of descriptor", descriptor["kind"], ["local", "holistic"]
    kind = descriptor["kind"]
    yield where, f"{kind} descriptor", descriptor["name"], computed.get(kind, {})
    if descriptor.get("color"):
        yield where, f"{kind} descriptor", descriptor["color"], computed.get(kind, {})
