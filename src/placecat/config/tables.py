"""Check table definitions when settings are composed, before any stage runs.

This module imports little, so it stays fast.
"""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from placecat import lookup, settings
from placecat.errors import PlacecatError, did_you_mean
from placecat.evaluation.trials import expand
from placecat.schema import signatures
from placecat.thesis import definitions


def check(params: Mapping[str, Any], root: Path = Path()) -> None:
    """Raise PlacecatError if a table has an unknown layout, or a trial has an unknown classifier or setting.

    Takes the same parameters as :func:`placecat.thesis.definitions.tables`, and also raises its errors and
    those of :func:`placecat.evaluation.trials.expand` and :mod:`placecat.schema.signatures`. For an unknown
    layout, the message names the most similar layout and all valid ones.
    """
    studies = definitions.studies(params, root).values()
    of_studies = {name: table for study in studies for name, table in study.items()}
    valid = lookup.keys("placecat.thesis", "layouts", "LAYOUTS")
    for name, table in {**definitions.tables(params, root), **of_studies}.items():
        layout = table.get("layout")
        if layout not in valid and (layout is not None or name not in of_studies):
            question = did_you_mean(layout, valid)
            raise PlacecatError(
                f"{name}: the layout {layout!r} does not exist{question}: use one of {', '.join(valid)}"
            )
    for name, table in of_studies.items():
        for trial in expand(name, table, list(settings.get(params, "dataset.homes"))):
            signatures.check_part(trial.settings, trial.name)
