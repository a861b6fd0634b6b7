"""Fill a table, or the numbers in the text, from the results and the files in data/thesis."""

from collections.abc import Mapping
from typing import Any

import pandas as pd

from placecat import files, paths, settings
from placecat.results.measured import Results
from placecat.thesis import definitions, in_text
from placecat.thesis.records import read_records
from placecat.thesis.tables import contradictions_of, dataset_of, fill_table

_KEY = ["group", "row", "column"]


def table(definition: Mapping[str, Any], results: Results, params: Mapping[str, Any]) -> pd.DataFrame:
    """Fill one table of :func:`~placecat.thesis.tables.tables_of` (see :func:`.tables.fill_table`).

    Raises PlacecatError if a file in data/thesis is damaged.
    """
    contradictions = contradictions_of(files.read_table(paths.CONTRADICTIONS, [*_KEY, "note"]))
    published = files.read_table(paths.PUBLISHED, _KEY)
    return fill_table(definition, results, published, dataset_of(definition, params), contradictions)


def text(results: Results, params: Mapping[str, Any]) -> pd.DataFrame:
    """Fill the numbers in the thesis's text (:func:`placecat.thesis.in_text.in_text`).

    Raises PlacecatError if a file in data/thesis is damaged, or a stage's record is missing.
    """
    columns = ["name", "section", "quantity", "home", "quote", "note"]
    return in_text.in_text(
        definitions.in_text(),
        results,
        files.read_table(paths.PUBLISHED_TEXT, columns),
        settings.get(params, "dataset"),
        {name: split["dataset"] for name, split in settings.get(params, "splits").items()},
        read_records(params),
    )
