"""Small ROS 1 and ROS 2 bags, written by rosbags. Each image shows its number."""

import cv2
import numpy as np
import pytest
from helpers_sequences import coded

pytest.importorskip("rosbags", reason="rosbags is not installed: pip install -e '.[robot]'")

from rosbags import rosbag1, rosbag2
from rosbags.typesys import Stores, get_typestore

STORES = {1: get_typestore(Stores.ROS1_NOETIC), 2: get_typestore(Stores.ROS2_HUMBLE)}
IMAGE, COMPRESSED, STRING = "sensor_msgs/msg/Image", "sensor_msgs/msg/CompressedImage", "std_msgs/msg/String"
CAMERA = "/camera/image_raw"
# 2023-11-14 in nanoseconds since 1970, as on a robot's clock.
START = 1_700_000_000_000_000_000
KINDS = ("walk.bag", "walk_ros2", "walk_folder_mcap", "walk.mcap", "walk.db3")


def header(version, stamp):
    types = STORES[version].types
    time = types["builtin_interfaces/msg/Time"](stamp // 10**9, stamp % 10**9)
    made = types["std_msgs/msg/Header"]
    return made(0, time, "camera") if version == 1 else made(time, "camera")


def raw(version, stamp, data, encoding, *, width, height, step):
    """Return a sensor_msgs/Image with the given data."""
    flat = np.frombuffer(np.ascontiguousarray(data).tobytes(), np.uint8)
    return STORES[version].types[IMAGE](header(version, stamp), height, width, encoding, 0, step, flat)


def picture(version, stamp, image, encoding="bgr8", padding=0):
    """Return a sensor_msgs/Image of (H, W) or (H, W, channels) pixels."""
    height, width = image.shape[:2]
    rows = np.pad(image.reshape(height, -1), ((0, 0), (0, padding)), constant_values=77)
    return raw(version, stamp, rows, encoding, width=width, height=height, step=rows.shape[1])


def compressed(version, stamp, image, ending=".png", kind="bgr8; png compressed bgr8"):
    """Return a sensor_msgs/CompressedImage of pixels or raw bytes."""
    content = image if isinstance(image, bytes) else cv2.imencode(ending, image)[1].tobytes()
    data = np.frombuffer(content, np.uint8)
    return STORES[version].types[COMPRESSED](header(version, stamp), kind, data)


def string(version, text):
    return STORES[version].types[STRING](text)


def write_bag(path, messages, **options):
    """Write (topic, reception time in nanoseconds, message) tuples to a bag whose name selects its format."""
    version = 1 if path.suffix == ".bag" else 2
    path.parent.mkdir(parents=True, exist_ok=True)
    store = STORES[version]
    is_mcap = path.suffix == ".mcap" or path.name.endswith("_mcap")
    if version == 1:
        writer = rosbag1.Writer(path)
    else:
        plugin = rosbag2.StoragePlugin.MCAP if is_mcap else rosbag2.StoragePlugin.SQLITE3
        folder = path.with_suffix("") if path.suffix else path
        writer = rosbag2.Writer(folder, version=8, storage_plugin=plugin)
    if options.get("compression"):
        writer.set_compression(*options["compression"])
    with writer:
        connections = {}
        for topic, received, message in messages:
            if topic not in connections:
                connections[topic] = writer.add_connection(topic, message.__msgtype__, typestore=store)
            serialize = store.serialize_ros1 if version == 1 else store.serialize_cdr
            writer.write(connections[topic], received, serialize(message, message.__msgtype__))
    if version == 2 and path.suffix:
        # Keep only the single file, without its folder.
        (folder / f"{folder.name}{path.suffix}").rename(path)
        for rest in folder.iterdir():
            rest.unlink()
        folder.rmdir()
    return path


def walk(path, count=30, fps=25.0, stamps=None, late=3_000_000, topic=CAMERA, size=(64, 48), others=()):
    """Write numbered frames, received `late` nanoseconds after their stamps, and other messages."""
    version = 1 if path.suffix == ".bag" else 2
    stamps = [START + round(number / fps * 1e9) for number in range(count)] if stamps is None else stamps
    messages = [
        (topic, stamp + late, picture(version, stamp, coded(number, *size)))
        for number, stamp in enumerate(stamps)
    ]
    return write_bag(path, sorted([*messages, *others], key=lambda one: one[1]))
