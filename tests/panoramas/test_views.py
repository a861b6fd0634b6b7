"""Tests that each pixel of a view has the colour of its direction."""

import math

import numpy as np
import pytest
from worlds import colour, faces, sphere

from placecat.panoramas import cube
from placecat.panoramas import sphere as equirectangular
from placecat.panoramas.render import view_rays

WIDTH, HEIGHT, FOV = 64, 36, 60.0
# Straight ahead, the seam at the back, both poles, edges and corners of the cube, and a tilted view across
# two faces.
DIRECTIONS = [
    (0, 0),
    (180, 0),
    (-170, 5),
    (20, 90),
    (-75, -90),
    (45, 0),
    (135, 0),
    (45, 35.26),
    (-135, -35.26),
    (80, 60),
]


def direct(pan, tilt):
    """Compute the view pixel by pixel, with rotation matrices."""
    pan, tilt = math.radians(pan), math.radians(tilt)
    about_x = np.array([[1, 0, 0], [0, math.cos(tilt), -math.sin(tilt)], [0, math.sin(tilt), math.cos(tilt)]])
    about_y = np.array([[math.cos(pan), 0, math.sin(pan)], [0, 1, 0], [-math.sin(pan), 0, math.cos(pan)]])
    view = np.empty((HEIGHT, WIDTH, 3))
    step = 2 * math.tan(math.radians(FOV) / 2) / WIDTH
    for row in range(HEIGHT):
        for column in range(WIDTH):
            flat = [(column - (WIDTH - 1) / 2) * step, (row - (HEIGHT - 1) / 2) * step, 1]
            view[row, column] = colour(*(about_y @ about_x @ flat))
    return view


@pytest.mark.parametrize(("pan", "tilt"), DIRECTIONS)
def test_a_view_shows_the_colour_of_every_direction(pan, tilt):
    rays = view_rays(pan, tilt, FOV, WIDTH, HEIGHT)
    wanted = direct(pan, tilt)
    for prepared, look in (
        (equirectangular.prepare(sphere(24), 1000.0), equirectangular.look),
        (cube.prepare(faces(16), 1000.0), cube.look),
        # These two panoramas are scaled down first.
        (equirectangular.prepare(sphere(96), 7.6), equirectangular.look),
        (cube.prepare(faces(64), 8.0), cube.look),
    ):
        seen = look(prepared, rays)
        assert seen.shape == wanted.shape
        # The limit covers the rounding of the panorama and of the view, half a grey level each, and the
        # curvature of the colours within a pixel, which spans up to 15 levels. A seam, pole or edge without
        # its neighbour deviates by at least 2.7.
        assert np.abs(seen - wanted).max() < 1.6


def test_a_longer_view_keeps_the_pixels_of_the_panorama():
    assert equirectangular.prepare(sphere(24), 1000.0).shape == (26, 50, 3)
    assert equirectangular.prepare(sphere(96), 7.6).shape == (26, 50, 3)
    assert cube.prepare(faces(16), 1000.0).shape == (36, 54, 3)
    assert cube.prepare(faces(64), 8.0).shape == (36, 54, 3)
