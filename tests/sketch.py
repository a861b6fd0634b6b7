"""Small homes in the VPC-2009 layout, drawn with lines and boxes, for tests that run the project.

Each room is a wide wall with furniture; the camera pans along it. Colours and the choice, place and size of
furniture are random for every home and room. Their ranges are the same for all classes, so only objects
distinguish classes. The drawings test the workflow. Accuracies on them say nothing about real homes.
"""

from collections.abc import Callable, Sequence
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from placecat.seeds import derive

Colour = tuple[int, int, int]
Image = NDArray[np.uint8]

WALL_WIDTH, WALL_HEIGHT, FLOOR = 2000, 440, 345
"""Size of the drawn wall and height of the line where the floor begins, in canvas pixels."""
_VIEW = 360
_JPEG = (cv2.IMWRITE_JPEG_QUALITY, 90)


class Pen:
    """Draws outlined shapes in random colours on a canvas, (H, W, 3) uint8 BGR."""

    def __init__(self, canvas: Image, rng: np.random.Generator) -> None:
        self.canvas = canvas
        self.rng = rng
        self._palette = [_colour(rng) for _ in range(4)]

    def colour(self) -> Colour:
        """Choose a colour from the palette of this room."""
        return self._palette[int(self.rng.integers(len(self._palette)))]

    def box(self, x: float, y: float, w: float, h: float, colour: Colour, edge: int = 2) -> None:
        """Draw a rectangle, given its upper left corner."""
        corners = (round(x), round(y)), (round(x + w), round(y + h))
        cv2.rectangle(self.canvas, *corners, colour, -1)
        if edge:
            cv2.rectangle(self.canvas, *corners, shade(colour, 0.55), edge, cv2.LINE_AA)

    def oval(
        self, x: float, y: float, w: float, h: float, colour: Colour, arc: tuple[int, int] = (0, 360)
    ) -> None:
        """Draw an ellipse or a filled part of one, given its centre."""
        where = (round(x), round(y)), (max(1, round(w / 2)), max(1, round(h / 2)))
        cv2.ellipse(self.canvas, *where, 0, *arc, colour, -1, cv2.LINE_AA)
        cv2.ellipse(self.canvas, *where, 0, *arc, shade(colour, 0.55), 2, cv2.LINE_AA)

    def line(self, x: float, y: float, x2: float, y2: float, colour: Colour, width: int = 3) -> None:
        """Draw a straight line."""
        cv2.line(self.canvas, (round(x), round(y)), (round(x2), round(y2)), colour, width, cv2.LINE_AA)

    def area(self, points: Sequence[tuple[float, float]], colour: Colour) -> None:
        """Draw a polygon."""
        corners = np.array(points).round().astype(np.int32).reshape(-1, 1, 2)
        cv2.fillPoly(self.canvas, [corners], colour, cv2.LINE_AA)
        cv2.polylines(self.canvas, [corners], True, shade(colour, 0.55), 2, cv2.LINE_AA)


Thing = Callable[[Pen, float, float, float], None]
"""A function that draws one object, given the pen, left edge, floor height and scale."""


def draw_homes(
    out: Path, *, homes: int = 6, frames_per_room: int = 16, width: int = 640, height: int = 360
) -> None:
    """Draw homes in the layout that `placecat.sequences.vpc2009` reads; equal arguments produce equal bytes.

    Each home has a kitchen, a bathroom, a living room, a dining room, a bedroom and a corridor, and shows the
    transitions between them. Two of the rooms are visited twice. One home has two floors. A first visit to a
    room has `frames_per_room` frames, at least 2. A second visit or the corridor has half as many.
    """
    grain = np.random.default_rng(derive("sketch", 0, "noise"))
    film = _Film(width, height, grain.normal(0, 2.2, (height + 64, width + 64, 3)).astype(np.int16))
    for number in range(1, homes + 1):
        _draw_home(out / f"Home{number}", film, frames_per_room, number == min(4, homes), number)


