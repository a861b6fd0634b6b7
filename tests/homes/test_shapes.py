"""Shapes are closed, wound outwards, and as large as requested."""

import math

import numpy as np
import pytest

from placecat_homes import shapes
from placecat_homes.materials import Material
from placecat_homes.mesh import Lamp, join


def corners(mesh):
    return (mesh.vertices[mesh.triangles[:, k]].astype(np.float64) for k in range(3))


def volume(mesh):
    """Compute the volume by the divergence theorem. It is correct only for closed bodies wound outwards."""
    a, b, c = corners(mesh)
    return np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6


SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]
BODIES = {
    "box": (shapes.box(1.0, 0.5, 0.8, bevel=0.0), 0.4),
    "bevelled box": (shapes.box(1.0, 0.5, 0.8, bevel=0.01), 0.4),
    "cylinder": (shapes.cylinder(0.1, 0.3, segments=64), math.pi * 0.003),
    "lathe": (shapes.lathe([(0, 0), (0.2, 0), (0, 0.3)], 64), math.pi * 0.04 * 0.1),
    "ellipsoid": (shapes.superellipsoid(0.6, 0.4, 0.2, 1, 1, 64), 4 / 3 * math.pi * 0.3 * 0.2 * 0.1),
    "extrusion": (shapes.extrude(SQUARE, 0.5), 0.5),
    "tube": (shapes.tube([(0, 0, 0), (0, 0, 2)], 0.05, 64), math.pi * 0.0025 * 2),
}


@pytest.mark.parametrize("name", BODIES)
def test_bodies_are_closed_and_wound_outwards(name):
    mesh, expected = BODIES[name]
    assert volume(mesh) == pytest.approx(expected, rel=0.01)
    # A body keeps this volume after a move only if it is closed.
    assert volume(mesh.moved(3, -2, 5)) == pytest.approx(expected, rel=0.01)


@pytest.mark.parametrize("name", BODIES)
def test_normals_agree_with_the_winding(name):
    mesh, _ = BODIES[name]
    a, b, c = corners(mesh)
    across = np.cross(b - a, c - a)
    size = np.linalg.norm(across, axis=1)
    agreement = np.einsum("ij,ij->i", across, mesh.normals[mesh.triangles].mean(axis=1))
    assert (agreement[size > 1e-9] > 0).all()
    assert np.linalg.norm(mesh.normals, axis=1) == pytest.approx(1, abs=1e-4)


def test_a_box_is_in_the_furniture_frame():
    mesh = shapes.box(1.0, 0.5, 0.8)
    assert mesh.low == pytest.approx([-0.5, 0, 0], abs=1e-6)
    assert mesh.high == pytest.approx([0.5, 0.5, 0.8], abs=1e-6)


def test_a_quad_faces_forward_with_an_upright_texture():
    mesh = shapes.quad(2.0, 1.0)
    assert mesh.normals == pytest.approx(np.tile([0, 1, 0], (4, 1)))
    # Seen along -y, the +x direction is on the left, so u grows towards -x and v grows upwards.
    left_low = mesh.uv[np.argmin(mesh.uv.sum(axis=1))]
    assert left_low == pytest.approx([0, 0])
    assert mesh.vertices[np.argmin(mesh.uv.sum(axis=1))] == pytest.approx([1, 0, 0])


@pytest.mark.parametrize(
    "change", [lambda m: m.mirrored(), lambda m: m.turned(40), lambda m: m.turned(25, "x")]
)
def test_rotating_and_mirroring_keep_the_volume(change):
    assert volume(change(shapes.box(1, 0.5, 0.8))) == pytest.approx(volume(shapes.box(1, 0.5, 0.8)), rel=1e-4)


def test_scaling_and_lamps():
    lamp = Lamp((0.1, 0.2, 0.3))
    mesh = shapes.box(1, 1, 1, 0).lit(lamp).scaled(2, 1, 0.5).moved(1, 0, 0)
    assert volume(mesh) == pytest.approx(1)
    assert mesh.lamps[0].position == pytest.approx((1.2, 0.2, 0.15))
    assert shapes.box(1, 1, 1).lit(lamp).turned(90).lamps[0].position == pytest.approx((-0.2, 0.1, 0.3))


def test_join_shares_equal_materials():
    red, blue = Material((1, 0, 0)), Material((0, 0, 1))
    cube = shapes.box(1, 1, 1, 0)
    mesh = join(cube.of(red), [cube.of(blue), cube.of(red)])
    assert mesh.materials == (red, blue)
    assert np.bincount(mesh.material).tolist() == [24, 12]
    assert mesh.triangles.max() == len(mesh.vertices) - 1
