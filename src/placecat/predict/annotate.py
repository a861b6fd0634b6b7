"""Draw a frame with its salient regions next to the places and their probabilities."""

from collections.abc import Sequence

import cv2
import numpy as np
from matplotlib.colors import to_rgb
from numpy.typing import NDArray

from placecat.categorizer import Decision
from placecat.drawing import palette
from placecat.drawing.lettering import line_height, mask, write
from placecat.predict.frame import Frame, clock
from placecat.vision.regions import radius

Color = tuple[int, int, int]
LEAST_HEIGHT, MOST_HEIGHT = 480, 540
"""Limits for the frame height, in pixels. Smaller frames are enlarged to keep the text readable, and larger
ones are reduced to save space."""
_PAPER, _INK, _GREY, _LIGHT = (255, 255, 255), (34, 34, 34), (120, 120, 120), (232, 232, 232)
_RIM, _REGION = (30, 30, 30), (120, 235, 255)


class Annotator:
    """Draws frames that are all the same size.

    The parameter `size` is the (width, height) of the frames. The attribute `size` is the (width, height) of
    the resulting images, both even because video encoders require it.
    """

    def __init__(self, classes: Sequence[str], size: tuple[int, int]) -> None:
        self._classes = classes
        self._colors: dict[str, Color] = {
            name: _bgr(color) for name, color in palette.place_colors(classes).items()
        }
        height = min(max(size[1], LEAST_HEIGHT), MOST_HEIGHT)
        self._times = height / size[1]
        width = round(size[0] * self._times)
        self._method = cv2.INTER_AREA if self._times < 1 else cv2.INTER_LINEAR
        self._unit = max(12, round(height / 26))
        self._width, self._height = width, height
        total = width + round(15.5 * self._unit)
        self._left, self._right = width + self._unit, total - self._unit
        self.size = (total + total % 2, height + height % 2)

    def __call__(self, frame: Frame, decision: Decision, label: str | None = None) -> NDArray[np.uint8]:
        """Draw a frame, with its true place if known, and return the (h, w, 3) uint8 BGR image."""
        picture = np.full((self.size[1], self.size[0], 3), 255, np.uint8)
        image = cv2.resize(frame.image, (self._width, self._height), interpolation=self._method)
        self._regions(image, decision.regions)  # type: ignore[arg-type]
        picture[: self._height, : self._width] = image
        self._decision(picture, decision, label)
        self._places(picture, decision)
        self._time(picture, frame)
        return picture

    def _regions(self, image: NDArray[np.uint8], regions: NDArray[np.float32]) -> None:
        """Draw a circle around each region, with stronger regions on top."""
        line = max(2, round(self._height / 360))
        sizes = radius(regions[:, 2], self._width)
        for (x, y, *_), size in zip(regions[::-1], np.atleast_1d(sizes)[::-1], strict=True):
            # OpenCV interprets these coordinates as sixteenths of a pixel.
            centre = (round((float(x) + 0.5) * self._times * 16), round((float(y) + 0.5) * self._times * 16))
            for color, thickness in ((_RIM, line + 2), (_REGION, line)):
                cv2.circle(image, centre, round(float(size) * 16), color, thickness, cv2.LINE_AA, 4)

    def _decision(self, picture: NDArray[np.uint8], decision: Decision, label: str | None) -> None:
        """Draw the place and its colour, the confidence as a number and a bar, and the label."""
        unit, left, right = self._unit, self._left, self._right
        top = unit
        corner, swatch = (left, top + unit // 4), round(1.1 * unit)
        opposite = (corner[0] + swatch, corner[1] + swatch)
        cv2.rectangle(picture, corner, opposite, self._colors[decision.place], cv2.FILLED)
        # A question mark means that the place is unknown.
        name = palette.place_title(decision.place) + ("" if decision.is_known else "?")
        x = left + round(1.6 * unit)
        write(picture, name, (x, top), _fitting(name, round(1.3 * unit), right - x), _INK, bold=True)
        top += round(2.2 * unit)
        write(picture, "confidence", (left, top), unit, _GREY)
        write(picture, f"{decision.confidence:.0%}", (right, top), unit, _INK, align="right")
        top += round(1.5 * unit)
        _bar(picture, (left, top, right, top + round(0.6 * unit)), decision.confidence, _INK)
        if label is not None:
            text = f"label: {palette.place_title(label)}" if label else "no label"
            write(picture, text, (left, top + unit), _fitting(text, unit, right - left), _GREY)

    def _places(self, picture: NDArray[np.uint8], decision: Decision) -> None:
        """Draw a bar for each place's probability, and a thin bar below it for this frame alone."""
        unit, left, right = self._unit, self._left, self._right
        top, bottom = round(7.9 * unit), self._height - round(4.2 * unit)
        row = min(round(3.0 * unit), (bottom - top) // max(1, len(self._classes)))
        size = min(unit, max(8, round(0.45 * row)))
        thick, thin = max(2, round(0.3 * row)), max(1, round(0.09 * row))
        for number, name in enumerate(self._classes):
            y = top + number * row
            bold, share = name == decision.place, float(decision.proba[number])
            # Long names are cut off where the number begins.
            uncovered = picture[:, : right - 3 * size]
            write(uncovered, palette.place_title(name), (left, y), size, _INK, bold=bold)
            write(picture, f"{share:.0%}", (right, y), size, _INK, align="right", bold=bold)
            y += line_height(size)
            _bar(picture, (left, y, right, y + thick), share, self._colors[name])
            y += thick + max(1, thin // 2)
            _bar(picture, (left, y, right, y + thin), float(decision.integrated[number]), _GREY)

    def _time(self, picture: NDArray[np.uint8], frame: Frame) -> None:
        size, left = round(0.8 * self._unit), self._left
        top = self._height - round(3.4 * self._unit)
        write(picture, "thin bars: this frame alone", (left, top), size, _GREY)
        text = f"{clock(frame.seconds)}   frame {frame.number}"
        write(picture, text, (left, top + round(1.5 * self._unit)), size, _GREY)


def _fitting(text: str, size: int, width: int) -> int:
    """Return the largest font size from 6 to `size` at which the text fits within `width` pixels."""
    return max(6, min(size, size * width // max(1, mask(text, size, bold=True).shape[1])))


def _bar(picture: NDArray[np.uint8], box: tuple[int, int, int, int], share: float, color: Color) -> None:
    """Draw a bar in `box` (left, top, right, bottom) and fill a fraction `share` of it."""
    left, top, right, bottom = box
    picture[top:bottom, left:right] = _LIGHT
    picture[top:bottom, left : left + round(share * (right - left))] = color


def _bgr(color: str) -> Color:
    red, green, blue = (round(255 * value) for value in to_rgb(color))
    return blue, green, red
