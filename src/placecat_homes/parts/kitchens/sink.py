"""Sinks and taps."""

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, block, chance
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.kitchens.design import SHADOW, STEEL
from placecat_homes.parts.outlines import loft, rectangle, ring
from placecat_homes.shapes import box, cylinder, lathe, tube
from placecat_homes.style import Style


def basin(width: float, depth: float, height: float, radius: float = 0.05) -> Mesh:
    """Draw the inside of a basin below z = 0, centred on the z axis."""
    rings = [
        ring(rectangle(width, depth, radius), 0.0),
        ring(rectangle(width - 0.015, depth - 0.015, radius), -0.85 * height),
        ring(rectangle(width - 0.06, depth - 0.06, radius), -height),
    ]
    walls = loft(rings)
    floor = loft([rings[-1], ring(rectangle(0.1, 0.1, 0.03), -height - 0.004)], close=True)
    drain = cylinder(0.035, 0.006, 14, 0.002).moved(z=-height - 0.004).of(STEEL)
    hole = cylinder(0.018, 0.008, 10, 0).moved(z=-height - 0.004).of(SHADOW)
    return join(walls, floor, drain, hole)


def rim(width: float, depth: float, inner_width: float, inner_depth: float, radius: float = 0.05) -> Mesh:
    """Draw a flat rim around a basin, centred on the z axis. Its top is 3 mm above z = 0."""
    outer = rectangle(width, depth, 0.02)
    inner = rectangle(inner_width, inner_depth, radius)
    top = loft([ring(outer, 0.003), ring(inner, 0.003)])
    edge = loft([ring(outer, 0.0), ring(outer, 0.003)])
    return join(top, edge)


def tap(rng: np.random.Generator, metal: Material) -> Mesh:
    """Draw a mixer tap standing on z = 0, with its spout pointing towards +y."""
    kind = rng.random()
    foot = cylinder(0.025, 0.012, 12, 0.003)
    if kind < 0.4:
        high, reach = between(rng, 0.24, 0.33), between(rng, 0.15, 0.2)
        angles = np.linspace(0, np.pi, 7)
        r = reach / 2
        arc = [(0.0, r - r * float(np.cos(a)), high - r + r * float(np.sin(a))) for a in angles]
        spout = tube([(0, 0, 0), *arc, (0, reach, high - r - 0.05)], 0.012, 8)
        lever = tube([(0.02, 0, 0.06), (0.075, 0.01, 0.085)], 0.007, 6)
        hub = cylinder(0.022, 0.1, 12)
        return join(foot, spout, lever, hub).of(metal)
    if kind < 0.7:
        high, reach = between(rng, 0.13, 0.2), between(rng, 0.16, 0.2)
        body = cylinder(0.023, high, 12)
        spout = tube(
            [(0, 0, high - 0.03), (0, reach, high + 0.02), (0, reach + 0.005, high - 0.01)], 0.012, 8
        )
        lever = tube([(0, 0, high), (0, 0.02, high + 0.03), (0, 0.1, high + 0.055)], 0.008, 6)
        return join(foot, body, spout, lever).of(metal)
    high = between(rng, 0.22, 0.3)
    base = tube([(-0.09, 0, 0.06), (0.09, 0, 0.06)], 0.011, 8)
    legs = [tube([(x, 0, 0), (x, 0, 0.06)], 0.014, 8) for x in (-0.09, 0.09)]
    cross = [
        lathe([(0, 0.07), (0.02, 0.07), (0.026, 0.09), (0.02, 0.105), (0, 0.106)], 8).moved(x)
        for x in (-0.09, 0.09)
    ]
    spout = tube(
        [
            (0, 0, 0.06),
            (0, 0, high - 0.05),
            (0, 0.03, high),
            (0, 0.1, high + 0.01),
            (0, 0.18, high - 0.03),
            (0, 0.19, high - 0.08),
        ],
        0.011,
        8,
    )
    return join(base, legs, cross, spout).of(metal)


