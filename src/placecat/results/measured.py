"""A run's measurements: decision counts by true place, and the quality of the distributions."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from placecat.errors import PlacecatError
from placecat.evaluation.accuracy import class_accuracies, home_accuracy
from placecat.paths import NO_SEED

SCORE_COLUMNS = ["result", "home", "seed", "truth", "decision", "frames"]
MISSING_COLUMNS = ["result", "home", "reason"]
DROPPED_COLUMNS = ["filter", "home", "threshold", "frames", "dropped", "labelled", "dropped_labelled"]
# The measures that are means, and how tables label them. The other measures are counts.
MEASURES = {
    "log_loss": "Log loss",
    "calibration_error": "Calibration error",
    "stay_accuracy": "Stay accuracy",
}
# Decimals of each measure: three for nats, two for percent.
DECIMALS = {"log_loss": 3, "calibration_error": 2, "stay_accuracy": 2}


@dataclass(frozen=True)
class Measured:
    """One result: for each seed, the decisions on the frames of some test homes.

    Attributes
    ----------
    homes, classes
        Names of the test homes, in the order of the data set, and of the places.
    seeds
        Names of the seeds, e.g. ``("seed-0", "seed-1")``; ``("no-seed",)`` if nothing is random.
    confusion
        (seeds, homes, classes, classes) counts. Rows are true classes, and columns are predicted classes.
    """

    homes: tuple[str, ...]
    seeds: tuple[str, ...]
    classes: tuple[str, ...]
    confusion: NDArray[np.int64]

    @property
    def is_random(self) -> bool:
        """Whether the result depends on a seed."""
        return self.seeds != (NO_SEED,)

    def by_home(self) -> NDArray[np.float64]:
        """Return (seeds, homes) accuracies in percent, each a mean over the classes present (thesis 4.2)."""
        return np.array([[home_accuracy(of_home) for of_home in of_seed] for of_seed in self.confusion])

    def by_class(self) -> NDArray[np.float64]:
        """Return (seeds, homes, classes) accuracies in percent; NaN if a home has no frames of the class."""
        return np.array([[class_accuracies(of_home) for of_home in of_seed] for of_seed in self.confusion])

    def plain(self) -> NDArray[np.float64]:
        """Return (seeds, homes) percentages of correctly classified frames, ignoring their places."""
        right = np.diagonal(self.confusion, axis1=2, axis2=3).sum(axis=2)
        frames = self.confusion.sum(axis=(2, 3))
        return np.divide(100.0 * right, frames, out=np.full(right.shape, np.nan), where=frames > 0)

    def pooled(self) -> Measured:
        """Return the result with the frames of all homes pooled into a single home named "all"."""
        return Measured(("all",), self.seeds, self.classes, self.confusion.sum(axis=1, keepdims=True))


@dataclass(frozen=True)
class Quality:
    """The quality of a result's distributions for some test homes and each seed (see :class:`Measured`).

    `values` maps each field of :class:`placecat.evaluation.quality.HomeQuality` to a (seeds, homes) array.
    """

    homes: tuple[str, ...]
    seeds: tuple[str, ...]
    values: Mapping[str, NDArray[np.float64]]

    @property
    def is_random(self) -> bool:
        """Whether the result depends on a seed."""
        return self.seeds != (NO_SEED,)

    def over_homes(self, measure: str) -> NDArray[np.float64]:
        """Return a measure's (seeds,) averages over homes, or (0,) if no home has labelled frames.

        `measure` is one of `MEASURES`.
        """
        values = self.values[measure]
        there = np.isfinite(values).all(axis=0)
        return values[:, there].mean(axis=1) if there.any() else np.empty(0)

    def stay_share(self) -> NDArray[np.float64]:
        """Return each seed's percentage of correctly named stays, over all homes together.

        The shape is (seeds,), or (0,) if there are no stays.
        """
        stays = self.values["stays"].sum(axis=1)
        return 100.0 * self.values["stays_right"].sum(axis=1) / stays if stays.all() else np.empty(0)

    def averages(self) -> dict[str, float]:
        """Return the rounded mean over homes and seeds of each of the `MEASURES` that could be computed."""
        means = {measure: self.over_homes(measure) for measure in MEASURES}
        return {name: round(float(one.mean()), DECIMALS[name]) for name, one in means.items() if len(one)}


@dataclass(frozen=True)
class Results:
    """All results of a run.

    Attributes
    ----------
    homes, classes
        Names of the homes and places of the main data set, in order.
    measured
        Maps each result's name, e.g. ``cues/gist/5-5-1``, to its measurement.
    missing
        Maps each missing (result, home) to the reason why it cannot be computed on this data set.
    stays
        The results on additional data sets, by stay. Each stay (a visit to a place) is treated as a home, and
        all its frames show the same place.
    dropped
        Maps each information filter's name to a table of the frames that it drops
        (:func:`placecat.fusion.information_filter.dropped`), with the columns of `DROPPED_COLUMNS`.
    quality
        Maps the name of each result that is not a trial to the quality of its distributions.
    """

    homes: tuple[str, ...]
    classes: tuple[str, ...]
    measured: dict[str, Measured]
    missing: dict[tuple[str, str], str]
    stays: dict[str, Measured] = field(default_factory=dict)
    dropped: dict[str, pd.DataFrame] = field(default_factory=dict)
    quality: Mapping[str, Quality] = field(default_factory=dict)

    @property
    def numbers(self) -> range:
        """The homes' numbers, starting at 1 as in the thesis."""
        return range(1, len(self.homes) + 1)

    def of(self, name: str) -> Measured:
        """Look up a result; if the name is unknown, raise PlacecatError, which suggests similar names."""
        if name not in self.measured:
            near = difflib.get_close_matches(name, self.measured, n=3) or sorted(self.measured)[:5]
            raise PlacecatError(f"result {name!r} does not exist: did you mean {' or '.join(near)}?")
        return self.measured[name]

    def find(self, name: str) -> Measured | None:
        """Like `of`, but return None for a result that is missing for a known reason."""
        return None if name not in self.measured and self.reasons(name) else self.of(name)

    def reasons(self, name: str) -> list[str]:
        """List the reasons why a result is missing in some homes, without duplicates."""
        return list(dict.fromkeys(reason for (result, _), reason in self.missing.items() if result == name))

    def drops(self, name: str, home: str = "") -> str:
        """Describe the share of frames dropped by a result's information filter; "" if it has no filter."""
        homes = next((self.dropped[part] for part in name.split("/")[1:2] if part in self.dropped), None)
        if homes is None:
            return ""
        if home:
            homes = homes[homes["home"] == home]
        share = 100.0 * homes["dropped_labelled"].sum() / max(int(homes["labelled"].sum()), 1)
        low, high = homes["threshold"].min(), homes["threshold"].max()
        threshold = f"{low:.5f}" if low == high else f"{low:.5f} to {high:.5f}"
        return f"the threshold {threshold} drops {share:.0f}% of the labelled frames"

    def accuracy_table(self) -> pd.DataFrame:
        """Tabulate all accuracies, with the columns result, home, place, frames, accuracy, spread and seeds.

        ``accuracy`` is the mean over seeds. ``place`` is "all" for the mean over places. ``spread`` is the
        difference between the largest and smallest accuracies over seeds, or NaN if nothing is random.
        """
        rows = []
        for name, one in self.measured.items():
            percent = np.concatenate([one.by_class(), one.by_home()[:, :, None]], axis=2)
            frames = one.confusion[0].sum(axis=2)
            frames = np.concatenate([frames, frames.sum(axis=1, keepdims=True)], axis=1)
            for h, home in enumerate(one.homes):
                for c, place in enumerate([*one.classes, "all"]):
                    mean, spread = mean_and_spread(percent[:, h, c], random=one.is_random)
                    seeds = len(one.seeds) if one.is_random else 0
                    rows.append((name, home, place, int(frames[h, c]), mean, spread, seeds))
        columns = ["result", "home", "place", "frames", "accuracy", "spread", "seeds"]
        return pd.DataFrame(rows, columns=columns)


