"""Read packets and count decoder errors with PyAV."""

from collections.abc import Iterator, Sequence
from itertools import pairwise

import av
from av.video.stream import VideoStream

# Reading a file stops after this many consecutive errors.
_PATIENCE = 100
# Codecs whose key frames are independent: no frame after a key frame refers to a frame before it.
_FRESH = ("ffv1", "mjpeg", "png", "vp8", "vp9")
# In these two codecs, a size field precedes each unit. Each codec maps to the header position that stores the
# length of this field, the shift and mask that extract the type of a unit, and the types of IDR images
# (ITU-T H.264, 7.4.1; H.265, 7.4.2.2).
_UNITS = {"h264": (4, 0, 0x1F, (5,)), "hevc": (21, 1, 0x3F, (19, 20))}


def packets(container: av.container.InputContainer, stream: VideoStream | None = None) -> Iterator[av.Packet]:
    """Yield the packets of a file or of one of its streams, skipping damaged parts."""
    failures = 0
    while failures < _PATIENCE:
        try:
            for packet in container.demux(stream) if stream is not None else container.demux():
                failures = 0
                # An empty packet would end decoding.
                if packet.size:
                    yield packet
        except av.FFmpegError:
            failures += 1
        else:
            return


def is_frame(packet: av.Packet, stream: VideoStream) -> bool:
    """Return whether a packet contains a frame to be displayed.

    Some frames are removed by edit lists, and others serve only as references.
    """
    is_hidden = stream.codec_context.name in ("vp8", "libvpx") and not memoryview(packet)[0] & 0x10
    return not packet.is_discard and not is_hidden


def is_fresh(packet: av.Packet, stream: VideoStream) -> bool:
    """Return whether decoding can start at this packet without affecting the pixels.

    Not every key frame qualifies, because later frames may refer to frames before it. If in doubt, returns
    False.
    """
    codec = stream.codec_context
    if not packet.is_keyframe or codec.name not in _UNITS:
        return packet.is_keyframe and codec.name in _FRESH
    place, shift, mask, wanted = _UNITS[codec.name]
    header, content = codec.extradata or b"", memoryview(packet)
    # Without this header, any packet may contain parameter sets.
    if len(header) <= place or header[0] != 1:
        return False
    size, at = (header[place] & 3) + 1, 0
    while at + size < len(content):
        if content[at + size] >> shift & mask in wanted:
            return True
        at += size + int.from_bytes(content[at : at + size], "big")
    return False


def run_forward(stamps: Sequence[int | None]) -> bool:
    """Return whether the known timestamps increase."""
    return all(one < other for one, other in pairwise(one for one in stamps if one is not None))


def drain(stream: VideoStream) -> None:
    """Let the decoder threads finish.

    Otherwise, a thread that reports an error while Python closes the decoder would hang forever.
    """
    for _ in range(_PATIENCE):
        try:
            if not stream.codec_context.is_open or not stream.codec_context.decode(None):
                return
        except av.error.EOFError:
            return
        except av.FFmpegError:
            continue


def errors() -> int:
    """Return the number of errors that FFmpeg has reported in this process."""
    return av.logging.get_last_error()[0]
