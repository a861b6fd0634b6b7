"""Stage `features`: one pass over the frames of a home computes every descriptor."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from placecat import files, listing, parallel, paths, settings
from placecat.sequences.base import read_frames
from placecat.stages import run
from placecat.vision.frame import check, describe_frame
from placecat.vision.memory import keep_freed_memory


def main(home: str) -> None:
    """Describe all frames of one home."""
    params = settings.load()
    root = Path(settings.get(params, "dataset.root"))
    describe_home(home, root, feature_options(params, settings.get(params, "descriptors")))


def feature_options(params: Mapping[str, Any], descriptors: Mapping[str, Any]) -> dict[str, Any]:
    """Gather the settings of :func:`placecat.vision.frame.describe_frame`.

    Parameters
    ----------
    params
        All settings.
    descriptors
        ``local`` and ``holistic``: the descriptors to compute, with their settings.
    """
    sections = ("attention", "regions", "information")
    options = {name: settings.get(params, name) for name in sections} | dict(descriptors)
    check(options)
    return options


def describe_home(home: str, root: Path, options: Mapping[str, Any]) -> None:
    """Write the descriptors of all frames of a home.

    Parameters
    ----------
    home
        As for :func:`placecat.paths.features`.
    root
        Folder of the data set.
    options
        From :func:`feature_options`.
    """
    frames = listing.read_frames(home)
    # A video is decoded from its start, so that it is cut into few parts only.
    is_video = bool((frames["position"] >= 0).any())
    chunk = max(32, -(-len(frames) // (4 * parallel.workers()))) if is_video else 32
    facts = files.read_json(paths.sequences(home) / "home.json")
    size = (facts["width"], facts["height"])
    tasks = [
        (root, size, frames.iloc[start : start + chunk], options) for start in range(0, len(frames), chunk)
    ]
    with files.replacing(paths.features(home)) as folder:
        folder.mkdir(parents=True)
        parts = parallel.in_parallel(describe, tasks, f"features of {home}")
        modules = {name: own.get("descriptor", name) for name, own in options["local"].items()}
        files.write_json(folder / "descriptors.json", modules)
        for name in parts[0]:
            files.write_array(folder / f"{name}.npy", np.concatenate([part[name] for part in parts]))


def describe(
    root: Path, size: tuple[int, int], frames: pd.DataFrame, options: Mapping[str, Any]
) -> dict[str, np.ndarray]:
    """Describe some frames of a home: each array's first axis is the frame."""
    keep_freed_memory()
    described = [describe_frame(image, options) for image in read_frames(root, frames, size=size)]
    return {name: np.stack([one[name] for one in described]) for name in described[0]}


if __name__ == "__main__":
    run(main, item="home")
