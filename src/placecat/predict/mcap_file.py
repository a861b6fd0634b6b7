"""Write a prediction as ROS 2 messages to an MCAP file, for Foxglove and ``ros2 bag play``."""

import shutil
from pathlib import Path
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from placecat.categorizer import Decision
from placecat.errors import PlacecatError
from placecat.predict.annotate import Annotator
from placecat.predict.frame import Frame, nanoseconds

PICTURE, PROBABILITIES, PLACE = "/placecat/image/compressed", "/placecat/classification", "/placecat/place"
"""The topics. The first two carry one message per frame. The last one is latched and carries a message
whenever the place changes or becomes `unknown`."""
JPEG_QUALITY = 90
"""JPEG quality of the images, from 0 to 100. Our choice."""

_IMAGE, _STRING = "sensor_msgs/msg/CompressedImage", "std_msgs/msg/String"
_HYPOTHESIS, _CLASSIFICATION = "vision_msgs/msg/ObjectHypothesis", "vision_msgs/msg/Classification"
# Message definitions from vision_msgs 4. The rosbags package does not include them.
_DEFINITIONS = {
    _HYPOTHESIS: "string class_id\nfloat64 score\n",
    _CLASSIFICATION: "std_msgs/Header header\nvision_msgs/ObjectHypothesis[] results\n",
}
# The newest bag format that ROS 2 Humble can read.
_VERSION = 8
# The bag stores its file name, so it is written under its final name in a temporary folder.
_WORK = ".folder"


class McapFile:
    """Writes an MCAP file, with a summary and indices, in a ``with`` block.

    `name` is the final name of the file without the suffix. `classes` are the names of the places, and `size`
    is the (width, height) of the frames. `start` is the time of the first frame in nanoseconds since 1970.
    """

    @staticmethod
    def require() -> tuple[Any, Any]:
        """Return the message definitions and the writer module. Raise PlacecatError if rosbags is missing."""
        try:
            from rosbags import rosbag2
            from rosbags.typesys import Stores, get_types_from_msg, get_typestore
        except ModuleNotFoundError as error:
            raise PlacecatError(
                f"--mcap needs the optional extra ({error.name} is missing): pip install -e '.[robot]'"
            ) from None
        store = get_typestore(Stores.ROS2_HUMBLE)
        for name, text in _DEFINITIONS.items():
            store.register(get_types_from_msg(text, name))
        return store, rosbag2

    def __init__(
        self, path: Path, name: str, classes: tuple[str, ...], size: tuple[int, int], start: int
    ) -> None:
        store, writer = self.require()
        self._path, self._classes, self._start = path, classes, start
        self._annotator = Annotator(classes, size)
        self._place: str | None = None
        self._store, self._folder = store, path.with_suffix(_WORK)
        self._inner = self._folder / name / f"{name}.mcap"
        self._writer = writer.Writer(
            self._inner.parent, version=_VERSION, storage_plugin=writer.StoragePlugin.MCAP
        )

    def __enter__(self) -> "McapFile":
        self._writer.open()
        kinds = {PICTURE: _IMAGE, PROBABILITIES: _CLASSIFICATION, PLACE: _STRING}
        self._connections = {
            topic: self._writer.add_connection(
                topic, kind, typestore=self._store, offered_qos_profiles=[_quality(is_latched=topic == PLACE)]
            )
            for topic, kind in kinds.items()
        }
        return self

    def __exit__(self, kind: type[BaseException] | None, *_: object) -> None:
        try:
            if kind is None:
                self._writer.close()
                self._inner.replace(self._path)
            else:
                self._writer.abort()
        finally:
            shutil.rmtree(self._folder, ignore_errors=True)

    def add(self, frame: Frame, decision: Decision, label: str | None = None) -> None:
        """Add a frame, and its true place if it is known. Every frame must match the given `size`."""
        types = self._store.types
        now = self._start + nanoseconds(frame.seconds)
        stamp = types["builtin_interfaces/msg/Time"](now // 10**9, now % 10**9)
        header = types["std_msgs/msg/Header"](stamp, "")
        coded = jpeg(self._annotator(frame, decision, label), JPEG_QUALITY)
        self._write(PICTURE, now, types[_IMAGE](header, "jpeg", coded))
        results = [
            types[_HYPOTHESIS](name, float(score))
            for name, score in zip(self._classes, decision.proba, strict=True)
        ]
        self._write(PROBABILITIES, now, types[_CLASSIFICATION](header, results))
        if decision.name != self._place:
            self._place = decision.name
            self._write(PLACE, now, types[_STRING](decision.name))

    def _write(self, topic: str, now: int, message: Any) -> None:
        self._writer.write(
            self._connections[topic], now, self._store.serialize_cdr(message, message.__msgtype__)
        )


def jpeg(picture: NDArray[np.uint8], quality: int) -> NDArray[np.uint8]:
    """Encode an (H, W, 3) uint8 BGR image as a JPEG, and return its bytes as (n,) uint8.

    `quality` is from 0 to 100.
    """
    done, coded = cv2.imencode(".jpg", picture, [cv2.IMWRITE_JPEG_QUALITY, quality])
    if not done:
        raise RuntimeError("OpenCV cannot write JPEG")
    return coded.ravel().astype(np.uint8, copy=False)


def _quality(*, is_latched: bool) -> Any:
    """Return the quality of service for a topic.

    If a topic is latched, late subscribers receive its last message.
    """
    from rosbags.interfaces import Qos, QosDurability, QosHistory, QosLiveliness, QosReliability, QosTime

    # The ROS 2 defaults.
    forever = QosTime(2147483647, 4294967295)
    return Qos(
        history=QosHistory.KEEP_LAST,
        depth=1 if is_latched else 10,
        reliability=QosReliability.RELIABLE,
        durability=QosDurability.TRANSIENT_LOCAL if is_latched else QosDurability.VOLATILE,
        deadline=forever,
        lifespan=forever,
        liveliness=QosLiveliness.AUTOMATIC,
        liveliness_lease_duration=forever,
        avoid_ros_namespace_conventions=False,
    )
