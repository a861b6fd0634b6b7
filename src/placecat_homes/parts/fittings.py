"""Drawer fronts, door fronts, handles and taps."""

import math

import numpy as np

from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, empty, join
from placecat_homes.shapes import box, cylinder, lathe, superellipsoid, tube

FRONTS = ("flat", "framed", "raised", "louvre", "beaded")
"""Designs of fronts."""

TAPS = ("mixer", "tall", "two handles", "square")
"""Designs of taps."""


def front(width: float, height: float, material: Material, design: str = "flat") -> Mesh:
    """Draw an upright drawer or door front, 2 cm thick, with its back at y = 0.

    Parameters
    ----------
    width, height
        Size in metres.
    material
        Material of the front.
    design
        One of `FRONTS`; small fronts are always flat.

    Returns
    -------
    Mesh
        A front standing on z = 0, centred on x = 0.
    """
    border = min(0.07, width * 0.18, height * 0.28)
    if design == "flat" or border < 0.025:
        return box(width, 0.02, height, bevel=0.003).of(material)
    inner_width, inner_height = width - 2 * border, height - 2 * border
    parts = [
        box(border, 0.022, height, bevel=0.003).moved(-(width - border) / 2),
        box(border, 0.022, height, bevel=0.003).moved((width - border) / 2),
        box(inner_width, 0.022, border, bevel=0.003),
        box(inner_width, 0.022, border, bevel=0.003).moved(z=height - border),
        box(inner_width, 0.010, inner_height, bevel=0.0).moved(z=border),
    ]
    if design == "raised":
        parts.append(
            box(inner_width - 0.04, 0.012, inner_height - 0.04, bevel=0.011).moved(0, 0.008, border + 0.02)
        )
    elif design == "louvre":
        count = max(2, int(inner_height / 0.045))
        slat = box(inner_width, 0.006, inner_height / count * 1.1, bevel=0.0).turned(-28, "x")
        parts.extend(slat.moved(0, 0.004, border + inner_height * k / count) for k in range(count))
    elif design == "beaded":
        count = max(2, round(inner_width / 0.08))
        strip = box(inner_width / count - 0.006, 0.008, inner_height, bevel=0.003)
        parts.extend(
            strip.moved((k + 0.5) / count * inner_width - inner_width / 2, 0.008, border)
            for k in range(count)
        )
    return join(parts).of(material)


def handle(kind: str, metal: Material, length: float = 0.14, *, upright: bool = False) -> Mesh:
    """Draw a handle at the origin, sticking out towards +y.

    Parameters
    ----------
    kind
        "bar", "knob" or "none".
    metal
        Material of the metal parts.
    length
        Length of a bar in metres.
    upright
        Whether a bar is vertical, as on doors.

    Returns
    -------
    Mesh
        A handle centred on the origin.
    """
    if kind == "none":
        return empty()
    if kind == "knob":
        profile = [
            (0, 0),
            (0.008, 0),
            (0.006, 0.012),
            (0.015, 0.02),
            (0.016, 0.026),
            (0.01, 0.032),
            (0, 0.033),
        ]
        return lathe(profile, 10).turned(-90, "x").of(metal)
    half = length / 2
    path = [(-half, 0.0, 0.0), (-half, 0.026, 0.0), (half, 0.026, 0.0), (half, 0.0, 0.0)]
    mesh = tube(path, 0.005, 6).of(metal)
    return mesh.turned(90, "y") if upright else mesh


def fronts(
    width: float,
    height: float,
    material: Material,
    metal: Material,
    *,
    rows: int = 1,
    columns: int = 1,
    design: str = "flat",
    grip: str = "bar",
    gap: float = 0.004,
    doors: bool = False,
) -> Mesh:
    """Cover a rectangle with fronts and handles.

    Parameters
    ----------
    width, height
        Width and height of the rectangle in metres.
    material, metal
        Materials of the fronts and handles.
    rows, columns
        Number of fronts in each direction.
    design
        Design of the fronts (see `front`).
    grip
        Kind of handle (see `handle`). With "none", each front has a dark gap above it instead.
    gap
        Gap between fronts in metres.
    doors
        Whether the fronts are doors. A pair of doors has its handles in the middle.

    Returns
    -------
    Mesh
        The fronts, standing on z = 0 and centred on x = 0, with their backs at y = 0.
    """
    parts: list[Mesh] = []
    w, h = width / columns, height / rows
    slot = 0.014 if grip == "none" else gap
    for row in range(rows):
        for column in range(columns):
            x, z = (column + 0.5) * w - width / 2, row * h
            parts.append(front(w - gap, h - slot, material, design).moved(x, 0, z + gap / 2))
            if doors:
                side = 1 if column % 2 == 0 else -1
                grip_x = x + side * (w / 2 - 0.045)
                grip_z = z + h * (0.5 if h > 1.0 else 0.72)
                length = min(0.22, h * 0.3)
                parts.append(handle(grip, metal, length, upright=True).moved(grip_x, 0.021, grip_z))
            else:
                places = (-0.25, 0.25) if grip == "knob" and w > 0.55 else (0.0,)
                lift = 0.5 if h < 0.28 else 0.75
                parts.extend(
                    handle(grip, metal, min(0.3, w * 0.35)).moved(x + place * w, 0.021, z + h * lift)
                    for place in places
                )
    return join(parts)


