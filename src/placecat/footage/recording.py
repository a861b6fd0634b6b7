"""Read the frames of a video file with their numbers and times, and find lost and damaged frames."""

import bisect
from collections.abc import Generator, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from fractions import Fraction
from itertools import chain
from pathlib import Path
from typing import cast

import av
import cv2
import numpy as np
from av.video.frame import VideoFrame
from av.video.reformatter import VideoReformatter
from av.video.stream import VideoStream
from numpy.typing import NDArray

from placecat.errors import PlacecatError
from placecat.footage import streams, timing
from placecat.footage.pictures import TURNS

Size = tuple[int, int]

MOST_PIXELS = 2**26
"""Maximum number of pixels in a frame; 8K video has half as many."""
_FLATTEST = 4.0
# Playlist formats are excluded, because FFmpeg would open the files and URLs that they list.
_FORMATS = "asf,avi,flv,h264,hevc,m4v,matroska,mov,mpeg,mpegts,mpegvideo,ogg"
_OPENING = {"format_whitelist": _FORMATS, "protocol_whitelist": "file"}
# BT.2020 colours, common in HDR video from phones, are converted to BT.709 if swscale supports their transfer
# curve.
_WIDE, _CURVES, _USUAL = 9, (14, 15, 16, 18), 1


class _Damaged(Exception):
    """The decoder reported an error."""


@dataclass(frozen=True, eq=False)
class Picture:
    """A decoded frame.

    `number` is the frame's number in the file, counted from 1, including lost frames. `size` is its (width,
    height) as displayed: upright, with square pixels.
    """

    number: int
    size: Size
    _recording: "Recording"
    _frame: VideoFrame

    def image(self) -> NDArray[np.uint8]:
        """Return the pixels: (height, width, 3) uint8, BGR."""
        return self._recording.convert(self._frame)


