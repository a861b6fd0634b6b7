"""Build a project folder of a given size, with params.yaml, data/sequences, data/features and data/tracks."""

import shutil
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from placecat import files, paths, settings
from placecat.compute import parallel
from placecat.config import compose
from placecat.errors import PlacecatError
from placecat.runs import linked_folder
from placecat.sequences import listing
from placecat_bench.scale import drawing
from placecat_bench.scale.database import Home, Stretch, classes_of

# Other inputs of the stages, to which the folder contains links.
LINKED = (
    paths.CONF,
    paths.SITE_SEQUENCES,
    paths.SITE_FEATURES,
    paths.SPLITS,
    paths.TOY,
    paths.PUBLISHED.parent,
)


def build(
    folder: Path, homes: Sequence[Home], *, test_homes: Sequence[str], regions: int, jitter: float
) -> dict[str, Any]:
    """Replace a folder with a project that has these homes, and return the project's settings.

    `test_homes` lists names of homes, `regions` is the number of regions in every frame, and `jitter` is
    passed to :func:`placecat_bench.scale.drawing.write_jittered`. Raises PlacecatError if this project has
    not been run, or if a home has a label that is not in the data set.
    """
    params = settings.load()
    sources = list(settings.get(params, "dataset.homes"))
    for path in [*LINKED, *(made / home for home in sources for made in (paths.FEATURES, paths.TRACKS))]:
        if not path.exists():
            raise PlacecatError(f"{path} is missing: run `make repro` first, to create the source features")
    if folder.exists():
        shutil.rmtree(folder)
    (folder / paths.DATA).mkdir(parents=True)
    own = _write_params(folder, homes, test_homes)
    linked_folder.link(folder, LINKED)
    tasks = []
    for number, home in enumerate(homes):
        source, walk = sources[number % len(sources)], home.walk()
        tasks += _plan(folder, home.name, source, walk, own, regions, jitter)
    parallel.in_parallel(
        drawing.write_jittered,
        tasks,
        f"features of {sum(home.frames for home in homes)} frames",
        locally=True,
    )
    return own


def _write_params(folder: Path, homes: Sequence[Home], test_homes: Sequence[str]) -> dict[str, Any]:
    """Write this project's settings with different homes and without thesis data, and return them."""
    overrides = [
        f"dataset.homes=[{','.join(home.name for home in homes)}]",
        "dataset.name=scale",
        "dataset.title='features drawn from others'",
        "dataset.thesis_data=null",
        "dataset.root=nowhere",
        f"protocol.test_homes=[{','.join(test_homes)}]",
    ]
    files.write_text(folder / paths.PARAMS, compose.compose(overrides))
    return settings.load(folder / paths.PARAMS)


def _plan(
    folder: Path,
    home: str,
    source: str,
    walk: Sequence[Stretch],
    params: Mapping[str, Any],
    regions: int,
    jitter: float,
) -> list[tuple[Any, ...]]:
    """Write the small files of a home, and return the tasks that write its large arrays."""
    dataset, frames = params["dataset"], params["region_variants"]["frames"]
    index = classes_of(walk, dataset["classes"], dataset["ignored"])
    _write_sequences(folder / paths.SEQUENCES / home, walk, index, paths.SEQUENCES / source)
    labels = files.read_table(paths.SEQUENCES / source / "labels.csv", ["label"])["label"].tolist()
    classes = listing.read_labels(source).astype(np.int64)
    chosen = drawing.draw_frames(walk, labels, classes, index, home)
    tasks = []
    for kind in (paths.FEATURES, paths.TRACKS):
        tasks += _plan_arrays(kind / source, folder / kind / home, chosen, classes, regions, jitter, home)
    for variant in sorted((paths.FEATURES / source).glob(paths.VARIANT.format("*"))):
        target = folder / paths.FEATURES / home / variant.name
        there = files.read_array(variant / paths.VARIANT_FRAMES, memory_map=False)
        rows = np.arange(frames["offset"], len(chosen), frames["step"])
        files.write_array(target / paths.VARIANT_FRAMES, rows)
        # Use the last source frame that has the variant and does not come after the drawn frame.
        own = np.maximum(np.searchsorted(there, chosen[rows], side="right") - 1, 0)
        most = files.read_array(variant / f"{drawing.REGIONS}.npy").shape[1]
        tasks += _plan_arrays(variant, target, own, classes[there], most, jitter, home)
    return tasks


def _plan_arrays(
    source: Path,
    target: Path,
    chosen: NDArray[np.int64],
    classes: NDArray[np.int64],
    regions: int,
    jitter: float,
    home: str,
) -> list[tuple[Any, ...]]:
    """Write the small files of a folder, and return the tasks that write its arrays.

    `chosen` contains indices of source rows, and `classes` the class indices of all source rows.
    """
    counts = files.read_array(source / f"{drawing.COUNT}.npy", memory_map=False)
    frame, place = drawing.draw_regions(chosen, counts.astype(np.int64), classes, regions, home)
    files.write_array(target / f"{drawing.COUNT}.npy", np.full(len(chosen), regions, counts.dtype))
    shutil.copy(source / "descriptors.json", target / "descriptors.json")
    tasks = []
    for name in drawing.arrays_in(source):
        file = f"{name}.npy"
        rows = (frame, place) if drawing.has_regions(name) else (chosen, None)
        tasks.append((source / file, target / file, *rows, jitter, home))
    return tasks


def _write_sequences(target: Path, walk: Sequence[Stretch], index: Sequence[int], source: Path) -> None:
    frames = [stretch.frames for stretch in walk]
    floor = np.repeat([stretch.floor for stretch in walk], frames)
    total = len(floor)
    facts = files.read_json(source / "home.json")
    table = pd.DataFrame(
        {
            "sequence": floor,
            "number": np.concatenate([np.arange(1, np.sum(floor == one) + 1) for one in np.unique(floor)]),
            "source": "drawn",
            "position": -1,
            "seconds": np.arange(total) / facts["fps"],
        }
    )
    files.write_csv(target / "frames.csv", table)
    labels = {
        "label": np.repeat([stretch.label for stretch in walk], frames),
        "class": np.repeat(np.asarray(index, np.int64), frames),
    }
    files.write_csv(target / "labels.csv", pd.DataFrame(labels))
    files.write_json(target / "home.json", facts)
