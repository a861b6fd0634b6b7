"""Outlines of boards and vessels, and solids made from them."""

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from placecat_homes.mesh import Mesh, from_arrays
from placecat_homes.shapes import extrude

Outline = list[tuple[float, float]]


def rectangle(width: float, depth: float, radius: float = 0.0, steps: int = 4) -> Outline:
    """Return the counter-clockwise outline of a centred rectangle with rounded corners.

    Parameters
    ----------
    width, depth, radius
        Dimensions in metres.
    steps
        Number of segments in each rounded corner.

    Returns
    -------
    list of (x, y)
    """
    r = min(radius, width / 2, depth / 2)
    if r <= 0:
        x, y = width / 2, depth / 2
        return [(x, -y), (x, y), (-x, y), (-x, -y)]
    points = []
    for quarter, (sx, sy) in enumerate(((1, 1), (-1, 1), (-1, -1), (1, -1))):
        for k in range(steps + 1):
            angle = (quarter + k / steps) * math.pi / 2
            points.append(
                (
                    sx * (width / 2 - r) + r * math.cos(angle),
                    sy * (depth / 2 - r) + r * math.sin(angle),
                )
            )
    return points


def oval(width: float, depth: float, steps: int = 24) -> Outline:
    """Return the counter-clockwise outline of a centred ellipse."""
    angles = [2 * math.pi * k / steps for k in range(steps)]
    return [(width / 2 * math.cos(a), depth / 2 * math.sin(a)) for a in angles]


def frontal(outline: Sequence[tuple[float, float]], depth: float, *, smooth: bool = False) -> Mesh:
    """Draw an upright board with the given outline, as seen from the front or back.

    Parameters
    ----------
    outline
        Points (x, z) in metres, counter-clockwise with x to the right and z up.
    depth
        Thickness in metres, along y.
    smooth
        Whether to shade the edges as if they were rounded.

    Returns
    -------
    Mesh
        A board with its back at y = 0.
    """
    return extrude(outline, depth, smooth=smooth).turned(90, "x").moved(y=depth)


def sideways(outline: Sequence[tuple[float, float]], width: float, *, smooth: bool = False) -> Mesh:
    """Draw a solid with the given outline, as seen from the side.

    Parameters
    ----------
    outline
        Points (y, z) in metres, counter-clockwise with y to the right and z up.
    width
        Width along x in metres.
    smooth
        Whether to shade the edges as if they were rounded.

    Returns
    -------
    Mesh
        A solid centred on x = 0.
    """
    return extrude(outline, width, smooth=smooth).turned(90, "x").turned(90, "z").moved(x=-width / 2)


def loft(rings: Sequence[NDArray[np.float64]], *, close: bool = False) -> Mesh:
    """Draw a smooth skin through rings with the same number of points.

    Parameters
    ----------
    rings
        Points of each ring, shape (n, 3). If the rings are ordered from bottom to top, the points must run
        counter-clockwise, as seen from above, for the skin to face outwards.
    close
        Whether to close the last ring with a triangle fan around its centre.

    Returns
    -------
    Mesh
        A skin that is open at the first ring.
    """
    closed = [np.vstack([ring, ring[:1]]) for ring in rings]
    if close:
        closed.append(np.tile(rings[-1].mean(axis=0), (len(closed[0]), 1)))
    points = np.stack(closed, axis=1)
    rows, columns = points.shape[:2]
    i, j = np.meshgrid(np.arange(rows - 1), np.arange(columns - 1), indexing="ij")
    a = (i * columns + j).ravel()
    b, c, d = a + columns, a + columns + 1, a + 1
    faces = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
    mesh = from_arrays(points.reshape(-1, 3), faces)
    normals = mesh.normals.reshape(rows, columns, 3).copy()
    seam = normals[0] + normals[-1]
    seam /= np.maximum(np.linalg.norm(seam, axis=1, keepdims=True), 1e-12)
    normals[0] = normals[-1] = seam
    if close:
        tip = normals[:, -1].sum(axis=0)
        normals[:, -1] = tip / max(float(np.linalg.norm(tip)), 1e-12)
    return replace(mesh, normals=normals.reshape(-1, 3).astype(np.float32))


def ring(outline: Sequence[tuple[float, float]], z: float) -> NDArray[np.float64]:
    """Return an outline at height `z` as a ring for `loft`."""
    points = np.asarray(outline, dtype=np.float64)
    return np.c_[points, np.full(len(points), z)]


def textured(mesh: Mesh, *, u: float = 0.0, v: float = 0.0, quarter: bool = False) -> Mesh:
    """Shift a mesh's texture by `u` and `v` metres. `quarter` rotates it by 90 degrees for vertical grain."""
    uv = mesh.uv[:, ::-1] if quarter else mesh.uv
    return replace(mesh, uv=(uv + np.array([u, v], np.float32)).astype(np.float32))
