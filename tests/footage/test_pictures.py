"""Tests of frame files, and of images that are damaged, huge, or of another kind."""

import random
import re
import struct
import zlib
from pathlib import Path

import cv2
import numpy as np
import pytest
import simplejpeg
from helpers_sequences import coded, decoded

from placecat.errors import PlacecatError
from placecat.footage import pictures
from placecat.footage.pictures import in_order, list_frames, read_image

PHOTO = cv2.resize(np.random.default_rng(0).integers(0, 256, (30, 40, 3), np.uint8), (320, 240))


def encoded(kind: str, image=PHOTO, *options: int) -> bytes:
    return cv2.imencode(kind, image, options)[1].tobytes()


def png(*chunks: tuple[bytes, bytes]) -> bytes:
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))
        for kind, content in chunks
    )


def header(width: int, height: int, depth: int = 8, color: int = 2) -> tuple[bytes, bytes]:
    return b"IHDR", struct.pack(">IIBBBBB", width, height, depth, color, 0, 0, 0)


def huge_jpeg() -> bytes:
    """Return a small image whose header declares a size of 60000x60000."""
    content = bytearray(encoded(".jpg"))
    at = content.index(b"\xff\xc0") + 5
    content[at : at + 4] = struct.pack(">HH", 60000, 60000)
    return bytes(content)


def with_exif(content: bytes, orientation: int) -> bytes:
    tiff = b"II*\x00\x08\x00\x00\x00\x01\x00" + struct.pack("<HHIHH", 0x112, 3, 1, orientation, 0) + bytes(4)
    exif = b"Exif\x00\x00" + tiff
    return content[:2] + b"\xff\xe1" + struct.pack(">H", len(exif) + 2) + exif + content[2:]


def filled(folder: Path, *names: str) -> Path:
    for name in names:
        (folder / name).write_bytes(b"x")
    return folder


def refused(message: str, function, *arguments) -> None:
    with pytest.raises(PlacecatError, match=message) as caught:
        function(*arguments)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    "ordered",
    [
        ["f1.jpg", "f2.PNG", "f10.jpeg"],
        ["1699999999.0.png", "1699999999.123456.png", "1699999999.5.png", "1700000000.25.png"],
        ["t0.125.jpg", "t0.25.jpg", "t0.5.jpg", "t12.0.jpg"],
        ["1156.000001_x1.jpeg", "1156.999999_x1.jpeg", "1157.000001_x0.jpeg"],
        # These are two counters, not a decimal number.
        ["seq1.9.png", "seq1.10.png", "seq1.11.png", "seq2.1.png"],
        ["1.2.9.png", "1.2.10.png"],
    ],
)
def test_numbers_in_names_are_numbers(ordered, tmp_path):
    mixed = ordered.copy()
    random.Random(1).shuffle(mixed)
    assert in_order(mixed) == ordered
    assert list_frames(filled(tmp_path, *mixed)) == ordered


@pytest.mark.parametrize(
    ("names", "message"),
    [
        (["1.jpg", "1.png"], r"1\.png: judging by its name, this is the same frame as 1\.jpg"),
        (["1.jpg", "1.JPEG"], "the same frame"),
        (
            ["rgb_1.jpg", "rgb_2.jpg", "depth_1.png", "depth_2.png"],
            r"rgb_1\.jpg: judging by its name, this is the same frame as depth_1\.png",
        ),
        (["0001.jpg", "0002.jpg", "0001_depth.png", "0002_depth.png"], "the same frame"),
        (["frame-1.color.png", "frame-2.color.png", "frame-1.depth.png"], "the same frame"),
        (["1.jpg", "2.webp"], r"2\.webp: this kind of image is not supported \(1 in this folder\)"),
        *(
            (["1.jpg", f"2.{kind}", f"3.{kind}"], r"\(2 in this folder\)")
            for kind in ("bmp", "tif", "TIFF", "heic", "gif")
        ),
    ],
)
def test_possible_frames_are_never_skipped_silently(names, message, tmp_path):
    refused(message, list_frames, filled(tmp_path, *names))


def test_other_files_and_hidden_ones_are_no_frames(tmp_path):
    filled(tmp_path, "1.JPG", "2.jpg", "._1.jpg", ".2.webp", "labels.csv", "notes.txt", "poses.json")
    assert list_frames(tmp_path) == ["1.JPG", "2.jpg"]
    # Names without numbers are different frames, sorted alphabetically.
    assert list_frames(filled(tmp_path, "bath.jpg", "hall.jpg")) == ["1.JPG", "2.jpg", "bath.jpg", "hall.jpg"]


