"""Schemas for params.yaml and for experiments, which reject invalid settings early."""

from collections.abc import Mapping
from typing import Any

from pydantic import ConfigDict, TypeAdapter, ValidationError

from placecat.errors import SettingError, did_you_mean, printable
from placecat.schema.base import Section
from placecat.schema.experiment import Experiment
from placecat.schema.sections import Params

__all__ = ["Experiment", "Params", "check", "check_value", "of_type"]

_SHOWN = 80


def check(content: Mapping[str, Any], model: type[Section] = Params) -> None:
    """Raise SettingError if a setting is unknown, missing, of the wrong type or out of range.

    `content` contains the settings in plain containers, and `model` is the section they belong to. The
    message contains the dotted name of the first invalid setting.
    """
    try:
        model.model_validate(content)
    except ValidationError as error:
        raise SettingError(_told(content, error)) from None


def check_value(value: Any, adapter: TypeAdapter[Any], where: str, context: Any = None) -> None:
    """Raise SettingError if a value has the wrong type or is out of range.

    `adapter` comes from :func:`of_type`, `where` is a dotted name, and `context` is passed to the type's
    validators.
    """
    try:
        adapter.validate_python(value, context=context)
    except ValidationError as error:
        raise SettingError(_told({where: value}, error, (where,))) from None


def of_type(kind: Any) -> TypeAdapter[Any]:
    """Build a strict type check that also rejects NaN and infinity."""
    return TypeAdapter(kind, config=ConfigDict(strict=True, allow_inf_nan=False))


def _told(content: Mapping[str, Any], error: ValidationError, before: tuple[str, ...] = ()) -> str:
    """Describe the first error on one line."""
    errors = error.errors(include_url=False)
    places = [_place(content, (*before, *one["loc"])) for one in errors]
    # If several types are allowed, report the closest one.
    same = [number for number, place in enumerate(places) if place[: len(places[0])] == places[0]]
    first = max(same, key=lambda number: (len(places[number]), not errors[number]["type"].endswith("_type")))
    place, told = places[first], errors[first]
    dotted, kind, value = ".".join(place), told["type"], told["input"]
    if kind == "missing":
        return f"{dotted or 'the file'} needs the setting {told['loc'][-1]!r}"
    if kind == "extra_forbidden":
        *parents, name = place
        unknown = {str(one["loc"][-1]) for one in errors if one["type"] == kind}
        around: Any = content
        for parent in parents:
            around = around[int(parent) if isinstance(around, list) else parent]
        valid = [str(key) for key in around if key not in unknown]
        where, question = ".".join(parents) or "the file", did_you_mean(name, valid)
        return f"{where} has no setting {name!r}{question} (it has {', '.join(valid)})"
    said = told["msg"].removeprefix("Value error, ").replace("Input should be", "it must be")
    said = said.replace("Value should", "it must").replace(" after validation", "")
    if kind == "string_type" and isinstance(value, int | float):
        said = f"it must be text, but YAML reads it as a number: write '{value}', with quotes"
    elif kind == "list_type":
        said = f"it must be a list: write [{_short(value)}]"
    elif kind in ("dict_type", "mapping_type", "model_type"):
        said = "it must be a mapping of settings"
    if told["loc"][-1:] == ("[key]",):
        return f"{'.'.join(place[:-1])}: {_short(repr(value))} is not a valid name: {said}"
    return f"{dotted}: {said}" if isinstance(value, Mapping) else f"{dotted}={_short(value)}: {said}"


def _place(content: Any, loc: tuple[Any, ...]) -> tuple[str, ...]:
    """Return the location of an error, without the type name that pydantic adds to `loc` for unions."""
    place: list[str] = []
    for part in loc:
        is_key = isinstance(content, Mapping) and part in content
        if is_key or (isinstance(content, list) and isinstance(part, int)):
            place.append(str(part))
            content = content[part]
    return tuple(place)


def _short(value: Any) -> str:
    """Write a value roughly as YAML would, leaving out the middle if it is long."""
    text = printable(str(value).replace("\n", "\\n"))
    return text if len(text) <= _SHOWN else f"{text[: _SHOWN // 2]}...{text[-_SHOWN // 2 :]}"
