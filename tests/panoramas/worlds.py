"""A synthetic world with a colour for every direction, and panoramas of it."""

import cv2
import numpy as np

from placecat.panoramas.command import read_settings
from project import ROOT


def colour(x, y, z):
    """Return a smooth colour that differs in every direction, for x, y and z of any equal shape.

    The three channels range from 0 to 255.
    """
    length = np.sqrt(x * x + y * y + z * z)
    x, y, z = x / length, y / length, z / length
    return 127.5 + 100 * np.stack([x + 0.2 * y * z, y - 0.2 * x * z, z + 0.2 * x * y], axis=-1)


def sphere(height):
    """Draw an equirectangular panorama from the longitude and latitude of each pixel."""
    longitude = ((np.arange(2 * height) + 0.5) / (2 * height) * 360 - 180)[None] * np.pi / 180
    latitude = (90 - (np.arange(height) + 0.5) / height * 180)[:, None] * np.pi / 180
    x, y, z = np.cos(latitude) * np.sin(longitude), -np.sin(latitude), np.cos(latitude) * np.cos(longitude)
    return np.rint(colour(x, np.broadcast_to(y, x.shape), z)).astype(np.uint8)


def faces(side):
    """Draw the six cube faces (front, right, back, left, up, down) from their definitions."""
    s = np.broadcast_to((np.arange(side) + 0.5) / side * 2 - 1, (side, side))
    t, one = s.T, np.ones((side, side))
    seen = [(s, t, one), (one, t, -s), (-s, t, -one), (-one, t, s), (s, -one, t), (s, one, -t)]
    return [np.rint(colour(*(np.array(part) for part in face))).astype(np.uint8) for face in seen]


def write(path, picture):
    path.parent.mkdir(parents=True, exist_ok=True)
    assert cv2.imwrite(str(path), picture, [cv2.IMWRITE_JPEG_QUALITY, 98])


def settings(*changes):
    """Return the project settings with the given changes."""
    return read_settings(changes, ROOT / "conf/panoramas.yaml")
