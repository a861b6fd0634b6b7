"""Dining chairs, benches and high chairs."""

import math
from collections.abc import Sequence

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, block, chance, choose, leg
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.arrange import grounded
from placecat_homes.parts.lofts import pillow
from placecat_homes.parts.outlines import frontal, loft, rectangle, ring, sideways, textured
from placecat_homes.shapes import box, extrude, lathe, sheet, tube
from placecat_homes.style import Style

DESIGNS = ("ladder", "slats", "upholstered", "shell", "bentwood", "cross", "windsor", "cantilever")
SEAT = 0.45


def chair(
    rng: np.random.Generator, style: Style, *, design: str | None = None, armrests: bool | None = None
) -> Mesh:
    """Draw a dining chair.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    design
        One of `DESIGNS`; chosen to suit the style if None.
    armrests
        Whether the chair has armrests; chosen at random (rarely True) if None.

    Returns
    -------
    Mesh
        A chair with its back to the wall, so that a person sitting in it faces +y.
    """
    m = style.modern
    weights = (1.2 - m, 1.0, 0.8, 0.2 + 1.3 * m, 0.7, 0.7 * (1 - m), 0.7 * (1 - m), 0.1 + 0.7 * m)
    kind = design or choose(rng, DESIGNS, weights)
    arms = armrests if armrests is not None else chance(rng, 0.08)
    makers = {
        "upholstered": _upholstered,
        "shell": _shell,
        "bentwood": _bentwood,
        "windsor": _windsor,
        "cantilever": _cantilever,
    }
    if kind in makers:
        return grounded(makers[kind](rng, style))
    return grounded(_framed(rng, style, kind, arms))


def _post(x: float, low: float, high: float, lean: float, size: float) -> Mesh:
    """Draw a rear post with a leg that splays backwards and an upper part that leans back."""
    half = size / 2
    lower = [(-0.05 - half, 0), (-0.05 + half, 0), (half, low), (-half, low)]
    upper = [(-half, low), (half, low), (half * 0.7 - lean, high), (-half - lean, high)]
    return join(sideways(lower, size * 0.85), sideways(upper, size * 0.85)).moved(x)


def _seat_outline(front: float, back: float, depth: float, radius: float = 0.03) -> list[tuple[float, float]]:
    corners = [(front / 2, depth), (-front / 2, depth), (-back / 2, 0.0), (back / 2, 0.0)]
    points = []
    for k, (x, y) in enumerate(corners):
        before, after = corners[k - 1], corners[(k + 1) % 4]
        start, end = _towards((x, y), before, radius), _towards((x, y), after, radius)
        for t in (0.0, 0.33, 0.67, 1.0):
            a, b, c = (1 - t) ** 2, 2 * t * (1 - t), t**2
            points.append((a * start[0] + b * x + c * end[0], a * start[1] + b * y + c * end[1]))
    return points


def _towards(point: tuple[float, float], other: tuple[float, float], distance: float) -> tuple[float, float]:
    dx, dy = other[0] - point[0], other[1] - point[1]
    factor = distance / math.hypot(dx, dy)
    return point[0] + factor * dx, point[1] + factor * dy


def _pad(outline: Sequence[tuple[float, float]], height: float) -> Mesh:
    """Draw a padded seat with the given outline and its underside at z = 0."""
    points = np.asarray(outline)
    middle = points.mean(axis=0)
    rings = [
        ring([tuple(middle + (p - middle) * scale) for p in points], z * height)
        for scale, z in (
            (0.97, 0.0),
            (1.0, 0.25),
            (1.0, 0.6),
            (0.96, 0.87),
            (0.88, 0.98),
            (0.7, 1.0),
            (0.3, 1.0),
        )
    ]
    return loft(rings, close=True)


def seat_cover(rng: np.random.Generator, style: Style) -> Material:
    """Choose a material for a seat cover."""
    kind = rng.random()
    if kind < 0.3:
        return palette.leather(rng)
    return palette.plain_fabric(rng) if kind < 0.7 else style.any_fabric(rng)


