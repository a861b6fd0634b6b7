"""Packets of a file and errors of a decoder, through PyAV."""

from collections.abc import Iterator
from itertools import pairwise

import av
from av.video.stream import VideoStream

# Errors in a row after which the rest of a file is given up.
_PATIENCE = 100
# Codecs whose key frames refer to no other frame and let no later one do so.
_FRESH = ("ffv1", "mjpeg", "png", "vp8", "vp9")
# For two others, with sizes of units: the place of their size in the header, the shift and mask of a unit's
# type, and the types of an IDR picture (ITU-T H.264, 7.4.1; H.265, 7.4.2.2).
_UNITS = {"h264": (4, 0, 0x1F, (5,)), "hevc": (21, 1, 0x3F, (19, 20))}


def packets(container: av.container.InputContainer, stream: VideoStream | None = None) -> Iterator[av.Packet]:
    """The packets of a file or of one of its streams; damaged places are passed over."""
    failures = 0
    while failures < _PATIENCE:
        try:
            for packet in container.demux(stream) if stream is not None else container.demux():
                failures = 0
                # An empty packet would end the decoding.
                if packet.size:
                    yield packet
        except av.FFmpegError:
            failures += 1
        else:
            return


def is_frame(packet: av.Packet, stream: VideoStream) -> bool:
    """Whether a packet is shown: not if an edit list cuts it off, or if other frames only refer to it."""
    is_hidden = stream.codec_context.name in ("vp8", "libvpx") and not memoryview(packet)[0] & 0x10
    return not packet.is_discard and not is_hidden


def is_fresh(packet: av.Packet, stream: VideoStream) -> bool:
    """Whether the frames from this packet on are the same bytes if decoding starts here.

    Not every key frame is one: frames after it may refer to frames before it. False where that is unknown.
    """
    codec = stream.codec_context
    if not packet.is_keyframe or codec.name not in _UNITS:
        return packet.is_keyframe and codec.name in _FRESH
    place, shift, mask, wanted = _UNITS[codec.name]
    header, content = codec.extradata or b"", memoryview(packet)
    # Without this header, parameters may stand in any packet.
    if len(header) <= place or header[0] != 1:
        return False
    size, at = (header[place] & 3) + 1, 0
    while at + size < len(content):
        if content[at + size] >> shift & mask in wanted:
            return True
        at += size + int.from_bytes(content[at : at + size], "big")
    return False


def is_cover(stream: VideoStream) -> bool:
    """Whether a stream is the cover picture of a music file."""
    return bool(stream.disposition & av.stream.Disposition.attached_pic)


def are_times(stamps: tuple[int | None, ...]) -> bool:
    """Whether all timestamps are known and differ."""
    return None not in stamps and len(set(stamps)) == len(stamps)


def run_forward(stamps: tuple[int | None, ...]) -> bool:
    """Whether each timestamp that is known is later than the one before."""
    known = [one for one in stamps if one is not None]
    return all(one < other for one, other in pairwise(known))


def drain(stream: VideoStream) -> None:
    """Let the decoder's threads end: one that reports an error while Python closes it waits for ever."""
    for _ in range(_PATIENCE):
        try:
            if not stream.codec_context.is_open or not stream.codec_context.decode(None):
                return
        except av.error.EOFError:
            return
        except av.FFmpegError:
            continue


def errors() -> int:
    """How many errors FFmpeg has reported in this process."""
    return av.logging.get_last_error()[0]
