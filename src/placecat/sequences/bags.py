"""Layout with one folder per home, ``<name>``, which contains one bag per floor.

A bag is a file ``<floor>.bag``, ``<floor>.mcap`` or ``<floor>.db3``, or a folder. The labels of a floor are
in ``<name>/<floor>.csv``, or on a string topic of the bag. If there are none, every frame is unlabelled.
"""

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from placecat.errors import PlacecatError
from placecat.footage.bag_recording import BagRecording
from placecat.footage.bags import STRING, Bag, is_bag
from placecat.sequences.base import Home
from placecat.sequences.folders import by_name, frame_rate, home_folder
from placecat.sequences.labels import Labels, find_labels, label_csv
from placecat.sequences.recorded import Part, home_of


def read_home(
    root: Path,
    name: str,
    *,
    fps: float | None = None,
    camera: str = "",
    topic: str | None = None,
    labels_topic: str | None = None,
) -> Home:
    """Read one home, with one sequence per bag; see `placecat.sequences.open_home`.

    Parameters
    ----------
    fps
        Frames per second, or None to use the timestamps of the images.
    topic
        Image topic, or None to use the only one in each bag.
    labels_topic
        Topic of the labels (std_msgs/String), or None to use the label files. Each frame gets the last label
        received before it, and frames before the first label are unlabelled.
    """
    folder = home_folder(root, name)
    bags = _bags(folder)
    if not bags:
        raise PlacecatError(f"{folder} contains no bag; correct dataset.homes or dataset.root.")
    rate = None if fps is None else frame_rate(fps, name)

    def floors() -> Iterator[Part]:
        for floor, path in bags.items():
            recording = BagRecording(path, topic, rate, settings="dataset.")
            label_file = f"{name}/{floor}.csv"
            if labels_topic is None:
                labels = find_labels(root, [label_file], recording.timing, "the bag")
            elif file := label_csv(root, label_file):
                raise PlacecatError(
                    f"{root / file} and dataset.labels_topic label the same frames; remove one of them."
                )
            else:
                labels = _labels_on_topic(recording, labels_topic)
            yield floor, recording, recording.timing, labels

    return home_of(name, root, camera, floors(), "bag")


def _bags(folder: Path) -> dict[str, Path]:
    """Map the floors to their bags, in natural order."""
    return by_name(path for path in folder.iterdir() if not path.name.startswith(".") and is_bag(path))


def _labels_on_topic(recording: BagRecording, topic: str) -> Labels:
    """Match labels to frames by reception time, because string messages have no timestamps."""
    bag = Bag(recording.path)
    bag.require(topic, (STRING,), "dataset.labels_topic")
    times, labels = zip(*bag.strings(topic), strict=True)
    last = np.searchsorted(np.array(times, np.int64), recording.received, side="right")
    names = ["" if index == 0 else labels[index - 1].strip() for index in last]
    return Labels(names, np.zeros(len(names), np.int32), None)
