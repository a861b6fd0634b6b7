"""Crop and scale frames to a size that the model was trained on."""

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError

Size = tuple[int, int]
LEAST = 0.5
"""Smallest share of a frame that may remain after cropping. A tighter crop would change the view too much."""


@dataclass(frozen=True)
class Fit:
    """How to crop and scale frames: the (width, height) of the footage, the centre crop and the result."""

    source: Size
    kept: Size
    target: Size

    def __call__(self, frame: NDArray[np.uint8]) -> NDArray[np.uint8]:
        """Crop and scale an (H, W, 3) uint8 frame to the size `target`.

        If the size of a frame differs from `source`, for example because a phone was rotated, the frame is
        cropped around its centre to the aspect ratio of `target`. A frame that already has the size `target`
        is returned unchanged.
        """
        size = (frame.shape[1], frame.shape[0])
        if size != self.source:
            return Fit(size, _middle(size, self.target), self.target)(frame)
        if self.source == self.target:
            return frame
        left, top = ((have - keep) // 2 for have, keep in zip(self.source, self.kept, strict=True))
        middle = frame[top : top + self.kept[1], left : left + self.kept[0]]
        # INTER_AREA averages pixels when shrinking a frame, but repeats them when enlarging one.
        method = cv2.INTER_AREA if self.target[0] <= self.kept[0] else cv2.INTER_LINEAR
        return cv2.resize(middle, self.target, interpolation=method)  # type: ignore[return-value]

    def __str__(self) -> str:
        cut = "" if self.kept == self.source else f" (cropped to the middle {_text(self.kept)})"
        return f"{_text(self.source)}{cut} is scaled to {_text(self.target)}"


def fit(source: Size, known: Sequence[Size], *, resize: bool) -> Fit:
    """Choose how to crop and scale footage to one of the model's frame sizes.

    `source` is the size of the footage, and `known` lists the sizes the model was trained on. With `resize`,
    frames of other sizes are scaled, and are cropped around the centre if their aspect ratio differs. The
    target is the size that keeps the largest part of the frame. Ties go to the size that needs the
    least scaling. Raises PlacecatError if the size is not in `known` and `resize` is false, or if less than
    half of the frame would remain.
    """
    if source in known:
        return Fit(source, source, source)
    sizes = " or ".join(_text(size) for size in known)
    if not resize:
        raise PlacecatError(
            f"the footage is {_text(source)} pixels, but the model was trained on {sizes}: add --resize to "
            "scale it, or train on footage of this size"
        )
    fits = [Fit(source, _middle(source, size), size) for size in known]
    best = max(fits, key=lambda one: (_share(one), -abs(np.log(_area(one.target) / _area(one.kept)))))
    if _share(best) < LEAST:
        raise PlacecatError(
            f"the footage is {_text(source)} pixels: cropping it to the aspect ratio of the model's frames, "
            f"{_text(best.target)}, would leave only {_share(best):.0%} of it; film in that format, or train "
            "a model on such frames"
        )
    return best


def _middle(source: Size, target: Size) -> Size:
    """Return the size of the largest crop with the aspect ratio of `target`.

    If neither side would shrink by more than 1%, returns `source` itself.
    """
    width = min(source[0], round(source[1] * target[0] / target[1]))
    height = min(source[1], round(source[0] * target[1] / target[0]))
    if width >= 0.99 * source[0] and height >= 0.99 * source[1]:
        return source
    return max(1, width), max(1, height)


def _share(one: Fit) -> float:
    return _area(one.kept) / _area(one.source)


def _area(size: Size) -> int:
    return size[0] * size[1]


def _text(size: Size) -> str:
    return f"{size[0]}x{size[1]}"
