"""A bag of ROS 1 or ROS 2: its topics, and the pictures and strings in it.

It is read by rosbags. Messages are decoded by the definitions that rosbags brings; out of those in a bag,
which come from outside, it would make Python code.
"""

from collections.abc import Collection, Generator, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError, did_you_mean
from placecat.footage.image_messages import compressed_image, raw_image

ROS_1, SINGLE = ".bag", (".mcap", ".db3")
IMAGE, COMPRESSED, STRING = "sensor_msgs/msg/Image", "sensor_msgs/msg/CompressedImage", "std_msgs/msg/String"
# What mends a bag whose end is missing, by its ending; "" is a folder.
_MENDING = {
    ROS_1: "rosbag reindex",
    ".mcap": "mcap recover",
    ".db3": "ros2 bag reindex",
    "": "ros2 bag reindex",
}


def is_bag(path: Path) -> bool:
    """Whether a path is that of a bag, by its ending; a folder is one if it holds parts of a ROS 2 bag."""
    if path.is_dir():
        return any(one.name == "metadata.yaml" or one.suffix in SINGLE for one in path.iterdir())
    return path.suffix.lower() in (ROS_1, *SINGLE) and path.is_file()


@dataclass(frozen=True, eq=False)
class Picture:
    """A message with a picture.

    Attributes
    ----------
    number
        From 1, of the bag's messages with pictures, on whatever topic, in the order of their reception.
    topic
        Its topic.
    received, stamp
        Nanoseconds: when the bag received it, and what its header says.
    """

    number: int
    topic: str
    received: int
    stamp: int
    _message: Any
    _name: str

    def image(self) -> NDArray[np.uint8]:
        """(height, width, 3) uint8, BGR; raises as `placecat.footage.image_messages` does."""
        decode = compressed_image if hasattr(self._message, "format") else raw_image
        return decode(self._message, self._name)


class Bag:
    """A bag, opened for each pass over its messages.

    Parameters
    ----------
    path
        A ``.bag`` of ROS 1, a folder of ROS 2, or one ``.mcap`` or ``.db3`` of it.

    Attributes
    ----------
    topics
        Topic to the type and the number of its messages, sorted.
    count
        Number of messages with pictures.

    Raises
    ------
    PlacecatError
        If rosbags is not installed, or the bag is damaged or of a kind that it does not read.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        topics: dict[str, tuple[str, int]] = {}
        with self._opened() as reader, self._explained():
            for one in reader.connections:
                _, count = topics.get(one.topic, ("", 0))
                topics[str(one.topic)] = (str(one.msgtype), count + int(one.msgcount))
        self.topics = dict(sorted(topics.items()))
        self.count = sum(count for kind, count in self.topics.values() if kind in (IMAGE, COMPRESSED))

    def topic_of_pictures(self, topic: str | None, setting: str) -> str:
        """Choose the topic of the frames: `topic`, or by None the only one with pictures.

        Parameters
        ----------
        setting
            What sets the topic, for messages.

        Raises
        ------
        PlacecatError
            If the bag has no such topic, or several with pictures and none is given.
        """
        having = [
            name for name, (kind, count) in self.topics.items() if kind in (IMAGE, COMPRESSED) and count
        ]
        if topic is not None:
            self.require(topic, (IMAGE, COMPRESSED), setting)
            return topic
        if len(having) == 1:
            return having[0]
        if having:
            raise PlacecatError(
                f"{self.path}: several topics have pictures; choose one with {setting}: {', '.join(having)}."
            )
        raise PlacecatError(
            f"{self.path}: no topic has pictures ({IMAGE} or {COMPRESSED}); it has {self._listed()}."
        )

    def require(self, topic: str, kinds: Collection[str], setting: str) -> None:
        """Refuse a topic that the bag does not have, or that is of another type or empty."""
        if topic not in self.topics:
            raise PlacecatError(
                f"{self.path}: no topic {topic!r}{did_you_mean(topic, self.topics)}; it has "
                f"{self._listed()}. Correct {setting}."
            )
        kind, count = self.topics[topic]
        if kind not in kinds:
            raise PlacecatError(
                f"{self.path}: the topic {topic!r} has messages of {kind}, not of {' or '.join(kinds)}; "
                f"correct {setting}."
            )
        if not count:
            raise PlacecatError(f"{self.path}: the topic {topic!r} has no message; correct {setting}.")

    def pictures(self, topic: str | None = None) -> Generator[Picture, None, None]:
        """Pass over the messages with pictures, in the order of their reception, without decoding pixels.

        Parameters
        ----------
        topic
            Give those of this topic only; they keep their numbers.
        """
        for number, (connection, received, raw) in enumerate(self._messages((IMAGE, COMPRESSED)), 1):
            if topic is None or connection.topic == topic:
                name = f"{self.path}, picture {number} ({connection.topic})"
                with self._explained():
                    message = self._decoded(raw, connection.msgtype)
                    stamp = message.header.stamp.sec * 10**9 + message.header.stamp.nanosec
                yield Picture(number, str(connection.topic), int(received), int(stamp), message, name)

    def strings(self, topic: str) -> Iterator[tuple[int, str]]:
        """Nanoseconds at which each string of a topic (std_msgs/String) was received, and its text."""
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
            # Without connections rosbags gives all messages.
            found = reader.messages(connections=chosen) if chosen else iter(())
            while True:
                with self._explained():
                    message = next(found, None)
                if message is None:
                    return
                yield message

    def _decoded(self, raw: bytes, kind: str) -> Any:
        store = _store(self.path.suffix.lower() == ROS_1)
        if self.path.suffix.lower() == ROS_1:
            return store.deserialize_ros1(raw, kind)
        return store.deserialize_cdr(raw, kind)

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
            is_first = self.path.suffix.lower() == ROS_1
            reader = rosbag1.Reader(self.path) if is_first else rosbag2.Reader(self.path)
            reader.open()
        try:
            yield reader
        finally:
            reader.close()

    @contextmanager
    def _explained(self) -> Iterator[None]:
        """One message for what rosbags says of damage, also where it trips over it."""
        try:
            yield
        except PermissionError as error:
            raise PlacecatError(
                f"{self.path}: cannot be read ({error.strerror}); make it readable."
            ) from None
        except Exception as error:
            said = " ".join(str(error).split())[:300].rstrip(".") or type(error).__name__
            mending = _MENDING["" if self.path.is_dir() else self.path.suffix.lower()]
            raise PlacecatError(
                f"{self.path}: not a readable bag ({said}); restore it, or mend it with `{mending}`."
            ) from None


@lru_cache
def _store(is_first: bool) -> Any:
    """Definitions of ROS 1 or ROS 2; those of pictures and strings are the same in all of its versions."""
    from rosbags.typesys import Stores, get_typestore

    return get_typestore(Stores.ROS1_NOETIC if is_first else Stores.ROS2_HUMBLE)
