"""Office chairs and visitor chairs."""

import math

import numpy as np

from placecat_homes import palette
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.forming import bent
from placecat_homes.parts.outlines import frontal, rectangle
from placecat_homes.shapes import box, lathe, superellipsoid, tube
from placecat_homes.style import Style


def office_chair(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a task, mesh or executive swivel chair on a five-star base."""
    kind = str(rng.choice(["task", "mesh", "executive"], p=[0.45, 0.3, 0.25]))
    frame = style.metal if rng.random() < 0.35 else _plastic(rng)
    if kind == "executive":
        cover = palette.leather(rng)
    elif rng.random() < 0.55:
        cover = palette.fabric(rng)
    else:
        grey = float(rng.uniform(0.05, 0.3))
        r, g, b = (float(v) for v in grey * rng.uniform(0.7, 1.4, 3))
        cover = Material((r, g, b))
    seat = float(rng.uniform(0.46, 0.52))
    wide = float(rng.uniform(0.48, 0.54))
    turn = float(rng.uniform(0, 72))
    parts = [_star(frame, _plastic(rng), seat, turn)]
    cushion = superellipsoid(wide, 0.5, 0.1, 0.35, 0.35, 16).moved(0, 0.02, seat - 0.09)
    parts.append(cushion.of(cover))
    parts.append(box(0.26, 0.3, 0.04, 0.01).moved(0, -0.15, seat - 0.11).of(_plastic(rng)))
    parts.append(_back(rng, kind, cover, frame, seat, wide))
    if kind == "executive" or rng.random() < 0.6:
        parts.append(_arms(rng, frame, seat, wide))
    chair = join(parts)
    return chair.moved(y=-float(chair.low[1]))


def visitor_chair(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a plain tubular-steel chair, either cantilevered or with four legs."""
    frame = style.metal if rng.random() < 0.6 else _plastic(rng)
    cover = palette.fabric(rng) if rng.random() < 0.6 else palette.plastic(rng)
    parts = [
        superellipsoid(0.46, 0.45, 0.06, 0.35, 0.3, 16).moved(0, 0.28, 0.42).of(cover),
        bent(superellipsoid(0.44, 0.05, 0.36, 0.35, 0.3, 16), 0.7)
        .turned(10, "x")
        .moved(0, 0.06, 0.56)
        .of(cover),
    ]
    for side in (-1, 1):
        x = side * 0.24
        parts.append(_side(frame, x, style.modern > 0.5))
    parts.append(tube([(-0.24, 0.08, 0.42), (0.24, 0.08, 0.42)], 0.011, 8).of(frame))
    parts.append(tube([(-0.24, 0.46, 0.42), (0.24, 0.46, 0.42)], 0.011, 8).of(frame))
    chair = join(parts)
    return chair.moved(y=-float(chair.low[1]))


def _side(frame: Material, x: float, cantilever: bool) -> Mesh:
    if cantilever:
        line = [
            (x, 0.02, 0.85), (x, 0.08, 0.5), (x, 0.1, 0.43), (x, 0.45, 0.43), (x, 0.5, 0.4),
            (x, 0.51, 0.05), (x, 0.47, 0.012), (x, 0.06, 0.012),
        ]  # fmt: skip
        return tube(line, 0.012, 8).of(frame)
    back = tube([(x, 0.02, 0.85), (x, 0.08, 0.45), (x, 0.02, 0.0)], 0.012, 8)
    front = tube([(x, 0.08, 0.42), (x, 0.46, 0.42), (x, 0.5, 0.0)], 0.012, 8)
    return join(back, front).of(frame)


def _plastic(rng: np.random.Generator) -> Material:
    grey = float(rng.choice([0.05, 0.08, 0.2, 0.45, 0.8], p=[0.35, 0.3, 0.15, 0.1, 0.1]))
    return Material((grey, grey, grey), gloss=0.03)


def _star(frame: Material, wheel: Material, seat: float, turn: float) -> Mesh:
    hub = [(0, 0.07), (0.05, 0.07), (0.045, 0.13), (0.03, 0.15)]
    parts = [
        lathe([*hub, (0.028, seat * 0.65), (0, seat * 0.65)], 10).of(frame),
        tube([(0, 0, seat * 0.6), (0, 0, seat - 0.08)], 0.016, 8).of(palette.BLACK_GLASS),
    ]
    for k in range(5):
        angle = math.radians(turn + 72 * k)
        c, s = math.cos(angle), math.sin(angle)
        line = [(0.03 * c, 0.03 * s, 0.105), (0.18 * c, 0.18 * s, 0.095), (0.31 * c, 0.31 * s, 0.075)]
        parts.append(tube(line, 0.021, 6).of(frame))
        for side in (-0.013, 0.013):
            disc = (
                lathe([(0, 0), (0.029, 0), (0.029, 0.018), (0, 0.018)], 8)
                .moved(z=-0.009)
                .turned(90, "x")
                .moved(0, side)
            )
            parts.append(disc.turned(math.degrees(angle) + 40).moved(0.3 * c, 0.3 * s, 0.029).of(wheel))
    return join(parts)


def _back(
    rng: np.random.Generator, kind: str, cover: Material, frame: Material, seat: float, wide: float
) -> Mesh:
    lean = float(rng.uniform(6, 14))
    if kind == "mesh":
        tall, width = float(rng.uniform(0.5, 0.62)), wide * 0.9
        rim = [(x, 0.0, z + tall / 2) for x, z in rectangle(width, tall, 0.12, 4)]
        net = Material(cover.colour, texture=cover.texture, opacity=float(rng.uniform(0.6, 0.85)))
        panel = frontal(rectangle(width - 0.01, tall - 0.01, 0.12, 4), 0.006).moved(0, -0.003, tall / 2)
        back = join(tube([*rim, rim[0]], 0.014, 6).of(frame), panel.of(net))
        rest = 0.07
    else:
        tall = float(rng.uniform(0.68, 0.78)) if kind == "executive" else float(rng.uniform(0.38, 0.6))
        width = wide * (0.98 if kind == "executive" else float(rng.uniform(0.82, 0.92)))
        thick = 0.11 if kind == "executive" else 0.07
        back = superellipsoid(width, thick, tall, 0.35, 0.3, 16).of(cover)
        if kind == "executive":
            pads = [superellipsoid(width * 0.86, 0.08, tall * 0.3, 0.6, 0.35, 12) for _ in range(3)]
            back = join(
                back, [p.moved(0, 0.03, tall * (0.02 + 0.32 * k)).of(cover) for k, p in enumerate(pads)]
            )
            rest = 0.0
        else:
            rest = float(rng.uniform(0.1, 0.16))
    back = bent(back, 0.55 if kind != "executive" else 0.9)
    parts = [back.turned(lean, "x").moved(0, -0.22, seat + rest)]
    line = [(0, 0.0, seat - 0.1), (0, -0.2, seat - 0.1), (0, -0.27, seat - 0.04)]
    line.append((0, -0.29, seat + rest + 0.2))
    parts.append(tube(line, 0.022, 6).of(frame))
    if kind == "mesh" and rng.random() < 0.3:
        head = bent(superellipsoid(0.28, 0.05, 0.14, 0.4, 0.3, 14), 0.4)
        parts.append(head.moved(0, -0.34, seat + rest + tall).of(cover))
        stem = [(0, -0.3, seat + rest + tall - 0.1), (0, -0.36, seat + rest + tall + 0.07)]
        parts.append(tube(stem, 0.012, 6).of(frame))
    return join(parts)


def _arms(rng: np.random.Generator, frame: Material, seat: float, wide: float) -> Mesh:
    x, z = wide / 2 + 0.03, seat + 0.2
    loop = rng.random() < 0.4
    parts = []
    for side in (-1, 1):
        if loop:
            line = [(0.18, -0.05), (x, -0.05), (x, 0.2), (x, 0.2), (x, -0.22)]
            heights = [seat - 0.08, seat - 0.05, z - 0.03, z, z]
            path = [(side * a, b, c) for (a, b), c in zip(line, heights, strict=True)]
            parts.append(tube(path, 0.014, 6).of(frame))
        else:
            path = [(side * 0.15, 0.0, seat - 0.09), (side * x, 0.0, seat - 0.08), (side * x, 0.0, z)]
            parts.append(tube(path, 0.016, 6).of(frame))
        pad = superellipsoid(0.08, 0.26, 0.035, 0.3, 0.5, 12).moved(side * x, -0.01, z - 0.01)
        parts.append(pad.of(Material((0.07, 0.07, 0.07))))
    return join(parts)
