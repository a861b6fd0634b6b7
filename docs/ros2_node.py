"""A ROS 2 node that names the place: python3 ros2_node.py --ros-args -r image:=/camera/image_raw."""

import rclpy
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from sensor_msgs.msg import Image
from std_msgs.msg import String
from vision_msgs.msg import Classification, ObjectHypothesis

from placecat.categorizer import Categorizer
from placecat.errors import PlacecatError
from placecat.footage.image_messages import raw_image


class PlaceNode(Node):
    """Publish a `classification` for each `image`, and a latched `place` whenever the place changes."""

    def __init__(self) -> None:
        super().__init__("placecat")
        path = str(self.declare_parameter("model", "data/model.placecat").value)
        self.categorizer, self.last, self.place = Categorizer.load(path, resize=True), float("-inf"), ""
        newest = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)
        latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.places = self.create_publisher(String, "place", latched)
        self.classifications = self.create_publisher(Classification, "classification", 10)
        self.create_subscription(Image, "image", self.see, newest)

    def see(self, message: Image) -> None:
        """Categorize a frame unless it is late; reset if the clock jumps back by more than 1 s."""
        now = message.header.stamp.sec + message.header.stamp.nanosec / 1e9
        if self.last - 1 <= now <= self.last:
            return
        try:
            if now < self.last:
                self.categorizer.reset()
            decision = self.categorizer.update(raw_image(message, "image"), time=now)
        except PlacecatError as error:
            self.get_logger().error(str(error))
            return
        scores = zip(self.categorizer.classes, decision.proba.tolist(), strict=True)
        results = [ObjectHypothesis(class_id=name, score=score) for name, score in scores]
        self.classifications.publish(Classification(header=message.header, results=results))
        if decision.name != self.place:
            self.places.publish(String(data=decision.name))
        self.last, self.place = now, decision.name


if __name__ == "__main__":
    rclpy.init()
    rclpy.spin(PlaceNode())
