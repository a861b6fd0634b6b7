"""List and decode the image files in a folder.

A frame is a JPEG or PNG file. Other kinds of images raise an error, because skipping them silently could
lose frames.
"""

import re
import stat
import struct
import zlib
from collections.abc import Iterable
from pathlib import Path

import cv2
import numpy as np
import simplejpeg
from numpy.typing import NDArray

from placecat.errors import PlacecatError
from placecat.footage.names import natural

SUFFIXES = (".jpeg", ".jpg", ".png")
"""Suffixes of frame files, in upper or lower case."""
# Images with these suffixes raise an error, because their formats lose quality, are slow to decode, or need
# uncommon libraries.
_OTHERS = (
    ".apng .arw .avif .bmp .cr2 .cr3 .dib .dng .exr .gif .hdr .heic .heif .jfif .jp2 .jpe .jxl .nef .pbm .pgm"
    " .pnm .ppm .tga .tif .tiff .webp"
)
OTHERS = tuple(_OTHERS.split())
# Decoding needs up to 12 bytes per pixel (progressive JPEG), so this limit keeps memory below 1 GB.
MOST_PIXELS = 50_000_000
MOST_BYTES = 256_000_000

TURNS = {90: cv2.ROTATE_90_CLOCKWISE, 180: cv2.ROTATE_180, 270: cv2.ROTATE_90_COUNTERCLOCKWISE}
"""Maps clockwise angles in degrees to OpenCV rotation codes. :func:`turned` also accepts 0."""

_NUMBER = re.compile(r"[0-9]+")
# Only one decimal point is allowed: 1.2.3 is not a number.
_DECIMAL = re.compile(r"(?<![0-9.])([0-9]+)\.([0-9]+)(?!\.?[0-9])")
_PNG = b"\x89PNG\r\n\x1a\n"
_JPEG = b"\xff\xd8\xff"


def list_frames(folder: Path) -> list[str]:
    """List a folder's frames in order.

    Numbers in names are compared as numbers (frame2 before frame10), including decimal numbers such as times
    (1.25 before 1.5). If trailing zeros show that the digits after the point are a counter (1.9, 1.10), these
    digits are compared as a separate number. Hidden files and subfolders are ignored.

    Returns file names; the list may be empty. Raises PlacecatError if the folder cannot be read, contains
    other kinds of images, or contains two images of the same frame. Two images are taken to show the
    same frame if their names differ only in the suffix, or contain the same numbers but different words, such
    as colour and depth.
    """
    paths = _visible(folder)
    others = sorted(path.name for path in paths if path.suffix.lower() in OTHERS)
    if others:
        raise PlacecatError(
            f"{folder / others[0]}: this kind of image is not supported ({len(others)} in this folder); "
            f"convert such images to {' or '.join(SUFFIXES)}, or remove them from the folder."
        )
    names = in_order(path.name for path in paths if path.suffix.lower() in SUFFIXES)
    numbers = [tuple(_NUMBER.findall(Path(name).stem)) for name in names]
    # Numbers that are the same in every name are not frame numbers.
    are_counted = len(set(numbers)) > 1
    seen: dict[object, str] = {}
    for name, own in zip(names, numbers, strict=True):
        for key in (Path(name).stem.casefold(), own if are_counted and own else name):
            first = seen.setdefault(key, name)
            if first != name:
                raise PlacecatError(
                    f"{folder / name}: judging by its name, this is the same frame as {first}, perhaps "
                    "as colour and depth, or from two cameras; keep one image per frame, or number all "
                    "images consecutively."
                )
    return names


def in_order(names: Iterable[str]) -> list[str]:
    """Sort file names as `list_frames` does."""
    files = list(names)
    decimals = [found[2] for name in files for found in _DECIMAL.finditer(Path(name).stem)]
    # Decimals of equal length sort the same either way.
    are_decimals = not any(len(digits) > 1 and digits.endswith("0") for digits in decimals)
    if not are_decimals or len({len(digits) for digits in decimals}) < 2:
        return sorted(files, key=natural)
    width = max(map(len, decimals))
    padded = {
        name: _DECIMAL.sub(lambda found: f"{found[1]}.{found[2].ljust(width, '0')}", Path(name).stem)
        for name in files
    }
    return sorted(files, key=lambda name: (natural(padded[name]), natural(name)))


def read_image(path: Path) -> NDArray[np.uint8]:
    """Decode a JPEG or PNG file to (H, W, 3) uint8 BGR, rotated according to its EXIF data.

    A greyscale image is returned as three equal channels.

    Raises PlacecatError if the file is missing, cannot be opened, is neither JPEG nor PNG, is damaged or
    truncated, or is larger than `MOST_BYTES` or `MOST_PIXELS`. The same goes for depth images (16-bit
    greyscale) and for transparent, animated or CMYK images.
    """
    try:
        status = path.stat()
        if not stat.S_ISREG(status.st_mode):
            raise PlacecatError(f"{path}: the frame cannot be opened (not a file).")
        if status.st_size > MOST_BYTES:
            raise PlacecatError(
                f"{path}: {status.st_size / 1e6:.0f} MB is too large for a frame; remove or convert it."
            )
        content = path.read_bytes()
    except FileNotFoundError:
        raise PlacecatError(f"{path}: the frame is missing; restore it, or correct the label file.") from None
    except OSError as error:
        raise PlacecatError(f"{path}: the frame cannot be opened ({error.strerror}).") from None
    return decode_image(content, path)


