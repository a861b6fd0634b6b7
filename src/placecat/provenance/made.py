"""How a result was made: its cues, system, filter, settings and stages."""

import json
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from placecat import settings
from placecat.evaluation.trials import Trial
from placecat.thesis.records import RECORD

_RECORD_STAGES = {"nu": ("sequences", "features", "codebooks", "cues", "trials"), "rejected": ("features",)}
# All stages in the order of the pipeline. Every number in the tables depends on those in `_LAST`.
_ORDER = (
    *("sequences", "site_sequences", "features", "tracks", "site_features", "codebooks", "cues"),
    *("integration", "filtering", "smoothing", "splits", "trials", "toy"),
)
_LAST = ("scores", "tables")


@dataclass(frozen=True)
class Made:
    """How a result was made.

    `title` describes the result on one line, and `stages` are its DVC stages, without `scores` and `tables`.
    `cues`, `classifiers` and `descriptors` are the names of the cues and of their classifiers and
    descriptors. `system` and `filter` are "" if there is none. `plan` is the protocol, such as "5-5-1", or
    the split; it is "" if there is neither. `fuses` says whether integration or smoothing is also trained.
    `extra` says whether the integration is also trained on the sequences of ``protocol.extra``. `settings`
    maps each part to its settings. `clusters` maps each cue to the text of its descriptor and its
    number of cells, which determine the seeds of its codebooks.
    """

    title: str
    stages: tuple[str, ...]
    cues: tuple[str, ...] = ()
    classifiers: tuple[str, ...] = ()
    descriptors: tuple[str, ...] = ()
    system: str = ""
    filter: str = ""
    plan: str = ""
    fuses: bool = False
    extra: bool = False
    settings: Mapping[str, Any] = field(default_factory=dict)
    clusters: Mapping[str, tuple[str, int]] = field(default_factory=dict)


def made(result: str, params: Mapping[str, Any], trials: Mapping[str, Trial]) -> Made:
    """Describe how a result was made, from its name (see :mod:`placecat.results.sources`).

    Raises PlacecatError if a setting that the name refers to is missing.
    """
    kind, _, rest = result.partition("/")
    if kind == "cues":
        name, _, scheme = rest.rpartition("/")
        return _of_cue(name, params, scheme)
    if kind == "tempered":
        one = _of_cue(rest, params)
        return replace(one, title=f"{one.title}, tempered by its cross-validated distributions")
    if kind == "integration":
        return _of_system(rest, params)
    if kind == "filtered":
        return _filtered(rest, params)
    if kind in ("hmm", "smoothing"):
        return _smoothed(kind, rest, params)
    if kind == "splits":
        return _of_split(rest, params)
    if kind == "trials":
        return _of_trial(trials[result], params)
    if kind == "toy":
        title = f"the toy problem of thesis 4.8, {rest}"
        return Made(title, ("toy",), settings={"toy": _toy(rest, settings.get(params, "toy"))})
    name = result.removeprefix(RECORD)
    return Made(f"taken from the record {name}", _RECORD_STAGES.get(name, ()))


def all_stages(made: Iterable[Made]) -> tuple[str, ...]:
    """Return the stages that produced the given results and their tables, in the order of the pipeline."""
    known = [stage for one in made for stage in one.stages]
    return (*(stage for stage in _ORDER if stage in known), *(_LAST if known else ("tables",)))


def _toy(name: str, toy: Mapping[str, Any]) -> dict[str, Any]:
    """Return the settings of a result from the toy problem, leaving out those of other schemes."""
    scheme = next(part for part in name.split("/") if part in toy["schemes"])
    shared = {key: value for key, value in toy.items() if key not in ("schemes", "sensitivity")}
    changed = {} if name.split("/")[0] in ("last", scheme) else {"sensitivity": toy["sensitivity"]}
    return {"scheme": toy["schemes"][scheme], **shared, **changed}


def _of_cue(name: str, params: Mapping[str, Any], scheme: str = "") -> Made:
    """Describe a cue in the protocol `scheme`, by default the first one."""
    own, one = settings.get(params, f"cues.{name}"), _described_cue(name, params)
    scheme = scheme or own["schemes"][0]
    is_tracked = one.settings[f"descriptor of {name}"].get("tracked")
    stages = ("codebooks",) * bool(one.clusters) + ("tracks",) * bool(is_tracked)
    title = f"the cue {name} ({own['title']}) trained alone, {scheme}"
    return replace(one, title=title, stages=("sequences", "features", "cues", *stages), plan=scheme)


def _described_cue(name: str, params: Mapping[str, Any]) -> Made:
    """Describe a cue in params.yaml, without a title, stages or a plan."""
    own = settings.get(params, f"cues.{name}")
    codebook = None if own["codebook"] is None else settings.get(params, f"codebooks.{own['codebook']}")
    return _described(name, (codebook or own)["descriptor"], own["classifier"], codebook, params)


