import base64

import cv2
import numpy as np
import pytest

from placecat.report.embed import embed


def decoded(picture):
    kind, content = picture.source.removeprefix("data:image/").split(";base64,")
    pixels = cv2.imdecode(np.frombuffer(base64.b64decode(content), np.uint8), cv2.IMREAD_UNCHANGED)
    return kind, pixels


def png(pixels):
    return cv2.imencode(".png", pixels)[1].tobytes()


def test_a_photograph_becomes_smaller_and_looks_the_same():
    rng = np.random.default_rng(0)
    pixels = cv2.GaussianBlur(rng.integers(0, 255, (90, 160, 3), np.uint8), (0, 0), 3)
    file = png(pixels)
    picture = embed(file)
    kind, shown = decoded(picture)
    assert (kind, picture.width, picture.height) == ("webp", 160, 90)
    assert shown.shape == pixels.shape
    assert np.abs(shown.astype(int) - pixels).mean() < 3
    assert len(picture.source) < len(file)


def test_small_pictures_are_unchanged():
    pixels = np.random.default_rng(0).integers(0, 2, (64, 64, 1), np.uint8).repeat(3, axis=2) * 255
    kind, shown = decoded(embed(png(pixels)))
    assert kind == "png"
    assert (shown == pixels).all()


def test_embedding_is_deterministic():
    file = png(np.random.default_rng(1).integers(0, 255, (20, 30, 4), np.uint8))
    assert embed(file) == embed(file)


@pytest.mark.parametrize("content", [b"", b"GIF89a", b"\x89PNG\r\n\x1a\n"])
def test_files_that_are_not_pictures_are_rejected(content):
    with pytest.raises(ValueError, match="not an image"):
        embed(content)
