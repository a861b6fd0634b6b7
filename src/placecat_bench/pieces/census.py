"""Census histograms over a grid of cells, compared with local binary patterns from scikit-image and mahotas.

`local_binary_pattern` with 8 points at radius 1 sets a bit if a neighbour is at least as bright as the
centre. The census transform sets it if the centre is at least as bright as the neighbour. The two agree if
one of them is given the inverted image. `local_binary_pattern` interpolates diagonal neighbours at distance 1
between pixels, so only the codes of the four nearest neighbours are compared. It also computes codes for
border pixels, which are discarded.
"""

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from placecat.vision.census import CODES, cell_histograms, census
from placecat_bench.comparison import Comparison, Limit, Peer
from placecat_bench.frames import REPEATS, Image, prepared, size

PIECE = "Census histograms"
PEER = Peer("scikit-image: local_binary_pattern and NumPy's histogram", "scikit-image")
MAHOTAS = Peer("mahotas: lbp", "mahotas")
# Bits of the right, upper, left and lower neighbours.
OUR_STRAIGHT = (8, 64, 16, 2)
THEIR_STRAIGHT = (1, 4, 16, 64)


def entries(*, images: Sequence[Image] | None = None, cells: int = 4) -> Iterator[Comparison | Limit]:
    """Yield comparisons of run times and histograms, with `cells` cells along each axis.

    `images` are (h, w) uint8 arrays of the same size. By default, they are one frame from each rendered home,
    scaled down to 320x180. One repeat is a pair of calls, each on all images.
    """
    given = reduced_frames() if images is None else images
    text = f"{size(given[0])}, {cells}x{cells} cells"
    codes = [census(image) for image in given]
    yield Comparison(
        PIECE,
        text,
        PEER,
        lambda: [ours(image, cells) for image in given],
        lambda: [theirs(image, cells) for image in given],
        faster=40,
        repeats=REPEATS,
        parts={
            "codes": lambda: [census(image) for image in given],
            "histograms": lambda: [cell_histograms(some, cells) for some in codes],
        },
    )
    yield Comparison(
        PIECE,
        text,
        MAHOTAS,
        lambda: [ours(image, cells) for image in given],
        lambda: [by_mahotas(image, cells) for image in given],
        faster=20,
        repeats=REPEATS,
    )
    yield Limit(
        PIECE,
        text,
        "largest difference between histogram bins (four nearest neighbours)",
        lambda: max(largest_difference(image, cells) for image in given),
        at_most=1e-6,
        peer=PEER,
    )


def reduced_frames() -> list[Image]:
    """Return a frame from each rendered home as a (180, 320) uint8 grey image."""
    greys = [cv2.cvtColor(frame, cv2.COLOR_BGR2GRAY) for frame in prepared()[1]]
    return [np.asarray(cv2.resize(grey, (320, 180), interpolation=cv2.INTER_AREA)) for grey in greys]


def ours(image: Image, cells: int) -> NDArray[np.float32]:
    """Compute the (cells**2, 256) census histograms of the cells."""
    return cell_histograms(census(image), cells)


def theirs(image: Image, cells: int) -> NDArray[np.float64]:
    """Compute the (cells**2, 256) histograms of the cells from scikit-image's codes."""
    from skimage.feature import local_binary_pattern

    codes = local_binary_pattern(image, P=8, R=1)[1:-1, 1:-1]
    blocks = _blocks(codes, cells)
    return np.array([np.histogram(block, bins=CODES, range=(0, CODES))[0] / block.size for block in blocks])


def by_mahotas(image: Image, cells: int) -> NDArray[np.float64]:
    """Compute the (cells**2, 36) histograms with mahotas, which treats rotated patterns as the same."""
    from mahotas.features import lbp

    return np.array([lbp(block, radius=1, points=8) for block in _blocks(image, cells)])


def _blocks(image: NDArray[Any], cells: int) -> Iterator[NDArray[Any]]:
    """Yield the cells of an image, row by row."""
    rows, columns = (np.arange(cells + 1) * length // cells for length in image.shape)
    for top, bottom in pairwise(rows):
        for left, right in pairwise(columns):
            yield image[top:bottom, left:right]


def largest_difference(image: Image, cells: int) -> float:
    """Return the largest difference between the two histograms, for the four nearest neighbours only."""
    found = of_straight(ours(255 - image, cells), OUR_STRAIGHT)
    expected = of_straight(theirs(image, cells), THEIR_STRAIGHT)
    return float(np.abs(found - expected).max())


def of_straight(histograms: NDArray[np.floating], bits: tuple[int, ...]) -> NDArray[np.float64]:
    """Sum the bins whose codes agree in the four given bits: (n, 256) becomes (n, 16)."""
    codes = np.arange(CODES)
    straight = sum(((codes & bit) > 0).astype(np.intp) << place for place, bit in enumerate(bits))
    return np.stack([np.bincount(straight, row, 16) for row in histograms])
