"""Shut doors, modelled in relief on a wall."""

from dataclasses import replace

import numpy as np

from placecat_homes.furniture.door import door
from placecat_homes.mesh import Mesh
from placecat_homes.style import Style

DEEP = 0.012
"""How far the leaf is set back from the front of its frame, in metres."""


def shut_door(
    rng: np.random.Generator, style: Style, width: float = 0.9, height: float = 2.05, hinge: str = "left"
) -> Mesh:
    """Draw the visible side of a shut door, flat against a wall.

    Parameters
    ----------
    rng, style
        Random number generator and style of the home.
    width, height
        Width and height of the opening in metres.
    hinge
        Which side the hinge is on: "left" or "right".
    """
    whole = door(rng, style, width, height, DEEP, 0.0, hinge)
    keep = whole.vertices[whole.triangles, 1].max(axis=1) > -DEEP
    flat = whole.vertices.copy()
    flat[:, 1] = np.maximum(flat[:, 1], -DEEP)
    used, triangles = np.unique(whole.triangles[keep], return_inverse=True)
    return replace(
        whole,
        vertices=flat[used],
        normals=whole.normals[used],
        uv=whole.uv[used],
        triangles=triangles.reshape(-1, 3).astype(np.int32),
        material=whole.material[keep],
    ).moved(y=DEEP)
