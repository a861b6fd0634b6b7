"""The schema of panorama imports (conf/panoramas.yaml): names, types and ranges."""

from typing import Annotated

from annotated_types import Interval, Len
from pydantic import AfterValidator, field_validator

from placecat.ranges import Index, Side
from placecat.schema.base import Section
from placecat.schema.names import Distinct, FileName, Label, Text


def _ordered(numbers: list[float]) -> list[float]:
    if numbers[0] > numbers[1]:
        raise ValueError("the first must not be larger than the second")
    return numbers


def _word(text: str) -> str:
    if not text or text.split() != [text]:
        raise ValueError("it must not contain spaces, which separate the columns of label files")
    return text


_Pair = (Len(2, 2), AfterValidator(_ordered))
Word = Annotated[Label, AfterValidator(_word)]
Tilts = Annotated[list[Annotated[float, Interval(ge=-90, le=90)]], *_Pair]
Fovs = Annotated[list[Annotated[float, Interval(ge=1, le=170)]], *_Pair]
Turns = Annotated[list[Annotated[float, Interval(ge=1, le=3600)]], *_Pair]
Seconds = Annotated[float, Interval(ge=0.01, le=3600)]
Rests = Annotated[list[Annotated[float, Interval(ge=0, le=3600)]], *_Pair]
Visits = Annotated[list[Annotated[int, Interval(ge=1, le=1000)]], *_Pair]


class Stay(Section):
    """How long people stay in a place, in seconds."""

    mean: Seconds
    deviation: Seconds


class Faces(Section):
    """Text that marks each face in file names."""

    front: Text
    right: Text
    back: Text
    left: Text
    up: Text
    down: Text


class Cubes(Section):
    """File names of the six images of a panorama."""

    file: Text
    faces: Faces

    @field_validator("file")
    @classmethod
    def _check_file(cls, file: str) -> str:
        if "FILE" not in file or "FACE" not in file:
            raise ValueError("it must contain FILE and FACE")
        return file


class Zind(Section):
    """Settings for the Zillow Indoor Dataset."""

    others: Word | None
    inside_only: bool


class Panoramas(Section):
    """conf/panoramas.yaml."""

    source: str
    table: FileName
    homes: Annotated[Distinct[FileName], Len(1)] | None
    labels: dict[Word, Distinct[Label]]
    cubes: Cubes
    zind: Zind
    width: Side
    height: Side
    fps: Annotated[float, Interval(gt=0, le=1000)]
    quality: Annotated[int, Interval(ge=1, le=100)]
    walk: Index
    visits: Visits
    ways: Distinct[Word]
    stays: dict[Word, Stay]
    other_stays: Stay
    shortest_stay: Seconds
    longest_look: Seconds
    fov: Fovs
    tilt: Tilts
    turn: Turns
    speed: Turns
    rest: Rests
