"""Check that the code named in the settings exists and accepts its settings.

The check does not import the code, so it is fast enough to run when settings are composed.
"""

from collections.abc import Mapping
from functools import lru_cache
from typing import Any, NamedTuple, get_type_hints

from pydantic import TypeAdapter

from placecat import lookup, schema
from placecat.errors import SettingError, did_you_mean
from placecat.schema.base import Section
from placecat.schema.sections import Attention, Dataset, Information, Regions, Tracking
from placecat.settings import refuse_unknown

SEQUENCES = "placecat.sequences"
CUES, LEARNING = "placecat.cues", "placecat.learning"
FIGURES = "placecat.report.figures"
VISION: dict[str, type[Section]] = {
    "attention": Attention,
    "regions": Regions,
    "information": Information,
    "tracking": Tracking,
}
# Estimator parameters that are set by the code.
GIVEN = frozenset({"base", "codebook", "n_clusters", "n_values", "n_jobs", "seed"})


def check(params: Mapping[str, Any]) -> None:
    """Check that the code named in the settings exists and accepts its settings.

    `params` contains all settings and has been checked by :func:`placecat.schema.check`. Raises a
    PlacecatError that names the invalid setting, the most similar valid name and all valid names.
    """
    for section in ("dataset", "toy", "codebooks", "cues", "systems", "splits"):
        check_part(params.get(section), section)
    for kind, entries in (params.get("descriptors") or {}).items():
        for name, entry in entries.items():
            check_descriptor(kind, name, entry)
    for name, variant in (params.get("region_variants") or {}).get("variants", {}).items():
        check_vision("regions", variant["regions"], f"region_variants.variants.{name}.regions")
    _check_figures(params.get("figures") or {})


def check_part(content: Any, where: str) -> None:
    """Check every classifier, clustering and layout in a part of the settings, as :func:`check` does.

    A mapping with ``layout`` is a data set, one with ``model`` is a classifier, and one with ``tree`` is a
    codebook. `where` is the name of the part in messages, such as ``cues``.
    """
    if not isinstance(content, Mapping):
        return
    if "layout" in content:
        layout = lookup.require(SEQUENCES, content["layout"], f"{where}.layout", "read_home")
        # `placecat.schema` checks the settings that all layouts share.
        own = {name: value for name, value in content.items() if name not in Dataset.model_fields}
        _check(own, _taken(SEQUENCES, layout, "read_home"), where)
    elif "model" in content:
        _check_classifier(content, where)
    if "tree" in content:
        check_estimator(content["tree"], f"{where}.tree")
    for name, value in content.items():
        check_part(value, f"{where}.{name}")


def check_estimator(options: Mapping[str, Any], where: str) -> str:
    """Check the settings of an estimator of `placecat.learning`; return the name of its class.

    The settings are ``name``, which is the module of the estimator, and its parameters except those in
    `GIVEN`. `where` is the name of the settings in messages, such as ``classifier.base``. The PlacecatError
    for an unknown setting lists the valid ones.
    """
    if not isinstance(options, Mapping) or "name" not in options:
        raise SettingError(f"{where} needs the setting 'name'")
    own = dict(options)
    name = own.pop("name")
    class_name = lookup.estimator(LEARNING, name, f"{where}.name")
    _check(own, _optional(LEARNING, name, class_name), where)
    return class_name


def check_descriptor(kind: str, name: str, entry: Mapping[str, Any]) -> None:
    """Check the module and settings of a descriptor; `kind` is ``local`` or ``holistic``."""
    where, own = f"descriptors.{kind}.{name}", dict(entry)
    # A variant of a descriptor names its module.
    module = own.pop("descriptor", name)
    lookup.require(f"placecat.vision.{kind}", module, f"{where}: {kind} descriptor", "describe")
    _check(own, _taken(f"placecat.vision.{kind}", module, "describe"), where)


def check_vision(section: str, options: Mapping[str, Any], where: str) -> None:
    """Check the settings of a section in `VISION`; none of them is required."""
    _check(options, _of_section(section), where)


def check_parameters(estimator: Any) -> None:
    """Raise SettingError if a parameter of an estimator does not fit its annotation in ``__init__``."""
    kind: Any = type(estimator)
    for name, values in _annotated(kind).items():
        value = getattr(estimator, name)
        # Convert NumPy numbers.
        schema.check_value(value.item() if hasattr(value, "item") else value, values, name)


@lru_cache
def _annotated(kind: Any) -> dict[str, TypeAdapter[Any]]:
    hints = get_type_hints(kind.__init__, include_extras=True)
    return {name: schema.of_type(hint) for name, hint in hints.items() if name != "return"}


def _check_classifier(options: Mapping[str, Any], where: str) -> None:
    own = dict(options)
    model = lookup.require(CUES, own.pop("model"), f"{where}.model", "fit")
    _check(own, _taken(CUES, model, "fit"), where)
    for part in ("base", "scheme"):
        if part in own:
            check_estimator(own[part], f"{where}.{part}")
    if isinstance(own.get("reduction"), Mapping):
        _check(own["reduction"], _optional(LEARNING, "spatial_pca", "SpatialPCA"), f"{where}.reduction")


def _check_figures(figures: Mapping[str, Any]) -> None:
    # Figures 12 to 14 share their settings; `placecat.schema` checks those of the example.
    drawn = lookup.entries(FIGURES, "FIGURES") | {"clusters": ("clusters", "draw_cluster")}
    for name, own in figures.items():
        if name == "example":
            continue
        if name not in drawn:
            question = did_you_mean(name, drawn)
            raise SettingError(f"figures: {name!r} does not exist{question}: use one of {', '.join(drawn)}")
        _check(own, _taken(FIGURES, *drawn[name]), f"figures.{name}")


class _Setting(NamedTuple):
    """Whether a setting is required, and a check for its values."""

    is_needed: bool
    values: TypeAdapter[Any]


@lru_cache
def _taken(package: str, name: str, definition: str) -> dict[str, _Setting]:
    """Return the settings of a function or class; see :func:`placecat.lookup.parameters`."""
    found = lookup.parameters(package, name, definition)
    return {setting: _Setting(needed, schema.of_type(kind)) for setting, (needed, kind) in found.items()}


@lru_cache
def _optional(package: str, name: str, definition: str) -> dict[str, _Setting]:
    """Return an estimator's settings, except those in `GIVEN`, all marked as optional."""
    taken = _taken(package, name, definition)
    return {name: one._replace(is_needed=False) for name, one in taken.items() if name not in GIVEN}


@lru_cache
def _of_section(section: str) -> dict[str, _Setting]:
    kinds = get_type_hints(VISION[section], include_extras=True)
    return {name: _Setting(False, schema.of_type(kinds[name])) for name in VISION[section].model_fields}


def _check(options: Mapping[str, Any], taken: Mapping[str, _Setting], where: str) -> None:
    refuse_unknown(options, list(taken), where)
    for name, setting in taken.items():
        if name in options:
            schema.check_value(options[name], setting.values, f"{where}.{name}")
        elif setting.is_needed:
            raise SettingError(f"{where} needs the setting {name!r}")
