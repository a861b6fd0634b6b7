"""The contact sheet, a single image that shows every place in every home."""

from collections.abc import Iterable, Mapping, Sequence

import cv2
import numpy as np
from numpy.typing import NDArray

Frame = NDArray[np.uint8]


def only(labels: Sequence[str], chosen: Mapping[str, int]) -> list[str]:
    """Keep only one labelled frame for some places.

    Parameters
    ----------
    labels
        Label of each frame.
    chosen
        Maps each such place to the number (from 1) of the frame that keeps its label.

    Returns
    -------
    list of str
        The labels, with "" for all other frames of these places.
    """
    return [
        "" if label in chosen and chosen[label] != number else label
        for number, label in enumerate(labels, start=1)
    ]


def sharpest(frames: Iterable[Frame], labels: Sequence[str], places: Sequence[str]) -> dict[str, Frame]:
    """For each place, choose the frame with the most detail.

    Parameters
    ----------
    frames
        (H, W, 3) uint8 BGR frames, in order.
    labels
        Label of each frame.
    places
        Labels to choose frames for.

    Returns
    -------
    dict
        Maps each place to a copy of its frame; places without a frame are left out.
    """
    best: dict[str, tuple[float, Frame]] = {}
    for frame, label in zip(frames, labels, strict=True):
        if label not in places:
            continue
        grey = cv2.cvtColor(
            cv2.resize(frame, None, fx=0.25, fy=0.25, interpolation=cv2.INTER_AREA), cv2.COLOR_BGR2GRAY
        )
        detail = float(np.abs(cv2.Laplacian(grey, cv2.CV_32F)).mean())
        if label not in best or detail > best[label][0]:
            best[label] = detail, frame.copy()
    return {place: frame for place, (_, frame) in best.items()}


def draw(views: Mapping[str, Mapping[str, Frame]], places: Sequence[str], width: int = 384) -> Frame:
    """Arrange views in a grid, with a row for each home and a column for each place.

    Parameters
    ----------
    views
        Maps each home to its views, which map places to (H, W, 3) uint8 BGR images.
    places
        Places shown in the columns, in order.
    width
        Width of one view in pixels.

    Returns
    -------
    numpy.ndarray
        uint8 BGR. The cell of a place that a home lacks stays white.
    """
    height = round(width * 9 / 16)
    head, margin = 30, 4
    rows = []
    for home, row in views.items():
        cells = []
        for place in places:
            cell = np.full((height, width, 3), 255, np.uint8)
            if place in row:
                cell[:] = cv2.resize(row[place], (width, height), interpolation=cv2.INTER_AREA)
            cells.append(
                cv2.copyMakeBorder(cell, 0, margin, 0, margin, cv2.BORDER_CONSTANT, value=(255,) * 3)
            )
        turned = np.full((head, height + margin, 3), 255, np.uint8)
        _write(turned, home)
        rows.append(cv2.hconcat([cv2.rotate(turned, cv2.ROTATE_90_COUNTERCLOCKWISE), *cells]))
    title = [np.full((head, head, 3), 255, np.uint8)]
    for place in places:
        cell = np.full((head, width + margin, 3), 255, np.uint8)
        _write(cell, place)
        title.append(cell)
    return np.asarray(cv2.vconcat([cv2.hconcat(title), *rows]), np.uint8)


def _write(picture: Frame, name: str) -> None:
    text = name.replace("_", " ")
    (width, height), _ = cv2.getTextSize(text, cv2.FONT_HERSHEY_SIMPLEX, 0.7, 2)
    at = ((picture.shape[1] - width) // 2, (picture.shape[0] + height) // 2)
    cv2.putText(picture, text, at, cv2.FONT_HERSHEY_SIMPLEX, 0.7, (60, 60, 60), 2, cv2.LINE_AA)
