"""Triangle meshes and how to join them."""

import math
from collections.abc import Iterable
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from placecat_homes.materials import Colour, Material

Floats = NDArray[np.float32]
Point = tuple[float, float, float]


@dataclass(frozen=True)
class Lamp:
    """A point light source.

    Attributes
    ----------
    position
        In metres, in the frame of the mesh.
    colour
        sRGB.
    power
        Irradiance at one metre; 1.0 is the light from a bright overcast sky at a window.
    radius
        Radius of the luminous body in metres. Larger bodies make shadows softer.
    """

    position: Point
    colour: Colour = (1.0, 0.9, 0.75)
    power: float = 1.0
    radius: float = 0.06


@dataclass(frozen=True, eq=False)
class Mesh:
    """Triangles with materials. Meshes are immutable: every method returns a new one.

    A piece of furniture stands on z = 0 with the middle of its back edge at the origin: it extends from
    -width/2 to width/2 along x and from 0 (its back, at the wall) to its depth along y. Its front faces +y.

    Attributes
    ----------
    vertices
        (n, 3) float32, metres.
    normals
        (n, 3) float32, of unit length, pointing outwards.
    uv
        (n, 2) float32, texture coordinates in metres.
    triangles
        (m, 3) int32, counter-clockwise seen from outside.
    material
        (m,) int16, index into `materials`.
    materials
        The materials used.
    lamps
        The lamps in the mesh.
    """

    vertices: Floats
    normals: Floats
    uv: Floats
    triangles: NDArray[np.int32]
    material: NDArray[np.int16]
    materials: tuple[Material, ...]
    lamps: tuple[Lamp, ...] = field(default=())

    @property
    def low(self) -> Floats:
        """(3,) float32, the smallest coordinates."""
        return self.vertices.min(axis=0)

    @property
    def high(self) -> Floats:
        """(3,) float32, the largest coordinates."""
        return self.vertices.max(axis=0)

    @property
    def size(self) -> Floats:
        """(3,) float32, width, depth and height in metres."""
        return self.high - self.low

    def moved(self, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> "Mesh":
        """Shift the mesh by x, y and z in metres."""
        return self.transformed(np.eye(3), (x, y, z))

    def turned(self, degrees: float, axis: str = "z") -> "Mesh":
        """Rotate the mesh around the x, y or z axis, counter-clockwise as seen from the tip of the axis."""
        c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
        if axis == "x":
            matrix = np.array([[1, 0, 0], [0, c, -s], [0, s, c]])
        elif axis == "y":
            matrix = np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])
        else:
            matrix = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
        return self.transformed(matrix, (0.0, 0.0, 0.0))

    def scaled(self, x: float, y: float | None = None, z: float | None = None) -> "Mesh":
        """Scale the mesh along each axis, or uniformly if only `x` is given. Factors must be positive."""
        factors = np.array([x, x if y is None else y, x if z is None else z], dtype=np.float32)
        normals = self.normals / factors
        normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
        lamps = tuple(replace(lamp, position=_point(floats(*lamp.position) * factors)) for lamp in self.lamps)
        return replace(
            self, vertices=self.vertices * factors, normals=normals.astype(np.float32), lamps=lamps
        )

    def transformed(self, matrix: NDArray[np.float64], shift: Point) -> "Mesh":
        """Rotate the mesh by a (3, 3) matrix, then shift it by a vector in metres."""
        m, s = np.asarray(matrix, dtype=np.float32), np.asarray(shift, dtype=np.float32)
        lamps = tuple(
            replace(lamp, position=_point(m @ np.asarray(lamp.position, np.float32) + s))
            for lamp in self.lamps
        )
        return replace(self, vertices=self.vertices @ m.T + s, normals=self.normals @ m.T, lamps=lamps)

    def mirrored(self) -> "Mesh":
        """Swap left and right by negating x."""
        flip = np.array([-1, 1, 1], dtype=np.float32)
        lamps = tuple(
            replace(lamp, position=(-lamp.position[0], lamp.position[1], lamp.position[2]))
            for lamp in self.lamps
        )
        return replace(
            self,
            vertices=self.vertices * flip,
            normals=self.normals * flip,
            triangles=np.ascontiguousarray(self.triangles[:, ::-1]),
            lamps=lamps,
        )

    def of(self, material: Material) -> "Mesh":
        """Give the entire mesh a single material."""
        return replace(self, material=np.zeros(len(self.triangles), np.int16), materials=(material,))

    def lit(self, *lamps: Lamp) -> "Mesh":
        """Add lamps whose positions are in the frame of the mesh."""
        return replace(self, lamps=self.lamps + lamps)


