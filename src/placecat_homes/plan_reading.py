"""Read rooms, doors and windows of a floor plan from YAML, and check them."""

from collections.abc import Mapping, Sequence
from typing import Any

from placecat.errors import PlacecatError
from placecat.settings import refuse_unknown
from placecat_homes.plan_parts import SIDES, DoorPlan, Rect, RoomPlan, WindowPlan, side

_DOOR_KINDS = ("door", "open", "glass", "closed")


def read_room(plan: str, name: str, value: Mapping[str, Any]) -> RoomPlan:
    """Read a room from a plan. Raises PlacecatError if it is invalid."""
    where = f"{plan}, room {name}"
    refuse_unknown(value, ["kind", "rect", "label", "part"], where)
    rect = _numbers(value["rect"], where)
    if not (rect[0] < rect[2] and rect[1] < rect[3]):
        raise PlacecatError(f"{where}: rect must be [x0, y0, x1, y1] with x0 < x1 and y0 < y1")
    kind = str(value["kind"])
    return RoomPlan(name, kind, rect, str(value.get("label", kind)), str(value.get("part", "")))


def _numbers(values: Sequence[Any], where: str) -> Rect:
    if len(values) != 4:
        raise PlacecatError(f"{where}: rect must have four numbers")
    x0, y0, x1, y1 = (float(value) for value in values)
    return x0, y0, x1, y1


def read_door(plan: str, value: Mapping[str, Any]) -> DoorPlan:
    """Read a door from a plan. Raises PlacecatError if it is invalid."""
    rooms = tuple(str(room) for room in value["rooms"])
    where = f"{plan}, door {' - '.join(rooms)}"
    refuse_unknown(value, ["rooms", "kind", "position", "width", "height", "side"], where)
    door = DoorPlan(rooms, **{key: part for key, part in value.items() if key != "rooms"})
    if door.kind not in _DOOR_KINDS:
        raise PlacecatError(f"{where}: kind must be one of {', '.join(_DOOR_KINDS)}")
    if len(rooms) != (1 if door.kind == "closed" else 2):
        raise PlacecatError(f"{where}: a closed door must have one room, and any other door must have two")
    if door.kind == "closed" and door.side not in SIDES:
        raise PlacecatError(f"{where}: side must be one of {', '.join(SIDES)}")
    if not (0.0 <= door.position <= 1.0 and door.width >= 0.7):
        raise PlacecatError(f"{where}: position must be in [0, 1] and width at least 0.7 m")
    return door


def read_window(plan: str, rooms: Mapping[str, RoomPlan], value: Mapping[str, Any]) -> WindowPlan:
    """Read a window from a plan. Raises PlacecatError if it is invalid."""
    name = str(value["room"])
    where = f"{plan}, window of {name}"
    refuse_unknown(value, ["room", "side", "width", "position", "sill", "top"], where)
    if name not in rooms or value["side"] not in SIDES:
        raise PlacecatError(
            f"{where}: the room must be in the plan, and the side must be south, east, north or west"
        )
    low, high, _, _ = side(rooms[name].rect, SIDES.index(value["side"]))
    width, margin = float(value["width"]), 0.15
    if width > high - low - 2 * margin:
        raise PlacecatError(f"{where} is wider than its wall")
    start = low + margin + float(value.get("position", 0.5)) * (high - low - 2 * margin - width)
    sill, top = float(value.get("sill", 0.9)), float(value.get("top", 2.15))
    return WindowPlan(name, str(value["side"]), start, start + width, sill, top)