def _seat(rng: np.random.Generator, style: Style, wood: Material, width: float, depth: float) -> Mesh:
    """Draw the board, pad or rush seat of a wooden chair, with its top at seat height."""
    outline = _seat_outline(width, width * 0.88, depth)
    kind = rng.random()
    if kind < 0.4:
        return extrude(outline, 0.025).of(wood).moved(z=SEAT - 0.025)
    frame = extrude(outline, 0.04).of(wood).moved(z=SEAT - 0.06)
    if kind < 0.8:
        return join(frame, _pad(outline, 0.045).of(seat_cover(rng, style)).moved(z=SEAT - 0.022))
    rush = Material(texture=palette.plain_fabric(rng).texture, colour=(0.9, 0.8, 0.55))
    return join(frame, _pad(outline, 0.025).of(rush).moved(z=SEAT - 0.022))


def _framed(rng: np.random.Generator, style: Style, kind: str, arms: bool) -> Mesh:
    wood = style.any_wood(rng)
    width, depth = between(rng, 0.42, 0.47), between(rng, 0.41, 0.45)
    height, lean = between(rng, 0.86, 1.02), between(rng, 0.06, 0.1)
    size = between(rng, 0.032, 0.042)
    back = width * 0.88 - size * 0.85
    parts = [_post(side * back / 2, SEAT, height, lean, size) for side in (-1, 1)]
    front = width - 0.03
    turned = style.modern < 0.4 and chance(rng, 0.5)
    for side in (-1, 1):
        x, y = side * (front / 2 - size / 2), depth - 0.04
        if turned:
            t, h = size * 0.6, SEAT - 0.02
            profile = [(0, 0), (0.6 * t, 0), (0.8 * t, 0.1 * h), (0.6 * t, 0.16 * h), (t, 0.6 * h)]
            shaft = lathe([*profile, (0.7 * t, 0.75 * h), (t, 0.8 * h), (t, h), (0, h)], 8)
            parts.append(textured(shaft, quarter=True).moved(x, y))
        else:
            shaft = block(wood, (size, size, SEAT - 0.02), (x, y - size / 2, 0))
            parts.append(textured(shaft, quarter=True))
    level = between(rng, 0.12, 0.25)
    for side in (-1, 1):
        rear = -0.05 + 0.05 * level / SEAT
        path = [(side * back / 2, rear, level), (side * (front / 2 - size / 2), depth - 0.04, level)]
        parts.append(tube(path, 0.009, 6))
    parts.append(tube([(-front / 2, depth / 2, level), (front / 2, depth / 2, level)], 0.009, 6))

    def slope(z: float) -> float:
        return -lean * (z - SEAT) / (height - SEAT)

    def slat(z: float, tall: float, bend: float = 0.025) -> Mesh:
        outline = []
        for thick in (0.0, 0.014):
            xs = np.linspace(-back / 2, back / 2, 7)
            curve = [(float(x), thick - bend * (1 - (2 * x / back) ** 2)) for x in xs]
            outline += curve if thick == 0.0 else curve[::-1]
        body = extrude([*outline[6:], *outline[:6]], tall, smooth=False)
        return body.moved(0, slope(z + tall / 2) - 0.007, z)

    if kind == "ladder":
        count = int(rng.integers(2, 5))
        room = height - SEAT - 0.14
        for k in range(count):
            parts.append(slat(SEAT + 0.12 + room * k / count, min(0.075, room / count * 0.6)))
    else:
        parts.append(slat(height - 0.085, 0.08))
        low = SEAT + between(rng, 0.03, 0.14)
        if kind == "slats":
            parts.append(slat(low, 0.04))
            count = int(rng.choice([1, 3, 4, 5, 6]))
            wide = 0.16 if count == 1 else min(0.035, back / count * 0.55)
            for k in range(count):
                x = (k - (count - 1) / 2) * back / (count + 0.6)
                sag = 0.025 * (1 - (2 * x / back) ** 2)
                top, bottom = height - 0.07, low + 0.02
                y0, y1 = slope(bottom) - sag, slope(top) - sag
                outline = [(y0 - 0.006, bottom), (y0 + 0.006, bottom), (y1 + 0.006, top), (y1 - 0.006, top)]
                parts.append(sideways(outline, wide).moved(x))
        else:
            a, b = back / 2 - 0.01, (SEAT + 0.06, height - 0.07)
            for side in (-1, 1):
                path = [(-side * a, slope(b[0]), b[0]), (0, slope(sum(b) / 2) - 0.03, sum(b) / 2)]
                parts.append(tube([*path, (side * a, slope(b[1]), b[1])], 0.011, 6))
    if arms:
        for side in (-1, 1):
            x = side * (front / 2 + 0.01)
            rest = [(side * back / 2, slope(0.67), 0.67), (x, 0.1, 0.66), (x, depth - 0.08, 0.65)]
            parts.append(tube([*rest, (x - side * 0.02, depth - 0.07, SEAT - 0.03)], 0.015, 8))
    mesh = join(join(parts).of(wood), _seat(rng, style, wood, width, depth).moved(y=0.0))
    if chance(rng, 0.2):
        cushion = pillow(width * 0.82, depth * 0.82, 0.05, 8).of(style.any_fabric(rng))
        mesh = join(mesh, cushion.moved(0, 0.04, SEAT + 0.002))
    return mesh


