"""The settings of `placecat replicate`, from conf/replication.yaml."""

from dataclasses import dataclass
from pathlib import Path

from placecat import paths, settings
from placecat.config import conf_file
from placecat.errors import SettingError

SETTINGS = paths.CONF / "replication.yaml"


@dataclass(frozen=True)
class Options:
    """How to group homes and judge the findings on them.

    Attributes
    ----------
    group
        Number of homes in a group, at least 3.
    level
        Level of the intervals, above 0.5 and below 1.
    shared
        Share of variance that a group's homes have in common, 0 to 1, above which a verdict is marked.
    """

    group: int
    level: float
    shared: float

    def __post_init__(self) -> None:
        """Raise SettingError if a value is out of range."""
        if self.group < 3:
            raise SettingError(f"group must be 3 or more, not {self.group}")
        if not 0.5 < self.level < 1.0:
            raise SettingError(f"level must be above 0.5 and below 1, not {self.level}")
        if not 0.0 <= self.shared <= 1.0:
            raise SettingError(f"shared must be from 0 to 1, not {self.shared}")


def read(path: Path = SETTINGS) -> Options:
    """Read the settings; raises PlacecatError if one is unknown, missing, out of range or of a wrong type."""
    content = conf_file.read(path, ("group", "level", "shared"))
    return settings.call(Options, settings=content, where=str(path))
