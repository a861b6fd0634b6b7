"""The schema of conf/toy."""

from typing import Annotated, Literal

from annotated_types import Interval, MinLen

from placecat.ranges import Count, Positive
from placecat.schema.base import Own, Section, Seeds
from placecat.schema.names import Distinct, Key


class Points(Section):
    """Points of the circles."""

    radius: Positive
    inside: Annotated[float, Interval(gt=0, lt=0.785)]


class Sensitivity(Section):
    """Variants of the circles."""

    seeds: Seeds
    radii: Annotated[Distinct[Positive], MinLen(1)]
    decisions: Annotated[Distinct[Literal["sign", "probability", "product"]], MinLen(1)]


class Toy(Section):
    """conf/toy."""

    schemes: dict[Key, Own]
    training: Count
    testing: Count
    seeds: Seeds
    points: Points
    sensitivity: Sensitivity
