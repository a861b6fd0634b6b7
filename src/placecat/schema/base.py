"""Types shared by the sections of the schema."""

from typing import Annotated, Any, Literal

from annotated_types import Interval, MinLen
from pydantic import AfterValidator, BaseModel, ConfigDict

from placecat.ranges import Count, Seed
from placecat.schema.names import Distinct, Key


def _odd(number: int) -> int:
    if number % 2 == 0:
        raise ValueError("it must be odd")
    return number


def _ascending(numbers: list[int]) -> list[int]:
    if sorted(set(numbers)) != numbers:
        raise ValueError("it must be ascending, without duplicates")
    return numbers


Odd = Annotated[Count, AfterValidator(_odd)]
Window = Annotated[int, Interval(ge=3, le=999), AfterValidator(_odd)]
Level = Annotated[int, Interval(ge=1, le=16)]
"""Levels of an image pyramid."""
Levels = Annotated[list[Level], MinLen(1), AfterValidator(_ascending)]
# Settings that are checked by the function that receives them.
Own = dict[str, Any]
Seeds = Annotated[Distinct[Seed], MinLen(1)]
Schemes = Annotated[Distinct[Literal["5-5-1", "4-5-1"]], MinLen(1)]
# Names of cues, descriptors and so on. :mod:`placecat.schema.references` checks that they exist.
Keys = Distinct[Key]


class Section(BaseModel):
    """A mapping with exactly these settings and types."""

    model_config = ConfigDict(extra="forbid", strict=True, allow_inf_nan=False)
