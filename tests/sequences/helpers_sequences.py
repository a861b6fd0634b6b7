"""Make tiny images and videos that encode frame numbers, so that tests can detect a wrong frame."""

from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

WIDTH, HEIGHT = 64, 48


def coded(number: int, width: int = WIDTH, height: int = HEIGHT) -> NDArray[np.uint8]:
    """Encode a number as eight black or white columns, which remain readable after lossy compression."""
    bits = (number >> np.arange(8)) & 1
    columns = np.repeat(bits * 255, -(-width // 8))[:width].astype(np.uint8)
    return np.ascontiguousarray(np.broadcast_to(columns[None, :, None], (height, width, 3)))


def decoded(image: NDArray[np.uint8]) -> int:
    """Decode the number in an image made by `coded`."""
    means = image.reshape(image.shape[0], 8, -1).mean(axis=(0, 2))
    return int(((means > 127) << np.arange(8)).sum())


def write_image(path: Path, number: int, **size: int) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    assert cv2.imwrite(str(path), coded(number, **size))


def write_video(path: Path, count: int, fps: float = 25.0, codec: str = "MJPG") -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    writer = cv2.VideoWriter(str(path), cv2.VideoWriter.fourcc(*codec), fps, (WIDTH, HEIGHT))
    assert writer.isOpened()
    for number in range(count):
        writer.write(coded(number))
    writer.release()
