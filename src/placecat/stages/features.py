"""Stage `features`: compute all descriptors in one pass over the frames of each home."""

from collections.abc import Collection, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from placecat import files, paths, settings
from placecat.compute import parallel
from placecat.footage.frames import read_frames
from placecat.runs import items
from placecat.sequences import listing
from placecat.stages import run
from placecat.vision.frame import describe_frame
from placecat.vision.memory import keep_freed_memory


def main() -> None:
    """Describe all frames of every home."""
    params = settings.load()
    root = Path(settings.get(params, "dataset.root"))
    options = feature_options(params, settings.get(params, "descriptors"))
    variants = settings.get(params, "region_variants")
    wanted = {home: inputs(home, [options, variants]) for home in settings.get(params, "dataset.homes")}
    items.refresh_together(
        "features", paths.FEATURES, wanted, describe, lambda home: plan(home, root, options, variants)
    )


def inputs(home: str, read: Any) -> items.Inputs:
    """Return the inputs for the features of a home: settings, frame list and checksums of source files."""
    listed = paths.sequences(home)
    return items.Inputs(read, (listed / "frames.csv", listed / "sources.csv", listed / "home.json"))


def feature_options(params: Mapping[str, Any], descriptors: Mapping[str, Any]) -> dict[str, Any]:
    """Collect the settings that :func:`placecat.vision.frame.describe_frame` needs.

    `descriptors` maps ``local`` and ``holistic`` to the descriptors to compute and their settings.
    """
    sections = ("attention", "regions", "information")
    return {name: settings.get(params, name) for name in sections} | dict(descriptors)


def plan(
    home: str, root: Path, options: Mapping[str, Any], variants: Mapping[str, Any] | None = None
) -> items.Work:
    """Plan the tasks for :func:`describe` that cover all frames of a home.

    `home` is the same as in :func:`placecat.paths.features`, `root` is the folder of the data set, and
    `options` come from :func:`feature_options`. `variants` contains variants of the salient regions, and the
    frames to describe with them, as in conf/region_variants.
    """
    frames = listing.read_frames(home)
    also, rows = {}, np.arange(0)
    if variants is not None:
        also = {
            name: variant | {"descriptors": variants["descriptors"]}
            for name, variant in variants["variants"].items()
        }
        rows = np.arange(variants["frames"]["offset"], len(frames), variants["frames"]["step"])
    # Reaching a part of a video requires decoding all frames before it, so use few parts.
    is_video = bool((frames["position"] >= 0).any())
    chunk = max(32, -(-len(frames) // (4 * parallel.workers()))) if is_video else 32
    size, varied = listing.frame_size(home), set(rows.tolist())
    tasks = [
        (root, size, frames.iloc[start : start + chunk], options, also, varied)
        for start in range(0, len(frames), chunk)
    ]

    def write(folder: Path, parts: Sequence[Mapping[str, np.ndarray]]) -> None:
        modules = {name: descriptor.get("descriptor", name) for name, descriptor in options["local"].items()}
        files.write_json(folder / "descriptors.json", modules)
        for name in also:
            files.write_json(folder / paths.VARIANT.format(name) / "descriptors.json", modules)
            files.write_array(folder / paths.VARIANT.format(name) / paths.VARIANT_FRAMES, rows)
        for name in _names(parts):
            array = np.concatenate([part[name] for part in parts if name in part])
            files.write_array(folder / f"{name}.npy", array)

    return tasks, write


def describe_home(home: str, root: Path, options: Mapping[str, Any], folder: Path) -> None:
    """Write the descriptors of all frames of a home to a folder; see :func:`plan` for the parameters."""
    tasks, write = plan(home, root, options)
    write(folder, parallel.in_parallel(describe, tasks, f"features of {home}"))


def describe(
    root: Path,
    size: tuple[int, int],
    frames: pd.DataFrame,
    options: Mapping[str, Any],
    variants: Mapping[str, Any],
    rows: Collection[int],
) -> dict[str, np.ndarray]:
    """Describe some frames of a home; those in `rows` are also described with each region variant.

    The first axis of each array is the frame. Arrays for variants contain only the frames in `rows`.
    """
    keep_freed_memory()
    more = {**options, "variants": variants}
    images = zip(frames.index, read_frames(root, frames, size=size), strict=True)
    described = [describe_frame(image, more if row in rows else options) for row, image in images]
    return {name: np.stack([one[name] for one in described if name in one]) for name in _names(described)}


def _names(described: Sequence[Mapping[str, np.ndarray]]) -> list[str]:
    """Return the names of all arrays in order; some parts have no arrays for variants."""
    return list(dict.fromkeys(name for one in described for name in one))


if __name__ == "__main__":
    run(main)
