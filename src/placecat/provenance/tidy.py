"""A table of all cells, with the origin of each cell in its row."""

import json
from collections.abc import Iterable
from pathlib import Path

import pandas as pd

from placecat import files, settings
from placecat.provenance.cells import Explained, quantity
from placecat.provenance.frames import Trained
from placecat.thesis.notes import joined


def tidy(cells: Iterable[Explained]) -> pd.DataFrame:
    """Build a table with one row per cell; :func:`placecat.results.load` explains the columns."""
    table = pd.DataFrame([_row(cell) for cell in cells])
    return table.astype({"seeds": "int64", "training_frames": "int64", "tested_frames": "int64"})


def write(path: Path, table: pd.DataFrame) -> None:
    """Write a table as Parquet; the same table and version of Arrow always produce the same bytes."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    # Remove the pandas metadata, which include the pandas version.
    arrow = pa.Table.from_pandas(table, preserve_index=False).replace_schema_metadata(None)
    with files.replacing(path) as temporary:
        pq.write_table(arrow, temporary, compression="zstd")


def _row(cell: Explained) -> dict[str, object]:
    made = cell.made
    trained = [one for of_home in cell.trained.values() for one in of_home]
    parts = {part: values for one in made for part, values in one.settings.items()}
    return {
        "cell": cell.id,
        "table": cell.table,
        "title": cell.title,
        "group": cell.group,
        "row": cell.row,
        "column": cell.column,
        "home": cell.home,
        "quantity": "; ".join(dict.fromkeys(quantity(origin, cell.home) for origin in cell.origins)),
        "measured": cell.measured,
        "published": cell.published,
        "difference": cell.difference,
        "unit": cell.unit,
        "spread": cell.spread,
        "seeds": cell.seeds,
        "seed_names": list(cell.measurement.seeds),
        "by_seed": list(cell.measurement.values),
        "note": joined(cell.notes),
        "findings": ", ".join(cell.findings),
        "data": cell.data[0],
        "published_data": cell.data[1],
        "results": _listed(origin.result for origin in cell.origins),
        "system": _listed(one.system for one in made),
        "cues": _listed(cue for one in made for cue in one.cues),
        "classifiers": _listed(name for one in made for name in one.classifiers),
        "descriptors": _listed(name for one in made for name in one.descriptors),
        "filter": _listed(one.filter for one in made),
        "plan": _listed(one.plan for one in made),
        "trained_on": _listed(home for one in trained for home, _ in (*one.cues, *one.integration)),
        "training_frames": _total(trained, "cues"),
        "integration_frames": _total(trained, "integration"),
        "tested_frames": _total(trained, "tested"),
        "settings": json.dumps(settings.flatten(parts), sort_keys=True),
        "stages": " ".join(cell.stages),
    }


def _listed(names: Iterable[str]) -> str:
    return "; ".join(dict.fromkeys(name for name in names if name))


def _total(trained: Iterable[Trained], kind: str) -> int:
    """Add up the frames of one kind.

    Among plans with the same test frames, only the one with the most frames counts.
    """
    by_test: dict[tuple[tuple[str, int], ...], int] = {}
    for one in trained:
        count = sum(frames for _, frames in getattr(one, kind))
        by_test[one.tested] = max(by_test.get(one.tested, 0), count)
    return sum(by_test.values())
