from std_msgs.msg import Header

class ObjectHypothesis:
    class_id: str
    score: float
    def __init__(self, *, class_id: str = ..., score: float = ...) -> None: ...

class Classification:
    header: Header
    results: list[ObjectHypothesis]
    def __init__(self, *, header: Header = ..., results: list[ObjectHypothesis] = ...) -> None: ...
