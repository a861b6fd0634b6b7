"""How far colour, brightness or file size alone tell the rooms of homes that training never saw.

A room should be known by what is in it. Run as a script, this prints a table for a data set of conf/dataset:

    python tests/shortcuts.py homes
"""

import sys
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pandas as pd
import yaml
from numpy.typing import NDArray
from sklearn.discriminant_analysis import LinearDiscriminantAnalysis
from sklearn.ensemble import RandomForestClassifier
from sklearn.neighbors import KNeighborsClassifier, NearestCentroid
from sklearn.pipeline import make_pipeline
from sklearn.preprocessing import StandardScaler
from sklearn.svm import SVC

from mp4 import frame_sizes
from placecat.evaluation.accuracy import confusion_matrix, home_accuracy
from placecat.sequences import open_home, place_labels, read_frames

ROOT = Path(__file__).resolve().parents[1]
EVERY = 3
"""Every third labelled frame is used, as in the thesis."""
AROUND = 25
"""Frames over which the size of the video is also averaged: 5 s at 5 frames a second."""

Shortcuts = dict[str, NDArray[np.float64]]

CLASSIFIERS: dict[str, Callable[[int], Any]] = {
    "nearest centroid": lambda classes: NearestCentroid(),
    "LDA": lambda classes: LinearDiscriminantAnalysis(priors=np.full(classes, 1 / classes)),
    "5 nearest": lambda classes: KNeighborsClassifier(5),
    "25 nearest": lambda classes: KNeighborsClassifier(25),
    "RBF SVM": lambda classes: SVC(class_weight="balanced"),
    "random forest": lambda classes: RandomForestClassifier(
        100, min_samples_leaf=5, class_weight="balanced", random_state=0
    ),
}
"""From the number of classes to an untrained classifier, which takes them for equally likely if it can."""


def data_set(name: str) -> dict[str, Any]:
    """A data set of conf/dataset, with its root made absolute."""
    settings = yaml.safe_load((ROOT / f"conf/dataset/{name}.yaml").read_text())
    return settings | {"root": ROOT / settings["root"]}


def measure(dataset: Mapping[str, Any], every: int = EVERY) -> pd.DataFrame:
    """Accuracy of every classifier on every shortcut, in percent, in each home and in the mean."""
    seen = [_see(dataset, home, every) for home in dataset["homes"]]
    truths = [truth for truth, _ in seen]
    n_classes = len(dataset["classes"])
    rows = {
        (shortcut, name): _leave_one_out([values[shortcut] for _, values in seen], truths, n_classes, make)
        for shortcut in seen[0][1]
        for name, make in CLASSIFIERS.items()
    }
    index = pd.MultiIndex.from_tuples(rows, names=["shortcut", "classifier"])
    table = pd.DataFrame(list(rows.values()), index, columns=list(dataset["homes"]))
    return table.assign(average=table.mean(axis=1))


def _see(dataset: Mapping[str, Any], name: str, every: int) -> tuple[NDArray[np.int16], Shortcuts]:
    """Class and shortcuts of labelled frames of a home."""
    home = open_home(dataset["layout"], dataset["root"], name, fps=dataset["fps"])
    truth = place_labels(home.frames["label"], dataset["classes"], dataset["ignored"], dataset["aliases"])
    used = np.flatnonzero(truth >= 0)[::every]
    frames = read_frames(home.root, home.frames.iloc[used])
    seen = pd.DataFrame([_look(frame) for frame in frames])
    bits = np.log(frame_sizes(home.root / home.frames["source"][0]))
    assert len(bits) == len(home.frames)
    around = pd.Series(bits).rolling(AROUND, center=True, min_periods=1).mean().to_numpy()
    sizes = {"video size of the frame": bits[used], "video size of 5 s": around[used]}
    shortcuts = {name: np.stack(list(column)) for name, column in seen.items()} | sizes
    return truth[used], {name: values.reshape(len(used), -1) for name, values in shortcuts.items()}


def _look(frame: NDArray[np.uint8]) -> dict[str, Any]:
    grey = cv2.cvtColor(frame, cv2.COLOR_BGR2GRAY)
    lab = cv2.cvtColor(frame, cv2.COLOR_BGR2LAB)
    _, jpeg = cv2.imencode(".jpg", frame)
    colour = np.concatenate([frame.mean(axis=(0, 1)), lab.mean(axis=(0, 1))])
    return {"mean colour": colour, "brightness": grey.mean(), "JPEG size": np.log(jpeg.size)}


def _leave_one_out(
    values: list[NDArray[np.float64]],
    truths: list[NDArray[np.int16]],
    n_classes: int,
    make: Callable[[int], Any],
) -> list[float]:
    """Mean accuracy of a home's classes in percent, for each home by a classifier trained on all others."""
    accuracies = []
    for left, (own, truth) in enumerate(zip(values, truths, strict=True)):
        others = [home for home in range(len(values)) if home != left]
        training = np.concatenate([truths[home] for home in others])
        model = make_pipeline(StandardScaler(), make(len(set(training))))
        model.fit(np.concatenate([values[home] for home in others]), training)
        accuracies.append(home_accuracy(confusion_matrix(truth, model.predict(own), n_classes)))
    return accuracies


if __name__ == "__main__":
    shown = measure(data_set(sys.argv[1] if len(sys.argv) > 1 else "homes"))
    print("| " + " | ".join([*shown.index.names, *shown.columns]) + " |")
    print("|" + "---|" * len(shown.index.names) + "---:|" * len(shown.columns))
    for (shortcut, name), row in shown.iterrows():
        print(f"| {shortcut} | {name} | " + " | ".join(f"{value:.1f}" for value in row) + " |")
