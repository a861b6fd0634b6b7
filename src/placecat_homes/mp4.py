"""Read frame sizes in bytes from the index of an MP4 file (ISO/IEC 14496-12)."""

import struct
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError


def frame_sizes(path: Path) -> NDArray[np.int64]:
    """Return the size in bytes of each frame in the first video track, in display order."""
    tracks = [
        _boxes(track)[b"mdia"] for kind, track in _walk(_boxes(path.read_bytes())[b"moov"]) if kind == b"trak"
    ]
    media = next(boxes for boxes in map(_boxes, tracks) if boxes[b"hdlr"][8:12] == b"vide")
    index = _boxes(_boxes(media[b"minf"])[b"stbl"])
    same, count = struct.unpack(">II", index[b"stsz"][4:12])
    sizes = np.full(count, same) if same else np.frombuffer(index[b"stsz"], ">u4", count, 12)
    shown = np.concatenate([[0], np.cumsum(_runs(index[b"stts"], count))[:-1]])
    if b"ctts" in index:
        shown = shown + _runs(index[b"ctts"], count)
    return sizes.astype(np.int64)[np.argsort(shown, kind="stable")]


def _walk(data: bytes) -> list[tuple[bytes, bytes]]:
    """Split bytes into boxes, and return the kind and content of each."""
    found, start = [], 0
    while start + 8 <= len(data):
        size, kind = struct.unpack_from(">I4s", data, start)
        head = 8
        if size == 1:
            head, size = 16, struct.unpack_from(">Q", data, start + 8)[0]
        end = start + size if size else len(data)
        found.append((kind, data[start + head : end]))
        start = end
    return found


def _boxes(data: bytes) -> dict[bytes, bytes]:
    return dict(_walk(data))


def _runs(box: bytes, count: int) -> NDArray[np.int64]:
    """Expand a table of (number of frames, value) pairs to one value per frame."""
    table = np.frombuffer(box, ">i4", offset=8).reshape(-1, 2)
    values = np.repeat(table[:, 1], table[:, 0]).astype(np.int64)
    if len(values) != count:
        raise PlacecatError(f"the video's index has {len(values)} timestamps for {count} frames")
    return values
