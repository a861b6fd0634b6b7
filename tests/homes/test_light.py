"""Light agrees with closed-form solutions."""

import numpy as np
import pytest

pytest.importorskip("embreex", reason="rendering needs the optional extra")

from placecat_homes import shapes
from placecat_homes.bake import Daylight, Quality, bake
from placecat_homes.materials import Material
from placecat_homes.mesh import Lamp, join
from placecat_homes.scene import linear, prepare
from placecat_homes.view import Lens, Pose, Viewer

pytestmark = pytest.mark.slow

DARK = Daylight(np.zeros((4, 8, 3), np.float32), np.float32([0, 0, 1]), np.zeros(3, np.float32))
GREY = Material((0.5, 0.5, 0.5))


def open_sky(level=1.0, sunlight=0.0, sun=(0, 0, 1)):
    panorama = np.full((4, 8, 3), level, np.float32)
    return Daylight(panorama, np.float32(sun), np.full(3, sunlight, np.float32))


def test_a_plane_under_a_uniform_sky_receives_all_its_light():
    scene = prepare(shapes.slab(1, 1).of(GREY), edge=0.3)
    light = bake(scene, open_sky(0.7), Quality(directions=64, bounces=1))
    assert light[:, :3] == pytest.approx(0.7, rel=1e-5)


def test_light_in_a_closed_room_is_a_geometric_series():
    # All walls glow and reflect equally, so after many bounces E = e / (1 - a), whatever the shape of the
    # room.
    room = shapes.box(2, 3, 2.5, bevel=0)
    walls = join(room.of(Material((0.6, 0.6, 0.6), emission=1.0)))
    inside_out = type(walls)(
        walls.vertices,
        -walls.normals,
        walls.uv,
        walls.triangles[:, ::-1].copy(),
        walls.material,
        walls.materials,
    )
    scene = prepare(inside_out, edge=0.5)
    albedo = float(linear(0.6))
    light = bake(scene, DARK, Quality(directions=64, bounces=30))
    assert light[:, :3] == pytest.approx(albedo / (1 - albedo), rel=0.02)


def test_lamplight_falls_off_with_the_square_of_the_distance():
    scene = prepare(shapes.slab(0.02, 0.02).of(GREY).lit(Lamp((0, 0, 2), (1, 1, 1), 3.0, 0.01)), edge=1)
    light = bake(scene, DARK, Quality(directions=16, bounces=1))
    assert light[:, :3] == pytest.approx(3.0 / 4, rel=0.01)


def test_a_board_casts_shadows_from_lamp_and_sun():
    floor = shapes.slab(4, 4).moved(0, -2, 0).of(GREY)
    board = shapes.box(1, 1, 0.02, 0).moved(0, -0.5, 1.0).of(GREY)
    lamp = Lamp((0, 0, 2), (1, 1, 1), 1.0, 0.01)
    scene = prepare(join(floor, board).lit(lamp), edge=0.2)
    light = bake(scene, open_sky(0.0, 1.0), Quality(directions=16, bounces=0))
    floor_ = scene.vertices[:, 2] == 0
    radius = np.abs(scene.vertices[:, :2]).max(axis=1)
    # The lamp is twice as high as the board, so the shadow is twice as wide. The shadow from the sun is not
    # wider.
    assert light[floor_ & (radius < 0.5), 0] == pytest.approx(0, abs=1e-6)
    assert (light[floor_ & (radius > 1.4), 0] > 0.02).all()
    assert light[floor_ & (radius < 0.3), 3] == pytest.approx(0, abs=1e-6)
    assert light[floor_ & (radius > 0.7), 3] == pytest.approx(1, abs=1e-5)


def camera(scene, daylight, light, pose, size=(64, 36)):
    return Viewer(scene, light, daylight).frame(pose, Lens(*size, 60))


def test_a_wall_and_the_sky_have_the_expected_radiance_and_distance():
    wall = shapes.quad(20, 20).moved(0, 0, -10).of(GREY)
    scene = prepare(wall, edge=5)
    light = bake(scene, open_sky(1.0), Quality(directions=64, bounces=0))
    picture, distance = camera(scene, open_sky(1.0), light, Pose(0, 2, 0, -np.pi / 2))
    assert picture == pytest.approx(float(linear(0.5)), rel=0.02)
    assert distance[18, 32] == pytest.approx(2, rel=0.01)
    picture, distance = camera(scene, open_sky(1.0), light, Pose(0, 2, 0, np.pi / 2))
    assert picture == pytest.approx(1.0)
    assert (distance == 100).all()


def test_the_image_is_neither_mirrored_nor_upside_down():
    red, blue = Material((1, 0, 0)), Material((0, 0, 1))
    # The camera looks along +x, so +y is on its left.
    left = shapes.box(0.2, 0.2, 0.2, 0).of(red).moved(3, 0.8, 0.9)
    high = shapes.box(0.2, 0.2, 0.2, 0).of(blue).moved(3, -0.1, 1.6)
    scene = prepare(join(left, high), edge=1)
    daylight = open_sky(1.0)
    picture, _ = camera(scene, daylight, bake(scene, daylight, Quality(16, 0)), Pose(0, 0, 1, 0.0))
    for material, where in ((0, (slice(10, 26), slice(0, 30))), (1, (slice(0, 16), slice(24, 40)))):
        channel = picture[..., 0 if material == 0 else 2] - picture[..., 1]
        assert (channel[where] > 0.5).sum() == (channel > 0.5).sum() > 0


def test_a_mirror_shows_what_is_behind_the_camera():
    mirror = shapes.quad(8, 8).moved(0, 0, -4).of(Material(gloss=0.9, roughness=0))
    lamp = shapes.quad(20, 20).turned(180).moved(0, 6, -10).of(Material((0, 1, 0), emission=1.0))
    scene = prepare(join(mirror, lamp), edge=1)
    light = bake(scene, DARK, Quality(16, 0))
    picture, _ = camera(scene, DARK, light, Pose(0, 2, 0, -np.pi / 2), (32, 18))
    assert picture[..., 1] == pytest.approx(0.9, abs=0.03)
    assert picture[..., 0] == pytest.approx(0, abs=0.01)


def test_glass_lets_most_light_through():
    pane = shapes.quad(8, 8).moved(0, 1, -4).of(Material((1, 1, 1), opacity=0.2))
    lamp = shapes.quad(8, 8).moved(0, 0, -4).of(Material((1, 1, 1), emission=1.0))
    scene = prepare(join(pane, lamp), edge=1)
    picture, distance = camera(
        scene, DARK, bake(scene, DARK, Quality(16, 0)), Pose(0, 2, 0, -np.pi / 2), (32, 18)
    )
    assert picture == pytest.approx(0.8, abs=0.02)
    assert distance[9, 16] == pytest.approx(1, rel=0.01)


def test_baking_does_not_depend_on_the_chunk_size():
    scene = prepare(shapes.box(1, 1, 1).of(GREY), edge=0.2)
    one, other = (bake(scene, open_sky(), Quality(directions=32, bounces=1, chunk=c)) for c in (64, 4096))
    assert np.array_equal(one, other)
