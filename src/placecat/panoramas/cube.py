"""Render views from inside a cube of six square images.

The front, right, back and left images stand upright, side by side. The lower edge of ``up`` and the upper
edge of ``down`` meet the front image.
"""

from collections.abc import Sequence

import cv2
import numpy as np
from numpy.typing import NDArray

FACES = ("front", "right", "back", "left", "up", "down")
"""Order of the images for :func:`prepare`."""
# Each face's right, down and outward directions, in the coordinates of placecat.panoramas.render.
_AXES = np.array(
    [
        [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
        [[0, 0, -1], [0, 1, 0], [1, 0, 0]],
        [[-1, 0, 0], [0, 1, 0], [0, 0, -1]],
        [[0, 0, 1], [0, 1, 0], [-1, 0, 0]],
        [[1, 0, 0], [0, 0, 1], [0, -1, 0]],
        [[1, 0, 0], [0, 0, -1], [0, 1, 0]],
    ],
    dtype=np.float64,
)
# Number of pixels added around each face for interpolation across its edges.
_BORDER = 1
# Number of faces in a row of the combined image.
_IN_ROW = 3


def prepare(faces: Sequence[NDArray[np.uint8]], focal: float) -> NDArray[np.uint8]:
    """Prepare the faces of a cube for `look`.

    `faces` are six (N, N, 3) uint8 images in the order of `FACES`. See
    :func:`placecat.panoramas.sphere.prepare` for `focal`. Faces of higher resolution are scaled down to
    (N', N', 3). Returns all faces in one image, (2 (N' + 2), 3 (N' + 2), 3) uint8, each surrounded by a
    border of pixels from its neighbours.
    """
    side = min(len(faces[0]), int(np.ceil(2 * focal)))
    if side < len(faces[0]):
        faces = [cv2.resize(face, (side, side), interpolation=cv2.INTER_AREA) for face in faces]  # type: ignore[misc]
    tiles = [
        cv2.copyMakeBorder(face, _BORDER, _BORDER, _BORDER, _BORDER, cv2.BORDER_REPLICATE) for face in faces
    ]
    atlas = np.concatenate([np.concatenate(tiles[:_IN_ROW], axis=1), np.concatenate(tiles[_IN_ROW:], axis=1)])
    # Compute all borders before writing any.
    is_border = np.pad(np.zeros((side, side), dtype=bool), _BORDER, constant_values=True)
    rows, columns = np.nonzero(is_border)
    flat = (2 * (np.stack([columns, rows]) - _BORDER + 0.5) / side) - 1
    seen = [look(atlas, (flat.T @ axes[:2] + axes[2])[None])[0] for axes in _AXES]
    for number, pixels in enumerate(seen):
        row, column = divmod(number, _IN_ROW)
        atlas[rows + row * (side + 2 * _BORDER), columns + column * (side + 2 * _BORDER)] = pixels
    return atlas


def look(prepared: NDArray[np.uint8], rays: NDArray[np.float64]) -> NDArray[np.uint8]:
    """Render the view along the given rays with bilinear interpolation; return (h, w, 3) uint8.

    `prepared` comes from :func:`prepare`, and `rays`, (h, w, 3), from `placecat.panoramas.render.view_rays`.
    """
    tile = len(prepared) // 2
    # A ray hits the face whose outward direction is closest to its own.
    outwards = rays @ _AXES[:, 2].T
    face = outwards.argmax(axis=-1)
    depth = np.take_along_axis(outwards, face[..., None], axis=-1)
    across_and_down = np.einsum("...j,...ij->...i", rays, _AXES[face, :2]) / depth
    places = (across_and_down + 1) / 2 * (tile - 2 * _BORDER) - 0.5 + _BORDER
    row, column = np.divmod(face, _IN_ROW)
    columns = (places[..., 0] + column * tile).astype(np.float32)
    rows = (places[..., 1] + row * tile).astype(np.float32)
    return cv2.remap(prepared, columns, rows, cv2.INTER_LINEAR)  # type: ignore[return-value]
