"""Meshes prepared for rendering, that is, subdivided for the baked light and with textures drawn."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from placecat_homes import textures
from placecat_homes.materials import Material
from placecat_homes.mesh import Floats, Lamp, Mesh

LEVELS = 6
"""Number of sizes in which each texture is stored. Each size is half the previous one."""
THIN = 0.03
"""Triangles thinner than this, in metres, may have edges three times as long."""


@dataclass(frozen=True, eq=False)
class Scene:
    """The surfaces and lamps to render.

    Attributes
    ----------
    vertices, normals, uv, triangles, material
        As in `Mesh`.
    properties
        (materials, 8) float32: linear red, green, blue, texture number or -1, 1 / texture width and
        1 / texture height in 1/m, texels per metre, 0.
    surface
        (materials, 4) float32: gloss, roughness, emission, opacity.
    albedo
        (materials, 3) float32, mean linear colour.
    atlas
        uint8, sRGB: every texture in `LEVELS` sizes, one after another.
    pixels
        Width of textures at the largest size.
    lamps
        The lamps in the frame of the scene.
    """

    vertices: Floats
    normals: Floats
    uv: Floats
    triangles: NDArray[np.int32]
    material: NDArray[np.int16]
    properties: Floats
    surface: Floats
    albedo: Floats
    atlas: NDArray[np.uint8]
    pixels: int
    lamps: tuple[Lamp, ...]


def linear(srgb: NDArray[np.floating] | tuple[float, ...]) -> Floats:
    """Convert sRGB values in [0, 1] to linear light (IEC 61966-2-1)."""
    value = np.asarray(srgb, dtype=np.float32)
    return np.where(value <= 0.04045, value / 12.92, ((value + 0.055) / 1.055) ** 2.4).astype(np.float32)


def prepare(mesh: Mesh, *, edge: float, pixels: int = 256) -> Scene:
    """Subdivide a mesh and draw its textures.

    Parameters
    ----------
    mesh
        In world coordinates, metres.
    edge
        Longest edge of a triangle in metres, which limits the detail of the baked light. Thin triangles may
        have edges three times as long.
    pixels
        Width of a texture; a power of two, at least 2**(LEVELS - 1).

    Returns
    -------
    Scene
        The scene without light.
    """
    fine = subdivide(mesh, edge)
    properties, surface, albedo, pictures = _tables(mesh.materials, pixels)
    return Scene(
        vertices=fine.vertices,
        normals=fine.normals,
        uv=fine.uv,
        triangles=fine.triangles,
        material=fine.material,
        properties=properties,
        surface=surface,
        albedo=albedo,
        atlas=np.concatenate(pictures) if pictures else np.zeros(3, np.uint8),
        pixels=pixels,
        lamps=fine.lamps,
    )


def _tables(
    materials: tuple[Material, ...], pixels: int
) -> tuple[Floats, Floats, Floats, list[NDArray[np.uint8]]]:
    properties = np.zeros((len(materials), 8), np.float32)
    surface = np.zeros((len(materials), 4), np.float32)
    albedo = np.zeros((len(materials), 3), np.float32)
    pictures: list[NDArray[np.uint8]] = []
    numbers: dict[object, tuple[int, Floats]] = {}
    for k, material in enumerate(materials):
        properties[k, :3] = albedo[k] = linear(material.colour)
        properties[k, 3] = -1
        surface[k] = material.gloss, material.roughness, material.emission, material.opacity
        texture = material.texture
        if texture is not None:
            if texture not in numbers:
                picture = textures.draw(texture, pixels)
                mean = linear(picture[::4, ::4].reshape(-1, 3).astype(np.float32) / 255).mean(axis=0)
                numbers[texture] = len(numbers), mean
                pictures.append(_pyramid(picture))
            number, mean = numbers[texture]
            properties[k, 3:7] = number, 1 / texture.size[0], 1 / texture.size[1], pixels / max(texture.size)
            albedo[k] *= mean
    return properties, surface, albedo, pictures


def _pyramid(picture: NDArray[np.uint8]) -> NDArray[np.uint8]:
    parts = []
    level: NDArray[np.floating] = picture.astype(np.float32)
    for _ in range(LEVELS):
        parts.append((level + 0.5).astype(np.uint8).ravel())
        level = (level[::2, ::2] + level[1::2, ::2] + level[::2, 1::2] + level[1::2, 1::2]) / 4
    return np.concatenate(parts)


def subdivide(mesh: Mesh, edge: float) -> Mesh:
    """Split edges until none is longer than a limit. Triangles that share an edge stay connected.

    Parameters
    ----------
    mesh
        Any mesh.
    edge
        Limit in metres; three times this for triangles thinner than `THIN`.

    Returns
    -------
    Mesh
        The same surface.
    """
    vertices, normals, uv = mesh.vertices, mesh.normals, mesh.uv
    faces, material = mesh.triangles.astype(np.int64), mesh.material
    for _ in range(16):
        pairs = np.sort(faces[:, [[0, 1], [1, 2], [2, 0]]], axis=2)
        length = np.linalg.norm(vertices[pairs[..., 0]] - vertices[pairs[..., 1]], axis=2)
        # Bars and bevels are so thin that light varies only along their length, and only slowly.
        limit = np.where(_thickness(vertices, faces, length) < THIN, 3 * edge, edge)
        keys = pairs[..., 0] * len(vertices) + pairs[..., 1]
        unique = np.unique(keys[length > limit[:, None]])
        if not len(unique):
            break
        a, b = unique // len(vertices), unique % len(vertices)
        where = np.minimum(np.searchsorted(unique, keys), len(unique) - 1)
        middle = np.where(unique[where] == keys, len(vertices) + where, -1)
        between = normals[a] + normals[b]
        between /= np.maximum(np.linalg.norm(between, axis=1, keepdims=True), 1e-9)
        vertices = np.concatenate([vertices, (vertices[a] + vertices[b]) / 2])
        normals = np.concatenate([normals, between.astype(np.float32)])
        uv = np.concatenate([uv, (uv[a] + uv[b]) / 2])
        faces, material = _split(faces, middle, length, material)
    return Mesh(
        vertices.astype(np.float32),
        normals.astype(np.float32),
        uv.astype(np.float32),
        np.ascontiguousarray(faces, dtype=np.int32),
        material,
        mesh.materials,
        mesh.lamps,
    )


def _thickness(vertices: Floats, faces: NDArray[np.int64], length: Floats) -> Floats:
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    doubled = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    return doubled / np.maximum(length.max(axis=1), 1e-9)


def _split(
    faces: NDArray[np.int64], middle: NDArray[np.int64], length: Floats, material: NDArray[np.int16]
) -> tuple[NDArray[np.int64], NDArray[np.int16]]:
    # Reorder each triangle's corners so that its longest split edge comes first. The split pattern then
    # depends only on which of the other two edges are split.
    rows = np.arange(len(faces))[:, None]
    order = (np.argmax(np.where(middle >= 0, length, -1), axis=1)[:, None] + np.arange(3)) % 3
    f, m = faces[rows, order], middle[rows, order]
    a, b, c = f.T
    ab, bc, ca = m.T
    none, second, third = ab < 0, bc >= 0, ca >= 0
    parts, kinds = [f[none]], [material[none]]
    cut = ~none
    for sides, wanted in (
        ((a, ab, c), cut & ~third),
        ((a, ab, ca), cut & third),
        ((ab, c, ca), cut & third),
        ((ab, b, c), cut & ~second),
        ((ab, b, bc), cut & second),
        ((ab, bc, c), cut & second),
    ):
        parts.append(np.stack(sides, axis=1)[wanted])
        kinds.append(material[wanted])
    return np.concatenate(parts), np.concatenate(kinds)