def draw_room(room: str, rng: np.random.Generator) -> Image:
    """Draw the wall of a room, (WALL_HEIGHT, WALL_WIDTH, 3) uint8 BGR; `room` is a key of `ROOMS`."""
    canvas = np.empty((WALL_HEIGHT, WALL_WIDTH, 3), dtype=np.uint8)
    pen = Pen(canvas, rng)
    _shell(pen)
    must, may, wall = ROOMS[room]
    things: list[tuple[Thing, int]] = []
    while sum(size for _, size in things) < WALL_WIDTH:
        things += [must[i] for i in rng.permutation(len(must))]
        if may:
            things.append(may[int(rng.integers(len(may)))])
    if wall is not None:
        wall(pen, 0, FLOOR, 1)
    x = float(rng.uniform(-60, 20))
    for thing, size in things:
        scale = float(rng.uniform(0.85, 1.15))
        thing(pen, x, FLOOR + float(rng.uniform(5, 30)), scale)
        x += size * scale + float(rng.uniform(10, 50))
        if x > WALL_WIDTH:
            break
    # A few broad lamps make the light uneven, in the same way for all classes.
    field = rng.uniform(0.72, 1.12, (3, 8)).astype(np.float32)
    light = cv2.resize(field, (WALL_WIDTH, WALL_HEIGHT), interpolation=cv2.INTER_CUBIC)
    return np.clip(canvas * light[:, :, None], 0, 255).astype(np.uint8)


