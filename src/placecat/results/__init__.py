"""The types and files of a run's results."""

from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import pandas as pd


def load(project: Path | str = ".") -> "pd.DataFrame":
    """Load every number of the tables and of the text as one table, one row per cell.

    `project` is the project's folder. Raises PlacecatError if the stage `report` has not run there. Columns:
    ``cell`` is the cell's number (for ``placecat explain``); ``table``, ``title``, ``group``, ``row`` and
    ``column`` locate the cell; ``home`` is the only test home, or "all". ``quantity`` is the measured
    quantity; ``measured``, ``published`` and their ``difference`` are in ``unit``, NaN if missing. ``spread``
    is the largest minus the smallest number over the ``seeds``; ``seed_names`` and ``by_seed`` list the seeds
    and their numbers. ``note`` says why ``measured`` and ``published`` differ or one is missing; ``findings``
    lists the findings that use the cell. The other columns tell where the number comes from: ``data`` and
    ``published_data``; ``results``, ``system``, ``cues``, ``classifiers``, ``descriptors``, ``filter`` and
    ``plan``; ``trained_on``; the numbers of frames that trained the cues (``training_frames``), trained the
    integration (``integration_frames``) and were tested (``tested_frames``); ``settings`` as JSON; and DVC's
    ``stages``.
    """
    import pandas as pd

    from placecat import paths
    from placecat.errors import PlacecatError

    path = Path(project) / paths.RESULTS
    if not path.is_file():
        raise PlacecatError(f"{path} is missing: run `dvc repro` to make it, or restore it from git")
    return pd.read_parquet(path)
