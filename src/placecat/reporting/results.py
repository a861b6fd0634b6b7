"""Measured accuracies, in the form that tables ask for them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from placecat.errors import PlacecatError
from placecat.evaluation.accuracy import class_accuracies, home_accuracy


@dataclass(frozen=True)
class Results:
    """Confusion matrices of everything that was measured.

    Attributes
    ----------
    homes
        Names of the test homes in order.
    classes
        Names of the places in order.
    confusion
        For each result (e.g. ``cues/gist/5-5-1``) the (homes, classes, classes) counts; a row a true class.
    """

    homes: tuple[str, ...]
    classes: tuple[str, ...]
    confusion: dict[str, NDArray[np.int64]]

    def _of(self, result: str) -> NDArray[np.int64]:
        if result not in self.confusion:
            raise PlacecatError(
                f"a table asks for result {result!r}, but there is {', '.join(sorted(self.confusion))}"
            )
        return self.confusion[result]

    def by_home(self, result: str) -> NDArray[np.float64]:
        """(homes,) accuracies in percent."""
        return np.array([home_accuracy(confusion) for confusion in self._of(result)])

    def by_class(self, result: str) -> NDArray[np.float64]:
        """(homes, classes) percentages, NaN where a home has no frame of a class."""
        return np.stack([class_accuracies(confusion) for confusion in self._of(result)])

    def long_table(self) -> pd.DataFrame:
        """All accuracies as rows of result, home, place, frames, accuracy; `all` is the mean over places."""
        rows = []
        for result, confusions in self.confusion.items():
            for home, confusion in zip(self.homes, confusions, strict=True):
                percent = class_accuracies(confusion)
                for place, frames, value in zip(self.classes, confusion.sum(axis=1), percent, strict=True):
                    rows.append((result, home, place, int(frames), round(float(value), 2)))
                rows.append((result, home, "all", int(confusion.sum()), round(home_accuracy(confusion), 2)))
        return pd.DataFrame(rows, columns=["result", "home", "place", "frames", "accuracy"])