def _legs(
    rng: np.random.Generator, style: Style, width: float, depth: float, height: float, splay: float
) -> Mesh:
    metal = chance(rng, 0.3 + 0.3 * style.modern)
    material = style.metal if metal else style.any_wood(rng)
    thick, thin = (0.011, 0.011) if metal else (0.02, 0.012)
    parts = []
    for sx in (-1, 1):
        for y, sy in ((0.04, -1), (depth - 0.04, 1)):
            top = (sx * (width / 2 - 0.05), y)
            foot = (top[0] + sx * splay, y + sy * splay)
            parts.append(textured(leg(foot, top, height, thick, thin, 8), quarter=True))
    return join(parts).of(material)


def _upholstered(rng: np.random.Generator, style: Style) -> Mesh:
    cover = seat_cover(rng, style)
    width, depth = between(rng, 0.45, 0.52), between(rng, 0.46, 0.52)
    height = between(rng, 0.84, 1.05)
    outline = [(x, y + depth / 2) for x, y in rectangle(width, depth, 0.05)]
    seat = _pad(outline, 0.11).of(cover).moved(z=SEAT - 0.08)
    tall = height - SEAT + 0.06
    panel = [(x, z + tall / 2) for x, z in rectangle(width, tall, choose(rng, (0.03, 0.08, 0.16)))]
    back = _pad([(x, z) for x, z in panel], 0.085).turned(90, "x").moved(y=0.085).turned(180).moved(y=0.085)
    back = back.turned(9, "x").moved(0, 0.0, SEAT - 0.05).of(cover)
    parts = [seat, back, _legs(rng, style, width, depth, SEAT - 0.07, choose(rng, (0.0, 0.03)))]
    if chance(rng, 0.3):
        for row in range(2):
            for k in (-1, 0, 1):
                button = lathe([(0.013, 0), (0.008, 0.007), (0, 0.009)], 8).turned(-81, "x").of(cover)
                z = 0.16 + 0.14 * row
                parts.append(button.moved(k * width * 0.27, 0.083 - 0.16 * z, SEAT + z - 0.03))
    return join(parts)


def _shell(rng: np.random.Generator, style: Style) -> Mesh:
    colour = palette.plastic(rng) if chance(rng, 0.8) else style.any_wood(rng)
    width = between(rng, 0.44, 0.5)
    arms = chance(rng, 0.35)
    rise = between(rng, 0.3, 0.4)
    curve = [(0.43, -0.03), (0.39, 0.0), (0.24, -0.012), (0.1, 0.0), (0.03, 0.06), (-0.02, 0.18)]
    curve.append((-0.06, rise))
    ys, zs = np.array([p[0] for p in curve]), np.array([p[1] for p in curve])
    knots = np.linspace(0, 1, len(curve))

    def surface(s: np.ndarray, t: np.ndarray) -> tuple[np.ndarray, ...]:
        u = 2 * s - 1
        narrow = np.sqrt(1 - 0.75 * np.clip((t - 0.55) / 0.45, 0, 1) ** 2.5)
        taper = np.where(t < 0.2, 0.9 + 0.5 * t, narrow)
        y, z = np.interp(t, knots, ys), np.interp(t, knots, zs)
        side = np.abs(u) ** 2.5
        lift = (0.2 if arms else 0.06) * np.exp(-(((t - 0.5) / 0.22) ** 2))
        wrap = 0.07 * np.clip((t - 0.55) / 0.3, 0, 1)
        return u * width / 2 * taper, y + side * wrap, z + side * lift

    skin = sheet(surface, 12, 16, (width, 0.8)).of(colour).moved(z=SEAT - 0.01)
    under = _legs(rng, style, width * 0.85, 0.42, SEAT - 0.015, 0.05)
    plate = block(palette.RUBBER, (0.24, 0.24, 0.015), (0, 0.12, SEAT - 0.05))
    parts = [skin, under, plate]
    if chance(rng, 0.35):
        cushion = pillow(0.36, 0.34, 0.045, 8).of(style.any_fabric(rng))
        parts.append(cushion.moved(0, 0.07, SEAT - 0.02))
    return join(parts)


