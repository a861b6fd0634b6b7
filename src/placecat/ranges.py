"""Types of settings with their ranges, for annotations. No range contains NaN or infinity.

:mod:`placecat.schema` checks those of a section; :mod:`placecat.signatures` those of a function or estimator.
"""

from collections.abc import Collection
from dataclasses import dataclass
from typing import Annotated, Any

from annotated_types import Interval

# Larger values are typing errors, and would overflow somewhere.
_MOST, _LARGEST = 2**31 - 1, 1e12

Count = Annotated[int, Interval(ge=1, le=_MOST)]
"""One or more."""
Index = Annotated[int, Interval(ge=0, le=_MOST)]
"""A number from 0, or none or more of something."""
Seed = Annotated[int, Interval(ge=0, le=2**32 - 1)]
"""A seed of NumPy."""
Two = Annotated[int, Interval(ge=2, le=_MOST)]
"""Two or more."""
Side = Annotated[int, Interval(ge=1, le=2**14)]
"""Width or height of an image, in pixels."""
Pixels = Annotated[int, Interval(ge=16, le=2**14)]
"""Width that a frame is reduced to."""
Positive = Annotated[float, Interval(gt=0, le=_LARGEST)]
NonNegative = Annotated[float, Interval(ge=0, le=_LARGEST)]
AtLeastOne = Annotated[float, Interval(ge=1, le=_LARGEST)]
Share = Annotated[float, Interval(ge=0, le=1)]
"""Part of a whole, from nothing to all."""
PositiveShare = Annotated[float, Interval(gt=0, le=1)]
PartShare = Annotated[float, Interval(gt=0, lt=1)]
"""Neither nothing nor all."""


@dataclass(frozen=True)
class OneOf:
    """A text that must be one of the names in a tuple, or of the keys of a dictionary."""

    names: Collection[str]

    def __get_pydantic_core_schema__(self, source: Any, handler: Any) -> Any:
        """The schema for pydantic."""
        from pydantic_core import core_schema

        return core_schema.literal_schema(list(self.names))
