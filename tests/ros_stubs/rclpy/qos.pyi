from enum import Enum

class DurabilityPolicy(Enum):
    TRANSIENT_LOCAL = 1
    VOLATILE = 2

class ReliabilityPolicy(Enum):
    RELIABLE = 1
    BEST_EFFORT = 2

class QoSProfile:
    def __init__(
        self, *, depth: int, durability: DurabilityPolicy = ..., reliability: ReliabilityPolicy = ...
    ) -> None: ...
