"""Reduce a home's video to a folder with every n-th frame and its label."""

from pathlib import Path

import cv2
import pandas as pd

from placecat.footage.recording import Recording
from placecat.sequences.labels import FRAME_HEADER, read_label_csv


def thin(root: Path, home: str, every: int, target: Path) -> float:
    """Write every `every`-th frame of a home, beginning with the first, in the layout `folder`.

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
        if (picture.number - 1) % every == 0:
            cv2.imwrite(str(folder / f"{picture.number:06}.jpg"), picture.image())
            rows.append((len(rows) + 1, len(rows) + 1, labels[picture.number - 1]))
    pd.DataFrame(rows, columns=FRAME_HEADER).to_csv(target / f"{home}.csv", index=False)
    return timing.fps / every