def tap(rng: np.random.Generator, metal: Material, kind: str | None = None, size: float = 1.0) -> Mesh:
    """Draw a tap standing on z = 0, with its spout pointing towards +y.

    Parameters
    ----------
    rng
        Random number generator.
    metal
        Material of the metal parts.
    kind
        One of `TAPS`; chosen at random if None.
    size
        Scale factor.

    Returns
    -------
    Mesh
        A tap about 15 cm long.
    """
    kind = kind or str(rng.choice(TAPS))
    parts: list[Mesh]
    if kind == "mixer":
        parts = [
            cylinder(0.024, 0.09, 12),
            tube([(0, 0.0, 0.05), (0, 0.12, 0.085), (0, 0.14, 0.075)], 0.012, 8),
            superellipsoid(0.05, 0.05, 0.035, 0.9, 1.0, 10).moved(0, 0, 0.085),
            tube([(0, 0.0, 0.115), (0, 0.08, 0.145)], 0.006, 6),
        ]
    elif kind == "tall":
        bow = [(0.0, 0.06 - 0.06 * math.cos(a), 0.2 + 0.06 * math.sin(a)) for a in np.linspace(0, math.pi, 8)]
        parts = [
            cylinder(0.022, 0.05, 12),
            tube([(0, 0, 0.03), (0, 0, 0.2), *bow[1:], (0, 0.12, 0.16)], 0.011, 8),
            tube([(0.02, 0, 0.035), (0.07, 0, 0.06)], 0.006, 6),
        ]
    elif kind == "two handles":
        parts = [
            cylinder(0.02, 0.06, 12),
            tube([(0, 0, 0.05), (0, 0.05, 0.1), (0, 0.1, 0.1), (0, 0.12, 0.07)], 0.011, 8),
        ]
        for x in (-0.1, 0.1):
            parts.append(cylinder(0.018, 0.045, 10).moved(x))
            parts.extend(
                tube([(-0.028, 0, 0), (0.028, 0, 0)], 0.006, 6).turned(turn).moved(x, 0, 0.05)
                for turn in (20, 110)
            )
    else:
        parts = [
            box(0.045, 0.045, 0.11, bevel=0.003).moved(0, -0.022),
            box(0.045, 0.14, 0.02, bevel=0.003).moved(0, 0.0, 0.07),
            box(0.03, 0.09, 0.01, bevel=0.002).turned(12, "x").moved(0, -0.01, 0.115),
        ]
    return join(parts).scaled(size).of(metal)


def wall_mixer(metal: Material, *, spout: bool = True) -> Mesh:
    """Draw the mixer tap of a bath or shower: a bar on the wall with two handles, and a spout."""
    parts = [
        tube([(-0.14, 0.05, 0), (0.14, 0.05, 0)], 0.02, 10),
        tube([(-0.18, 0.05, 0), (-0.142, 0.05, 0)], 0.025, 10),
        tube([(0.142, 0.05, 0), (0.18, 0.05, 0)], 0.025, 10),
        tube([(-0.075, 0, 0), (-0.075, 0.05, 0)], 0.025, 10),
        tube([(0.075, 0, 0), (0.075, 0.05, 0)], 0.025, 10),
    ]
    if spout:
        parts.append(tube([(0, 0.05, -0.01), (0, 0.16, -0.02), (0, 0.19, -0.06)], 0.013, 8))
    return join(parts).of(metal)


def hand_shower(metal: Material, white: Material, length: float = 0.6) -> Mesh:
    """Draw a wall rail with a sliding hand shower and its hose. The lower end of the rail is at z = 0."""
    head = length * 0.9
    turn = np.linspace(0, math.pi, 9)
    hose = [
        (0.05 + 0.09 * math.sin(t), 0.06 + 0.02 * math.sin(t), head - (head + 0.25) * float(t) / math.pi)
        for t in turn
    ]
    return join(
        tube([(0, 0.05, 0), (0, 0.05, length)], 0.01, 8).of(metal),
        tube([(0, 0, 0.02), (0, 0.05, 0.02)], 0.014, 8).of(metal),
        tube([(0, 0, length - 0.02), (0, 0.05, length - 0.02)], 0.014, 8).of(metal),
        tube([(0.03, 0.07, head - 0.08), (0.0, 0.16, head + 0.08)], 0.012, 8).of(white),
        cylinder(0.055, 0.025, 14).turned(60, "x").moved(0, 0.165, head + 0.07).of(metal),
        tube(hose, 0.007, 6).of(metal),
    )
