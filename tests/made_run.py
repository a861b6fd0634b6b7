"""A small finished run on disk, with three homes of drawn frames, a codebook and artificial distributions."""

from pathlib import Path

import cv2
import numpy as np
import pandas as pd

from placecat import files, paths, settings
from placecat.cues.codebook import Codebook
from placecat.training import fold_file, protocol, store
from placecat.vision.attention import compute_maps, find_regions
from placecat.vision.information import information
from placecat.vision.local import hog

ROOT = Path(__file__).parents[1]
HOMES = ("flat_1", "flat_2", "flat_3")
CLASSES = ("bedroom", "sauna")
WIDTH, HEIGHT, FRAMES, CLUSTERS = 320, 180, 8, 16
LABELS = np.array([0, 0, 0, 0, 1, 1, 1, -1], np.int16)
CUES = ("hog_y", "sift_y", "centrist_y", "gist", "spatial_pact")
# The frame with the most information, frames with little or none, and frames that all cues get wrong.
RICHEST, POOR, BLANK = ("flat_2", 5), ("flat_1", 6), ("flat_3", 2)
WRONG = {("flat_1", 1), ("flat_3", 4), BLANK}


def parameters():
    """Return the project's settings, reduced to the drawn homes."""
    params = settings.load(ROOT / "params.yaml")
    params["figures"] = settings.load(ROOT / "conf/figures/figures.yaml")
    params["dataset"] |= {"name": "drawn", "root": "frames", "homes": list(HOMES), "classes": list(CLASSES)}
    params["codebooks"]["hog_y"]["tree"]["max_clusters"] = CLUSTERS
    params["cues"]["hog_y"]["classifier"]["clusters"] = CLUSTERS
    return params


def draw(home, index):
    """Draw a frame with coloured boxes on a wall; more boxes contain more information."""
    rng = np.random.default_rng([HOMES.index(home), index])
    image = np.full((HEIGHT, WIDTH, 3), 150, np.uint8)
    count = {RICHEST: 60, POOR: 3, BLANK: 0}.get((home, index), 25)
    for _ in range(count):
        x, y = rng.integers(WIDTH), rng.integers(HEIGHT)
        w, h = rng.integers(8, 30, 2)
        color = rng.integers(0, 256, 3).tolist()
        cv2.rectangle(image, (int(x), int(y)), (int(x + w), int(y + h)), color, -1)
    return image


def build(folder, params):
    """Write the run; `folder` must be the current folder."""
    for home in HOMES:
        images = [draw(home, index) for index in range(FRAMES)]
        _write_sequence(folder, home, images)
        _write_features(home, images, params)
        _write_cues(home)
    for home in HOMES:
        _write_codebook(home, params)


def _write_sequence(folder, home, images):
    (folder / "frames" / home).mkdir(parents=True)
    for index, image in enumerate(images):
        cv2.imwrite(str(folder / "frames" / home / f"{index}.png"), image)
    frames = pd.DataFrame({"sequence": ["1"] * 5 + ["2"] * 3, "number": [1, 2, 3, 4, 5, 1, 2, 3]})
    frames["source"] = [f"{home}/{index}.png" for index in range(FRAMES)]
    frames["position"] = -1
    frames["seconds"] = 0.2 * (frames["number"] - 1)
    files.write_csv(paths.sequences(home) / "frames.csv", frames)
    names = [CLASSES[label] if label >= 0 else "" for label in LABELS]
    files.write_csv(paths.sequences(home) / "labels.csv", pd.DataFrame({"label": names, "class": LABELS}))
    facts = {"fps": 5.0, "camera": "drawn", "width": WIDTH, "height": HEIGHT}
    files.write_json(paths.sequences(home) / "home.json", facts)


def _write_features(home, images, params):
    most = params["regions"]["max_regions"]
    count, regions, described, measure = [], np.zeros((FRAMES, most, 4), np.float32), [], []
    for index, image in enumerate(images):
        maps = compute_maps(image, **params["attention"])
        found = find_regions(maps, **params["regions"])
        count.append(len(found))
        regions[index, : len(found)] = found
        rows = np.zeros((most, 128), np.float32)
        rows[: len(found)] = hog.describe(maps, found)
        described.append(rows)
        measure.append(information(maps, **params["information"]))
    folder = paths.features(home)
    files.write_array(folder / "count.npy", np.array(count, np.int16))
    files.write_array(folder / "regions.npy", regions)
    files.write_array(folder / "local_hog.npy", np.stack(described))
    files.write_array(folder / "information.npy", np.array(measure, np.float32))
    files.write_json(folder / "descriptors.json", {"hog": "hog"})


def proba(home, cue):
    """Return the (FRAMES, 2) distributions of a cue, which are wrong only in the frames `WRONG`."""
    sure = {("flat_1", 1): 0.9, ("flat_3", 4): 0.8, BLANK: 0.99}
    rows = []
    for index, label in enumerate(LABELS):
        wrong = (home, index) in WRONG
        # The distributions of some cues are nearly uniform.
        most = (
            sure.get((home, index), 0.7) if CUES.index(cue) < 3 else 0.5 + sure.get((home, index), 0.7) / 100
        )
        decision = 1 - max(label, 0) if wrong else max(label, 0)
        rows.append([most, 1 - most] if decision == 0 else [1 - most, most])
    return np.array(rows)


def _write_cues(home):
    for cue in CUES:
        seed = paths.NO_SEED if cue in ("gist", "spatial_pact") else paths.seed_name(0)
        fold_file.write(fold_file.path_of(paths.CUES / cue / "5-5-1", home, seed), {"test": proba(home, cue)})


def _write_codebook(test, params):
    own = params["codebooks"]["hog_y"]
    rows = protocol.select_frames(LABELS, **params["protocol"]["cue_frames"])
    train = store.read_training(
        own["descriptor"], dict.fromkeys((home for home in HOMES if home != test), rows)
    )
    codebook = Codebook.fit(train, cells=1, seed=0, tree=own["tree"])
    path = paths.codebook("hog_y", f"without-{test}", 0)
    files.write_arrays(path, codebook.to_arrays())