def mean_and_spread(values: NDArray[np.float64], *, random: bool) -> tuple[float, float]:
    """Return the mean and spread of some values, rounded to two decimals.

    The spread is the difference between the largest and smallest values, or NaN if they are not random.
    """
    spread = round(float(values.max() - values.min()), 2) if random else float("nan")
    return round(float(values.mean()), 2), spread


def score_rows(name: str, one: Measured) -> list[tuple[str, str, str, str, str, int]]:
    """List a result's rows for the score file (see `SCORE_COLUMNS`), omitting counts of zero."""
    return [
        (name, one.homes[h], one.seeds[s], one.classes[i], one.classes[k], int(one.confusion[s, h, i, k]))
        for s, h, i, k in np.argwhere(one.confusion).tolist()
    ]


def from_scores(
    scores: pd.DataFrame,
    missing: pd.DataFrame,
    homes: Sequence[str],
    classes: Sequence[str],
    other_classes: Iterable[Sequence[str]] = (),
    stays: pd.DataFrame | None = None,
    dropped: pd.DataFrame | None = None,
) -> Results:
    """Build the results from the rows of `score_rows`; the rows in `stays` have stays instead of homes.

    The columns of `scores` and `missing` are `SCORE_COLUMNS` and `MISSING_COLUMNS`. `classes` lists the main
    data set's places, and `other_classes` those of each other data set. Each result uses `classes` or, if
    that lacks any of the result's places, the first other list that contains them all.
    """
    reasons = {(str(row.result), str(row.home)): str(row.reason) for row in missing.itertuples(index=False)}
    lists = (tuple(classes), *map(tuple, other_classes))
    return Results(
        tuple(homes),
        tuple(classes),
        _measured(scores, lists),
        reasons,
        {} if stays is None else _measured(stays, lists),
        {} if dropped is None else {str(name): rows for name, rows in dropped.groupby("filter", sort=False)},
    )


def _measured(scores: pd.DataFrame, lists: Sequence[tuple[str, ...]]) -> dict[str, Measured]:
    # Convert the columns to lists once; calling pandas for each result would take most of the run time.
    columns = {name: scores[name].tolist() for name in ("home", "seed", "truth", "decision", "frames")}
    codes, names = pd.factorize(scores["result"])
    rows: list[list[int]] = [[] for _ in names]
    for row, code in enumerate(codes.tolist()):
        if code >= 0:
            rows[code].append(row)
    measured = {}
    for name, own in zip(names, rows, strict=True):
        values = {column: [content[row] for row in own] for column, content in columns.items()}
        seen = {*values["truth"], *values["decision"]}
        places = next((one for one in lists if seen <= set(one)), tuple(sorted(seen)))
        homes, seeds = tuple(dict.fromkeys(values["home"])), tuple(dict.fromkeys(values["seed"]))
        axes = {"seed": seeds, "home": homes, "truth": places, "decision": places}
        confusion = np.zeros([len(labels) for labels in axes.values()], np.int64)
        index = tuple([labels.index(one) for one in values[column]] for column, labels in axes.items())
        confusion[index] = values["frames"]
        measured[str(name)] = Measured(homes, seeds, places, confusion)
    return measured
