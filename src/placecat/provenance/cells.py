"""Explanations for every cell of the tables and every number in the text."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, cached_property, partial
from typing import Any

import pandas as pd

from placecat import settings
from placecat.evaluation.trials import AXES
from placecat.provenance import numbering
from placecat.provenance.frames import Trained, trained
from placecat.provenance.made import Made, all_stages, made
from placecat.provenance.origins import Measurement, from_json
from placecat.results.measured import MEASURES
from placecat.thesis import in_text
from placecat.thesis.comparison import DIFFERENCE
from placecat.thesis.notes import Notes
from placecat.thesis.number import ALL_FRAMES, Origin
from placecat.thesis.records import RECORD, trials_of
from placecat.thesis.tables import in_percent

ALL_HOMES = "all"


@dataclass(frozen=True)
class Table:
    """A table with its definition (which includes its name), its cells with their notes, and its data set."""

    settings: Mapping[str, Any]
    cells: pd.DataFrame
    dataset: Mapping[str, Any]


@dataclass(frozen=True)
class Explained:
    """A cell of a table, or a number in the text, with its explanation.

    :func:`placecat.results.load` explains most attributes. `id` is the number of the cell on the page
    (:mod:`placecat.provenance.numbering`). For a number in the text, `group`, `row` and `column` are its
    name, quantity and home. `unit` is "percent", "points", "nats", "times", or "" if the quantity names it.
    `data` contains the titles of the data sets behind the measured and published numbers; the second is ""
    if nothing was published. `made` describes how each result behind the cell was made. `trained` maps each
    test home to the frames of each of its plans, without duplicates. `findings` lists the numbers of the
    findings that are based on these results.
    """

    id: str
    table: str
    title: str
    group: str
    row: str
    column: str
    home: str
    measured: float
    published: float
    spread: float
    seeds: int
    unit: str
    measurement: Measurement
    notes: Notes
    data: tuple[str, str]
    made: tuple[Made, ...]
    trained: Mapping[str, Sequence[Trained]]
    findings: tuple[str, ...]

    @property
    def stages(self) -> tuple[str, ...]:
        """The DVC stages that produced the cell, in order."""
        return all_stages(self.made)

    @property
    def origins(self) -> tuple[Origin, ...]:
        """The results behind the cell."""
        return self.measurement.origins

    @property
    def difference(self) -> float:
        """Measured minus published, rounded to 2 decimals; NaN if either is missing."""
        return round(self.measured - self.published, 2)


@dataclass
class Explaining:
    """All cells of a run.

    `params` contains all settings. `tables` are the filled tables in the order of the report, and `texts` are
    the numbers in the text, with notes. `origins` holds the contents of data/origins.json. `comparisons` are
    the comparisons in the findings, with the columns finding, left_results and right_results.
    """

    params: Mapping[str, Any]
    tables: Sequence[Table]
    texts: pd.DataFrame
    origins: Mapping[str, Sequence[Mapping[str, Any]]]
    comparisons: pd.DataFrame

    def __post_init__(self) -> None:
        """Prepare caches for information that many cells share."""
        trials = trials_of(self.params)
        self._how = cache(lambda result: made(result, self.params, trials))
        self._trained = cache(partial(trained, self.params))

    def cells(self) -> Iterator[Explained]:
        """Yield every cell of the tables, then every number in the text."""
        for table in self.tables:
            yield from self._of_table(table)
        yield from self._of_text()

    def _of_table(self, table: Table) -> Iterator[Explained]:
        name, own = table.settings["name"], table.settings
        title = own["title"] if own["number"] is None else f"Table {own['number']}: {own['title']}"
        ids, measurements = numbering.numbers(table.cells, name), from_json(self.origins[name])
        data = (str(table.dataset["title"]), str(own["thesis_data"] or ""))
        for row in table.cells.to_dict("records"):
            key = (row["group"], row["row"], row["column"])
            one = measurements[key]
            unit = "points" if len(one.origins) > 1 else "percent"
            if not in_percent(own) and one.origins and one.origins[0].part == "log_loss":
                unit = "nats"
            yield self._cell(key, row, one, id=ids[key], table=name, title=title, unit=unit, data=data)

    def _of_text(self) -> Iterator[Explained]:
        name, measurements = in_text.NAME, from_json(self.origins[in_text.NAME])
        ids = numbering.numbers(self.texts, name)
        for row in self.texts.to_dict("records"):
            key = (row["name"], row["quantity"], row["home"])
            one = measurements[key]
            data = str(next((note.text for note in row["notes"] if note.is_of_the_table), ""))
            yield self._cell(
                key,
                row,
                one,
                id=ids[key],
                table=name,
                title=f"Number in the text, section {row['section']}",
                unit=_unit_in_text(row["quantity"], one.origins),
                data=(data.removeprefix("measured on "), ""),
            )

    def _cell(
        self, key: tuple[str, str, str], row: Mapping[Any, Any], one: Measurement, **named: Any
    ) -> Explained:
        homes = list(dict.fromkeys(home for origin in one.origins for home in origin.homes))
        results = list(dict.fromkeys(origin.result for origin in one.origins))
        named.update(zip(AXES, key, strict=True))
        named.update((name, float(row[name])) for name in ("measured", "published", "spread"))
        return Explained(
            **named,
            home=homes[0] if len(homes) == 1 else ALL_HOMES,
            seeds=int(row["seeds"]),
            measurement=one,
            notes=row["notes"],
            made=tuple(self._how(result) for result in results),
            trained=self._frames(one.origins),
            findings=tuple(finding for finding, of in self._findings.items() if of & set(results)),
        )

    def _frames(self, origins: Sequence[Origin]) -> dict[str, list[Trained]]:
        found: dict[str, list[Trained]] = {}
        for origin in origins:
            how = self._how(origin.result)
            is_split = how.plan in settings.get(self.params, "splits")
            # If a number is a mean over all homes, its origin does not list them.
            homes = origin.homes or settings.get(self.params, "dataset.homes")
            for home in [how.plan] if is_split else homes:
                one = self._trained(how.plan, home, how.fuses, how.extra)
                if one is not None and one not in found.setdefault(home, []):
                    found[home].append(one)
        return found

    @cached_property
    def _findings(self) -> dict[str, set[str]]:
        """Map the number of each finding to the results that it compares."""
        found: dict[str, set[str]] = {}
        columns = self.comparisons[["finding", "left_results", "right_results"]]
        for finding, left, right in columns.itertuples(index=False, name=None):
            names = [name for side in (left, right) for name in str(side).split("; ")]
            found.setdefault(str(finding), set()).update(names)
        return found


def _unit_in_text(quantity: str, origins: Sequence[Origin]) -> str:
    if not origins or origins[0].result.startswith(RECORD):
        return ""
    if DIFFERENCE in quantity:
        return "points"
    return "percent" if len(origins) == 1 else "times"


def quantity(origin: Origin, home: str) -> str:
    """Describe the measured quantity, such as "accuracy in home_3: mean over the places ..."."""
    where = f" in {home}" if home != ALL_HOMES else ""
    if origin.part in MEASURES:
        text = f"{MEASURES[origin.part].lower()} of the distributions"
    elif origin.part == ALL_FRAMES:
        text = f"share of all labelled frames{where} that are named correctly, whatever their place"
    elif origin.part:
        text = f"share of the frames of {origin.part}{where} that are named {origin.part}"
    else:
        text = f"accuracy{where}: mean over the places of the share of correctly named frames"
    if origin.result.startswith(RECORD):
        text = "taken from a record"
    several = home == ALL_HOMES and len(origin.homes) > 1
    return f"{text}; mean over {', '.join(origin.homes)}" if several else text
