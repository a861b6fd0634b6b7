"""Subdivision preserves the surface, and the tables contain the textures and colours."""

import numpy as np
import pytest

from placecat_homes import shapes
from placecat_homes.materials import Material, Texture
from placecat_homes.mesh import join
from placecat_homes.scene import LEVELS, linear, prepare, subdivide


def area(mesh):
    a, b, c = (mesh.vertices[mesh.triangles[:, k]].astype(np.float64) for k in range(3))
    return np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2


def test_subdivision_keeps_the_surface_and_its_materials():
    red, blue = Material((1, 0, 0)), Material((0, 0, 1))
    mesh = join(shapes.box(1, 0.7, 0.4, 0).of(red), shapes.slab(2, 3).of(blue))
    fine = subdivide(mesh, 0.11)
    a, b, c = (fine.vertices[fine.triangles[:, k]] for k in range(3))
    edges = np.concatenate([a - b, b - c, c - a])
    assert np.linalg.norm(edges, axis=1).max() <= 0.11 + 1e-6
    for k in range(2):
        assert area(fine)[fine.material == k].sum() == pytest.approx(area(mesh)[mesh.material == k].sum())
    assert (area(fine) > 0).all()


def test_subdivision_leaves_no_gaps():
    fine = subdivide(shapes.slab(1.0, 1.3), 0.1)
    sides = np.sort(fine.triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    _, uses = np.unique(sides, axis=0, return_counts=True)
    border = 2 * (1.0 + 1.3)
    single = sides[np.isin(np.arange(len(sides)), np.unique(sides, axis=0, return_index=True)[1][uses == 1])]
    length = np.linalg.norm(fine.vertices[single[:, 0]] - fine.vertices[single[:, 1]], axis=1).sum()
    # Inner edges belong to two triangles. Edges of only one triangle form the border.
    assert set(uses) == {1, 2}
    assert length == pytest.approx(border, rel=1e-5)


def test_texture_coordinates_stay_linear():
    fine = subdivide(shapes.slab(1.0, 1.3), 0.1)
    assert fine.uv == pytest.approx(fine.vertices[:, :2] + [0.5, 0], abs=1e-6)


def test_scene_tables_contain_materials_and_textures():
    picture = Texture("tiles", ((0.2, 0.4, 0.6), (0.1, 0.1, 0.1)), (0.5, 0.25))
    mesh = join(
        shapes.slab(1, 1).of(Material((0.5, 0.5, 0.5), gloss=0.1, opacity=0.2)),
        shapes.slab(1, 1).of(Material(texture=picture)),
        shapes.slab(1, 1).of(Material((0.5, 0.5, 0.5), texture=picture)),
    )
    scene = prepare(mesh, edge=9, pixels=64)
    assert scene.properties[:, 3].tolist() == [-1, 0, 0]
    assert scene.properties[1, 4:7].tolist() == [2, 4, 128]
    assert scene.surface[0].tolist() == pytest.approx([0.1, 0.3, 0, 0.2])
    assert len(scene.atlas) == sum((64 >> k) ** 2 * 3 for k in range(LEVELS))
    assert scene.albedo[2] == pytest.approx(scene.albedo[1] * linear(0.5))
    assert scene.albedo[1] == pytest.approx(linear((0.2, 0.4, 0.6)), rel=0.25)
