"""A frame of footage."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, eq=False)
class Frame:
    """One frame.

    Attributes
    ----------
    number
        From 1; in a camera's footage, of the frames that were taken.
    seconds
        Since the first frame.
    file
        Name of the image in a folder; "" otherwise.
    image
        (H, W, 3) uint8, BGR.
    """

    number: int
    seconds: float
    file: str
    image: NDArray[np.uint8]
