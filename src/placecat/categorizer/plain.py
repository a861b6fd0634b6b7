"""Convert trained models to JSON and arrays, and back, without pickle.

A model's attributes are numbers, text, arrays, containers of these, and objects of classes in
`placecat.learning`, `placecat.cues` and `placecat.fusion`. Rebuilding a model runs none of their code.
"""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat import cues, fusion, learning, lookup
from placecat.categorizer import fields
from placecat.errors import PlacecatError

_PACKAGES = (learning, cues, fusion)
# A mapping with this key represents a type that JSON lacks.
_KIND = "$"


def to_plain(value: Any, arrays: list[NDArray[Any]]) -> Any:
    """Convert a value to JSON types. Append its arrays to `arrays`, and replace each with its index.

    Attributes that a class lists as ``TRAINING_ONLY`` are omitted. Raises TypeError for any value that cannot
    be part of a model.
    """
    if value is None or isinstance(value, bool | int | str):
        return value
    if isinstance(value, float) and not isinstance(value, np.generic):
        return value if math.isfinite(value) else {_KIND: "float", "text": repr(value)}
    if isinstance(value, np.ndarray | np.generic):
        if np.asarray(value).dtype.hasobject:
            raise TypeError("an array of Python objects cannot be stored without pickle")
        arrays.append(np.asarray(value))
        return {_KIND: "array" if isinstance(value, np.ndarray) else "scalar", "index": len(arrays) - 1}
    if isinstance(value, list):
        return [to_plain(item, arrays) for item in value]
    if isinstance(value, tuple):
        return {_KIND: "tuple", "items": [to_plain(item, arrays) for item in value]}
    if isinstance(value, dict):
        items = [[to_plain(key, arrays), to_plain(item, arrays)] for key, item in value.items()]
        return {_KIND: "dict", "items": items}
    kind = type(value)
    name = f"{kind.__module__}:{kind.__qualname__}"
    if name not in _classes(kind.__module__):
        raise TypeError(f"{name} is not a class that a model may contain")
    skipped = getattr(kind, "TRAINING_ONLY", ())
    state = {key: to_plain(item, arrays) for key, item in vars(value).items() if key not in skipped}
    return {_KIND: "object", "class": name, "state": state}


def from_plain(plain: Any, arrays: Sequence[NDArray[Any]]) -> Any:
    """Undo :func:`to_plain`. Raises PlacecatError for values that cannot be part of a model."""
    if plain is None or isinstance(plain, bool | int | float | str):
        return plain
    if isinstance(plain, list):
        return [from_plain(item, arrays) for item in plain]
    try:
        kind = plain[_KIND]
        if kind == "float":
            return float(plain["text"])
        if kind in ("array", "scalar"):
            index = plain["index"]
            if type(index) is not int or not 0 <= index < len(arrays):
                raise PlacecatError(
                    f"part of the model refers to array {index!r}, but there are {len(arrays)} arrays"
                )
            array = arrays[index]
            return array if kind == "array" else array[()]
        if kind == "tuple":
            return tuple(from_plain(item, arrays) for item in plain["items"])
        if kind == "dict":
            return {from_plain(key, arrays): from_plain(item, arrays) for key, item in plain["items"]}
        if kind == "object":
            return _rebuild(
                plain["class"], {name: from_plain(item, arrays) for name, item in plain["state"].items()}
            )
    except PlacecatError:
        raise
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        raise PlacecatError(f"part of the model cannot be read ({error!r})") from None
    raise PlacecatError(f"part of the model is of an unknown kind, {kind!r}")


def _rebuild(name: str, state: dict[str, Any]) -> Any:
    kind = _classes(name.partition(":")[0]).get(name)
    if kind is None:
        raise PlacecatError(f"part of the model is a {name}, which this version of placecat lacks")
    if not all(attribute.isidentifier() and not attribute.startswith("__") for attribute in state):
        raise PlacecatError(f"part of the model, a {name}, has an invalid attribute name")
    fields.check(kind, state)
    rebuilt: Any = object.__new__(kind)
    # Bypass __setattr__, because frozen classes forbid it.
    rebuilt.__dict__.update(state)
    return rebuilt


def _classes(module_name: str) -> dict[str, type]:
    """Return the classes that a module of an allowed package defines, keyed by ``module:name``."""
    package, _, name = module_name.rpartition(".")
    if package not in {allowed.__name__ for allowed in _PACKAGES} or name not in lookup.names(package):
        return {}
    module = lookup.module(package, name, "the module")
    return {
        f"{module_name}:{name}": member
        for name, member in vars(module).items()
        if isinstance(member, type) and member.__module__ == module_name
    }
