"""The files that contain each result's distributions."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat import paths, settings
from placecat.training import fold_file, protocol


@dataclass(frozen=True)
class Source:
    """The files that contain a result's distributions over `classes`.

    There is one file per test home and seed, which contains the array `name`. Test homes are named after
    their folders. `site` is the data set of the test homes, or "" for the main one.
    """

    folder: Path
    name: str
    homes: tuple[str, ...]
    site: str
    classes: tuple[str, ...]

    def seeds(self) -> tuple[str, ...]:
        """Return the names of the seeds that have files."""
        return tuple(fold_file.seeds_in(self.folder, self.homes[0]))

    def file(self, home: str, seed: str) -> Path:
        """Return the path of the file for one test home and seed."""
        return fold_file.path_of(self.folder, home, seed)

    def array(self, home: str, seed: str) -> NDArray[np.float64]:
        """Read the (frames, classes) distributions for one test home and seed."""
        return fold_file.read(self.file(home, seed), self.name)

    def listed(self, home: str) -> str:
        """Return the name that `placecat.sequences.listing` uses for a test home."""
        return f"{self.site}/{home}" if self.site else home


def sources(params: Mapping[str, Any]) -> dict[str, Source]:
    """Return the files of all results that have distributions under the given settings, by result name.

    Examples of names are ``cues/gist/5-5-1``, ``tempered/gist``, ``integration/das_551_all``, ``hmm/...`` and
    ``smoothing/...`` (before and after the delay), ``filtered/informative/gist`` and
    ``splits/university/cues/gist``.
    """
    homes = protocol.tested_homes(
        settings.get(params, "dataset.homes"), settings.get(params, "protocol.test_homes")
    )
    classes = tuple(settings.get(params, "dataset.classes"))
    found: dict[str, Source] = {}

    def add(name: str, folder: Path, array: str) -> None:
        found[name] = Source(folder, array, homes, "", classes)

    for cue, options in settings.get(params, "cues").items():
        for scheme in options["schemes"]:
            add(f"cues/{cue}/{scheme}", paths.CUES / cue / scheme, "test")
        if options["cross_validate"]:
            scheme = options["schemes"][0]
            add(f"tempered/{cue}", paths.CUES / cue / scheme, "tempered")
    systems = settings.get(params, "systems")
    for system in systems:
        add(f"integration/{system}", paths.INTEGRATION / system, "test")
    for name, options in settings.get(params, "filters").items():
        for result in [*options["cues"], *options["systems"]]:
            add(f"filtered/{name}/{result}", paths.FILTERED / name / result, "test")
    smoothing = settings.get(params, "smoothing")
    for name in [*systems, *smoothing["cues"], *smoothing["filtered"]]:
        add(f"hmm/{name}", paths.SMOOTHING / name, "hmm")
        add(f"smoothing/{name}", paths.SMOOTHING / name, "delayed")
    for name, split in settings.get(params, "splits").items():
        found |= _of_split(name, split)
    return found


def _of_split(name: str, split: Mapping[str, Any]) -> dict[str, Source]:
    tests, places = tuple(split["test"]), tuple(split["dataset"]["classes"])
    root = paths.SPLITS / name
    found = {}
    for cue in dict.fromkeys(cue for system in split["systems"].values() for cue in system):
        found[f"splits/{name}/cues/{cue}"] = Source(root / "cues" / cue, "test", tests, name, places)
    arrays = {"integration": "test", "hmm": "hmm", "smoothing": "delayed"}
    for system in split["systems"]:
        folder = root / "systems" / system
        for kind, array in arrays.items():
            found[f"splits/{name}/{kind}/{system}"] = Source(folder, array, tests, name, places)
    return found
