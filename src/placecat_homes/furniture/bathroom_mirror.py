"""Mirrors and mirrored cabinets for the wall above a washbasin."""

import math

import numpy as np

from placecat_homes import palette
from placecat_homes.materials import Material
from placecat_homes.mesh import Lamp, Mesh, join
from placecat_homes.parts.arrange import grounded
from placecat_homes.parts.lofts import loft, rounded
from placecat_homes.shapes import box, cylinder, tube
from placecat_homes.style import Style

_LIT = Material((1.0, 0.96, 0.88), emission=1.2)


def bathroom_mirror(
    rng: np.random.Generator,
    style: Style,
    *,
    kind: str | None = None,
    width: float | None = None,
    height: float | None = None,
) -> Mesh:
    """Draw a bathroom mirror.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    kind
        "plain", "framed", "round" or "cabinet"; chosen at random if None.
    width, height
        Size in metres; chosen at random if None.

    Returns
    -------
    Mesh
        A mirror with its lower edge at z = 0, possibly with a lamp above it.
    """
    kind = kind or str(rng.choice(("plain", "framed", "round", "cabinet"), p=(0.25, 0.25, 0.18, 0.32)))
    width = width or rng.uniform(0.45, 0.8)
    height = height or rng.uniform(0.55, 0.8)
    if kind == "plain":
        parts = [_glass(width, height, 0.0), box(width, 0.012, height, bevel=0.0).of(palette.WHITE)]
    elif kind == "framed":
        parts = _framed(rng, style, width, height)
    elif kind == "round":
        parts = _round(rng, style, width, min(height, width * rng.uniform(1.0, 1.4)))
    else:
        parts = _cabinet(rng, style, width, height)
    depth = max(float(part.high[1]) for part in parts)
    top = max(float(part.high[2]) for part in parts)
    if rng.random() < 0.55:
        parts.append(_lamp(rng, style, width, depth).moved(z=top + 0.05))
    elif kind != "cabinet" and rng.random() < 0.35:
        glass = box(width * 0.9, 0.11, 0.008, bevel=0.0).of(palette.GLASS)
        parts.append(glass.moved(z=-0.06))
    return grounded(parts)


def _glass(width: float, height: float, frame: float) -> Mesh:
    sheet = box(width - 2 * frame, 0.004, height - 2 * frame, bevel=0.0)
    return sheet.moved(0, 0.012, frame).of(palette.MIRROR)


def _framed(rng: np.random.Generator, style: Style, width: float, height: float) -> list[Mesh]:
    frame = rng.uniform(0.03, 0.08)
    choice = int(rng.integers(4))
    material = (style.wood, style.metal, palette.paint(rng), palette.wood(rng))[choice]
    bar_h = box(width, 0.03, frame, bevel=0.008)
    bar_v = box(frame, 0.03, height - 2 * frame, bevel=0.008).moved(z=frame)
    x = (width - frame) / 2
    frame_mesh = join(bar_h, bar_h.moved(z=height - frame), bar_v.moved(x), bar_v.moved(-x)).of(material)
    return [_glass(width, height, frame - 0.004), frame_mesh]


def _round(rng: np.random.Generator, style: Style, width: float, height: float) -> list[Mesh]:
    outline = rounded(width, height, (width / 2, height / 2), points=9)
    disc = loft([(outline, 0.0), (outline, 0.012)]).turned(90, "x").mirrored()
    # Once turned upright, the disc stands on z = 0 and extends towards -y.
    disc = disc.moved(0, 0.014)
    angle = np.linspace(0, 2 * math.pi, 33)
    path = [(width / 2 * math.cos(a), 0.01, height / 2 + height / 2 * math.sin(a)) for a in angle]
    frame = style.metal if rng.random() < 0.5 else style.any_wood(rng)
    return [disc.of(palette.MIRROR), tube(path, rng.uniform(0.006, 0.018), 6).of(frame)]


def _cabinet(rng: np.random.Generator, style: Style, width: float, height: float) -> list[Mesh]:
    width = max(width, 0.5)
    depth = rng.uniform(0.11, 0.15)
    material = palette.WHITE if rng.random() < 0.5 else style.fronts
    doors = 3 if width > 0.75 else 2
    share = width / doors
    parts = [box(width, depth, height, bevel=0.003).of(material)]
    for k in range(doors):
        x = (k + 0.5) * share - width / 2
        parts.append(
            box(share - 0.006, 0.016, height - 0.01, bevel=0.0).moved(x, depth, 0.005).of(palette.WHITE)
        )
        edge = 0.0 if style.modern > 0.4 else 0.025
        parts.append(
            box(share - 0.012 - edge, 0.002, height - 0.016 - edge, bevel=0.0)
            .moved(x, depth + 0.016, 0.008 + edge / 2)
            .of(palette.MIRROR)
        )
        if edge:
            knob = cylinder(0.01, 0.02, 8).turned(-90, "x").of(style.metal)
            parts.append(knob.moved(x + (share / 2 - 0.03) * (1 if k % 2 == 0 else -1), depth + 0.016, 0.06))
    return parts


def _lamp(rng: np.random.Generator, style: Style, width: float, depth: float) -> Mesh:
    """Draw a strip light or a row of bulbs for a mirror, with its base at z = 0."""
    white = (1.0, 0.93, 0.82)
    if rng.random() < 0.6:
        length = min(width, rng.uniform(0.35, 0.6))
        arm = box(0.05, depth + 0.06, 0.02, bevel=0.0).of(style.metal)
        strip = tube([(-length / 2, depth + 0.06, 0.01), (length / 2, depth + 0.06, 0.01)], 0.018, 8)
        bulbs = [strip.of(_LIT)]
        parts = [arm, *bulbs]
    else:
        count = int(rng.integers(2, 5))
        length = min(width, count * 0.16)
        parts = [box(length, 0.03, 0.06, bevel=0.004).of(style.metal)]
        bulb = cylinder(0.03, 0.06, 10, bevel=0.015).turned(-90, "x").of(_LIT)
        parts.extend(bulb.moved((k + 0.5) / count * length - length / 2, 0.03, 0.03) for k in range(count))
    return join(parts).lit(Lamp((0.0, depth + 0.12, 0.0), white, 0.25, 0.1))
