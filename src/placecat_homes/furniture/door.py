"""Doors with a frame and an open or shut leaf."""

from dataclasses import replace
from itertools import pairwise

import numpy as np

from placecat_homes import palette
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.shapes import box, cylinder, tube
from placecat_homes.style import Style

LEAF = 0.04
"""Thickness of a door leaf in metres."""

_LINING = 0.02


def door(
    rng: np.random.Generator,
    style: Style,
    width: float = 0.85,
    height: float = 2.05,
    wall: float = 0.12,
    angle: float = 90.0,
    hinge: str = "left",
    glass: bool = False,
) -> Mesh:
    """Build a door for an opening in a wall.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the building.
    width, height
        Width and height of the opening in metres.
    wall
        Thickness of the wall in metres.
    angle
        Opening angle of the leaf in degrees; 0 is shut.
    hinge
        Which side the hinge is on ("left" or "right"), as seen from the room the leaf swings into.
    glass
        Whether the leaf is a pane of glass in a narrow frame.

    Returns
    -------
    Mesh
        A door that swings towards +y. The near face of the wall is at y = 0 and the far face is at y = -wall.
    """
    designs = ["plain", "two", "four", "lights"]
    design = "glass" if glass else str(rng.choice(designs, p=[0.35, 0.25, 0.25, 0.15]))
    knob = style.handle == "knob" and rng.random() < 0.6
    casing = float(rng.uniform(0.05, 0.09))
    leaf_width, leaf_height = width - 2 * _LINING + 0.012, height - _LINING - 0.004
    leaf = _leaf(rng, style, design, leaf_width, leaf_height)
    side = leaf_width / 2 - 0.07
    for face in (0, 1):
        handle = _handle(style.metal, knob, leaf_width)
        # The hinge of the leaf is at x = +width / 2, on the left as seen from +y.
        if face == 0:
            handle = handle.moved(-side, LEAF, 0.0)
        else:
            handle = handle.mirrored().turned(180).moved(-side, 0.0, 0.0)
        leaf = join(leaf, handle)
    leaf = leaf.moved(-leaf_width / 2, -LEAF, 0.004)
    leaf = leaf.turned(-angle).moved(leaf_width / 2, 0.0, 0.0)
    if hinge == "right":
        leaf = leaf.mirrored()
    return join(frame(style, width, height, wall, casing), leaf)


def frame(style: Style, width: float, height: float, wall: float = 0.12, casing: float = 0.07) -> Mesh:
    """Build the lining and casings for an opening in a wall.

    Parameters
    ----------
    style
        Style of the building.
    width, height
        Width and height of the opening in metres.
    wall
        Thickness of the wall in metres.
    casing
        Width of the boards around the opening in metres.

    Returns
    -------
    Mesh
        The near face of the wall is at y = 0 and the far face is at y = -wall.
    """
    t, deep = _LINING, 0.014
    parts = []
    for sign in (-1, 1):
        parts.append(_upright(box(t, wall, height, 0.0)).moved(sign * (width - t) / 2, -wall))
    parts.append(box(width, wall, t, 0.0).moved(0, -wall, height - t))
    for y in (-0.002, -wall - deep + 0.002):
        for sign in (-1, 1):
            x = sign * (width + casing - 0.016) / 2
            board = _upright(box(casing, deep, height + casing - 0.008, 0.004))
            parts.append(board.moved(x, y))
        parts.append(box(width + 0.016, deep, casing, 0.004).moved(0, y, height - 0.008))
    return join(parts).of(style.trim)


def leaf_corners(width: float, angle: float, hinge: str) -> np.ndarray:
    """Return the (4, 2) corners of an open leaf's footprint, counter-clockwise in `door` coordinates."""
    t, w = _LINING, width - 2 * _LINING + 0.012
    corners = np.array([(-w, -LEAF), (0.0, -LEAF), (0.0, 0.0), (-w, 0.0)])
    c, s = np.cos(np.radians(-angle)), np.sin(np.radians(-angle))
    corners = corners @ np.array([[c, s], [-s, c]]) + (width / 2 - t, 0.0)
    return corners if hinge == "left" else corners[::-1] * (-1, 1)