class _Film:
    """Turns views of a wall into frames."""

    def __init__(self, width: int, height: int, noise: NDArray[np.int16]) -> None:
        self._size = (width, height)
        self._noise = noise

    def span(self, zoom: float) -> tuple[float, float]:
        """Return the size of the view on the canvas."""
        high = _VIEW * zoom
        return high * self._size[0] / self._size[1], high

    def shoot(
        self, wall: Image, x: float, y: float, zoom: float, light: float, smear: int, rng: np.random.Generator
    ) -> Image:
        """Cut out a view at its upper left corner, blur and brighten it, and add noise."""
        width, height = self._size
        step = self.span(zoom)[1] / height
        view = np.array([[step, 0, x], [0, step, y]])
        flags = cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP
        frame = cv2.warpAffine(wall, view, self._size, flags=flags, borderMode=cv2.BORDER_REFLECT)
        frame = cv2.blur(frame, (max(1, smear * width // 640), 1)) if smear > 1 else frame
        frame = cv2.GaussianBlur(frame, (3, 3), float(rng.uniform(0.4, 0.9)))
        top, left = (int(value) for value in rng.integers(0, 64, 2))
        noise = self._noise[top : top + height, left : left + width]
        bright = cv2.convertScaleAbs(frame, alpha=light)
        return cv2.add(bright, noise, dtype=cv2.CV_8U)  # type: ignore[return-value]


def _draw_home(folder: Path, film: _Film, stay: int, storeys: bool, number: int) -> None:
    key = ("sketch", 0, number)
    rng = np.random.default_rng(derive(*key))
    walls = {room: draw_room(room, np.random.default_rng(derive(*key, room))) for room in ROOMS}
    text: list[str] = []
    for floor, visits in enumerate(_tour(rng, storeys), start=1):
        (folder / str(floor)).mkdir(parents=True)
        frames, segments = _walk(visits, walls, film, stay, rng)
        for place, frame in enumerate(frames, start=1):
            path = folder / str(floor) / f"{place:08d}.jpg"
            path.write_bytes(cv2.imencode(".jpg", frame, _JPEG)[1].tobytes())
        text += [f"{floor}/", str(len(frames))]
        text += [f"{first:<8d}{last:<8d}{label}" for first, last, label in segments] + ["-1      -1      end"]
    (folder / "label.txt").write_text("\n".join([*text, "-1      -1      end"]) + "\n", encoding="ascii")


def _tour(rng: np.random.Generator, storeys: bool) -> list[list[tuple[str, bool]]]:
    """Choose the order of visits on each floor, as pairs of a room and whether this is its first visit."""
    day = ["living_room", "dining_room", "kitchen"]
    night = ["bedroom", "bathroom"]
    floors = [day, night] if storeys else [day + night]
    tours = []
    for rooms in floors:
        order = [rooms[i] for i in rng.permutation(len(rooms))]
        visits = [(room, True) for room in order]
        again = order[:-1][: 1 if storeys else 2]
        visits += [(room, False) for room in again]
        corridor = int(rng.integers(0, len(order)))
        visits.insert(corridor, ("corridor", False))
        tours.append(visits)
    return tours


def _walk(
    visits: list[tuple[str, bool]], walls: dict[str, Image], film: _Film, stay: int, rng: np.random.Generator
) -> tuple[list[Image], list[tuple[int, int, str]]]:
    frames: list[Image] = []
    segments: list[tuple[int, int, str]] = []

    def add(label: str, shots: list[Image]) -> None:
        segments.append((len(frames) + 1, len(frames) + len(shots), label))
        frames.extend(shots)

    for index, (room, first) in enumerate(visits):
        if index:
            before = visits[index - 1][0]
            add("transition", _cross(walls[before], walls[room], film, int(rng.integers(3, 6)), rng))
        add(room, _pan(walls[room], film, stay if first else max(1, stay // 2), first, rng))
    return frames, segments


def _pan(wall: Image, film: _Film, count: int, first: bool, rng: np.random.Generator) -> list[Image]:
    zoom = float(rng.uniform(0.82, 1.05))
    room = WALL_WIDTH - film.span(1.05)[0]
    left, right = (0.0, 0.75 * room) if first else (0.45 * room, room)
    start, stop = (left, right) if rng.random() < 0.5 else (right, left)
    light = float(rng.uniform(0.85, 1.1))
    frames = []
    for step in range(count):
        part = step / max(1, count - 1)
        x = start + (stop - start) * (part - 0.04 * np.sin(4 * np.pi * part)) + float(rng.normal(0, 4))
        zoomed = zoom * (1 + 0.06 * float(np.sin(3 * part + start)))
        slack = WALL_HEIGHT - film.span(zoomed)[1]
        y = slack * float(rng.uniform(0.55, 0.9))
        smear = int(rng.choice([1, 1, 1, 5, 9]))
        frames.append(
            film.shoot(wall, max(0.0, x), y, zoomed, light + float(rng.normal(0, 0.02)), smear, rng)
        )
    return frames


def _cross(before: Image, after: Image, film: _Film, count: int, rng: np.random.Generator) -> list[Image]:
    """Pan over a door frame from one wall to the next."""
    jamb = np.empty((WALL_HEIGHT, 220, 3), dtype=np.uint8)
    pen = Pen(jamb, rng)
    jamb[:] = pen.colour()
    for x in (25, 60, 150, 185):
        pen.line(x, 0, x, WALL_HEIGHT, shade(pen.colour(), 0.6), 4)
    width = int(film.span(1.0)[0])
    strip = np.hstack([before[:, -width:], jamb, after[:, :width]])
    steps = np.linspace(0.15, 0.85, count) * (strip.shape[1] - width)
    return [film.shoot(strip, float(x), 50, 1.0, 0.9, 21, rng) for x in steps]


def shade(colour: Colour, factor: float) -> Colour:
    """Darken (below 1) or brighten a BGR colour."""
    blue, green, red = (min(255, round(channel * factor)) for channel in colour)
    return blue, green, red


def _colour(rng: np.random.Generator) -> Colour:
    hue, saturation, value = rng.uniform(0, 180), rng.uniform(10, 100), rng.uniform(90, 235)
    pixel = cv2.cvtColor(np.array([[[hue, saturation, value]]], dtype=np.uint8), cv2.COLOR_HSV2BGR)[0, 0]
    return int(pixel[0]), int(pixel[1]), int(pixel[2])


def _shell(pen: Pen) -> None:
    """Draw wall, skirting board and floor, with the same variety for every class."""
    wall, ground = shade(_colour(pen.rng), 1.15), _colour(pen.rng)
    pen.canvas[:FLOOR] = wall
    pen.canvas[FLOOR:] = ground
    if pen.rng.random() < 0.3:
        for x in range(0, WALL_WIDTH, int(pen.rng.integers(40, 90))):
            pen.line(x, 0, x, FLOOR, shade(wall, 0.92), 5)
    kind = pen.rng.integers(3)
    if kind == 0:
        for y in range(FLOOR, WALL_HEIGHT, 18):
            pen.line(0, y, WALL_WIDTH, y, shade(ground, 0.75), 2)
    elif kind == 1:
        for x in range(-400, WALL_WIDTH, 70):
            pen.line(x, FLOOR, x + (x - 1000) * 0.3, WALL_HEIGHT, shade(ground, 0.75), 2)
    pen.box(0, FLOOR - 12, WALL_WIDTH, 12, shade(wall, 0.8))


def _tiles(pen: Pen, x: float, base: float, s: float) -> None:
    size = int(pen.rng.integers(26, 40))
    grout = shade(pen.colour(), 0.7)
    top = int(pen.rng.integers(20, 120))
    for y in range(top, FLOOR, size):
        pen.line(0, y, WALL_WIDTH, y, grout, 1)
    for left in range(0, WALL_WIDTH, size):
        pen.line(left, top, left, FLOOR, grout, 1)


def _handles(pen: Pen, x: float, y: float, w: float, h: float, count: int) -> None:
    """Draw cupboard doors side by side."""
    colour = pen.colour()
    for i in range(count):
        left = x + i * w / count
        pen.box(left, y, w / count, h, colour)
        pen.box(left + 7, y + 7, w / count - 14, h - 14, shade(colour, 0.93), 1)
        pen.line(left + w / count - 12, y + h * 0.4, left + w / count - 12, y + h * 0.6, (60, 60, 60), 3)


def _counter(pen: Pen, x: float, base: float, s: float) -> None:
    w, h = 260 * s, 115 * s
    _handles(pen, x, base - h, w, h, 4)
    pen.box(x - 5, base - h - 12, w + 10, 12, shade(pen.colour(), 0.7))
    _handles(pen, x, base - h - 190 * s, w, 95 * s, 4)
    pen.box(x + 90 * s, base - h - 18, 80 * s, 10, (190, 190, 190))
    pen.line(x + 130 * s, base - h - 16, x + 130 * s, base - h - 55 * s, (150, 150, 150), 5)
    pen.line(x + 130 * s, base - h - 55 * s, x + 152 * s, base - h - 45 * s, (150, 150, 150), 5)
    pen.oval(x + 215 * s, base - h - 28 * s, 30 * s, 36 * s, pen.colour())
    pen.box(x + 25 * s, base - h - 42 * s, 34 * s, 30 * s, pen.colour())


def _stove(pen: Pen, x: float, base: float, s: float) -> None:
    w, h = 130 * s, 125 * s
    body = shade(pen.colour(), 1.1)
    pen.box(x, base - h, w, h, body)
    for i in range(4):
        pen.oval(x + w * (0.2 + 0.2 * i), base - h + 16 * s, 13 * s, 13 * s, (40, 40, 40))
    pen.box(x + 12 * s, base - h + 40 * s, w - 24 * s, 60 * s, (45, 45, 50))
    pen.line(x + 15 * s, base - h + 33 * s, x + w - 15 * s, base - h + 33 * s, (200, 200, 200), 4)
    for part in (0.3, 0.7):
        pen.oval(x + w * part, base - h - 4, 45 * s, 10 * s, (30, 30, 30))
    pen.box(x + w * 0.18, base - h - 36 * s, 40 * s, 30 * s, pen.colour())
    pen.line(x + w * 0.18, base - h - 28 * s, x - 12 * s, base - h - 28 * s, (50, 50, 50), 5)
    top = base - h - 190 * s
    pen.area(
        [(x + w * 0.35, top), (x + w * 0.65, top), (x + w, top + 70 * s), (x, top + 70 * s)], shade(body, 0.8)
    )


def _fridge(pen: Pen, x: float, base: float, s: float) -> None:
    w, h = 115 * s, 255 * s
    colour = shade(pen.colour(), 1.2)
    pen.box(x, base - h, w, h * 0.33, colour, 3)
    pen.box(x, base - h * 0.67, w, h * 0.67, colour, 3)
    for y in (base - h * 0.78, base - h * 0.58):
        pen.line(x + 14 * s, y, x + 14 * s, y + 36 * s, (90, 90, 90), 6)
    for _ in range(4):
        left, top = pen.rng.uniform(0.3, 0.8), pen.rng.uniform(0.3, 0.6)
        pen.box(x + w * left, base - h * top, 16 * s, 20 * s, pen.colour(), 1)


def _utensils(pen: Pen, x: float, base: float, s: float) -> None:
    y = base - 230 * s
    pen.line(x, y, x + 130 * s, y, (70, 70, 70), 5)
    for i in range(5):
        left = x + (12 + 26 * i) * s
        pen.line(left, y, left, y + 50 * s, (90, 90, 90), 4)
        pen.oval(left, y + 58 * s, 17 * s, 24 * s, pen.colour())
    _handles(pen, x - 5, base - 110 * s, 140 * s, 110 * s, 2)
    pen.box(x - 10, base - 122 * s, 150 * s, 12, shade(pen.colour(), 0.7))


def _toilet(pen: Pen, x: float, base: float, s: float) -> None:
    white = shade(pen.colour(), 1.35)
    pen.box(x + 18 * s, base - 165 * s, 64 * s, 70 * s, white)
    pen.box(x + 12 * s, base - 175 * s, 76 * s, 12 * s, white)
    pen.oval(x + 50 * s, base - 168 * s, 12 * s, 6 * s, (130, 130, 130))
    pen.area(
        [(x + 25 * s, base), (x + 75 * s, base), (x + 84 * s, base - 60 * s), (x + 16 * s, base - 60 * s)],
        white,
    )
    pen.oval(x + 50 * s, base - 68 * s, 96 * s, 50 * s, white)
    pen.oval(x + 50 * s, base - 66 * s, 62 * s, 28 * s, shade(white, 0.7))
    pen.box(x + 105 * s, base - 130 * s, 26 * s, 26 * s, (235, 235, 235))


def _basin(pen: Pen, x: float, base: float, s: float) -> None:
    white = shade(pen.colour(), 1.35)
    pen.area(
        [(x + 55 * s, base), (x + 85 * s, base), (x + 80 * s, base - 90 * s), (x + 60 * s, base - 90 * s)],
        white,
    )
    pen.oval(x + 70 * s, base - 115 * s, 130 * s, 74 * s, white, (0, 180))
    pen.box(x + 2 * s, base - 124 * s, 136 * s, 12 * s, white)
    pen.line(x + 70 * s, base - 124 * s, x + 70 * s, base - 150 * s, (150, 150, 150), 6)
    pen.line(x + 70 * s, base - 150 * s, x + 84 * s, base - 142 * s, (150, 150, 150), 6)
    pen.oval(x + 70 * s, base - 228 * s, 100 * s, 128 * s, shade(pen.colour(), 0.8))
    pen.oval(x + 70 * s, base - 228 * s, 84 * s, 112 * s, (225, 220, 215))
    pen.line(x + 50 * s, base - 210 * s, x + 82 * s, base - 258 * s, (250, 250, 250), 5)


def _tub(pen: Pen, x: float, base: float, s: float) -> None:
    white = shade(pen.colour(), 1.35)
    cloth = pen.colour()
    pen.line(x, base - 285 * s, x + 290 * s, base - 285 * s, (120, 120, 120), 5)
    for i in range(9):
        left = x + 12 * i * s
        fold = [(left, base - 285 * s), (left + 12 * s, base - 285 * s), (left + 15 * s, base - 70 * s)]
        pen.area([*fold, (left - 2 * s, base - 70 * s)], shade(cloth, 0.85 + 0.3 * (i % 2)))
    pen.oval(x + 250 * s, base - 262 * s, 36 * s, 14 * s, (140, 140, 140))
    for i in range(5):
        pen.line(
            x + (238 + 6 * i) * s, base - 252 * s, x + (232 + 9 * i) * s, base - 220 * s, (210, 210, 210), 1
        )
    points = [
        (x, base - 90 * s),
        (x + 290 * s, base - 90 * s),
        (x + 268 * s, base - 8),
        (x + 22 * s, base - 8),
    ]
    pen.area(points, white)
    pen.box(x - 6 * s, base - 98 * s, 302 * s, 14 * s, white)
    for left in (38, 236):
        pen.oval(x + left * s, base - 4, 22 * s, 16 * s, (120, 120, 120))


def _towels(pen: Pen, x: float, base: float, s: float) -> None:
    pen.line(x, base - 215 * s, x + 110 * s, base - 215 * s, (130, 130, 130), 5)
    for left in (10, 60):
        colour = pen.colour()
        pen.box(x + left * s, base - 217 * s, 40 * s, 95 * s, colour)
        pen.line(x + left * s, base - 140 * s, x + (left + 40) * s, base - 140 * s, shade(colour, 0.7), 5)
    pen.box(x + 25 * s, base - 60 * s, 60 * s, 60 * s, pen.colour())
    for y in (45, 30, 15):
        pen.line(x + 28 * s, base - y * s, x + 82 * s, base - y * s, (80, 80, 80), 2)


def _sofa(pen: Pen, x: float, base: float, s: float) -> None:
    colour, w = pen.colour(), 300 * s
    pen.box(x + 15 * s, base - 130 * s, w - 30 * s, 80 * s, shade(colour, 0.9))
    for i in range(3):
        pen.box(x + 28 * s + i * (w - 56 * s) / 3, base - 68 * s, (w - 56 * s) / 3, 32 * s, colour)
    pen.box(x + 15 * s, base - 38 * s, w - 30 * s, 26 * s, shade(colour, 0.8))
    for left in (0.0, w - 34 * s):
        pen.box(x + left, base - 95 * s, 34 * s, 84 * s, colour)
        pen.oval(x + left + 17 * s, base - 95 * s, 38 * s, 30 * s, colour)
        pen.line(x + left + 17 * s, base - 10 * s, x + left + 17 * s, base, (40, 40, 40), 7)
    other = pen.colour()
    for left in (60, 205):
        pen.area(
            [(x + (left + dx) * s, base - dy * s) for dx, dy in ((0, 66), (38, 72), (44, 112), (4, 104))],
            other,
        )


def _television(pen: Pen, x: float, base: float, s: float) -> None:
    pen.box(x, base - 55 * s, 230 * s, 48 * s, pen.colour())
    for left in (6, 80, 154):
        pen.box(x + left * s, base - 48 * s, 70 * s, 34 * s, shade(pen.colour(), 0.8), 1)
    pen.box(x + 100 * s, base - 70 * s, 30 * s, 15 * s, (35, 35, 35))
    pen.box(x + 20 * s, base - 185 * s, 190 * s, 115 * s, (30, 30, 32), 3)
    pen.box(x + 28 * s, base - 177 * s, 174 * s, 99 * s, (62, 54, 48), 0)
    pen.area(
        [(x + dx * s, base - dy * s) for dx, dy in ((40, 90), (90, 170), (110, 170), (60, 90))], (84, 76, 70)
    )


def _books(pen: Pen, x: float, base: float, s: float) -> None:
    frame = pen.colour()
    pen.box(x, base - 270 * s, 150 * s, 270 * s, shade(frame, 0.75), 3)
    for shelf in range(5):
        y, left = base - (12 + 52 * shelf) * s, x + 8 * s
        while left < x + 128 * s:
            thick, tall = float(pen.rng.uniform(6, 14)) * s, float(pen.rng.uniform(28, 44)) * s
            pen.box(left, y - tall, thick, tall, _colour(pen.rng), 1)
            left += thick
        pen.line(x, y, x + 150 * s, y, frame, 5)


def _armchair(pen: Pen, x: float, base: float, s: float) -> None:
    colour = pen.colour()
    pen.box(x + 20 * s, base - 150 * s, 90 * s, 110 * s, shade(colour, 0.9))
    pen.box(x + 22 * s, base - 72 * s, 86 * s, 34 * s, colour)
    for left in (0, 100):
        pen.box(x + left * s, base - 95 * s, 30 * s, 82 * s, colour)
    pen.line(x + 165 * s, base, x + 165 * s, base - 215 * s, (60, 60, 60), 5)
    pen.oval(x + 165 * s, base - 3, 50 * s, 10 * s, (60, 60, 60))
    shape = ((138, 210), (192, 210), (180, 262), (150, 262))
    pen.area([(x + dx * s, base - dy * s) for dx, dy in shape], shade(pen.colour(), 1.2))


def _chair(pen: Pen, x: float, base: float, s: float, colour: Colour, turn: int) -> None:
    """Draw a chair from the side. Its back is on the left if `turn` is 1, and on the right if it is -1."""
    for dx in (0, 44):
        pen.line(x + turn * dx * s, base, x + turn * dx * s, base - 75 * s, colour, 6)
    pen.line(x, base - 75 * s, x - turn * 8 * s, base - 165 * s, colour, 7)
    pen.line(x - turn * 4 * s, base - 75 * s, x + turn * 50 * s, base - 75 * s, shade(colour, 0.8), 9)
    pen.line(x + turn * 2 * s, base - 35 * s, x + turn * 44 * s, base - 35 * s, colour, 3)


def _table(pen: Pen, x: float, base: float, s: float) -> None:
    wood, chair, w = pen.colour(), shade(pen.colour(), 0.7), 380 * s
    for left in (150, 230):
        for dx in (0, 16, 32, 48):
            pen.line(
                x + (left - 24 + dx) * s, base - 30 * s, x + (left - 24 + dx) * s, base - 180 * s, chair, 4
            )
        pen.line(x + (left - 26) * s, base - 180 * s, x + (left + 26) * s, base - 180 * s, chair, 9)
    pen.box(x + 75 * s, base - 118 * s, w - 150 * s, 14 * s, wood)
    for left in (90, 290):
        pen.area(
            [
                (x + left * s - 6, base - 104 * s),
                (x + left * s + 8, base - 104 * s),
                (x + left * s + 2, base),
            ],
            wood,
        )
    _chair(pen, x + 30 * s, base + 6, s, chair, 1)
    _chair(pen, x + 350 * s, base + 6, s, chair, -1)
    for left in (125, 190, 255):
        pen.oval(x + left * s, base - 122 * s, 44 * s, 9 * s, (235, 235, 235))
    pen.box(x + 183 * s, base - 152 * s, 14 * s, 30 * s, pen.colour())
    for angle in (-14, 0, 14):
        pen.line(x + 190 * s, base - 152 * s, x + (190 + angle) * s, base - 178 * s, (60, 130, 60), 3)
    middle = x + w / 2
    pen.line(middle, 0, middle, base - 275 * s, (60, 60, 60), 3)
    pen.area(
        [
            (middle - 52 * s, base - 235 * s),
            (middle + 52 * s, base - 235 * s),
            (middle + 16 * s, base - 280 * s),
            (middle - 16 * s, base - 280 * s),
        ],
        shade(pen.colour(), 1.15),
    )


def _sideboard(pen: Pen, x: float, base: float, s: float) -> None:
    _handles(pen, x, base - 95 * s, 200 * s, 88 * s, 3)
    pen.box(x - 5, base - 104 * s, 200 * s + 10, 10 * s, shade(pen.colour(), 0.7))
    pen.box(x + 10 * s, base - 250 * s, 180 * s, 130 * s, shade(pen.colour(), 0.85), 3)
    for shelf in (135, 200):
        pen.line(x + 10 * s, base - shelf * s, x + 190 * s, base - shelf * s, (70, 70, 70), 3)
        for i in range(4):
            pen.oval(x + (35 + 43 * i) * s, base - (shelf + 19) * s, 34 * s, 34 * s, (238, 238, 238))
            pen.oval(x + (35 + 43 * i) * s, base - (shelf + 19) * s, 20 * s, 20 * s, (215, 215, 215))


def _bed(pen: Pen, x: float, base: float, s: float) -> None:
    wood, cloth = pen.colour(), pen.colour()
    pen.box(x, base - 165 * s, 24 * s, 165 * s, wood)
    pen.box(x + 320 * s, base - 95 * s, 20 * s, 95 * s, wood)
    pen.box(x + 20 * s, base - 45 * s, 304 * s, 30 * s, shade(wood, 0.8))
    pen.box(x + 22 * s, base - 82 * s, 300 * s, 40 * s, (225, 225, 228))
    shape = ((110, 90), (322, 96), (322, 34), (110, 34))
    pen.area([(x + dx * s, base - dy * s) for dx, dy in shape], cloth)
    for dx in (140, 180, 220, 260, 300):
        pen.line(x + dx * s, base - 88 * s, x + (dx - 8) * s, base - 38 * s, shade(cloth, 0.8), 3)
    pen.box(x + 100 * s, base - 94 * s, 24 * s, 58 * s, shade(cloth, 1.25))
    for left in (56, 82):
        pen.oval(x + left * s, base - 96 * s, 58 * s, 34 * s, (238, 236, 240))


def _front_bed(pen: Pen, x: float, base: float, s: float) -> None:
    wood, cloth = pen.colour(), pen.colour()
    pen.box(x + 10 * s, base - 190 * s, 220 * s, 130 * s, wood, 3)
    for left in (22, 130):
        pen.box(x + left * s, base - 178 * s, 88 * s, 70 * s, shade(wood, 0.88))
    for left in (68, 172):
        pen.oval(x + left * s, base - 122 * s, 92 * s, 46 * s, (238, 236, 240))
    shape = ((8, 108), (232, 108), (256, 15), (-16, 15))
    pen.area([(x + dx * s, base - dy * s) for dx, dy in shape], cloth)
    pen.area(
        [(x + dx * s, base - dy * s) for dx, dy in ((6, 108), (234, 108), (239, 88), (1, 88))],
        shade(cloth, 1.3),
    )
    for dx in (50, 120, 190):
        pen.line(
            x + dx * s, base - 86 * s, x + (dx + (dx - 120) * 0.12) * s, base - 18 * s, shade(cloth, 0.8), 3
        )


def _nightstand(pen: Pen, x: float, base: float, s: float) -> None:
    pen.box(x, base - 70 * s, 75 * s, 64 * s, pen.colour())
    for y in (62, 34):
        pen.box(x + 6 * s, base - y * s, 63 * s, 24 * s, shade(pen.colour(), 0.9), 1)
        pen.oval(x + 37 * s, base - (y - 12) * s, 9 * s, 9 * s, (60, 60, 60))
    pen.line(x + 28 * s, base - 70 * s, x + 28 * s, base - 105 * s, (70, 70, 70), 5)
    shape = ((5, 102), (51, 102), (41, 142), (15, 142))
    pen.area([(x + dx * s, base - dy * s) for dx, dy in shape], shade(pen.colour(), 1.25))
    pen.oval(x + 58 * s, base - 84 * s, 26 * s, 26 * s, (230, 230, 230))


def _wardrobe(pen: Pen, x: float, base: float, s: float) -> None:
    colour = pen.colour()
    pen.box(x - 5, base - 290 * s, 190 * s + 10, 16 * s, shade(colour, 0.8))
    for left in (0, 95):
        pen.box(x + left * s, base - 275 * s, 95 * s, 225 * s, colour, 3)
        for y, tall in ((260, 90), (158, 96)):
            pen.box(x + (left + 14) * s, base - y * s, 67 * s, tall * s, shade(colour, 0.92))
    for left in (84, 106):
        pen.line(x + left * s, base - 175 * s, x + left * s, base - 145 * s, (50, 50, 50), 4)
    pen.box(x, base - 50 * s, 190 * s, 44 * s, shade(colour, 0.9))
    for left in (50, 140):
        pen.oval(x + left * s, base - 28 * s, 12 * s, 12 * s, (50, 50, 50))


def _window(pen: Pen, x: float, base: float, s: float) -> None:
    top, w, h = base - 270 * s, 130 * s, 140 * s
    pen.box(x, top, w, h, (240, 225, 205), 4)
    pen.oval(x + w * 0.3, top + h * 0.85, w * 0.5, h * 0.4, (70, 130, 80), (180, 360))
    pen.line(x + w / 2, top, x + w / 2, top + h, (225, 225, 225), 6)
    pen.line(x, top + h / 2, x + w, top + h / 2, (225, 225, 225), 6)
    pen.box(x - 8, top + h, w + 16, 9, (215, 215, 215))


def _picture(pen: Pen, x: float, base: float, s: float) -> None:
    w, h = float(pen.rng.uniform(50, 90)) * s, float(pen.rng.uniform(50, 80)) * s
    y = base - float(pen.rng.uniform(210, 260)) * s
    pen.box(x, y, w, h, shade(pen.colour(), 0.6))
    pen.box(x + 7, y + 7, w - 14, h - 14, _colour(pen.rng))
    pen.oval(x + w / 2, y + h / 2, w * 0.4, h * 0.3, _colour(pen.rng))


def _plant(pen: Pen, x: float, base: float, s: float) -> None:
    pen.area([(x + dx * s, base - dy * s) for dx, dy in ((25, 0), (65, 0), (75, 55), (15, 55))], pen.colour())
    for angle in np.linspace(-1.1, 1.1, 9):
        tip = x + (45 + 60 * float(np.sin(angle))) * s, base - (55 + 90 * float(np.cos(angle))) * s
        pen.line(x + 45 * s, base - 55 * s, *tip, (60, 120, 60), 5)


def _door(pen: Pen, x: float, base: float, s: float) -> None:
    colour, h = pen.colour(), 275 * s
    pen.box(x - 10, FLOOR - h - 10, 130 * s + 20, h + 10, shade(colour, 1.2), 2)
    pen.box(x, FLOOR - h, 130 * s, h, colour, 3)
    for y, tall in ((255, 100), (135, 115)):
        for left in (14, 72):
            pen.box(x + left * s, FLOOR - y * s, 44 * s, tall * s, shade(colour, 0.9))
    pen.oval(x + 120 * s, FLOOR - 130 * s, 12 * s, 12 * s, (80, 190, 210))


def _coats(pen: Pen, x: float, base: float, s: float) -> None:
    pen.box(x, base - 255 * s, 150 * s, 14 * s, shade(pen.colour(), 0.7))
    for left in (22, 70, 122):
        colour = _colour(pen.rng)
        shape = ((-8, 248), (8, 248), (24, 225), (20, 130), (-20, 130), (-24, 225))
        pen.area([(x + (left + dx) * s, base - dy * s) for dx, dy in shape], colour)
        pen.line(x + left * s, base - 240 * s, x + left * s, base - 132 * s, shade(colour, 0.6), 2)
    for left in (10, 45, 95):
        pen.oval(x + left * s, base - 8 * s, 36 * s, 18 * s, (50, 50, 60))


_COMMON: list[tuple[Thing, int]] = [(_window, 140), (_picture, 90), (_plant, 90), (_door, 140)]

ROOMS: dict[str, tuple[list[tuple[Thing, int]], list[tuple[Thing, int]], Thing | None]] = {
    "kitchen": ([(_counter, 260), (_stove, 130), (_fridge, 115), (_utensils, 140)], _COMMON, None),
    "bathroom": ([(_toilet, 130), (_basin, 140), (_tub, 295), (_towels, 110)], _COMMON, _tiles),
    "living_room": ([(_sofa, 300), (_television, 230), (_books, 150), (_armchair, 195)], _COMMON, None),
    "dining_room": ([(_table, 385), (_sideboard, 200)], _COMMON, None),
    "bedroom": ([(_bed, 345), (_nightstand, 80), (_wardrobe, 190), (_front_bed, 245)], _COMMON, None),
    "corridor": (
        [(_door, 140), (_coats, 150), (_door, 140), (_picture, 90)],
        [(_plant, 90), (_picture, 90)],
        None,
    ),
}
"""Maps each room to the objects it always has, objects it may have (with widths), and its wall covering."""