def floats(*values: float) -> Floats:
    """Convert numbers to a float32 array."""
    return np.array(values, dtype=np.float32)


def _point(values: NDArray[np.floating]) -> Point:
    x, y, z = (float(value) for value in values)
    return x, y, z


def join(*parts: Mesh | Iterable[Mesh]) -> Mesh:
    """Join meshes without moving them.

    Parameters
    ----------
    *parts
        Meshes, or iterables of meshes.

    Returns
    -------
    Mesh
        The combined mesh, with equal materials merged.
    """
    meshes: list[Mesh] = []
    for part in parts:
        meshes.extend([part] if isinstance(part, Mesh) else part)
    if not meshes:
        return empty()
    numbers: dict[Material, int] = {}
    material = []
    for mesh in meshes:
        table = np.array([numbers.setdefault(m, len(numbers)) for m in mesh.materials] or [0], np.int16)
        material.append(table[mesh.material])
    starts = np.cumsum([0, *(len(mesh.vertices) for mesh in meshes)])
    return Mesh(
        vertices=np.concatenate([mesh.vertices for mesh in meshes]),
        normals=np.concatenate([mesh.normals for mesh in meshes]),
        uv=np.concatenate([mesh.uv for mesh in meshes]),
        triangles=np.concatenate(
            [mesh.triangles + np.int32(start) for mesh, start in zip(meshes, starts[:-1], strict=True)]
        ),
        material=np.concatenate(material),
        materials=tuple(numbers),
        lamps=tuple(lamp for mesh in meshes for lamp in mesh.lamps),
    )


def empty() -> Mesh:
    """Return a mesh without triangles."""
    return Mesh(
        np.zeros((0, 3), np.float32),
        np.zeros((0, 3), np.float32),
        np.zeros((0, 2), np.float32),
        np.zeros((0, 3), np.int32),
        np.zeros(0, np.int16),
        (),
    )


def from_arrays(
    vertices: NDArray[np.floating],
    triangles: NDArray[np.integer],
    *,
    normals: NDArray[np.floating] | None = None,
    uv: NDArray[np.floating] | None = None,
) -> Mesh:
    """Make a mesh from arrays.

    Parameters
    ----------
    vertices
        (n, 3), metres.
    triangles
        (m, 3), counter-clockwise seen from outside.
    normals
        (n, 3); by default, the area-weighted mean of the normals of adjacent triangles, so that the surface
        looks smooth.
    uv
        (n, 2), metres; by default, x and y.

    Returns
    -------
    Mesh
        A mesh with the default material.
    """
    points, faces = np.asarray(vertices, np.float32), np.asarray(triangles, np.int32)
    if normals is None:
        a, b, c = (points[faces[:, k]] for k in range(3))
        across = np.cross(b - a, c - a)
        sums = np.zeros_like(points)
        for k in range(3):
            np.add.at(sums, faces[:, k], across)
        normals = sums / np.maximum(np.linalg.norm(sums, axis=1, keepdims=True), 1e-12)
    return Mesh(
        points,
        np.asarray(normals, np.float32),
        np.asarray(points[:, :2] if uv is None else uv, np.float32),
        faces,
        np.zeros(len(faces), np.int16),
        (Material(),),
    )
