"""Read what the figures need from a finished run: frames, maps, features, codebooks and distributions."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat import files, paths, settings
from placecat.cues.codebook import Codebook
from placecat.cues.descriptors import Descriptors
from placecat.errors import PlacecatError, SettingError
from placecat.footage.frames import read_frames
from placecat.results.collect import read_results
from placecat.results.measured import Results
from placecat.results.sources import Source, sources
from placecat.sequences import listing
from placecat.training import protocol, store
from placecat.vision.attention import compute_maps
from placecat.vision.discovery import settings_of
from placecat.vision.maps import FrameMaps
from placecat.vision.saliency import Saliency, saliency

Frame = NDArray[np.uint8]

KEPT_FRAMES = 8


@dataclass(frozen=True)
class TrainingRegions:
    """Salient regions in training frames.

    `x` contains the (n, D) float32 descriptors, and `labels` the (n,) classes of their frames. `home`,
    `frame` and `number` contain (n,) integers: the index of a region's home in `homes`, the index of its
    frame in that home, and its rank in that frame, where 0 is the most salient region.
    """

    x: NDArray[np.float32]
    labels: NDArray[np.int16]
    homes: tuple[str, ...]
    home: NDArray[np.int64]
    frame: NDArray[np.int64]
    number: NDArray[np.int64]


class Run:
    """A finished run, read from the project folder.

    Figures open files only through this class. `params` contains the composed settings. `homes` and `classes`
    are the homes and places of the main data set, in order. Methods raise PlacecatError if data are missing,
    for example because a result was not computed.
    """

    def __init__(self, params: Mapping[str, Any]) -> None:
        self.params = params
        self.homes: tuple[str, ...] = tuple(settings.get(params, "dataset.homes"))
        self.classes: tuple[str, ...] = tuple(settings.get(params, "dataset.classes"))
        self._frames: dict[tuple[str, int], Frame] = {}

    def threshold(self, name: str) -> float:
        """Return an information filter's threshold.

        Raises SettingError if the filter is defined by a share of frames instead.
        """
        value = settings.get(self.params, f"filters.{name}.threshold")
        if value is None:
            raise SettingError(
                f"the filter {name} has no threshold, which the figures need: use another filter"
            )
        return float(value)

    def options(self, figure: str) -> Mapping[str, Any]:
        """Return one figure's settings, ``figures.<figure>``; empty if there are none."""
        return settings.get(self.params, "figures").get(figure) or {}

    @cached_property
    def results(self) -> Results:
        """All measured results."""
        return read_results(self.params)

    @cached_property
    def sources(self) -> dict[str, Source]:
        """The files that contain each result's distributions, by result name."""
        return sources(self.params)

    def source(self, result: str) -> Source:
        """Return the files that contain one result's distributions."""
        if result not in self.sources:
            known = ", ".join(sorted(self.sources)) or "none"
            raise PlacecatError(f"this run has no distributions of {result!r}, only of {known}")
        return self.sources[result]

    def proba(self, result: str, home: str, seed: str | None = None) -> NDArray[np.float64]:
        """Return a result's (frames, classes) distributions for one home.

        `seed` is the name of a seed, e.g. "seed-0"; None means the first one.
        """
        source = self.source(result)
        if home not in source.homes:
            raise PlacecatError(f"{result} has no test home {home!r}, only {', '.join(source.homes)}")
        if seed is None:
            seeds = source.seeds()
            if not seeds:
                raise PlacecatError(f"{result} was not computed: run `dvc repro` to create it")
            seed = seeds[0]
        files.existing(source.file(home, seed))
        return np.asarray(source.array(home, seed), np.float64)

    def labels(self, home: str) -> NDArray[np.int16]:
        """Return a home's (frames,) class indices in temporal order, with -1 for unlabelled frames."""
        return listing.read_labels(home)

    def sequence_slices(self, home: str) -> list[slice]:
        """Return the stretches of a home's frames between cuts."""
        return listing.sequence_slices(home)

    def home_facts(self, home: str) -> Mapping[str, Any]:
        """Return a home's ``fps``, ``camera``, ``width`` and ``height``."""
        return files.read_json(paths.sequences(home) / "home.json")

    def frames(self, home: str, indices: Iterable[int]) -> Iterator[tuple[int, Frame]]:
        """Decode some of a home's frames in one pass.

        `home` is a home in the main data set or in another one, e.g. ``university/north_2_cloudy_2``.
        `indices` start at 0 and may be in any order. Yields each index once, in ascending order, with its
        frame, (H, W, 3) uint8 BGR.
        """
        rows = sorted({int(index) for index in indices})
        files.existing(paths.sequences(home) / "frames.csv")
        table = listing.read_frames(home)
        if rows and not 0 <= rows[0] <= rows[-1] < len(table):
            raise PlacecatError(f"{home} has the frames 0 to {len(table) - 1}, not {rows[0]} to {rows[-1]}")
        facts = self.home_facts(home)
        site = home.rpartition("/")[0]
        root = settings.get(self.params, f"splits.{site}.dataset.root" if site else "dataset.root")
        decoded = read_frames(root, table.iloc[rows], size=(facts["width"], facts["height"]))
        yield from zip(rows, decoded, strict=True)

    def frame(self, home: str, index: int) -> Frame:
        """Return one frame of a home, (H, W, 3) uint8 BGR; do not modify it, because it is cached."""
        key = (home, int(index))
        if key not in self._frames:
            if len(self._frames) >= KEPT_FRAMES:
                self._frames.pop(next(iter(self._frames)))
            self._frames[key] = next(self.frames(home, [index]))[1]
        return self._frames[key]

    def maps(self, home: str, index: int) -> FrameMaps:
        """Return one frame's pyramids and feature maps."""
        return compute_maps(self.frame(home, index), **settings.get(self.params, "attention"))

    def saliency(self, home: str, index: int) -> Saliency:
        """Return one frame's saliency map and its components."""
        known, options = settings_of(saliency), settings.get(self.params, "regions")
        return saliency(self.maps(home, index), **{name: options[name] for name in options if name in known})

    def regions(self, home: str, index: int) -> NDArray[np.float32]:
        """Return one frame's (n, 4) salient regions, most salient first: x, y (pixels), scale, saliency."""
        count = int(self._feature(home, "count")[index])
        return np.array(self._feature(home, "regions")[index, :count])

    def information(self, home: str) -> NDArray[np.float32]:
        """Return the (frames,) information measures of a home (thesis 4.6)."""
        return np.array(self._feature(home, "information"))

    def descriptors(
        self, home: str, name: str, rows: Sequence[int] | NDArray[np.int64] | None = None
    ) -> Descriptors:
        """Return a home's descriptors for a codebook such as ``hog_y``, for the frames `rows` (None: all)."""
        descriptor = settings.get(self.params, f"codebooks.{name}.descriptor")
        return store.read_descriptors(home, descriptor, None if rows is None else np.asarray(rows, np.int64))

    def codebook(self, name: str, test_home: str) -> Codebook:
        """Return the codebook with seed 0 from a test home's 5-5-1 fold."""
        path = paths.codebook(name, protocol.training_set([test_home]), 0)
        return Codebook.from_arrays(files.read_arrays(files.existing(path)))

    def training_frames(self, home: str) -> NDArray[np.int64]:
        """Return the indices of the frames of a home on which cues and codebooks are trained (thesis 4.2)."""
        return protocol.select_frames(self.labels(home), **settings.get(self.params, "protocol.cue_frames"))

    def training_regions(self, codebook: str, test_home: str) -> TrainingRegions:
        """Return the regions on which a codebook such as ``hog_y`` is trained in a test home's 5-5-1 fold."""
        homes, _ = protocol.training_homes(self.homes, "5-5-1", [test_home])
        parts = []
        for position, home in enumerate(homes):
            rows = self.training_frames(home)
            found = self.descriptors(home, codebook, rows)
            of_row, number = np.nonzero(found.valid())
            frame = rows[of_row]
            place = self.labels(home)[frame]
            parts.append((found.rows(), place, np.full(len(frame), position), frame, number))
        x, labels, *rest = (np.concatenate(column) for column in zip(*parts, strict=True))
        return TrainingRegions(x, labels, homes, *rest)

    @cached_property
    def example(self) -> tuple[str, int]:
        """The home and frame shown in Figures 2 to 7, from ``figures.example``.

        By default, the frame is the labelled one with the largest information measure, either in the home
        named in the settings or, if none is named, in any home.
        """
        asked = self.options("example")
        homes = self.homes if asked.get("home") is None else (home_of(self, asked["home"]),)
        if asked.get("frame") is not None:
            home, frame, last = homes[0], asked["frame"], len(self.labels(homes[0])) - 1
            if frame > last:
                raise SettingError(f"figures.example.frame must be 0 to {last}, not {frame}")
            return home, frame
        best: dict[str, tuple[float, int]] = {}
        for home in homes:
            shown = np.where(self.labels(home) >= 0, self.information(home), -np.inf)
            best[home] = float(shown.max()), int(shown.argmax())
        home = max(best, key=lambda name: best[name][0])
        if best[home][0] < 0:
            raise PlacecatError("no frame has a label to serve as the example: set figures.example.frame")
        return home, best[home][1]

    def _feature(self, home: str, name: str) -> NDArray[Any]:
        return files.read_array(files.existing(paths.features(home) / f"{name}.npy"))


def home_of(run: Run, number: int) -> str:
    """Return the n-th home (from 1, as in the thesis), or the last home if there are fewer."""
    return run.homes[min(number, len(run.homes)) - 1]
