"""A row a result: how good its distributions are, averaged over test homes (an addition to the thesis)."""

from collections.abc import Mapping
from typing import Any

from placecat.results.measured import MEASURES, Results
from placecat.thesis.layouts import Cell, cell
from placecat.thesis.number import Number, home_label, nothing


def cells(table: Mapping[str, Any], results: Results) -> list[Cell]:
    """Cells of every row in ``table["rows"]``, each with `group`, `row` and `result` of the main data set.

    A column each for log-loss (nats), calibration error and accuracy of stays (both in percent), see
    :class:`placecat.evaluation.quality.HomeQuality`.
    """
    return [
        cell((row["group"], row["row"], column), _over_homes(results, row["result"], measure))
        for row in table["rows"]
        for measure, column in MEASURES.items()
    ]


def _over_homes(results: Results, name: str, measure: str) -> Number:
    one = results.quality.get(name)
    if one is None:
        reasons = [reason for (result, _), reason in results.missing.items() if result == name]
        if not reasons:
            # Refuses a name that there is not.
            results.of(name)
        return nothing(*(dict.fromkeys(reasons) or ["nothing was measured"]))
    values = one.over_homes(measure)
    if not len(values):
        return nothing("no tested frame has a label")
    there = [home_label(number) for number, home in enumerate(results.homes, 1) if home in one.homes]
    note = "" if len(there) == len(results.homes) else f"mean over {', '.join(there)} only"
    return Number(values, one.is_random).noted(note)