@pytest.mark.parametrize(
    ("kind", "options"),
    [
        (".jpg", ()),
        (".jpg", (cv2.IMWRITE_JPEG_PROGRESSIVE, 1)),
        (".jpg", (cv2.IMWRITE_JPEG_RST_INTERVAL, 4)),
        (".png", ()),
    ],
)
def test_a_picture_damaged_in_the_middle_or_cut_is_refused(kind, options, tmp_path, capfd):
    content, file = encoded(kind, PHOTO, *options), tmp_path / f"1{kind}"
    file.write_bytes(content)
    np.testing.assert_array_equal(
        read_image(file), cv2.imdecode(np.frombuffer(content, np.uint8), cv2.IMREAD_COLOR)
    )
    middle = len(content) // 2
    for damaged in (
        content[:middle] + bytes(2000) + content[middle + 2000 :],
        content[:middle],
        content[: len(content) - 40],
        content[:30],
        content[:3],
        b"",
    ):
        file.write_bytes(damaged)
        refused(re.escape(f"{file}: not a readable image ({len(damaged)} bytes; "), read_image, file)
    # The decoders themselves print nothing.
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (huge_jpeg(), "60000x60000 is more than 50 million pixels"),
        (png(header(60000, 60000), (b"IDAT", b""), (b"IEND", b"")), "60000x60000 is more than"),
        (
            png(header(5000, 5000), (b"IDAT", zlib.compress(bytes(99))), (b"IEND", b"")),
            "not a readable image",
        ),
        (png((b"tEXt", b""), header(5, 5), (b"IEND", b"")), "not a readable image"),
        (encoded(".png", np.full((9, 9), 700, np.uint16)), "16-bit greyscale image, such as a depth image"),
        (encoded(".png", np.full((9, 9, 4), 100, np.uint8)), "parts of it are transparent"),
        (
            png(
                header(1, 1),
                (b"acTL", bytes(8)),
                (b"IDAT", zlib.compress(bytes(4))),
                (b"IEND", b""),
            ),
            "the image is animated",
        ),
        (simplejpeg.encode_jpeg(np.zeros((9, 9, 4), np.uint8), colorspace="CMYK"), "model for printing"),
        (encoded(".webp"), "neither JPEG nor PNG"),
        (encoded(".bmp"), "neither JPEG nor PNG"),
        (b"GIF89a" + bytes(50), "neither JPEG nor PNG"),
    ],
)
def test_pictures_that_are_no_frames_are_refused(content, message, tmp_path):
    file = tmp_path / "1.png"
    file.write_bytes(content)
    refused(rf"1\.png: .*{message}", read_image, file)


def test_gray_deep_and_opaque_pictures_are_right(tmp_path):
    for content in (
        encoded(".png", coded(5)[:, :, 0]),
        encoded(".jpg", coded(5)[:, :, 0]),
        encoded(".png", coded(5).astype(np.uint16) * 257),
        encoded(".png", np.dstack([coded(5), np.full((48, 64), 255, np.uint8)])),
    ):
        (tmp_path / "1.png").write_bytes(content)
        image = read_image(tmp_path / "1.png")
        assert (image.shape, image.dtype, decoded(image)) == ((48, 64, 3), np.uint8, 5)


def test_a_picture_is_turned_as_the_camera_was(tmp_path):
    # Orientation 6 means that the image must be rotated clockwise by 90 degrees.
    (tmp_path / "1.jpg").write_bytes(with_exif(encoded(".jpg", coded(5)), 6))
    image = read_image(tmp_path / "1.jpg")
    assert image.shape == (64, 48, 3)
    assert decoded(cv2.rotate(image, cv2.ROTATE_90_COUNTERCLOCKWISE)) == 5


def test_files_that_may_not_be_read_give_one_message(tmp_path, monkeypatch):
    def refuse(path, *_):
        raise PermissionError(13, "Permission denied", str(path))

    filled(tmp_path, "1.jpg")
    monkeypatch.setattr(Path, "read_bytes", refuse)
    refused(r"1\.jpg: the frame cannot be opened \(Permission denied\)", read_image, tmp_path / "1.jpg")
    monkeypatch.setattr(Path, "iterdir", refuse)
    refused(r"the folder cannot be read \(Permission denied\)", list_frames, tmp_path)


def test_a_file_larger_than_any_frame_is_not_read(tmp_path):
    with (tmp_path / "1.jpg").open("wb") as file:
        file.truncate(pictures.MOST_BYTES + 1)
    refused(r"1\.jpg: 256 MB is too large for a frame", read_image, tmp_path / "1.jpg")