def _bentwood(rng: np.random.Generator, style: Style) -> Mesh:
    wood = style.any_wood(rng)
    r = between(rng, 0.19, 0.21)
    height = between(rng, 0.84, 0.92)
    middle = r + 0.02
    disc = [(r * math.cos(a), r * math.sin(a)) for a in np.linspace(0, 2 * math.pi, 22)[:-1]]
    rim = extrude(disc, 0.035, smooth=True).moved(0, middle, SEAT - 0.035).of(wood)
    seat = seat_cover(rng, style) if chance(rng, 0.4) else Material((0.85, 0.72, 0.45))
    inner = _pad([(0.9 * x, 0.9 * y) for x, y in disc], 0.02).of(seat).moved(0, middle, SEAT - 0.005)
    parts = []
    for sx in (-1, 1):
        foot, top = (sx * 0.19, middle + 0.19), (sx * 0.13, middle + 0.13)
        parts.append(textured(leg(foot, top, SEAT - 0.02, 0.017, 0.012, 8), quarter=True))
    for x, deep in ((0.175, height), (0.11, height - 0.1)):
        angles = np.linspace(0, math.pi, 9)
        arch = deep - x * 1.2
        loop = [(x * math.cos(a), -0.05 - 0.03 * math.sin(a), arch + x * 1.2 * math.sin(a)) for a in angles]
        if x > 0.15:
            legs_right = [(0.19, -0.03, 0.0), (0.165, 0.05, SEAT - 0.02)]
            path = [*legs_right, *loop, *[(-a, b, c) for a, b, c in legs_right[::-1]]]
        else:
            path = [(0.1, 0.05, SEAT - 0.01), *loop, (-0.1, 0.05, SEAT - 0.01)]
        parts.append(tube(path, 0.0135, 8))
    hoop = [(0.16 * math.cos(a), middle + 0.16 * math.sin(a), 0.22) for a in np.linspace(0, 2 * math.pi, 17)]
    parts.append(tube(hoop, 0.009, 6))
    return join(join(parts).of(wood), rim, inner)


def _windsor(rng: np.random.Generator, style: Style) -> Mesh:
    wood = style.any_wood(rng)
    width, depth, height = 0.44, 0.42, between(rng, 0.86, 0.98)
    seat = extrude(_seat_outline(width, width * 0.85, depth, 0.1), 0.035, smooth=True).moved(z=SEAT - 0.035)
    parts = [seat]
    for sx in (-1, 1):
        for y, sy in ((0.07, -1), (depth - 0.07, 1)):
            foot, top = (sx * 0.21, y + sy * 0.06), (sx * 0.15, y)
            parts.append(textured(leg(foot, top, SEAT - 0.02, 0.018, 0.012, 8), quarter=True))
    for y in (0.05, depth - 0.05):
        parts.append(tube([(-0.18, y, 0.2), (0.18, y, 0.2)], 0.009, 6))
    angles = np.linspace(0, math.pi, 11)
    wave = [(math.cos(a), math.sin(a)) for a in angles]
    arch = [(0.185 * c, -0.01 - 0.07 * s, height - 0.2 + 0.2 * s) for c, s in wave]
    parts.append(tube([(0.17, 0.03, SEAT - 0.01), *arch, (-0.17, 0.03, SEAT - 0.01)], 0.012, 8))
    for k in range(6):
        x = (k - 2.5) * 0.052
        s = math.sqrt(max(1 - (x / 0.185) ** 2, 0.0))
        tip = (x, -0.01 - 0.07 * s, height - 0.2 + 0.2 * s)
        parts.append(tube([(0.85 * x, 0.03, SEAT - 0.01), tip], 0.006, 6))
    return join(parts).of(wood)