def _described(
    name: str,
    descriptor: Mapping[str, Any],
    classifier: Mapping[str, Any],
    codebook: Mapping[str, Any] | None,
    params: Mapping[str, Any],
) -> Made:
    """Describe a descriptor, a classifier and, if the classifier uses clusters, a codebook."""
    kind, module = descriptor["kind"], descriptor["name"]
    computed = (settings.get(params, "descriptors").get(kind) or {}).get(module, {})
    base = classifier.get("base", {}).get("name")
    parts = {f"descriptor of {name}": {**descriptor, **computed}, f"classifier of {name}": dict(classifier)}
    clusters = {}
    if codebook is not None:
        parts[f"codebook of {name}"] = {key: codebook[key] for key in ("cells", "tree")}
        clusters[name] = (json.dumps(dict(descriptor), sort_keys=True), int(codebook["cells"]))
    return Made(
        "",
        (),
        cues=(name,),
        classifiers=(" of ".join(part for part in (classifier["model"], base) if part),),
        descriptors=(f"{kind} {module}",),
        settings=parts,
        clusters=clusters,
    )


def _together(cues: Iterable[Made], title: str, stages: Iterable[str], **own: Any) -> Made:
    """Combine several cues into one result. Its own settings precede those of the cues."""
    cues = list(cues)
    return Made(
        title,
        tuple(stages),
        tuple(name for cue in cues for name in cue.cues),
        tuple(name for cue in cues for name in cue.classifiers),
        tuple(name for cue in cues for name in cue.descriptors),
        settings=own.pop("settings") | {key: one for cue in cues for key, one in cue.settings.items()},
        clusters={key: one for cue in cues for key, one in cue.clusters.items()},
        **own,
    )


def _smoothing(params: Mapping[str, Any]) -> dict[str, Any]:
    """Return the smoothing settings, except for the lists of results to smooth."""
    section = settings.get(params, "smoothing")
    return {name: value for name, value in section.items() if name not in ("cues", "filtered")}


def _of_system(name: str, params: Mapping[str, Any]) -> Made:
    system = settings.get(params, f"systems.{name}")
    cues = [_of_cue(cue, params, system["scheme"]) for cue in system["cues"]]
    stages = {"integration", *(stage for cue in cues for stage in cue.stages)}
    if system["extra"]:
        stages |= {"site_sequences", "site_features"}
    return _together(
        cues,
        f"the system {name}: the cues {', '.join(system['cues'])} integrated, {system['scheme']}",
        sorted(stages),
        system=name,
        plan=system["scheme"],
        fuses=True,
        extra=bool(system["extra"]),
        settings={"integration": _integrator(system)},
    )


def _integrator(own: Mapping[str, Any]) -> dict[str, Any]:
    """Return the settings of an integration, with the settings of its classifier at the top level."""
    integrator = own["integrator"]
    rest = {key: value for key, value in integrator.items() if key != "classifier"}
    of_system = {key: own[key] for key in ("temperature", "extra") if key in own}
    return {**rest, **integrator.get("classifier", {}), **of_system}


def _named(name: str, params: Mapping[str, Any]) -> Made:
    """Describe a system, or a cue in the first of its protocols."""
    return (_of_system if name in settings.get(params, "systems") else _of_cue)(name, params)


def _filtered(name: str, params: Mapping[str, Any]) -> Made:
    chosen, _, result = name.partition("/")
    one = _named(result, params)
    options = settings.get(params, f"filters.{chosen}")
    own = {key: options[key] for key in ("threshold", "share") if options.get(key) is not None}
    own |= settings.get(params, "information")
    return replace(
        one,
        title=f"{one.title}; frames below the information filter {chosen} keep the last decision",
        stages=(*one.stages, "filtering"),
        filter=chosen,
        settings={f"filter {chosen}": own, **one.settings},
    )


def _smoothed(kind: str, name: str, params: Mapping[str, Any]) -> Made:
    one = _filtered(name, params) if "/" in name else _named(name, params)
    model = "the delayed HMM" if kind == "smoothing" else "the HMM before its delay"
    return replace(
        one,
        title=f"{model} over {one.title}",
        stages=(*one.stages, "smoothing"),
        fuses=True,
        settings={"smoothing": _smoothing(params), **one.settings},
    )


def _of_split(name: str, params: Mapping[str, Any]) -> Made:
    split, kind, part = name.split("/", 2)
    own = settings.get(params, f"splits.{split}")
    names = [part] if kind == "cues" else list(own["systems"][part])
    cues = [_described_cue(cue, params) for cue in names]
    parts: dict[str, Any] = {}
    if kind != "cues":
        parts["integration"] = _integrator(own)
    if kind in ("hmm", "smoothing"):
        parts["smoothing"] = _smoothing(params)
    layers = {
        "cues": f"the cue {part} trained alone",
        "integration": f"the system {part}: the cues {', '.join(names)} integrated",
        "hmm": f"the HMM before its delay over the system {part}",
        "smoothing": f"the delayed HMM over the system {part}",
    }
    return _together(
        cues,
        f"{layers[kind]}, on the fixed split of {split}",
        ("site_sequences", "site_features", "splits"),
        system="" if kind == "cues" else part,
        plan=split,
        fuses=kind != "cues",
        settings=parts,
    )


def _of_trial(trial: Trial, params: Mapping[str, Any]) -> Made:
    own = trial.settings
    described = _described("the trial", own["descriptor"], own["classifier"], own.get("codebook"), params)
    tracks = ("tracks",) * bool(own["descriptor"].get("tracked"))
    return replace(
        described,
        title=f"a separate trial: {described.descriptors[0]}, {described.classifiers[0]}, 5-5-1",
        stages=("sequences", "features", *tracks, "trials"),
        cues=(),
        plan="5-5-1",
    )
