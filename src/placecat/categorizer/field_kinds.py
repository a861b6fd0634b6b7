"""Kinds of fields in a trained model; each checks a value's type, range and shape."""

import math
from collections.abc import Callable
from typing import Any

import numpy as np

# Maps letters to sizes that an object's fields share; the first field with a letter sets its size.
Sizes = dict[str, int]
# Raises ValueError if a value is invalid.
Field = Callable[[Any, Sizes], None]
_LARGE = 10**15


def _passing(test: Callable[[Any], bool], wanted: str) -> Field:
    def field(value: Any, sizes: Sizes) -> None:
        if not test(value):
            raise ValueError(f"is {_short(value)}, not {wanted}")

    return field


truth = _passing(lambda value: type(value) is bool, "true or false")
mapping = _passing(lambda value: isinstance(value, dict), "a mapping")


def number(low: float = -_LARGE, high: float = _LARGE, *, above: float = -math.inf) -> Field:
    """Accept a finite number from `low` to `high` that is greater than `above`."""
    return _passing(
        lambda value: (
            isinstance(value, int | float)
            and not isinstance(value, bool)
            and low <= value <= high
            and value > above
        ),
        f"a number from {max(low, above):g} to {high:g}",
    )


def whole(low: int = 0, high: int = _LARGE, *, side: str = "") -> Field:
    """Accept a whole number from `low` to `high`; a letter `side` is set to this number."""

    def field(value: Any, sizes: Sizes) -> None:
        if type(value) is not int or not low <= value <= high:
            raise ValueError(f"is {_short(value)}, not a whole number from {low} to {high}")
        if side:
            _same(value, side, sizes)

    return field


def one_of(*valid: str) -> Field:
    """Accept one of the words in `valid`."""
    return _passing(lambda value: isinstance(value, str) and value in valid, f"one of {', '.join(valid)}")


def optional(other: Field) -> Field:
    """Accept None, or what another field accepts."""

    def field(value: Any, sizes: Sizes) -> None:
        if value is not None:
            other(value, sizes)

    return field


def array(
    kind: str,
    *sides: int | str | None,
    low: float = -_LARGE,
    high: float = _LARGE,
    below: str = "",
    nan: bool = False,
) -> Field:
    """Accept an array; each side is a number, the letter of a size, or None for any length.

    `kind` is one or more of NumPy's letters ``i``, ``u`` (integers), ``f`` (floats) and ``b`` (booleans).
    Values must be finite, from `low` to `high`, and below the size of the letter `below`; `nan` also allows
    NaN.
    """

    def field(value: Any, sizes: Sizes) -> None:
        if not isinstance(value, np.ndarray) or value.dtype.kind not in kind or value.ndim != len(sides):
            raise ValueError(f"is not an array of type {kind} with {len(sides)} dimensions")
        for length, side in zip(value.shape, sides, strict=True):
            if isinstance(side, str):
                _same(length, side, sizes)
            elif side is not None and length != side:
                raise ValueError(f"has the shape {value.shape}, not {sides}")
        if value.dtype.kind == "b":
            return
        known = value[~np.isnan(value)] if nan else value
        if not known.size:
            return
        if not np.isfinite(known).all():
            raise ValueError("holds numbers that are not finite")
        least, most = known.min().item(), known.max().item()
        if least < low or most > high or (below and most >= sizes[below]):
            raise ValueError(f"holds numbers from {least} to {most}, some of which are out of range")

    return field


def several(item: Field, *, least: int = 0, side: str = "") -> Field:
    """Accept a list or tuple of at least `least` items; a letter `side` takes the length as its size."""

    def field(value: Any, sizes: Sizes) -> None:
        if not isinstance(value, list | tuple) or len(value) < least:
            raise ValueError(f"is not a list of at least {least} items")
        if side:
            _same(len(value), side, sizes)
        for one in value:
            item(one, sizes)

    return field


def by_number(item: Field) -> Field:
    """Accept a mapping whose keys are whole numbers."""

    def field(value: Any, sizes: Sizes) -> None:
        if not isinstance(value, dict) or not all(type(key) is int for key in value):
            raise ValueError("is not a mapping whose keys are whole numbers")
        for one in value.values():
            item(one, sizes)

    return field


def having(*methods: str) -> Field:
    """Accept a model object with these methods; its attributes are checked separately."""

    def field(value: Any, sizes: Sizes) -> None:
        if not all(callable(getattr(value, name, None)) for name in methods):
            raise ValueError(f"does not have all of the methods {', '.join(methods)}")

    return field


def _same(length: int, side: str, sizes: Sizes) -> None:
    if sizes.setdefault(side, length) != length:
        raise ValueError(f"has a side of length {length}, but another attribute has {sizes[side]}")


def _short(value: Any) -> str:
    # An integer may have more digits than Python converts to text.
    said = repr(value) if not isinstance(value, int) or abs(value) < _LARGE else "a very large number"
    return said if len(said) < 80 else f"{said[:80]}..."
