"""Parameters that describe how results were made, with the same names for tables and experiments."""

from collections.abc import Mapping
from typing import Any

from placecat.mlflow_log.store import key
from placecat.provenance.made import Made
from placecat.settings import flatten

# Maps the prefix of a result name to the part of the system that makes the decision.
_DECIDES = {
    "cues": "cue",
    "tempered": "tempered cue",
    "trials": "cue",
    "integration": "integration",
    "hmm": "HMM before its delay",
    "smoothing": "delayed HMM",
    "toy": "toy problem",
}


def params_of_results(results: Mapping[str, Made]) -> dict[str, str]:
    """Return the parameters of several results; each parameter lists its distinct values.

    They start with ``decides`` (the part that decides, such as a cue, an integration or an HMM),
    ``protocol``, ``cues``, ``system``, ``filter`` and ``descriptor``. The settings of a single cue
    (`params_of_cue`), the integration and the smoothing follow.
    """
    values: dict[str, dict[str, None]] = {}
    for result, made in results.items():
        for name, value in _of_one(result, made).items():
            values.setdefault(name, {})[value] = None
    return {name: ", ".join(of_name) for name, of_name in values.items()}


def params_of_cue(
    descriptor: Mapping[str, Any], classifier: Mapping[str, Any], codebook: Mapping[str, Any] | None
) -> dict[str, str]:
    """Return the parameters of one cue, from its settings.

    ``descriptor``, ``classifier`` and ``scheme`` are the names of the choices; other parameters are named
    after the settings, such as ``y_pos``, ``clusters``, ``nu``, ``scheme.calibration`` and
    ``codebook.cells``.
    """
    kind, name = (str(descriptor.get(one, "")) for one in ("kind", "name"))
    params = {"descriptor": f"{kind} {name}"} | _flat(descriptor, "kind", "name") | _of_classifier(classifier)
    return params | ({} if codebook is None else _under("codebook", codebook))


def _of_one(result: str, made: Made) -> dict[str, str]:
    parts = result.split("/")
    kind = parts[2] if parts[0] == "splits" else parts[0]
    if kind == "filtered":
        kind = "integration" if made.system else "cues"
    shown = {
        "decides": _DECIDES.get(kind, kind),
        "protocol": made.plan,
        "cues": ", ".join(made.cues),
        "system": made.system,
        "filter": made.filter,
        "descriptor": ", ".join(dict.fromkeys(made.descriptors)),
    }
    params = {name: text for name, text in shown.items() if text}
    own: dict[str, Any] = {}
    for part, settings in made.settings.items():
        title, _, _ = part.partition(" of ")
        if title in ("descriptor", "classifier", "codebook"):
            own[title] = settings
        elif part == "integration":
            params |= _of_classifier(settings)
        elif part == "toy":
            params |= _of_toy(parts, settings)
        else:
            # In "filter informative", the name of the filter is already a parameter.
            params |= _under(part.split()[0], settings)
    if "classifier" in own and not made.system:
        params |= params_of_cue(own["descriptor"], own["classifier"], own.get("codebook"))
    return params


def _of_toy(parts: list[str], settings: Mapping[str, Any]) -> dict[str, str]:
    """Return the parameters of the toy problem; those that vary are taken from the result name."""
    rest = {name: value for name, value in settings.items() if name not in ("scheme", "sensitivity")}
    params = _of_classifier(settings["scheme"]) | _under("toy", rest)
    if "sensitivity" in settings:
        params |= dict(zip(("toy.points.radius", "scheme", "toy.decision"), parts[1:], strict=False))
    return params


def _of_classifier(settings: Mapping[str, Any]) -> dict[str, str]:
    """Return the parameters of a classifier or an integration. Those of a base classifier have no prefix."""
    base, scheme = (settings.get(one) or {} for one in ("base", "scheme"))
    params = {"classifier": str(base.get("name") or settings.get("model") or settings.get("method", ""))}
    if "combination" in scheme:
        params["scheme"] = str(scheme["combination"])
    return (
        params
        | _flat(base, "name")
        | _under("scheme", {name: value for name, value in scheme.items() if name != "combination"})
        | _flat(settings, "base", "scheme")
    )


def _flat(settings: Mapping[str, Any], *without: str) -> dict[str, str]:
    rest = {name: value for name, value in settings.items() if name not in without}
    return {key(name): value for name, value in flatten(rest).items()}


def _under(prefix: str, settings: Mapping[str, Any]) -> dict[str, str]:
    return {key(f"{prefix}.{name}"): value for name, value in flatten(settings).items()}
