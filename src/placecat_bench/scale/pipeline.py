"""The stages as dvc.yaml has them, with the items that the settings give them."""

import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import yaml

from placecat import settings
from placecat.errors import PlacecatError

DEFINITION = Path("dvc.yaml")


@dataclass(frozen=True)
class Step:
    """One stage with one item.

    Attributes
    ----------
    stage, item
        E.g. ``cues`` and ``gist``; "" for a stage without items.
    command
        To run in the project's folder.
    """

    stage: str
    item: str
    command: tuple[str, ...]

    @property
    def name(self) -> str:
        """As DVC writes it, e.g. ``cues@gist``."""
        return f"{self.stage}@{self.item}" if self.item else self.stage


def steps(wanted: Sequence[str], params: Mapping[str, Any], definition: Path = DEFINITION) -> list[Step]:
    """List stages with their items, in the order that they are named.

    Parameters
    ----------
    wanted
        Names of stages.
    params
        All settings.

    Raises
    ------
    PlacecatError
        A stage that dvc.yaml does not have.
    """
    stages = yaml.safe_load(definition.read_text(encoding="utf-8"))["stages"]
    found = []
    for stage in wanted:
        if stage not in stages:
            raise PlacecatError(f"dvc.yaml has no stage {stage!r}: it has {', '.join(stages)}")
        own = stages[stage]
        items = [""]
        if "foreach" in own:
            items = list(settings.get(params, own["foreach"].removeprefix("${").removesuffix("}")))
        for item in items:
            words = own.get("do", own)["cmd"].split()
            filled = [item if word in ("${key}", "${item}") else word for word in words]
            found.append(Step(stage, str(item), (sys.executable, *filled[1:])))
    return found