def decode_image(content: bytes, path: Path | str) -> NDArray[np.uint8]:
    """Decode the content of a JPEG or PNG file as :func:`read_image` does; errors refer to it as `path`."""
    if content.startswith(_PNG):
        _check_png(path, content)
    elif content.startswith(_JPEG):
        _check_jpeg(path, content)
    else:
        raise _damaged(path, len(content), "neither JPEG nor PNG")
    image = cv2.imdecode(np.frombuffer(content, np.uint8), cv2.IMREAD_COLOR)
    if image is None:
        raise _damaged(path, len(content), "cut off or damaged?")
    return image  # type: ignore[return-value]


def turned(image: NDArray[np.uint8], degrees: int) -> NDArray[np.uint8]:
    """Rotate an image, (H, W, 3) uint8, clockwise by 0, 90, 180 or 270 degrees.

    Returns (H, W, 3) uint8, or (W, H, 3) for 90 and 270 degrees. For 0 degrees, returns `image` itself.
    Raises PlacecatError for other angles.
    """
    if degrees == 0:
        return image
    if degrees not in TURNS:
        raise PlacecatError(f"an image cannot be rotated by {degrees} degrees; choose 0, 90, 180 or 270.")
    return cv2.rotate(image, TURNS[degrees])  # type: ignore[return-value]


def _visible(folder: Path) -> list[Path]:
    try:
        return [path for path in folder.iterdir() if not path.name.startswith(".")]
    except OSError as error:
        raise PlacecatError(f"{folder}: the folder cannot be read ({error.strerror}).") from None


def check_size(path: Path | str, width: int, height: int) -> None:
    """Raise an error if an image has more than `MOST_PIXELS`, before memory is allocated for it."""
    if width * height > MOST_PIXELS:
        raise PlacecatError(
            f"{path}: {width}x{height} is more than {MOST_PIXELS // 10**6} million pixels; scale it down."
        )


def _damaged(path: Path | str, size: int, why: str) -> PlacecatError:
    return PlacecatError(f"{path}: not a readable image ({size} bytes; {why}); restore or remove the file.")


def _check_jpeg(path: Path | str, content: bytes) -> None:
    """Raise an error if a JPEG uses CMYK colours, is too large, or is damaged.

    OpenCV hides damage by filling in the areas that it cannot decode.
    """
    try:
        height, width, colors, _ = simplejpeg.decode_jpeg_header(content)
        check_size(path, width, height)
        if colors in ("CMYK", "YCCK"):
            raise PlacecatError(f"{path}: it uses {colors}, a colour model for printing; convert it to RGB.")
        # Decoding to greyscale at an eighth of the width and height takes a fifth of the time.
        simplejpeg.decode_jpeg(content, "GRAY", min_height=1, min_width=1, min_factor=8)
    except PlacecatError:
        raise
    except ValueError as error:
        raise _damaged(path, len(content), f"cut off or damaged: {error}") from None


def _check_png(path: Path | str, content: bytes) -> None:
    """Raise an error if a PNG has a chunk with a wrong checksum, or is of a kind that cannot be a frame."""
    kinds: set[bytes] = set()
    at = len(_PNG)
    while b"IEND" not in kinds:
        length = int.from_bytes(content[at : at + 4], "big")
        end = at + 8 + length
        if content[end : end + 4] != struct.pack(">I", zlib.crc32(content[at + 4 : end])):
            raise _damaged(path, len(content), "cut off or damaged")
        if not kinds and (content[at + 4 : at + 8] != b"IHDR" or length != 13):
            raise _damaged(path, len(content), "it does not begin with its size")
        kinds.add(content[at + 4 : at + 8])
        at = end + 4
    width, height, depth, color = struct.unpack_from(">IIBB", content, len(_PNG) + 8)
    check_size(path, width, height)
    if depth == 16 and color in (0, 4):
        raise PlacecatError(
            f"{path}: it is a 16-bit greyscale image, such as a depth image; remove it from the "
            "folder, or convert it."
        )
    if b"acTL" in kinds:
        raise PlacecatError(f"{path}: the image is animated; remove it, or save its frames one by one.")
    if (color in (4, 6) or b"tRNS" in kinds) and _is_transparent(content):
        raise PlacecatError(f"{path}: parts of it are transparent; save it without transparency.")


def _is_transparent(content: bytes) -> bool:
    image = cv2.imdecode(np.frombuffer(content, np.uint8), cv2.IMREAD_UNCHANGED)
    if image is None or image.ndim < 3 or image.shape[2] < 4:
        return False
    return bool((image[:, :, 3] < (255 if image.dtype == np.uint8 else 65535)).any())
