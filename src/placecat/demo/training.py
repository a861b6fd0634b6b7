"""Training for the demo: thin out the frames, describe them, and train a system, all in one folder."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import cv2
import pandas as pd

from placecat import paths
from placecat.categorizer.system import TrainedSystem
from placecat.categorizer.train import assemble
from placecat.compute import parallel
from placecat.footage.recording import Recording
from placecat.sequences.labels import FRAME_HEADER, read_label_csv
from placecat.sequences.listing import frame_size
from placecat.stages.features import describe, feature_options, plan
from placecat.stages.sequences import list_homes
from placecat.training import plan as plans
from placecat.training import system as systems

# Our choice: these frames are enough to learn from, and the entire demo takes half a minute.
EVERY = 10
SYSTEM, SCHEME, SEED = "das_551_best", "5-5-1", 0
FRAMES = Path("frames")
# The cues learn from every second remaining frame, and the integration learns from the others.
_FRAMES = {"cue_frames": {"offset": 0, "step": 2}, "integration_frames": {"offset": 1, "step": 2}}


def thin_homes(params: Mapping[str, Any], root: Path) -> dict[str, Any]:
    """Write every 10th frame of all homes to the current folder; return the settings for these frames.

    `params` contains all settings; its data set has the layout ``video`` and is in the folder `root`.
    """
    homes = list(params["dataset"]["homes"])
    tasks = [(root, home, FRAMES.absolute()) for home in homes]
    fps = parallel.in_parallel(_thin, tasks, f"every {EVERY}th frame", locally=True)
    dataset = {"layout": "folder", "root": str(FRAMES), "fps": fps[0]}
    return {
        **params,
        "dataset": {**params["dataset"], **dataset},
        "protocol": {**params["protocol"], **_FRAMES},
    }


def _thin(root: Path, home: str, target: Path) -> float:
    """Write every 10th frame of a home, starting with the first, in the layout `folder`.

    Reads ``root/HOME.mp4`` and ``root/HOME.csv``, and writes JPEG files to ``target/HOME`` and their labels
    to ``target/HOME.csv``. Returns the new rate in frames per second. Unreadable files raise PlacecatError.
    """
    recording = Recording(root / f"{home}.mp4")
    timing = recording.timing()
    labels, _ = read_label_csv(root / f"{home}.csv", timing, "the video")
    folder = target / home
    folder.mkdir(parents=True)
    rows: list[tuple[int, int, str]] = []
    for picture in recording.pictures():
        if (picture.number - 1) % EVERY == 0:
            cv2.imwrite(str(folder / f"{picture.number:06}.jpg"), picture.image())
            rows.append((len(rows) + 1, len(rows) + 1, labels[picture.number - 1]))
    pd.DataFrame(rows, columns=FRAME_HEADER).to_csv(target / f"{home}.csv", index=False)
    return timing.fps / EVERY


def train(params: Mapping[str, Any], tested: str) -> TrainedSystem:
    """Train the five-cue system on all homes but `tested`, with the settings from :func:`thin_homes`."""
    system = systems.System.of(params, SYSTEM)
    options = feature_options(params, system.descriptors(params))
    dataset = params["dataset"]
    training = [home for home in dataset["homes"] if home != tested]
    list_homes({**dataset, "homes": training}, paths.SEQUENCES, "dataset")
    # Describe all homes in one loop, so that workers do not wait at the end of each home.
    works = {home: plan(home, FRAMES.absolute(), options) for home in training}
    described = iter(
        parallel.in_parallel(describe, [task for tasks, _ in works.values() for task in tasks], "features")
    )
    for home, (tasks, write) in works.items():
        write(paths.FEATURES / home, [next(described) for _ in tasks])
    (fold,) = plans.of_homes(params, SCHEME, tested)
    trained = systems.train(fold, system, SEED)
    title = f"{params['systems'][SYSTEM]['title']}, with smoothing; every {EVERY}th frame"
    card = {"title": title, "classes": dataset["classes"], "frame_sizes": [frame_size(training[0])]}
    return assemble(params, system, trained, card)
