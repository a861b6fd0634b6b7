from collections.abc import Callable
from typing import Any, Generic, TypeVar

from rclpy.qos import QoSProfile

Message = TypeVar("Message")

class Logger:
    def error(self, message: str) -> bool: ...

class Parameter:
    @property
    def value(self) -> Any: ...

class Publisher(Generic[Message]):
    def publish(self, msg: Message) -> None: ...

class Node:
    def __init__(self, node_name: str) -> None: ...
    def declare_parameter(self, name: str, value: Any = ...) -> Parameter: ...
    def get_logger(self) -> Logger: ...
    def create_publisher(
        self, msg_type: type[Message], topic: str, qos_profile: QoSProfile | int
    ) -> Publisher[Message]: ...
    def create_subscription(
        self,
        msg_type: type[Message],
        topic: str,
        callback: Callable[[Message], None],
        qos_profile: QoSProfile | int,
    ) -> object: ...
