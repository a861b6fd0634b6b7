"""Settings against what params.yaml and an experiment have, so that a wrong one is refused at once."""

from collections.abc import Mapping
from typing import Any

from pydantic import ValidationError

from placecat.errors import PlacecatError, did_you_mean
from placecat.schema.sections import Experiment, Params, Section

__all__ = ["Experiment", "Params", "check"]


def check(content: Mapping[str, Any], model: type[Section] = Params) -> None:
    """Refuse a setting that nothing reads, that is missing, or that is of another type.

    Parameters
    ----------
    content
        Settings, as plain containers.
    model
        What they have.

    Raises
    ------
    PlacecatError
        Naming the first such setting by its dotted name.
    """
    try:
        model.model_validate(content)
    except ValidationError as error:
        raise PlacecatError(_told(content, error)) from None


def _told(content: Mapping[str, Any], error: ValidationError) -> str:
    """The first mistake in one line."""
    errors = error.errors(include_url=False)
    # Where a value may be of several kinds, the name of the kind is a part of the place.
    place: list[str] = []
    here: Any = content
    part: Any
    for part in errors[0]["loc"]:
        if isinstance(here, Mapping | list) and _has(here, part):
            place.append(str(part))
            here = here[part]
    dotted, kind = ".".join(place), errors[0]["type"]
    if kind == "missing":
        return f"{dotted or 'the settings'} has no setting {errors[0]['loc'][-1]!r}, which it needs"
    if kind == "extra_forbidden":
        *parents, name = place
        unknown = {str(one["loc"][-1]) for one in errors if one["type"] == kind}
        around: Any = content
        for parent in parents:
            around = around[int(parent) if isinstance(around, list) else parent]
        valid = [str(key) for key in around if key not in unknown]
        where, question = ".".join(parents) or "the whole", did_you_mean(name, valid)
        return f"{where} has no setting {name!r}{question} (it has {', '.join(valid)})"
    return f"{dotted}={errors[0]['input']}: {errors[0]['msg']}"


def _has(here: Any, part: Any) -> bool:
    return part in here if isinstance(here, Mapping) else isinstance(part, int) and part < len(here)
