"""Decode ROS image messages: sensor_msgs/Image and sensor_msgs/CompressedImage."""

from typing import Any, Protocol

import cv2
import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError
from placecat.footage.pictures import MOST_BYTES, check_size, decode_image


class Damaged(PlacecatError):
    """An image that cannot be decoded; others in the same recording may be intact."""


class Image(Protocol):
    """A sensor_msgs/Image from any library; ``data`` is a buffer of bytes."""

    width: int
    height: int
    step: int
    encoding: str
    data: Any


class CompressedImage(Protocol):
    """A sensor_msgs/CompressedImage from any library."""

    format: str
    data: Any


# The sensor_msgs/image_encodings with 8 bits per channel. Each maps to its bytes per pixel in a row and its
# OpenCV conversion to BGR. "yuv422" is what ROS calls UYVY.
_ENCODINGS: dict[str, tuple[int, int | None]] = {
    "bgr8": (3, None),
    "8UC3": (3, None),
    "rgb8": (3, cv2.COLOR_RGB2BGR),
    "bgra8": (4, cv2.COLOR_BGRA2BGR),
    "8UC4": (4, cv2.COLOR_BGRA2BGR),
    "rgba8": (4, cv2.COLOR_RGBA2BGR),
    "mono8": (1, cv2.COLOR_GRAY2BGR),
    "8UC1": (1, cv2.COLOR_GRAY2BGR),
    "bayer_rggb8": (1, cv2.COLOR_BayerRGGB2BGR),
    "bayer_bggr8": (1, cv2.COLOR_BayerBGGR2BGR),
    "bayer_gbrg8": (1, cv2.COLOR_BayerGBRG2BGR),
    "bayer_grbg8": (1, cv2.COLOR_BayerGRBG2BGR),
    "yuv422": (2, cv2.COLOR_YUV2BGR_UYVY),
    "uyvy": (2, cv2.COLOR_YUV2BGR_UYVY),
    "yuv422_yuy2": (2, cv2.COLOR_YUV2BGR_YUYV),
    "yuyv": (2, cv2.COLOR_YUV2BGR_YUYV),
    "nv21": (1, cv2.COLOR_YUV2BGR_NV21),
}
ENCODINGS = tuple(_ENCODINGS)
"""Supported encodings of sensor_msgs/Image."""


def raw_image(message: Image, name: str) -> NDArray[np.uint8]:
    """Decode a sensor_msgs/Image to (height, width, 3) uint8 BGR; errors refer to it as `name`.

    Raises PlacecatError if the encoding is not in `ENCODINGS` or the image has more pixels than
    `placecat.footage.pictures.MOST_PIXELS`, and Damaged if the dimensions do not match the length of the
    data.
    """
    width, height, step, encoding = message.width, message.height, message.step, message.encoding
    data = np.frombuffer(message.data, np.uint8)
    if encoding not in _ENCODINGS:
        raise PlacecatError(
            f"{name}: the encoding {encoding!r} is not supported; choose another topic, or convert the "
            f"images to one of {', '.join(ENCODINGS)}."
        )
    check_size(name, width, height)
    depth, conversion = _ENCODINGS[encoding]
    # In nv21, the colour rows follow the luminance rows.
    rows, row = height * 3 // 2 if encoding == "nv21" else height, width * depth
    if not (width and height and row <= step and rows * step <= len(data)):
        raise Damaged(
            f"{name}: {width}x{height} pixels in {encoding} with rows of {step} bytes do not match "
            f"{len(data)} bytes of data; record it again."
        )
    pixels = data[: rows * step].reshape(rows, step)[:, :row].copy()
    pixels = pixels.reshape((rows, width) if depth == 1 else (rows, width, depth))
    if conversion is None:
        return pixels
    try:
        return cv2.cvtColor(pixels, conversion)  # type: ignore[return-value]
    except cv2.error:
        raise Damaged(
            f"{name}: an image in {encoding} cannot be {width}x{height} pixels; record it again."
        ) from None


def compressed_image(message: CompressedImage, name: str) -> NDArray[np.uint8]:
    """Decode a sensor_msgs/CompressedImage to (H, W, 3) uint8 BGR; errors refer to it as `name`.

    The content determines the format; the ``format`` field is ignored. Raises Damaged if the image is
    truncated, damaged, or not a JPEG or PNG that :func:`placecat.footage.pictures.decode_image` accepts.
    """
    content = memoryview(message.data)
    if content.nbytes > MOST_BYTES:
        raise Damaged(f"{name}: {content.nbytes / 1e6:.0f} MB is too large for an image; record it again.")
    try:
        return decode_image(content.tobytes(), f"{name} (format {message.format!r})")
    except PlacecatError as error:
        raise Damaged(str(error)) from None
