"""Names in the settings that stand for code: each is there, and takes the settings beside it.

Checked when settings are composed, before any stage runs, without importing the code.
"""

from collections.abc import Mapping
from typing import Any

from placecat import lookup
from placecat.errors import SettingError, did_you_mean
from placecat.schema.sections import Regions
from placecat.settings import refuse_unknown

SEQUENCES, READER = "placecat.sequences", ("list_homes", "read_home")
CUES, LEARNING = "placecat.cues", "placecat.learning"
FIGURES = "placecat.report.figures"
# A variant has some of them.
OF_REGIONS = dict.fromkeys(Regions.model_fields, False)
# Parameters of estimators that the code gives, so that no setting does.
GIVEN = frozenset({"base", "codebook", "n_clusters", "n_values", "n_jobs", "seed"})


def check(params: Mapping[str, Any]) -> None:
    """Refuse what names no code, and settings that the named code does not take or lacks.

    Parameters
    ----------
    params
        All settings, as :func:`placecat.schema.check` lets them pass.

    Raises
    ------
    PlacecatError
        Naming the setting, the nearest valid one and all valid ones.
    """
    for section in ("dataset", "toy", "codebooks", "cues", "systems", "splits"):
        check_part(params.get(section), section)
    for kind, entries in (params.get("descriptors") or {}).items():
        for name, entry in entries.items():
            _check_descriptor(kind, name, entry)
    for name, variant in (params.get("region_variants") or {}).get("variants", {}).items():
        _check(variant["regions"], OF_REGIONS, f"region_variants.variants.{name}.regions")
    _check_figures(params.get("figures") or {})


def check_part(content: Any, where: str) -> None:
    """Check every classifier, clustering and layout in a part of the settings.

    Parameters
    ----------
    content
        Plain containers. A mapping with ``layout`` is a data set, one with ``model`` a classifier, one with
        ``tree`` a codebook.
    where
        What a message calls the part, e.g. ``cues``.

    Raises
    ------
    PlacecatError
        As :func:`check`.
    """
    if not isinstance(content, Mapping):
        return
    if "layout" in content:
        # Its settings are those of all layouts and its own (`placecat.schema`).
        lookup.require(SEQUENCES, content["layout"], f"{where}.layout", *READER)
    elif "model" in content:
        _check_classifier(content, where)
    if "tree" in content:
        check_estimator(content["tree"], f"{where}.tree")
    for name, value in content.items():
        check_part(value, f"{where}.{name}")


def check_estimator(options: Mapping[str, Any], where: str) -> str:
    """Check the settings of an estimator of `placecat.learning`.

    Parameters
    ----------
    options
        ``name``, that of its module, and its parameters but those that are `GIVEN`.
    where
        What a message calls the options, e.g. ``classifier.base``.

    Returns
    -------
    str
        Name of the class.

    Raises
    ------
    PlacecatError
        An unknown estimator or parameter; the message names the valid ones.
    """
    if not isinstance(options, Mapping) or "name" not in options:
        raise SettingError(f"{where} has no setting 'name', which it needs")
    own = dict(options)
    name = own.pop("name")
    class_name = lookup.estimator(LEARNING, name, f"{where}.name")
    taken = lookup.parameters(LEARNING, name, class_name)
    _check(own, {setting: False for setting in taken if setting not in GIVEN}, where)
    return class_name


def _check_classifier(options: Mapping[str, Any], where: str) -> None:
    own = dict(options)
    model = lookup.require(CUES, own.pop("model"), f"{where}.model", "fit")
    _check(own, lookup.parameters(CUES, model, "fit"), where)
    for part in ("base", "scheme"):
        if part in own:
            check_estimator(own[part], f"{where}.{part}")
    if isinstance(own.get("reduction"), Mapping):
        taken = lookup.parameters(LEARNING, "spatial_pca", "SpatialPCA")
        _check(own["reduction"], taken, f"{where}.reduction")


def _check_descriptor(kind: str, name: str, entry: Mapping[str, Any]) -> None:
    where, own = f"descriptors.{kind}.{name}", dict(entry)
    # A variant says of which module it is.
    module = own.pop("descriptor", name)
    lookup.require(f"placecat.vision.{kind}", module, f"{where}: {kind} descriptor", "describe")
    _check(own, lookup.parameters(f"placecat.vision.{kind}", module, "describe"), where)


def _check_figures(figures: Mapping[str, Any]) -> None:
    # Figures 12 to 14 share their settings; the example's are checked by `placecat.schema`.
    drawn = lookup.entries(FIGURES, "FIGURES") | {"clusters": ("clusters", "_draw")}
    for name, own in figures.items():
        if name == "example":
            continue
        if name not in drawn:
            question = did_you_mean(name, drawn)
            raise SettingError(f"figures: {name!r} does not exist{question}: use one of {', '.join(drawn)}")
        _check(own, lookup.parameters(FIGURES, *drawn[name]), f"figures.{name}")


def _check(options: Mapping[str, Any], taken: Mapping[str, bool], where: str) -> None:
    refuse_unknown(options, list(taken), where)
    for name, needed in taken.items():
        if needed and name not in options:
            raise SettingError(f"{where} has no setting {name!r}, which it needs")