def sink(
    rng: np.random.Generator, kind: str, metal: Material, width: float, depth: float
) -> tuple[Mesh, tuple[float, float, float, float]]:
    """Draw a sink with its rim at z = 0 and its back at y = 0.

    Parameters
    ----------
    rng
        Random number generator.
    kind
        "steel" (with a draining board where there is space), "sunk" or "belfast".
    metal
        Material of the tap.
    width, depth
        Width and depth of the space for the sink in metres. A Belfast sink sticks out at the front.

    Returns
    -------
    mesh : Mesh
        The sink with its tap.
    hole : tuple of float
        Left, right, back and front edges of the hole in the worktop.
    """
    if kind == "belfast":
        w, d, wall = min(width, 0.7), 0.46, 0.035
        white = palette.ceramic(rng)
        middle = depth - d / 2 + 0.03
        rings = [
            ring(rectangle(w, d, 0.03), -0.22),
            ring(rectangle(w, d, 0.03), -0.012),
            ring(rectangle(w - 0.02, d - 0.02, 0.03), 0.0),
            ring(rectangle(w - 2 * wall, d - 2 * wall, 0.03), 0.0),
        ]
        inside = basin(w - 2 * wall, d - 2 * wall, 0.19, 0.03)
        bowl = loft(rings).of(white)
        skin = _except_drain(inside, white)
        mesh = join(
            bowl.moved(0, middle), skin.moved(0, middle), tap(rng, metal).moved(0, middle - d / 2 - 0.05)
        )
        return mesh, (-w / 2, w / 2, middle - d / 2, depth + 0.1)
    material = (
        STEEL
        if kind == "steel" or chance(rng, 0.5)
        else Material(palette.colour(rng, 0.2, 0.1, 0.9), gloss=0.03)
    )
    bowl_d, bowl_w = 0.38, min(0.45, width - 0.12)
    middle = depth / 2 + 0.03
    spout = tap(rng, metal).moved(0, middle - bowl_d / 2 - 0.045, 0.003)
    if kind == "steel":
        whole = min(width, 0.95)
        outer_d = 0.5
        side = -1 if chance(rng, 0.5) else 1
        x = 0.0
        parts: list[Mesh] = []
        if whole > 0.72:
            board = whole - bowl_w - 0.06
            x = side * (whole / 2 - bowl_w / 2 - 0.03)
            left = -whole / 2 if side > 0 else whole / 2 - board
            parts.append(box(board, outer_d, 0.004, 0.001).moved(left + board / 2, middle - outer_d / 2))
            for k in range(6):
                y = middle - 0.16 + 0.064 * k
                groove = tube([(left + 0.04, y, 0.005), (left + board - 0.03, y, 0.005)], 0.004, 4)
                parts.append(groove)
            flange = bowl_w + 0.06
        else:
            flange = whole
        parts.append(rim(flange, outer_d, bowl_w, bowl_d).moved(x if whole > 0.72 else 0.0, middle))
        parts.append(_except_drain(basin(bowl_w, bowl_d, 0.16), material).moved(x, middle, 0.003))
        mesh = join(_except_drain(join(parts), material), spout.moved(x))
        return mesh, (x - bowl_w / 2, x + bowl_w / 2, middle - bowl_d / 2, middle + bowl_d / 2)
    inside = _except_drain(basin(bowl_w, bowl_d, 0.18, 0.02), material).moved(0, middle)
    return join(inside, spout), (-bowl_w / 2, bowl_w / 2, middle - bowl_d / 2, middle + bowl_d / 2)


def _except_drain(mesh: Mesh, material: Material) -> Mesh:
    """Set the material of all parts that still have the default material."""
    plain = Material()
    materials = tuple(material if each == plain else each for each in mesh.materials)
    return Mesh(mesh.vertices, mesh.normals, mesh.uv, mesh.triangles, mesh.material, materials, mesh.lamps)


def washing_up(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a bottle of washing-up liquid with a sponge and a brush."""
    r = 0.03
    colour = Material(palette.colour(rng, 0.95, 0.5, 0.95), gloss=0.05)
    bottle = lathe(
        [(0, 0), (r, 0), (r, 0.12), (0.6 * r, 0.17), (0.25 * r, 0.18), (0.25 * r, 0.21), (0, 0.21)], 12
    )
    cap = cylinder(0.012, 0.025, 8, 0.002).moved(z=0.205).of(palette.WHITE)
    sponge = block(Material((0.92, 0.8, 0.25)), (0.09, 0.06, 0.03), (0.09, -0.03, 0))
    top = block(Material((0.2, 0.45, 0.25)), (0.09, 0.06, 0.008), (0.09, -0.03, 0.03))
    return join(bottle.of(colour), cap, sponge, top)
