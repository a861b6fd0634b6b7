"""Intersect rays with triangles, using Embree."""

from typing import NamedTuple

import numpy as np
from embreex.mesh_construction import TriangleMesh
from embreex.rtcore_scene import EmbreeScene
from numpy.typing import NDArray

from placecat_homes.mesh import Floats


class Hits(NamedTuple):
    """The surfaces that rays hit first.

    Attributes
    ----------
    triangle
        (r,) int32; -1 if nothing is hit.
    u, v
        (r,) float32, barycentric weights of the second and third corners.
    distance
        (r,) float32, in metres; very large if nothing is hit.
    across
        (r, 3) float32, normal of the flat triangle. It can have any length and point to either side.
    """

    triangle: NDArray[np.int32]
    u: Floats
    v: Floats
    distance: Floats
    across: Floats


class Tracer:
    """A set of triangles to intersect with rays.

    Parameters
    ----------
    vertices
        (n, 3) float32, metres.
    triangles
        (m, 3) int32.
    """

    def __init__(self, vertices: Floats, triangles: NDArray[np.int32]) -> None:
        self._scene = EmbreeScene()
        corners = np.ascontiguousarray(vertices, dtype=np.float32)
        self._mesh = TriangleMesh(self._scene, corners, np.ascontiguousarray(triangles, dtype=np.int32))

    def hits(self, origins: Floats, directions: Floats) -> Hits:
        """Find the surfaces that rays hit first.

        Parameters
        ----------
        origins, directions
            (r, 3) float32; directions of unit length.

        Returns
        -------
        Hits
            The first hit of each ray.
        """
        found = self._scene.run(_rays(origins), _rays(directions), output=1)
        return Hits(found["primID"], found["u"], found["v"], found["tfar"], found["Ng"])

    def blocked(self, origins: Floats, directions: Floats, distances: Floats) -> NDArray[np.bool_]:
        """Return whether rays hit anything within a distance.

        Parameters
        ----------
        origins, directions
            (r, 3) float32; directions of unit length.
        distances
            (r,) float32, metres.

        Returns
        -------
        numpy.ndarray
            (r,) bool.
        """
        reach = np.ascontiguousarray(distances, dtype=np.float32)
        found = self._scene.run(_rays(origins), _rays(directions), dists=reach, query="OCCLUDED")
        return np.asarray(found) >= 0


def _rays(values: Floats) -> Floats:
    return np.ascontiguousarray(values, dtype=np.float32)
