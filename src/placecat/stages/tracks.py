"""Stage `tracks`: track the salient regions in each home and describe them (thesis 4.7)."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from placecat import files, paths, settings
from placecat.footage.frames import read_frames
from placecat.runs import items
from placecat.sequences import listing
from placecat.stages import run
from placecat.vision.frame import describe_frame
from placecat.vision.memory import keep_freed_memory
from placecat.vision.tracking import RegionTracker


def main() -> None:
    """Write the tracked regions in all frames of every home, with their descriptors."""
    params = settings.load()
    wanted = {}
    for home in settings.get(params, "dataset.homes"):
        read = [settings.get(params, name) for name in ("attention", "tracking", "descriptors.local")]
        listed = [paths.sequences(home) / name for name in ("frames.csv", "sources.csv", "home.json")]
        regions = [paths.features(home) / name for name in ("regions.npy", "count.npy")]
        wanted[home] = items.Inputs(read, (*listed, *regions))
    items.refresh_together("tracks", paths.TRACKS, wanted, track, lambda home: plan(home, params))


def plan(home: str, params: Mapping[str, Any]) -> items.Work:
    """Plan the tasks for :func:`track` that cover all frames of one home."""
    tracking = dict(settings.get(params, "tracking"))
    wanted = {name: settings.get(params, f"descriptors.local.{name}") for name in tracking.pop("descriptors")}
    options = {
        "attention": settings.get(params, "attention"),
        "regions": {"max_regions": settings.get(params, "tracking.max_regions")},
        "local": wanted,
    }
    root, size = Path(settings.get(params, "dataset.root")), listing.frame_size(home)
    frames, regions = listing.read_frames(home), _found_regions(home, tracking["max_regions"])
    tasks = [
        (root, size, frames.iloc[part], regions[part], tracking, options)
        for part in listing.sequence_slices(home)
    ]

    def write(folder: Path, parts: Sequence[Mapping[str, np.ndarray]]) -> None:
        modules = {name: descriptor.get("descriptor", name) for name, descriptor in wanted.items()}
        files.write_json(folder / "descriptors.json", modules)
        for name in parts[0]:
            files.write_array(folder / f"{name}.npy", np.concatenate([part[name] for part in parts]))

    return tasks, write


def _found_regions(home: str, max_regions: int) -> list[np.ndarray]:
    """Return the strongest salient regions of each frame, (n, 4), from the `features` stage."""
    folder = paths.features(home)
    regions = files.read_array(folder / "regions.npy")
    counts = files.read_array(folder / "count.npy")
    return [np.array(rows[: min(count, max_regions)]) for rows, count in zip(regions, counts, strict=True)]


def track(
    root: Path,
    size: tuple[int, int],
    frames: pd.DataFrame,
    found: Sequence[np.ndarray],
    tracking: Mapping[str, Any],
    options: Mapping[str, Any],
) -> dict[str, np.ndarray]:
    """Track and describe the regions in one sequence; the first axis of each array is the frame."""
    keep_freed_memory()
    tracker = RegionTracker(**tracking)
    described = []
    for image, regions in zip(read_frames(root, frames, size=size), found, strict=True):
        described.append(describe_frame(image, options, regions=tracker.step(image, regions)))
    # A frame's information does not depend on the regions; the features already contain it.
    names = [name for name in described[0] if name != "information"]
    return {name: np.stack([one[name] for one in described]) for name in names}


if __name__ == "__main__":
    run(main)
