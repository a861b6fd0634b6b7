"""Tests of every sensor_msgs/Image encoding with known colours."""

from types import SimpleNamespace

import cv2
import numpy as np
import pytest

from placecat.errors import PlacecatError
from placecat.footage.image_messages import ENCODINGS, Damaged, compressed_image, raw_image

WIDTH, HEIGHT = 8, 6
# Blue, green and red all differ, so that a swapped channel is noticed.
COLOR = (40, 200, 90)
GRAY = 123
BAYER = {"bayer_rggb8": "RGGB", "bayer_bggr8": "BGGR", "bayer_gbrg8": "GBRG", "bayer_grbg8": "GRBG"}


def decode(data, encoding, step, width=WIDTH, height=HEIGHT):
    content = np.ascontiguousarray(data).tobytes()
    message = SimpleNamespace(width=width, height=height, step=step, encoding=encoding, data=content)
    return raw_image(message, "a.bag")


def luma_and_chroma():
    """Convert the colour by ITU-R BT.601, with luma from 16 (black) to 235 (white)."""
    blue, green, red = np.array(COLOR) / 255
    y = 16 + 65.481 * red + 128.553 * green + 24.966 * blue
    u = 128 - 37.797 * red - 74.203 * green + 112 * blue
    v = 128 + 112 * red - 93.786 * green - 18.214 * blue
    return np.rint([y, u, v]).astype(np.uint8)


def filled(encoding):
    """Return the rows of a single-colour image, as a camera with that encoding would send them."""
    blue, green, red = COLOR
    pixels = {
        **dict.fromkeys(("bgr8", "8UC3"), COLOR),
        "rgb8": (red, green, blue),
        **dict.fromkeys(("bgra8", "8UC4"), (*COLOR, 7)),
        "rgba8": (red, green, blue, 7),
        **dict.fromkeys(("mono8", "8UC1"), (GRAY,)),
    }
    y, u, v = luma_and_chroma()
    pairs = {
        **dict.fromkeys(("yuv422", "uyvy"), (u, y, v, y)),
        **dict.fromkeys(("yuv422_yuy2", "yuyv"), (y, u, y, v)),
    }
    if encoding in pixels:
        return np.tile(np.array(pixels[encoding], np.uint8), (HEIGHT, WIDTH))
    if encoding in pairs:
        return np.tile(np.array(pairs[encoding], np.uint8), (HEIGHT, WIDTH // 2))
    if encoding == "nv21":
        chroma = np.tile(np.array([v, u], np.uint8), (HEIGHT // 2, WIDTH // 2))
        return np.concatenate([np.full((HEIGHT, WIDTH), y, np.uint8), chroma])
    square = np.array([{"B": blue, "G": green, "R": red}[one] for one in BAYER[encoding]], np.uint8)
    return np.tile(square.reshape(2, 2), (HEIGHT // 2, WIDTH // 2))


@pytest.mark.parametrize("padding", [0, 5])
@pytest.mark.parametrize("encoding", ENCODINGS)
def test_pixels_match_the_camera(encoding, padding):
    rows = np.pad(filled(encoding), ((0, 0), (0, padding)), constant_values=255)
    image = decode(rows, encoding, rows.shape[1])
    assert image.shape == (HEIGHT, WIDTH, 3) and image.dtype == np.uint8
    expected = (GRAY,) * 3 if encoding in ("mono8", "8UC1") else COLOR
    tolerance = 2 if encoding.startswith(("yuv", "uyvy", "nv")) else 0
    assert np.abs(image.astype(int) - expected).max() <= tolerance


def test_each_pixel_has_its_place_and_may_be_written():
    pixels = np.random.default_rng(0).integers(0, 256, (HEIGHT, WIDTH, 3), np.uint8)
    image = decode(pixels, "bgr8", WIDTH * 3)
    assert np.array_equal(image, pixels)
    image[0, 0] = 1


@pytest.mark.parametrize(
    "sizes",
    [
        {"step": WIDTH * 3 - 1},
        {"step": WIDTH * 3 + 1},
        {"step": 2**32 - 1},
        {"height": HEIGHT + 1, "step": WIDTH * 3},
        {"width": 0, "step": WIDTH * 3},
    ],
)
def test_sizes_are_checked_against_the_data(sizes):
    with pytest.raises(Damaged, match=r"a\.bag: .* do not match 144 bytes"):
        decode(filled("bgr8"), "bgr8", **sizes)


def test_more_pixels_than_any_picture_has_are_refused():
    with pytest.raises(PlacecatError, match="more than 50 million"):
        decode(b"", "bgr8", 1, width=2**32 - 1, height=2**32 - 1)


def test_sizes_that_an_encoding_cannot_have():
    with pytest.raises(Damaged, match="an image in yuv422 cannot be 7x6 pixels"):
        decode(filled("yuv422"), "yuv422", WIDTH * 2, width=7)


def test_other_encodings_are_named():
    with pytest.raises(PlacecatError, match="encoding '16UC1' is not supported; choose") as caught:
        decode(bytes(96), "16UC1", 16)
    assert not isinstance(caught.value, Damaged)


@pytest.mark.parametrize("ending", [".png", ".jpg"])
def test_compressed_pictures(ending):
    content = cv2.imencode(ending, np.full((HEIGHT, WIDTH, 3), COLOR, np.uint8))[1].ravel()
    image = compressed_image(SimpleNamespace(data=content, format="rgb8; jpeg compressed bgr8"), "a.bag")
    assert np.abs(image.astype(int) - COLOR).max() <= (0 if ending == ".png" else 3)


@pytest.mark.parametrize("keep", [0, 60, -1])
def test_damaged_pictures_are_reported(keep):
    pixels = np.random.default_rng(0).integers(0, 256, (64, 64, 3), np.uint8)
    content = cv2.imencode(".png", pixels)[1].ravel()[:keep]
    with pytest.raises(Damaged, match=r"a\.bag \(format 'png'\): not a readable image"):
        compressed_image(SimpleNamespace(data=content, format="png"), "a.bag")
