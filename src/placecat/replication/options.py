"""The settings of `placecat replicate`, from conf/replication.yaml."""

from pathlib import Path
from typing import Annotated

from annotated_types import Interval

from placecat import paths, schema
from placecat.config import conf_file
from placecat.ranges import Share
from placecat.schema.base import Section

SETTINGS = paths.CONF / "replication.yaml"


class Options(Section):
    """How to group homes and judge the findings on them; conf/replication.yaml explains the settings."""

    group: Annotated[int, Interval(ge=3)]
    level: Annotated[float, Interval(gt=0.5, lt=1)]
    shared: Share


def read(path: Path = SETTINGS) -> Options:
    """Read the settings; raise PlacecatError if a setting is unknown, missing or invalid."""
    content = conf_file.read(path, tuple(Options.model_fields))
    schema.check(content, Options)
    return Options(**content)
