"""Boards with rounded corners, and bent panels."""

from dataclasses import replace

import numpy as np

from placecat_homes.mesh import Mesh
from placecat_homes.parts.outlines import rectangle
from placecat_homes.shapes import extrude


def board(width: float, depth: float, height: float, radius: float, steps: int = 4) -> Mesh:
    """Draw a horizontal board with rounded corners and its back at y = 0.

    Parameters
    ----------
    width, depth, height, radius
        Dimensions in metres.
    steps
        Number of segments in each corner.
    """
    return extrude(rectangle(width, depth, radius, steps), height, smooth=False).moved(y=depth / 2)


def bent(mesh: Mesh, radius: float) -> Mesh:
    """Bend the sides of an upright panel towards +y around a vertical axis `radius` metres in front of it."""
    x = mesh.vertices[:, 0]
    vertices = mesh.vertices.copy()
    vertices[:, 1] += x * x / np.float32(2 * radius)
    normals = mesh.normals.copy()
    normals[:, 0] -= normals[:, 1] * x / np.float32(radius)
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
    return replace(mesh, vertices=vertices, normals=normals)
