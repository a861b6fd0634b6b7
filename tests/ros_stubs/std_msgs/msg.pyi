class Time:
    sec: int
    nanosec: int

class Header:
    stamp: Time
    frame_id: str

class String:
    data: str
    def __init__(self, *, data: str = ...) -> None: ...
