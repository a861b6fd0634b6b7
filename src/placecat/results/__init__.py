"""The results of a run: types, files, and `load`, which reads all numbers as one table."""

from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import pandas as pd


def load(project: Path | str = ".") -> "pd.DataFrame":
    """Load all numbers in the tables and in the text as one table with one row per cell.

    `project` is the project folder. Raises PlacecatError if the `report` stage has not run there.

    The column ``cell`` contains the cell's number (for ``placecat explain``), and ``table``, ``title``,
    ``group``, ``row`` and ``column`` locate the cell. ``home`` is the test home if there is only one, and
    "all" otherwise. ``quantity`` is the measured quantity. The units of ``measured``, ``published`` and their
    ``difference`` are given in ``unit``; a missing number is NaN. ``spread`` is the difference between the
    largest and smallest numbers over the ``seeds``; ``seed_names`` and ``by_seed`` list the seeds and their
    numbers. ``note`` says why ``measured`` and ``published`` differ, or why one of them is missing.
    ``findings`` lists the findings that use the cell.

    The other columns say where the number comes from. ``data`` and ``published_data`` are the data sets.
    ``results``, ``system``, ``cues``, ``classifiers``, ``descriptors``, ``filter`` and ``plan`` say how the
    number was produced, and ``trained_on`` lists the homes used for training. ``training_frames``,
    ``integration_frames`` and ``tested_frames`` are the numbers of frames used to train the cues, to train
    the integration, and to test the result. ``settings`` contains the settings as JSON, and ``stages`` lists
    the DVC stages.
    """
    import pandas as pd

    from placecat import paths
    from placecat.errors import PlacecatError

    project = Path(project).resolve()
    if not (project / paths.RESULTS).is_file():
        raise PlacecatError(
            f"{paths.RESULTS} is missing in {project}: call load() in the project folder or with its path; "
            "if this is one, run `dvc repro` there, or restore the file from git"
        )
    return pd.read_parquet(project / paths.RESULTS)
