"""Check the names in the settings: every cue, codebook or other item that they refer to must exist."""

from collections.abc import Collection, Iterable, Iterator, Mapping
from typing import Any

from placecat import paths
from placecat.errors import PlacecatError, did_you_mean

# The location of a reference, the kind and name of its target, and the names that exist.
_Reference = tuple[str, str, str, Collection[str]]
_SECTIONS = (
    *("cues", "codebooks", "systems", "filters", "splits"),
    *("descriptors", "smoothing", "tracking", "protocol", "dataset", "model", "region_variants"),
)


def check(params: Mapping[str, Any]) -> None:
    """Raise a PlacecatError that lists the existing names if a setting refers to a missing one."""
    for where, kind, name, valid in _references(params):
        if str(name) not in valid:
            question, there = did_you_mean(name, valid), ", ".join(valid) or "none"
            raise PlacecatError(f"{where}: there is no {kind} {name!r}{question} (available: {there})")


def _references(params: Mapping[str, Any]) -> Iterator[_Reference]:
    # A missing section is skipped here and reported by the stage that reads it.
    cues, codebooks, systems, filters, splits, descriptors, smoothing, *others = (
        params.get(name) or {} for name in _SECTIONS
    )
    tracking, protocol, dataset, model, variants = others
    judged = [name for name, cue in cues.items() if cue["cross_validate"]]
    for name, cue in cues.items():
        where, codebook = _file("cue", name), cue["codebook"]
        if codebook is None:
            yield from _of_descriptor(where, cue.get("descriptor"), descriptors)
        else:
            yield where, "codebook", codebook, codebooks
            kind = f"codebook {codebook} for the scheme"
            yield from _each(where, kind, cue["schemes"], codebooks[codebook]["schemes"])
    for name, codebook in codebooks.items():
        yield from _of_descriptor(_file("codebook", name), codebook.get("descriptor"), descriptors)
    for name, system in systems.items():
        where = _file("system", name)
        for cue in system["cues"]:
            yield where, "cue", cue, cues
            if system["temperature"]:
                yield f"{where} (temperature: true)", "cross-validated cue", cue, judged
            if system["integrator"]["method"] == "log_pool":
                yield f"{where} (method: log_pool)", "cross-validated cue", cue, judged
            yield where, f"cue {cue} with the scheme", system["scheme"], cues[cue]["schemes"]
    for name, own in filters.items():
        yield from _each(_file("filter", name), "cue", own["cues"], cues)
        yield from _each(_file("filter", name), "system", own["systems"], systems)
    yield from _each("smoothing.cues", "cue", smoothing.get("cues", []), cues)
    yield from _each("smoothing.cues", "cross-validated cue", smoothing.get("cues", []), judged)
    filtered = [f"{name}/{one}" for name, own in filters.items() for one in own["cues"] + own["systems"]]
    yield from _each("smoothing.filtered", "filtered result", smoothing.get("filtered", []), filtered)
    local = descriptors.get("local", {})
    for section, own in (("tracking", tracking), ("region_variants", variants)):
        yield from _each(f"{section}.descriptors", "local descriptor", own.get("descriptors", []), local)
    for name, split in splits.items():
        where = _file("split", name)
        for kind, names in split["descriptors"].items():
            yield from _each(where, f"{kind} descriptor", names, descriptors.get(kind, {}))
        for cue in dict.fromkeys(cue for system in split["systems"].values() for cue in system):
            yield where, "cue", cue, cues
            whose = f"{where}, descriptors for the cue {cue}"
            yield from _of_descriptor(whose, _described(cues[cue], codebooks), split["descriptors"])
    extra = (protocol.get("extra") or {}).get("split") if "splits" in params else None
    if extra is not None:
        yield "protocol.extra.split", "split", extra, splits
    if "systems" in params and model:
        yield "model.system", "system", model["system"], systems
    if protocol and model:
        yield (
            "model.seed must be in protocol.seeds",
            "seed",
            model["seed"],
            [str(seed) for seed in protocol["seeds"]],
        )
    tested = protocol.get("test_homes", "all")
    homes = ["all", *dataset.get("homes", [])]
    yield from _each("protocol.test_homes", "home", [tested] if isinstance(tested, str) else tested, homes)
    for name, cue in cues.items():
        if cue["extra"] and extra is not None:
            where = f"{_file('split', extra)}, descriptors for {_file('cue', name)} (extra: true)"
            yield from _of_descriptor(where, _described(cue, codebooks), splits[extra]["descriptors"])


def _each(where: str, kind: str, names: Iterable[str], valid: Collection[str]) -> Iterator[_Reference]:
    return ((where, kind, name, valid) for name in names)


def _described(cue: Mapping[str, Any], codebooks: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return the descriptor of a cue, or of its codebook if it has one."""
    own = cue if cue["codebook"] is None else codebooks[cue["codebook"]]
    descriptor: Mapping[str, Any] = own["descriptor"]
    return descriptor


def _file(group: str, name: str) -> str:
    return f"{paths.CONF / group / name}.yaml"


def _of_descriptor(
    where: str, descriptor: Mapping[str, Any] | None, computed: Mapping[str, Collection[str]]
) -> Iterator[_Reference]:
    """Yield references to the descriptor of a cue or codebook and to the colour descriptor appended to it."""
    if not isinstance(descriptor, Mapping) or not {"kind", "name"} <= set(descriptor):
        raise PlacecatError(f"{where}: descriptor needs kind (local or holistic) and name")
    yield where, "kind of descriptor", descriptor["kind"], ["local", "holistic"]
    kind = descriptor["kind"]
    yield where, f"{kind} descriptor", descriptor["name"], computed.get(kind, {})
    if descriptor.get("color"):
        yield where, f"{kind} descriptor", descriptor["color"], computed.get(kind, {})
