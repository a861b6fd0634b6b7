"""Use a home from a data set as footage, with all its floors and labels."""

from collections.abc import Collection, Iterator, Mapping, Sequence
from typing import Any

import numpy as np
import yaml
from numpy.typing import NDArray

from placecat import settings
from placecat.errors import PlacecatError
from placecat.footage.frames import read_frames
from placecat.footage.timing import Timing
from placecat.predict.frame import Damage, Frame, Source
from placecat.sequences import open_home_of, place_labels

PREFIX = "home:"
"""Prefix that marks a source as a home from a data set. The name of the home follows it."""


class DataSetHome(Source):
    """The frames of a home, floor by floor.

    The system restarts at each floor and at any other cut. Times continue from the previous floor. `name` is
    the name of the home. `dataset` contains the settings of its data set, from a file in conf/dataset. `fps`,
    in frames per second, overrides the frame rate of the data set. Raises PlacecatError if the home is
    unknown or cannot be read.
    """

    timing: Timing

    def __init__(self, name: str, dataset: Mapping[str, Any], fps: float | None) -> None:
        if not name:
            raise PlacecatError(
                f"{PREFIX} needs the name of a home: use one of {', '.join(dataset['homes'])}"
            )
        if name not in dataset["homes"]:
            raise PlacecatError(
                f"{PREFIX}{name}: {dataset['title']} has no such home: use one of "
                f"{', '.join(dataset['homes'])}, or choose other data with "
                "--set dataset=... --set dataset.root=PATH"
            )
        self._home = home = open_home_of(dataset, name, **{} if fps is None else {"fps": fps})
        self._dataset = dataset
        self.name = name
        self.title = str(dataset["title"])
        self.fps = home.fps
        self.size = (home.width, home.height)
        floors = home.frames["sequence"].to_numpy()
        self._begins = np.append(True, floors[1:] != floors[:-1])
        seconds = home.frames["seconds"].to_numpy(np.float64).copy()
        for first in np.flatnonzero(self._begins)[1:]:
            seconds[first:] += seconds[first - 1] + 1 / home.fps - seconds[first]
        self.timing = Timing(seconds, float(seconds[-1] + 1 / home.fps), home.fps, home.is_even)

    def frames(self, every: int) -> Iterator[Frame]:
        """Decode every `every`-th frame of each floor, starting with the first."""
        place = np.arange(len(self._begins))
        rows = np.flatnonzero((place - np.maximum.accumulate(np.where(self._begins, place, 0))) % every == 0)
        table = self._home.frames.iloc[rows]
        images = read_frames(self._home.root, table, size=self.size)
        for row, source, position, image in zip(
            rows.tolist(), table["source"], table["position"], images, strict=True
        ):
            self.reached = row + 1
            file = source if position < 0 else ""
            seconds = float(self.timing.seconds[row])
            yield Frame(row + 1, seconds, file, image, begins=bool(self._begins[row]))
        self.reached = len(self._begins)

    def damage(self) -> Damage:
        """Return the home's lost and damaged frames."""
        return Damage(self._home.lost, self._home.damaged, self._home.note)

    def truth(self, classes: Sequence[str], ignored: Collection[str]) -> NDArray[np.int16]:
        """Return the true place of each frame, as `Source.truth` does.

        Raises PlacecatError if a label is neither in `classes` nor ignored.
        """
        own = [name for name in self._dataset["classes"] if name not in ignored]
        labels = place_labels(
            self._home.frames["label"],
            own,
            list({*self._dataset["ignored"], *ignored}),
            self._dataset["aliases"],
            home=self._home,
        )
        for number in np.unique(labels[labels >= 0]):
            if own[number] not in classes:
                raise PlacecatError(
                    f"{self.name}: the label {own[number]!r} is not one of the model's places "
                    f"({', '.join(classes)}): exclude such frames from scoring with --ignore {own[number]}"
                )
        numbers = [classes.index(name) if name in classes else -1 for name in own]
        return np.array([*numbers, -1], np.int16)[labels]


def data_set(overrides: Sequence[str]) -> Mapping[str, Any]:
    """Return the settings of the data set from params.yaml or, if there are overrides, from conf/."""
    from placecat.config.check import check
    from placecat.config.compose import compose

    params = yaml.load(compose(overrides), Loader=settings.Loader) if overrides else settings.load()
    dataset: Mapping[str, Any] = settings.get(params, "dataset")
    check({"dataset": dataset})
    return dataset
