"""Pydantic validators for fields of a trained model, in addition to those in `placecat.ranges`.

A letter stands for a size that several fields of an object share. The first field with that letter sets the
size. The sizes are stored in a dictionary that is passed to pydantic as its validation context.
"""

from typing import Any

import numpy as np
from pydantic import AfterValidator, PlainValidator, ValidationInfo

_LARGE = 10**15


def side(letter: str) -> AfterValidator:
    """Require an integer, or the length of a list, to equal the size this letter stands for."""

    def check(value: Any, info: ValidationInfo) -> Any:
        _same(value if isinstance(value, int) else len(value), letter, info)
        return value

    return AfterValidator(check)


def array(
    kind: str,
    *sides: int | str | None,
    low: float = -_LARGE,
    high: float = _LARGE,
    below: str = "",
    nan: bool = False,
) -> PlainValidator:
    """Accept an array of this shape and type.

    Each side is a number, the letter of a size, or None for any length. `kind` consists of one or more of
    NumPy's letters ``i``, ``u`` (integers), ``f`` (floats) and ``b`` (booleans). Values must be finite and
    lie between `low` and `high`. If `below` is a letter, they must also be below the size it stands for. If
    `nan` is true, NaN is allowed too.
    """

    def check(value: Any, info: ValidationInfo) -> Any:
        if not isinstance(value, np.ndarray) or value.dtype.kind not in kind or value.ndim != len(sides):
            raise ValueError(f"it must be an array of type {kind} with {len(sides)} dimensions")
        for length, wanted in zip(value.shape, sides, strict=True):
            if isinstance(wanted, str):
                _same(length, wanted, info)
            elif wanted is not None and length != wanted:
                raise ValueError(f"it must have the shape {sides}, not {value.shape}")
        known = value[~np.isnan(value)] if nan else value
        if value.dtype.kind == "b" or not known.size:
            return value
        if not np.isfinite(known).all():
            raise ValueError("it contains non-finite numbers")
        sizes: Any = info.context
        least, most = known.min().item(), known.max().item()
        if least < low or most > high or (below and most >= sizes[below]):
            raise ValueError(f"it contains numbers from {least} to {most}, some of which are out of range")
        return value

    return PlainValidator(check)


def having(*methods: str) -> PlainValidator:
    """Accept a model object with these methods. Its attributes are checked separately."""

    def check(value: Any) -> Any:
        if not all(callable(getattr(value, name, None)) for name in methods):
            raise ValueError(f"it must have the methods {', '.join(methods)}")
        return value

    return PlainValidator(check)


def _same(length: int, letter: str, info: ValidationInfo) -> None:
    sizes: Any = info.context
    if sizes.setdefault(letter, length) != length:
        raise ValueError(f"it has size {length}, but another attribute has size {sizes[letter]}")
