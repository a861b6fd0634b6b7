"""Encode frames into a video file that OpenCV can decode on every platform."""

from collections.abc import Iterable
from fractions import Fraction
from pathlib import Path
from typing import cast

import av
import numpy as np
from av.video.stream import VideoStream
from numpy.typing import NDArray


def write_video(
    path: Path, frames: Iterable[NDArray[np.uint8]], *, fps: int, codec: str, quality: int, preset: str
) -> int:
    """Encode frames and write them to a file.

    Parameters
    ----------
    path
        The .mp4 file to write.
    frames
        (height, width, 3) uint8, BGR. All must have the same size, with even width and height.
    fps
        Frames per second.
    codec
        Name of the encoder in FFmpeg.
    quality
        Constant rate factor; lower values give better quality and larger files.
    preset
        Speed preset of the encoder; slower presets give smaller files.

    Returns
    -------
    int
        Number of frames written.
    """
    count = 0
    with av.open(str(path), "w") as container:
        stream: VideoStream | None = None
        for frame in frames:
            if stream is None:
                # With one thread and no version string, the same frames always produce the same file.
                options = {"crf": str(quality), "preset": preset, "threads": "1"}
                stream = cast(VideoStream, container.add_stream(codec, rate=Fraction(fps), options=options))
                stream.height, stream.width = frame.shape[:2]
                stream.pix_fmt = "yuv420p"
                stream.codec_context.thread_count = 1
            picture = av.VideoFrame.from_ndarray(np.ascontiguousarray(frame), format="bgr24")
            for packet in stream.encode(picture):
                container.mux(packet)
            count += 1
        if stream is not None:
            for packet in stream.encode():
                container.mux(packet)
    return count
