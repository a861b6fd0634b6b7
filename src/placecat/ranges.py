"""Types and ranges of settings, for use in annotations. All ranges exclude NaN and infinity.

:mod:`placecat.schema` applies them to params.yaml, and :mod:`placecat.schema.signatures` to the
parameters of code.
"""

from collections.abc import Collection
from dataclasses import dataclass
from typing import Annotated, Any

from annotated_types import Interval

# Larger values are probably typos and could overflow.
_MOST, _LARGEST = 2**31 - 1, 1e12

Count = Annotated[int, Interval(ge=1, le=_MOST)]
"""One or more."""
Index = Annotated[int, Interval(ge=0, le=_MOST)]
"""A position or count, at least 0."""
Seed = Annotated[int, Interval(ge=0, le=2**32 - 1)]
"""A seed for NumPy."""
Two = Annotated[int, Interval(ge=2, le=_MOST)]
"""Two or more."""
Side = Annotated[int, Interval(ge=1, le=2**14)]
"""Width or height of an image, in pixels."""
Pixels = Annotated[int, Interval(ge=16, le=2**14)]
"""Width to which frames are scaled down, in pixels."""
Positive = Annotated[float, Interval(gt=0, le=_LARGEST)]
NonNegative = Annotated[float, Interval(ge=0, le=_LARGEST)]
AtLeastOne = Annotated[float, Interval(ge=1, le=_LARGEST)]
Share = Annotated[float, Interval(ge=0, le=1)]
"""A share from 0 to 1."""
PositiveShare = Annotated[float, Interval(gt=0, le=1)]
PartShare = Annotated[float, Interval(gt=0, lt=1)]
"""A share above 0 and below 1."""


@dataclass(frozen=True)
class OneOf:
    """A string that must be in a tuple of names or among the keys of a dictionary."""

    names: Collection[str]

    def __get_pydantic_core_schema__(self, source: Any, handler: Any) -> Any:
        """Return the schema for pydantic."""
        from pydantic_core import core_schema

        return core_schema.literal_schema(list(self.names))