class Recording:
    """A video file, read by FFmpeg.

    Opening reads all packets without decoding them. Every packet of the video stream counts as a frame with a
    time. A frame that cannot be decoded is lost, but later frames keep their numbers and times. `count` is
    the number of frames, including lost ones. `positions` holds the integers from 0 to `count` - 1, (count,)
    int64. Raises PlacecatError if the file is missing or not a video.
    """

    def __init__(self, path: Path) -> None:
        if not path.is_file():
            raise PlacecatError(f"{path}: the video is missing; restore it, or correct dataset.homes.")
        self.path = path
        self._is_careful = False
        self._start()
        self._reformatter = VideoReformatter()
        with self._opened() as (container, stream):
            self._read_index(container, stream)
            self._rates = (stream.average_rate, stream.guessed_rate)

    def size(self) -> Size:
        """Return the (width, height) of the first frame as displayed, in pixels.

        Raises PlacecatError if no frame is readable.
        """
        first = next(self.pictures(), None)
        if first is None:
            raise self._empty()
        return first.size

    def timing(self, fps: float | None = None, setting: str = "dataset.fps") -> timing.Timing:
        """Return the times of all frames: those in the file or, with `fps`, evenly spaced times.

        Raises PlacecatError if the times in the file are missing or implausible. The message names the
        `setting` for the frame rate.
        """
        if fps is not None:
            return timing.even(self.count, fps)
        if self._ticks is not None:
            found = timing.measure(self._ticks, self._tick, self._last, self._rates)
        else:
            found = timing.usual(self.count, self._rates)
        if found is None:
            texts = ", ".join(sorted({f"{float(rate):g}" for rate in self._rates if rate})) or "none"
            raise PlacecatError(
                f"{self.path}: the video has no plausible times for its frames (its frame rate: {texts}); "
                f"set the frame rate with {setting}."
            )
        timing.check_gaps(found, str(self.path), setting)
        return found

    def pictures(self, first: int = 1) -> Generator[Picture, None, None]:
        """Decode frames in display order, starting at `first` and skipping lost frames.

        Decoding starts at the frame that `start_before` returns, so starting late in the file costs little.
        FFmpeg decodes several frames at once and does not report which one caused an error. After the first
        error, the file is decoded again from the beginning, one frame at a time.
        """
        self._start(first)
        start = self.start_before(first)
        while True:
            try:
                yield from self._decoded(start)
            except _Damaged:
                self._is_careful, start = True, 1
            else:
                self._reached = self.count
                return

    def start_before(self, number: int) -> int:
        """Return the last frame up to `number` where decoding can start without affecting the pixels."""
        after = bisect.bisect_right(self._fresh, number)
        return 1 if self._is_careful or after == 0 else self._fresh[after - 1]

    def _start(self, first: int = 1) -> None:
        self._erroneous: set[int] = set()
        self._seen: set[int] = set()
        self._before = self._reached = first - 1

    @property
    def lost(self) -> list[int]:
        """Numbers of the frames that the last pass could not decode."""
        return sorted(set(range(self._before + 1, self._reached + 1)) - self._seen)

    @property
    def damaged(self) -> list[int]:
        """Numbers of the frames that the last pass decoded with errors."""
        return sorted(self._erroneous & self._seen)

    def note(self) -> str:
        """Describe the damage that the last pass found; return "" if there was none."""
        parts = []
        if self.lost:
            parts.append(f"{named(self.lost)} of {self.count} cannot be decoded and {are(self.lost)} lost")
        if self.damaged:
            parts.append(f"{named(self.damaged)} {are(self.damaged)} damaged")
        if parts:
            parts.append("later frames may be damaged up to the next key frame")
        if self._reached == self.count:
            parts += self._unread
        return f"{self.path}: {'; '.join(parts)}. Restore the file if you can." if parts else ""

    def convert(self, frame: VideoFrame) -> NDArray[np.uint8]:
        """Convert a decoded frame to pixels for `Picture.image`."""
        is_wide = frame.color_primaries == _WIDE and frame.color_trc in _CURVES
        usual = _USUAL if is_wide else None
        # These settings reproduce OpenCV's output exactly.
        changed = self._reformatter.reformat(
            frame,
            *self._square(frame),
            "bgr24",
            interpolation="BICUBIC",
            dst_color_trc=usual,
            dst_color_primaries=usual,
            threads=1,
        )
        image = changed.to_ndarray()
        turn = TURNS.get(-frame.rotation % 360)
        return cast(NDArray[np.uint8], image if turn is None else cv2.rotate(image, turn))

    def _square(self, frame: VideoFrame) -> Size:
        """Return the size in square pixels, before rotation."""
        return max(1, round(frame.width * self._flatness)), frame.height

    def _shown(self, frame: VideoFrame) -> Size:
        width, height = self._square(frame)
        return (height, width) if frame.rotation % 360 in (90, 270) else (width, height)

    @contextmanager
    def _opened(self) -> Iterator[tuple[av.container.InputContainer, VideoStream]]:
        # Count FFmpeg's errors instead of printing them.
        av.logging.set_level(av.logging.PANIC)
        try:
            container = av.open(str(self.path.absolute()), options=_OPENING, metadata_errors="replace")
        except PermissionError as error:
            raise PlacecatError(f"{self.path}: the video cannot be opened ({error.strerror}).") from None
        except (OSError, av.FFmpegError, ValueError):
            raise self._unreadable() from None
        with container:
            stream = self._stream(container)
            try:
                yield container, stream
            finally:
                streams.drain(stream)

    def _unreadable(self) -> PlacecatError:
        return PlacecatError(
            f"{self.path}: not a readable video (damaged, or a codec that FFmpeg lacks); convert it."
        )

    def _empty(self) -> PlacecatError:
        return PlacecatError(f"{self.path}: the video has no readable frames; restore or convert it.")

    def _stream(self, container: av.container.InputContainer) -> VideoStream:
        """Return the first video stream, ignoring the cover art of music files."""
        cover = av.stream.Disposition.attached_pic
        videos = [one for one in container.streams.video if not one.disposition & cover]
        if not videos:
            if container.streams.video:
                raise PlacecatError(
                    f"{self.path}: the file contains a cover image but no video; use a video file."
                )
            raise self._unreadable()
        stream = videos[0]
        if stream.codec_context is None:
            raise self._unreadable()
        ratio = stream.sample_aspect_ratio
        self._flatness = float(ratio) if ratio else 1.0
        if not 1 / _FLATTEST <= self._flatness <= _FLATTEST:
            raise PlacecatError(
                f"{self.path}: according to the header, pixels are {self._flatness:.4g} times as wide as "
                "they are high, which is implausible; convert the video to square pixels."
            )
        stream.codec_context.options = {"max_pixels": str(MOST_PIXELS)}
        # Worker processes of `placecat.compute.parallel` have one thread. With more threads, FFmpeg would use
        # 20% more CPU time.
        if self._is_careful or cv2.getNumThreads() == 1:
            stream.codec_context.thread_count = 1
            stream.thread_type = "NONE"
        else:
            stream.thread_type = "AUTO"
        return stream

    def _read_index(self, container: av.container.InputContainer, stream: VideoStream) -> None:
        """Find the timestamps of all frames, and check whether the file is complete."""
        name = container.format.name
        # Frames removed by an edit list do not count.
        entries = [entry for entry in stream.index_entries if not entry.is_discard] if "mov" in name else []
        announced = stream.frames if name == "avi" else len(entries)
        stamps: list[tuple[int | None, int | None]] = []
        fresh: list[int | None] = []
        packets, furthest, before = 0, 0.0, streams.errors()
        self._last = 0
        latest = -(2**63)
        for packet in streams.packets(container):
            if packet.pts is not None and packet.time_base is not None:
                furthest = max(furthest, float((packet.pts + (packet.duration or 0)) * packet.time_base))
            if packet.stream_index != stream.index:
                continue
            packets += not packet.is_discard
            if streams.is_frame(packet, stream):
                stamps.append((packet.pts, packet.dts))
                if streams.is_fresh(packet, stream):
                    fresh.append(packet.pts)
                if packet.pts is not None and packet.pts > latest:
                    latest, self._last = packet.pts, packet.duration or 0
        if not stamps:
            raise self._empty()
        self.count, self._tick = len(stamps), stream.time_base or Fraction(1)
        self.positions = np.arange(self.count)
        shown, coded = zip(*stamps, strict=True)
        # AVI stores only decoding times.
        are_distinct = None not in shown and len(set(shown)) == len(shown)
        is_known = name != "avi" and are_distinct and streams.run_forward(coded)
        self._numbers = {pts: number for number, pts in enumerate(sorted(shown), 1)} if is_known else {}
        self._fresh = sorted(self._numbers[pts] for pts in fresh if pts in self._numbers)
        times = shown if is_known else coded
        usable = is_known or (None not in coded and streams.run_forward(coded))
        self._ticks = np.array(sorted(times), np.int64) if usable else None
        self._unread: list[str] = []
        if announced > packets:
            self._unread.append(
                f"only {packets} of the {announced} frames listed in the file can be read: it may be "
                "cut off or damaged"
            )
        elif "mov" not in name and streams.errors() > before:
            self._unread.append("the file itself is damaged: more frames may be missing")
        # Other formats do not store their duration.
        elif ("matroska" in name or "mov" in name) and container.duration is not None:
            until = (container.duration + (container.start_time or 0)) / 1e6
            if until - furthest > 0.25:
                self._unread.append(f"it ends {until - furthest:.1f} s early: it may be cut off")

    def _decoded(self, start: int) -> Generator[Picture, None, None]:
        """Decode once, starting at frame `start`, but yield only frames after `_reached`.

        Raises _Damaged if an error occurs while several frames are decoded at once.
        """
        given, last, is_in = self._reached, start - 1, start == 1
        with self._opened() as (container, stream):
            codec = stream.codec_context
            for packet in chain(streams.packets(container, stream), [None]):
                is_in = is_in or packet is None or self._numbers.get(packet.pts) == start
                if not is_in:
                    continue
                before, failed = streams.errors(), False
                try:
                    frames = codec.decode(packet)
                except av.FFmpegError:
                    frames, failed = [], True
                if failed or streams.errors() > before:
                    if not self._is_careful:
                        raise _Damaged
                    if packet is not None and packet.pts in self._numbers:
                        self._erroneous.add(self._numbers[packet.pts])
                    elif not self._numbers:
                        last += failed
                        self._erroneous |= set() if failed else {last + 1}
                if packet is not None and packet.is_corrupt and packet.pts in self._numbers:
                    self._erroneous.add(self._numbers[packet.pts])
                for frame in frames:
                    number = self._numbers.get(frame.pts, last + 1)
                    if not last < number <= self.count:
                        continue
                    last = number
                    if number > given:
                        self._seen.add(number)
                        self._reached = number
                        if frame.is_corrupt:
                            self._erroneous.add(number)
                        yield Picture(number, self._shown(frame), self, frame)


def are(numbers: list[int]) -> str:
    """Return "is" for a single frame and "are" for several."""
    return "are" if len(numbers) > 1 else "is"


def named(numbers: list[int], most: int = 5) -> str:
    """Return a phrase such as "frames 3, 7 to 9"."""
    breaks = np.flatnonzero(np.diff(numbers) > 1) + 1
    runs = [part.tolist() for part in np.split(np.array(numbers), breaks)]
    texts = [f"{run[0]} to {run[-1]}" if len(run) > 1 else f"{run[0]}" for run in runs[:most]]
    more = f" and {sum(map(len, runs[most:]))} more" if len(runs) > most else ""
    return f"frame{'s' if len(numbers) > 1 else ''} {', '.join(texts)}{more}"
