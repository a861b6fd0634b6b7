"""Check that the card and settings of a model file are valid, and that its parts fit together."""

from collections.abc import Mapping
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import Field, StringConstraints

from placecat import schema
from placecat.categorizer.system import TrainedSystem
from placecat.errors import PlacecatError
from placecat.ranges import Index, Positive, Side
from placecat.schema import signatures
from placecat.schema.base import Own, Section
from placecat.vision.frame import check as check_vision

# Largest number allowed in a vision setting. Larger numbers could exhaust memory. Real settings are far
# smaller.
_MOST = 4096
_Name = Annotated[str, StringConstraints(min_length=1, max_length=1000)]
# Rounding may push a probability above 1.
_Share = Annotated[float, Field(ge=0, le=1.000001)]


class _TrainingFrames(Section):
    cues: Index
    integration: Index


class _Data(Section):
    title: str | int
    note: str | None
    version: str
    homes: list[str | int]
    left_out: list[str | int]
    frames: _TrainingFrames


class _Risk(Section):
    risk: _Share
    threshold: _Share | None
    coverage: _Share
    wrong: _Share | None
    worst: _Share | None


class _Unknown(Section):
    risk: _Share
    threshold: _Share | None
    measured: list[_Risk]


class _Card(Section):
    format: int
    placecat: str
    title: str
    data: _Data
    classes: Annotated[list[_Name], Field(min_length=2)]
    frame_sizes: Annotated[
        list[Annotated[list[Side], Field(min_length=2, max_length=2)]], Field(min_length=1)
    ]
    fps: list[Positive]
    accuracy: dict[str, float]
    unknown: _Unknown | None
    settings: Own
    versions: dict[str, str]


class _LocalDescriptor(Section):
    kind: Literal["local"]
    name: _Name
    y_pos: bool
    y_weight: Annotated[float, Field(ge=0, allow_inf_nan=False)]
    color: _Name | None
    max_regions: Annotated[int, Field(ge=1, le=_MOST)]
    tracked: bool = False


class _HolisticDescriptor(Section):
    kind: Literal["holistic"]
    name: _Name


class _Cue(Section):
    name: _Name
    descriptor: Annotated[_LocalDescriptor | _HolisticDescriptor, Field(discriminator="kind")]
    model: Own


class _Vision(Section):
    attention: Own
    regions: Own
    information: Own
    local: dict[str, Own]
    holistic: dict[str, Own]


class _Content(Section):
    vision: _Vision
    tracking: Own | None
    cues: Annotated[list[_Cue], Field(min_length=1)]
    integrator: Own
    smoothing: Own
    arrays: Annotated[int, Field(ge=0, le=9999)]


def check_card(card: Mapping[str, Any]) -> None:
    """Raise an error if a card has missing, extra or invalid fields, or if it lists a class twice."""
    schema.check(card, _Card)
    if len(set(card["classes"])) < len(card["classes"]):
        raise PlacecatError("classes: a place is listed twice")


def check_content(content: Any) -> None:
    """Raise an error if :func:`placecat.categorizer.model_file.write` could not have written the content."""
    if not isinstance(content, dict):
        raise PlacecatError("its content is not a mapping")
    schema.check(content, _Content)
    check_vision(content["vision"])
    signatures.check_vision("tracking", content["tracking"] or {}, "tracking")
    _check_sizes(content["vision"], "vision")
    _check_sizes(content["tracking"], "tracking")


def check_system(system: TrainedSystem) -> None:
    """Raise an error if a system lists a cue twice, or if its parts are inconsistent."""
    n_classes, names = len(system.card["classes"]), [cue.name for cue in system.cues]
    if len(set(names)) < len(names):
        raise PlacecatError("a cue is listed twice")
    if any(cue.is_tracked for cue in system.cues) != (system.tracking is not None):
        raise PlacecatError("its tracking settings do not match its cues")
    if system.smoothing.transition.shape != (n_classes, n_classes):
        raise PlacecatError(f"its smoothing does not match its {n_classes} places")
    integrator = system.integrator
    for name, array in (("temperatures", integrator.temperatures), ("weights", integrator.weights)):
        if array is not None and array.shape != (len(names),):
            raise PlacecatError(f"its {name} do not match its {len(names)} cues")


def check_distribution(proba: Any, n_classes: int) -> None:
    """Raise an error unless `proba` is (n_classes,) and contains probabilities that sum to 1."""
    values = np.asarray(proba)
    if values.shape != (n_classes,) or not np.isfinite(values).all():
        raise PlacecatError(f"it does not return a distribution over {n_classes} places")
    if values.min() < 0 or abs(values.sum() - 1.0) > 1e-6:
        raise PlacecatError("its probabilities do not sum to 1")


def _check_sizes(value: Any, place: str) -> None:
    """Raise an error if numbers or lists in the settings would need too much memory."""
    if isinstance(value, Mapping):
        for name, own in value.items():
            _check_sizes(own, f"{place}.{name}")
    elif isinstance(value, list):
        if len(value) > _MOST:
            raise PlacecatError(f"{place} has {len(value)} values, more than {_MOST}")
        for own in value:
            _check_sizes(own, place)
    elif isinstance(value, int | float) and not -_MOST <= value <= _MOST:
        raise PlacecatError(f"{place} is larger than {_MOST} in magnitude")
