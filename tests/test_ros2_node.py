"""The ROS node in docs/, with stubs for the ROS modules."""

import array
import runpy
import sys
from types import ModuleType, SimpleNamespace

import numpy as np
import pytest
from made_system import CLASSES, frames, make_system

from placecat.categorizer import Categorizer
from project import ROOT

FILE = ROOT / "docs/ros2_node.py"


class Node:
    def __init__(self, name):
        self.sent, self.said = [], []

    def declare_parameter(self, name, value):
        return SimpleNamespace(value=value)

    def create_publisher(self, kind, topic, quality):
        return SimpleNamespace(publish=lambda message: self.sent.append((topic, message)))

    def create_subscription(self, kind, topic, callback, quality):
        self.subscribed = (topic, callback)

    def get_logger(self):
        return SimpleNamespace(error=self.said.append)


@pytest.fixture
def node(monkeypatch):
    named = SimpleNamespace(TRANSIENT_LOCAL=1, BEST_EFFORT=2)
    made = {
        "rclpy": {},
        "rclpy.node": {"Node": Node},
        "rclpy.qos": {"DurabilityPolicy": named, "ReliabilityPolicy": named, "QoSProfile": SimpleNamespace},
        "sensor_msgs.msg": {"Image": SimpleNamespace},
        "std_msgs.msg": {"String": SimpleNamespace},
        "vision_msgs.msg": dict.fromkeys(("Classification", "ObjectHypothesis"), SimpleNamespace),
    }
    for name, content in made.items():
        module = ModuleType(name)
        vars(module).update(content)
        monkeypatch.setitem(sys.modules, name.partition(".")[0], ModuleType(name))
        monkeypatch.setitem(sys.modules, name, module)
    monkeypatch.setattr(Categorizer, "load", lambda path, resize: Categorizer(make_system(), resize=resize))
    return runpy.run_path(str(FILE))["PlaceNode"]()


def message(image, seconds, encoding="bgr8"):
    height, width = image.shape[:2]
    stamp = SimpleNamespace(sec=int(seconds), nanosec=round(seconds % 1 * 1e9))
    return SimpleNamespace(
        header=SimpleNamespace(stamp=stamp),
        width=width,
        height=height,
        step=3 * width,
        encoding=encoding,
        data=array.array("B", image.tobytes()),
    )


def test_the_node_publishes_the_decisions_of_the_categorizer(node):
    images = list(frames(3))
    topic, see = node.subscribed
    assert topic == "image"
    see(message(images[0], 100.0))
    # The next message is late, and the one after it has an unsupported encoding.
    see(message(images[1], 99.5))
    see(message(images[1], 100.2, "mono16"))
    see(message(images[1], 100.5))
    assert len(node.said) == 1 and "encoding 'mono16'" in node.said[0]
    plain = Categorizer(make_system())
    expected = [plain.update(images[0]), plain.update(images[1], 0.5)]
    sent = [one for name, one in node.sent if name == "classification"]
    for one, decision in zip(sent, expected, strict=True):
        assert [result.class_id for result in one.results] == list(CLASSES)
        assert np.array_equal([result.score for result in one.results], decision.proba)
    places = [one.data for name, one in node.sent if name == "place"]
    assert places == list(dict.fromkeys(decision.name for decision in expected))


def test_an_uncertain_place_is_published_as_unknown(node):
    node.categorizer.threshold = 1.1
    node.subscribed[1](message(frames(1)[0], 100.0))
    assert [one.data for name, one in node.sent if name == "place"] == ["unknown"]


def test_frames_with_another_aspect_ratio_are_cropped(node):
    (image,) = frames(1)
    tall = np.pad(image, ((30, 30), (0, 0), (0, 0)))
    node.subscribed[1](message(tall, 100.0))
    (sent,) = [one for name, one in node.sent if name == "classification"]
    expected = Categorizer(make_system()).update(image).proba
    assert np.array_equal([result.score for result in sent.results], expected)


def test_a_clock_that_goes_back_resets_the_node(node):
    images = list(frames(2))
    for image, seconds in ((images[0], 100.0), (images[1], 3.0), (images[0], 2.5), (images[0], 3.2)):
        node.subscribed[1](message(image, seconds))
    assert not node.said
    sent = [one for name, one in node.sent if name == "classification"]
    # The third message is late, and the first one is forgotten.
    assert [one.header.stamp.sec for one in sent] == [100, 3, 3]
    expected = Categorizer(make_system()).update(images[1]).proba
    assert np.array_equal([result.score for result in sent[1].results], expected)


def test_the_node_is_short():
    assert len(FILE.read_text().splitlines()) <= 50
