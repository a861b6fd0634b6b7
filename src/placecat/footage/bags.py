"""Read topics, images and strings from a ROS 1 or ROS 2 bag.

The rosbags library reads the bag and decodes messages using its built-in definitions. The definitions in the
bag are not used, because they are untrusted and rosbags would turn them into Python code.
"""

from collections.abc import Collection, Generator, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError, did_you_mean
from placecat.footage.image_messages import compressed_image, raw_image

ROS_1, SINGLE = ".bag", (".mcap", ".db3")
IMAGE, COMPRESSED, STRING = "sensor_msgs/msg/Image", "sensor_msgs/msg/CompressedImage", "std_msgs/msg/String"
_PICTURES = (IMAGE, COMPRESSED)
# Maps each suffix to the command that repairs a truncated bag; "" stands for a folder.
_MENDING = {
    ROS_1: "`rosbag reindex`",
    ".mcap": "`mcap recover`",
    ".db3": "`sqlite3 FILE .recover`",
    "": "`ros2 bag reindex`, and a damaged file in it with `mcap recover` or `sqlite3 FILE .recover`",
}


def is_bag(path: Path) -> bool:
    """Return whether a path is a bag: a file with a bag suffix, or a folder with the parts of a ROS 2 bag."""
    if path.is_dir():
        return any(one.name == "metadata.yaml" or one.suffix in SINGLE for one in path.iterdir())
    return path.suffix.lower() in (ROS_1, *SINGLE) and path.is_file()


@dataclass(frozen=True, eq=False)
class Picture:
    """A message with an image.

    `number` is the message's number among the image messages of all topics, counted from 1 in the order
    received. `received` is the reception time, and `stamp` is the time in the header, both in nanoseconds.
    """

    number: int
    received: int
    stamp: int
    _message: Any
    _name: str

    def image(self) -> NDArray[np.uint8]:
        """Decode to (H, W, 3) uint8 BGR; raises the same errors as `placecat.footage.image_messages`."""
        decode = compressed_image if hasattr(self._message, "format") else raw_image
        return decode(self._message, self._name)


class Bag:
    """A ROS 1 ``.bag``, a ROS 2 folder, or a single ROS 2 ``.mcap`` or ``.db3``.

    `topics` maps each topic, in sorted order, to its message type and number of messages. `count` is the
    number of messages with images. Each pass over the messages reopens the bag. Raises PlacecatError if
    rosbags is not installed or cannot read the bag.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self._is_ros1 = path.suffix.lower() == ROS_1
        topics: dict[str, tuple[str, int]] = {}
        with self._opened() as reader, self._explained():
            for one in reader.connections:
                _, count = topics.get(one.topic, ("", 0))
                topics[str(one.topic)] = (str(one.msgtype), count + int(one.msgcount))
        self.topics = dict(sorted(topics.items()))
        self.count = sum(count for kind, count in self.topics.values() if kind in _PICTURES)

    def topic_of_pictures(self, topic: str | None, setting: str) -> str:
        """Check the topic of the frames and return it; None chooses the only topic with images.

        Raises a PlacecatError that names the `setting` if the topic is wrong or the choice is ambiguous.
        """
        if topic is not None:
            self.require(topic, _PICTURES, setting)
            return topic
        having = [name for name, (kind, count) in self.topics.items() if kind in _PICTURES and count]
        if len(having) > 1:
            raise PlacecatError(
                f"{self.path}: several topics have images; choose one with {setting}: {', '.join(having)}."
            )
        if not having:
            raise PlacecatError(
                f"{self.path}: no topic has images ({IMAGE} or {COMPRESSED}); the bag has {self._listed()}."
            )
        return having[0]

    def require(self, topic: str, kinds: Collection[str], setting: str) -> None:
        """Raise an error if a topic is missing, empty, or of the wrong type."""
        if topic not in self.topics:
            raise PlacecatError(
                f"{self.path}: there is no topic {topic!r}{did_you_mean(topic, self.topics)}; the bag has "
                f"{self._listed()}. Correct {setting}."
            )
        kind, count = self.topics[topic]
        if kind not in kinds:
            raise PlacecatError(
                f"{self.path}: the topic {topic!r} has messages of type {kind}, not {' or '.join(kinds)}; "
                f"correct {setting}."
            )
        if not count:
            raise PlacecatError(f"{self.path}: the topic {topic!r} has no messages; correct {setting}.")

    def pictures(self, topic: str | None = None) -> Generator[Picture, None, None]:
        """Yield the images of one topic or of all topics in the order received, without decoding pixels.

        Images are numbered across all topics, even if only one topic is read.
        """
        for number, (connection, received, raw) in enumerate(self._messages(_PICTURES), 1):
            if topic is None or connection.topic == topic:
                name = f"{self.path}, image {number} ({connection.topic})"
                with self._explained():
                    message = self._decoded(raw, connection.msgtype)
                    stamp = message.header.stamp.sec * 10**9 + message.header.stamp.nanosec
                yield Picture(number, int(received), int(stamp), message, name)

    def strings(self, topic: str) -> Iterator[tuple[int, str]]:
        """Yield the reception time in nanoseconds and the text of each string on a std_msgs/String topic."""
        for connection, received, raw in self._messages((STRING,)):
            if connection.topic == topic:
                with self._explained():
                    text = str(self._decoded(raw, STRING).data)
                yield int(received), text

    def _listed(self) -> str:
        return ", ".join(f"{name} ({kind})" for name, (kind, _) in self.topics.items()) or "none"

    def _messages(self, kinds: Collection[str]) -> Generator[tuple[Any, int, bytes], None, None]:
        with self._opened() as reader:
            chosen = [one for one in reader.connections if one.msgtype in kinds]
            # Without connections, rosbags would return all messages.
            found = reader.messages(connections=chosen) if chosen else iter(())
            while True:
                with self._explained():
                    message = next(found, None)
                if message is None:
                    return
                yield message

    def _decoded(self, raw: bytes, kind: str) -> Any:
        store = _store(self._is_ros1)
        return store.deserialize_ros1(raw, kind) if self._is_ros1 else store.deserialize_cdr(raw, kind)

    @contextmanager
    def _opened(self) -> Iterator[Any]:
        try:
            from rosbags import rosbag1, rosbag2
        except ModuleNotFoundError as error:
            raise PlacecatError(
                f"{self.path}: bags need the optional extra ({error.name} is missing): "
                "pip install -e '.[robot]'"
            ) from None
        with self._explained():
            reader = rosbag1.Reader(self.path) if self._is_ros1 else rosbag2.Reader(self.path)
            reader.open()
        try:
            yield reader
        finally:
            reader.close()

    @contextmanager
    def _explained(self) -> Iterator[None]:
        """Convert any error to a PlacecatError, because rosbags may raise anything on a damaged bag."""
        try:
            yield
        except PermissionError as error:
            raise PlacecatError(
                f"{self.path}: the bag cannot be read ({error.strerror}); correct its permissions."
            ) from None
        except Exception as error:
            said = " ".join(str(error).split())[:300].rstrip(".") or type(error).__name__
            mending = _MENDING["" if self.path.is_dir() else self.path.suffix.lower()]
            raise PlacecatError(
                f"{self.path}: not a readable bag ({said}); restore it, or repair it with {mending}."
            ) from None


@cache
def _store(is_ros1: bool) -> Any:
    """Return the message definitions of ROS 1 or ROS 2; for images and strings, all versions agree."""
    from rosbags.typesys import Stores, get_typestore

    return get_typestore(Stores.ROS1_NOETIC if is_ros1 else Stores.ROS2_HUMBLE)
