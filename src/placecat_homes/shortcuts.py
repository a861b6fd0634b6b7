"""Test how well colour, brightness or file size alone can identify rooms in unseen homes.

Rooms should be recognized by what is in them. ``python -m placecat_homes.shortcuts FOLDER`` prints a table of
accuracies for the homes in a folder.
"""

import argparse
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pandas as pd
from numpy.typing import NDArray
from sklearn.discriminant_analysis import LinearDiscriminantAnalysis
from sklearn.ensemble import RandomForestClassifier
from sklearn.neighbors import KNeighborsClassifier, NearestCentroid
from sklearn.pipeline import make_pipeline
from sklearn.preprocessing import StandardScaler
from sklearn.svm import SVC

from placecat.errors import PlacecatError, exiting
from placecat.evaluation.accuracy import confusion_matrix, home_accuracy
from placecat.sequences import open_home, place_labels, read_frames
from placecat_homes.drawn.rendering import dataset
from placecat_homes.mp4 import frame_sizes

LIMIT = 35
"""Highest accuracy in percent that a shortcut may reach, averaged over homes; chance level is 20."""
EVERY = 3
"""Every third labelled frame is used, as in the thesis."""
AROUND = 25
"""Number of frames over which the video size is averaged for one shortcut: 5 s at 5 frames per second."""

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
"""Functions that create an untrained classifier for a number of classes, weighted equally if possible."""


def measure(dataset: Mapping[str, Any], every: int = EVERY) -> pd.DataFrame:
    """Measure each classifier's accuracy on each shortcut, leaving out one home at a time.

    Parameters
    ----------
    dataset
        Settings as in conf/dataset, with "video" layout, an absolute root and at least two homes.
    every
        Use only every n-th labelled frame.

    Returns
    -------
    pandas.DataFrame
        Accuracies in percent, with a row for each shortcut and classifier, a column for each home, and
        `average`.

    Raises
    ------
    PlacecatError
        If there is only one home.
    """
    if len(dataset["homes"]) < 2:
        raise PlacecatError(f"{dataset['root']}: shortcuts need at least two homes, one of them for testing")
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
    """Return the classes and shortcuts of labelled frames in a home."""
    home = open_home(dataset["layout"], dataset["root"], name, fps=dataset["fps"])
    truth = place_labels(home.frames["label"], dataset["classes"], dataset["ignored"], dataset["aliases"])
    used = np.flatnonzero(truth >= 0)[::every]
    frames = read_frames(home.root, home.frames.iloc[used])
    seen = pd.DataFrame([_look(frame) for frame in frames])
    bits = np.log(frame_sizes(home.root / home.frames["source"][0]))
    if len(bits) != len(home.frames):
        raise PlacecatError(
            f"{home.root}: {home.frames['source'][0]} has {len(bits)} frames, but {len(home.frames)} labels"
        )
    around = pd.Series(bits).rolling(AROUND, center=True, min_periods=1).mean().to_numpy()
    sizes = {"video size of the frame": bits[used], "video size of 5 s": around[used]}
    shortcuts = {name: np.stack(list(column)) for name, column in seen.items()} | sizes
    return truth[used], {str(name): values.reshape(len(used), -1) for name, values in shortcuts.items()}


def _look(frame: NDArray[np.uint8]) -> dict[str, Any]:
    grey = cv2.cvtColor(frame, cv2.COLOR_BGR2GRAY)
    lab = cv2.cvtColor(frame, cv2.COLOR_BGR2LAB)
    _, jpeg = cv2.imencode(".jpg", frame)
    colour = np.concatenate([_mean(frame), _mean(lab)])
    return {"mean colour": colour, "brightness": _mean(grey)[0], "JPEG size": np.log(jpeg.size)}


def _mean(image: NDArray[Any]) -> NDArray[np.float64]:
    """Return the mean of each channel. This is faster than NumPy and just as accurate."""
    channels = 1 if image.ndim == 2 else image.shape[2]
    return np.array(cv2.sumElems(image)[:channels]) / (image.shape[0] * image.shape[1])


def _leave_one_out(
    values: list[NDArray[np.float64]],
    truths: list[NDArray[np.int16]],
    n_classes: int,
    make: Callable[[int], Any],
) -> list[float]:
    """Return, for each home, the mean class accuracy of a classifier trained on the others, in percent."""
    accuracies = []
    for left, (own, truth) in enumerate(zip(values, truths, strict=True)):
        others = [home for home in range(len(values)) if home != left]
        training = np.concatenate([truths[home] for home in others])
        model = make_pipeline(StandardScaler(), make(len(set(training))))
        model.fit(np.concatenate([values[home] for home in others]), training)
        accuracies.append(home_accuracy(confusion_matrix(truth, model.predict(own), n_classes)))
    return accuracies


def report(table: pd.DataFrame) -> str:
    """Format the table of :func:`measure` as Markdown, followed by the best shortcut and the limit."""
    lines = [
        "| " + " | ".join([*map(str, table.index.names), *table.columns]) + " |",
        "|" + "---|" * len(table.index.names) + "---:|" * len(table.columns),
    ]
    for names, row in zip(table.index, table.to_numpy(), strict=True):
        lines.append("| " + " | ".join([*names, *(f"{value:.1f}" for value in row)]) + " |")
    best: Any = table["average"].idxmax()
    return "\n".join(
        [
            *lines,
            "",
            f"Best: {best[1]} on {best[0]}, {table['average'].max():.1f}% (limit {LIMIT}%, chance 20%).",
        ]
    )


def main(arguments: Sequence[str] | None = None) -> None:
    """Test the homes in a folder, and exit with status 1 if any shortcut exceeds `LIMIT`."""
    parser = argparse.ArgumentParser(
        prog="python -m placecat_homes.shortcuts",
        description="Print how well colour, brightness and file size alone identify rooms in unseen homes.",
    )
    parser.add_argument("folder", type=Path, help="folder of videos with labels, laid out like data/homes")
    folder = parser.parse_args(arguments).folder
    with exiting():
        table = measure(dataset(folder))
        print(report(table))
        if table["average"].max() > LIMIT:
            raise PlacecatError(f"a shortcut reaches more than {LIMIT}% in {folder}")


if __name__ == "__main__":
    main()