def _leaf(rng: np.random.Generator, style: Style, design: str, width: float, height: float) -> Mesh:
    if design == "plain":
        return _upright(box(width, LEAF, height, 0.003)).of(style.trim)
    if design == "glass":
        bar = 0.06
        return _framed(style.metal, width, height, [(0.0, 1.0)], 1, bar, palette.GLASS)
    if design == "lights":
        rows = int(rng.integers(2, 5))
        edges = np.linspace(0.42, 1.0, rows + 1)
        body = _framed(style.trim, width, height, [(float(a), float(b)) for a, b in pairwise(edges)], 2, 0.09)
        low = _upright(box(width - 0.2, 0.02, height * 0.42, 0.0)).moved(0, 0.01, 0.02).of(style.trim)
        return join(body, low)
    split = float(rng.uniform(0.38, 0.5))
    columns = 1 if design == "two" else 2
    return _framed(style.trim, width, height, [(0.0, split), (split, 1.0)], columns, 0.11, style.trim)


def _framed(
    material: Material,
    width: float,
    height: float,
    rows: list[tuple[float, float]],
    columns: int,
    bar: float,
    filling: Material | None = None,
) -> Mesh:
    """Draw a leaf of stiles and rails around panels, or around frosted glass if `filling` is None."""
    parts = []
    for sign in (-1, 1):
        parts.append(_upright(box(bar, LEAF, height, 0.003)).moved(sign * (width - bar) / 2))
    edges = sorted({edge for row in rows for edge in row} | {0.0, 1.0})
    for edge in edges:
        rail = bar * 1.5 if edge == 0.0 else (bar if edge == 1.0 else bar * 0.8)
        z = edge * (height - bar) if edge < 1 else height - rail
        parts.append(box(width - 2 * bar, LEAF, rail, 0.003).moved(0, 0, z))
    for k in range(1, columns):
        x = -width / 2 + bar + k * (width - 2 * bar) / columns
        z = rows[0][0] * (height - bar)
        parts.append(_upright(box(bar * 0.7, LEAF - 0.004, height - z - bar, 0.0)).moved(x, 0.002, z))
    body = join(parts).of(material)
    if filling is None:
        filling = Material((0.85, 0.88, 0.87), gloss=0.05, roughness=0.3, opacity=0.75)
    z = rows[0][0] * (height - bar) + bar * 0.5
    thick = 0.008 if filling.opacity < 1 else 0.016
    panel = _upright(box(width - 1.6 * bar, thick, height - z - bar * 0.6, 0.0))
    panel = panel.moved(0, (LEAF - thick) / 2, z).of(filling)
    if filling.opacity < 1 or len(rows) < 2:
        return join(body, panel)
    raised = []
    for low, high in rows:
        tall = (high - low) * (height - bar) - 2.2 * bar
        wide = (width - 2 * bar) / columns - 1.2 * bar
        if tall < 0.1 or wide < 0.08:
            continue
        for k in range(columns):
            x = -width / 2 + bar + (k + 0.5) * (width - 2 * bar) / columns
            z = low * (height - bar) + 1.7 * bar
            raised.append(_upright(box(wide, LEAF - 0.01, tall, 0.01)).moved(x, 0.005, z))
    return join(body, panel, join(raised).of(material))


def _upright(mesh: Mesh) -> Mesh:
    """Make the wood grain vertical."""
    return replace(mesh, uv=np.ascontiguousarray(mesh.uv[:, ::-1]))


def _handle(metal: Material, knob: bool, width: float) -> Mesh:
    """Draw a handle at hand height on the face y = 0, pointing towards the hinge (+x)."""
    z = 1.03
    if knob:
        ball = cylinder(0.028, 0.03, 12, 0.01).turned(-90, "x").moved(0, 0.03, z)
        stem = cylinder(0.01, 0.04, 8, 0.0).turned(-90, "x").moved(0, 0, z)
        return join(ball, stem).of(metal)
    plate = box(0.035, 0.008, 0.2, 0.003).moved(0, 0, z - 0.13)
    lever = tube([(0, 0.0, z), (0, 0.045, z), (0.02, 0.055, z), (0.12, 0.055, z)], 0.009, 8)
    return join(plate, lever).of(metal)
