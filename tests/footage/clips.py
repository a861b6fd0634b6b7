"""Small videos like those from phones and browsers, and functions that damage them.

Each frame shows its own number.
"""

from fractions import Fraction
from pathlib import Path

import av
import numpy as np
from helpers_sequences import HEIGHT, WIDTH, coded, decoded

TICK = Fraction(1, 90000)
PLAIN = {"libx264": {"g": "12", "preset": "ultrafast"}}


def write_clip(
    path,
    times,
    *,
    codec="libx264",
    size=(WIDTH, HEIGHT),
    rate=30,
    tick=TICK,
    options=None,
    shape=None,
    turn=0,
    sound=False,
    color=None,
):
    """Write a video with one frame at each of the `times`, in seconds.

    `rate` is the frame rate in the header, `shape` is the pixel aspect ratio, and `turn` is the rotation of
    the phone in degrees. `sound` adds an audio packet every 5 ms.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    with av.open(str(path), "w", options={"movflags": "faststart"}) as container:
        stream = container.add_stream(codec, rate=rate, options=options or PLAIN.get(codec, {}))
        stream.width, stream.height = size
        stream.pix_fmt = "yuvj420p" if codec == "mjpeg" else "yuv420p"
        stream.time_base = stream.codec_context.time_base = tick
        if shape:
            stream.codec_context.sample_aspect_ratio = shape
        if turn:
            stream.set_display_rotation(turn)
        if color:
            stream.codec_context.colorspace = stream.codec_context.color_primaries = color
        audio = container.add_stream("pcm_s16le", rate=8000) if sound else None
        heard = 0
        for number, time in enumerate(times):
            picture = av.VideoFrame.from_ndarray(coded(number % 256, *size), format="bgr24")
            picture.pts, picture.time_base = round(time / tick), tick
            while audio is not None and heard < time * 8000:
                _sound(container, audio, heard)
                heard += 40
            container.mux(stream.encode(picture))
        container.mux(stream.encode())
    return path


def _sound(container, stream, start):
    packet = av.Packet(bytes(80))
    packet.stream, packet.pts, packet.dts, packet.time_base = stream, start, start, Fraction(1, 8000)
    container.mux(packet)


def steady(count, fps=30):
    return [number / fps for number in range(count)]


def packets(path):
    """Return the (position, size) of each video packet in the file, in file order."""
    with av.open(str(path)) as container:
        return [(packet.pos, packet.size) for packet in container.demux(video=0) if packet.size]


def zero(path, number, start=0):
    """Overwrite a packet with zeros from the byte `start` on; `number` counts from 1."""
    content = bytearray(path.read_bytes())
    position, size = packets(path)[number - 1]
    content[position + start : position + size] = bytes(size - start)
    path.write_bytes(content)


def flip(path, number, seed=0, bits=4):
    """Flip some bits in the middle of a packet; `number` counts from 1."""
    content = bytearray(path.read_bytes())
    position, size = packets(path)[number - 1]
    rng = np.random.default_rng(seed)
    for place in rng.integers(min(8, size // 2), size, bits):
        content[position + int(place)] ^= 1 << int(rng.integers(8))
    path.write_bytes(content)


def shown(recording):
    """Return the number and the content of every decoded frame."""
    return [(picture.number, decoded(picture.image())) for picture in recording.pictures()]


def intact(count):
    return [(number, (number - 1) % 256) for number in range(1, count + 1)]


def copied(source, target, *, key, start, rate=30):
    """Trim a video losslessly: its packets start at the frame `key`, but frames before `start` are hidden."""
    with av.open(str(source)) as old, av.open(str(target), "w") as new:
        stream = old.streams.video[0]
        copy = new.add_stream_from_template(stream)
        period = int(1 / stream.time_base / rate)
        is_in = False
        for packet in old.demux(stream):
            if not packet.size:
                continue
            is_in |= packet.is_keyframe and packet.pts >= key * period
            if is_in:
                packet.pts -= start * period
                packet.dts -= start * period
                packet.stream = copy
                new.mux(packet)
    return Path(target)


def turned_on_the_way(path):
    """Write a browser recording. The phone is rotated after five frames, which changes the frame size."""
    parts = [path.with_name("wide.webm"), path.with_name("high.webm")]
    write_clip(parts[0], steady(5), codec="libvpx", tick=Fraction(1, 1000))
    write_clip(parts[1], steady(5), codec="libvpx", tick=Fraction(1, 1000), size=(HEIGHT, WIDTH))
    with av.open(str(path), "w") as new:
        copy, offset = None, 0
        for part in parts:
            with av.open(str(part)) as old:
                copy = copy or new.add_stream_from_template(old.streams.video[0])
                for packet in old.demux(video=0):
                    if packet.size:
                        packet.pts, packet.dts, packet.stream = packet.pts + offset, packet.dts + offset, copy
                        new.mux(packet)
            offset += 200
    return path
