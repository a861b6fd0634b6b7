"""Types of image sizes: pyramid levels, and windows with a centre."""

from typing import Annotated

from annotated_types import Interval, MinLen
from pydantic import AfterValidator

from placecat.ranges import Count


def _odd(number: int) -> int:
    if number % 2 == 0:
        raise ValueError("it must be odd")
    return number


def _ascending(numbers: list[int]) -> list[int]:
    if sorted(set(numbers)) != numbers:
        raise ValueError("it must be ascending")
    return numbers


Odd = Annotated[Count, AfterValidator(_odd)]
Window = Annotated[int, Interval(ge=3, le=999), AfterValidator(_odd)]
Level = Annotated[int, Interval(ge=1, le=16)]
"""Levels of an image pyramid."""
Levels = Annotated[list[Level], MinLen(1), AfterValidator(_ascending)]