def _cantilever(rng: np.random.Generator, style: Style) -> Mesh:
    metal = style.metal
    cover = seat_cover(rng, style)
    width, depth, height = 0.46, 0.45, between(rng, 0.8, 0.95)
    parts = []
    for side in (-1, 1):
        x = side * width / 2
        path = [(0.0, 0.0, 0.013), (x, 0.0, 0.013), (x, depth - 0.02, 0.013), (x, depth + 0.01, 0.05)]
        path += [(x, depth + 0.01, SEAT - 0.08), (x, depth - 0.02, SEAT - 0.035), (x, 0.04, SEAT - 0.045)]
        path += [(x, 0.0, SEAT), (x, -0.07, height)]
        parts.append(tube(path, 0.0125, 8))
    frame = join(parts).of(metal)
    seat = _pad([(x, y + depth / 2) for x, y in rectangle(width - 0.02, depth, 0.04)], 0.05).of(cover)
    tall = 0.3
    panel = _pad([(x, z + tall / 2) for x, z in rectangle(width - 0.02, tall, 0.04)], 0.04)
    rest = panel.turned(90, "x").turned(180).turned(9, "x").moved(0, -0.05, height - tall - 0.01).of(cover)
    return join(frame, seat.moved(0, 0.0, SEAT - 0.035), rest)


def bench(rng: np.random.Generator, style: Style, *, width: float = 1.4) -> Mesh:
    """Draw a wooden bench for one side of a table."""
    wood = style.any_wood(rng)
    seat = box(width, 0.34, 0.04, 0.004).moved(z=SEAT - 0.04)
    parts = [seat]
    if chance(rng, 0.5):
        for side in (-1, 1):
            outline = [(-0.15, 0.0), (0.15, 0.0), (0.12, SEAT - 0.04), (-0.12, SEAT - 0.04)]
            board = sideways([(y + 0.17, z) for y, z in outline], 0.04).moved(side * (width / 2 - 0.15))
            parts.append(textured(board, quarter=True))
        parts.append(box(width - 0.3, 0.03, 0.08, 0).moved(0, 0.155, 0.2))
    else:
        for side in (-1, 1):
            for y in (0.02, 0.27):
                parts.append(box(0.05, 0.05, SEAT - 0.04, 0).moved(side * (width / 2 - 0.06), y))
        parts.append(box(width - 0.1, 0.02, 0.07, 0).moved(0, 0.03, SEAT - 0.11))
        parts.append(box(width - 0.1, 0.02, 0.07, 0).moved(0, 0.29, SEAT - 0.11))
    return join(parts).of(wood)


def high_chair(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a child's high chair."""
    wood = style.any_wood(rng)
    parts = []
    for sx in (-1, 1):
        for y, sy in ((0.08, -1), (0.38, 1)):
            parts.append(leg((sx * 0.23, y + sy * 0.07), (sx * 0.15, y), 0.55, 0.017, 0.015, 8))
        parts.append(tube([(sx * 0.15, 0.06, 0.55), (sx * 0.16, 0.0, 0.98)], 0.014, 8))
        parts.append(tube([(sx * 0.155, 0.04, 0.74), (sx * 0.17, 0.4, 0.74)], 0.012, 8))
    parts.append(box(0.34, 0.34, 0.025, 0.004).moved(0, 0.06, 0.54))
    outline = rectangle(0.36, 0.22, 0.06)
    parts.append(frontal([(x, z + 0.9) for x, z in outline], 0.015).moved(y=0.0))
    tray = extrude([(x, y + 0.42) for x, y in rectangle(0.46, 0.26, 0.08)], 0.015).moved(z=0.75)
    return grounded(join(parts).of(wood), tray.of(palette.WHITE))
