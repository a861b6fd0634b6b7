"""Dining tables and kitchen tables."""

import math
from dataclasses import replace

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import backed, between, block, chance, choose, legs
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.outlines import loft, oval, rectangle, sideways, textured
from placecat_homes.shapes import box, extrude, lathe, tube
from placecat_homes.style import Style

HEIGHT = 0.75


def dining_table(
    rng: np.random.Generator,
    style: Style,
    *,
    shape: str | None = None,
    width: float | None = None,
    depth: float | None = None,
    cloth: bool | None = None,
) -> Mesh:
    """Draw a dining table.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    shape
        "rectangle", "round" or "oval"; chosen at random if None.
    width, depth
        Width and depth of the top in metres; chosen at random if None.
    cloth
        Whether the table has a tablecloth; chosen at random if None.

    Returns
    -------
    Mesh
        A table 0.75 m high.
    """
    form = shape or choose(rng, ("rectangle", "round", "oval"), (0.65, 0.2, 0.15))
    if form == "round":
        w = d = width or depth or between(rng, 1.0, 1.35)
    else:
        w, d = width or between(rng, 1.4, 2.1), depth or between(rng, 0.85, 1.0)
    thick = choose(rng, (0.02, 0.03, 0.045))
    wood = style.any_wood(rng)
    glass = style.modern > 0.5 and chance(rng, 0.15)
    top = Material((0.82, 0.9, 0.88), gloss=0.08, roughness=0.0, opacity=0.35) if glass else wood
    if not glass and chance(rng, 0.12):
        top = palette.stone(rng)
    if form == "rectangle":
        board = box(w, d, thick, min(0.006, thick / 3)).moved(0, -d / 2)
        outline = rectangle(w, d, 0.012)
    else:
        outline = oval(w, d, 40)
        board = extrude(outline, thick, smooth=True)
    parts = [board.moved(0, 0, HEIGHT - thick).of(top)]
    parts.append(_under(rng, style, form, w, d, HEIGHT - thick, wood, glass))
    if cloth if cloth is not None else chance(rng, 0.2):
        parts.append(table_cloth(rng, style, outline=outline, drop=between(rng, 0.15, 0.32)))
    return backed(join(parts))


def _under(
    rng: np.random.Generator,
    style: Style,
    form: str,
    w: float,
    d: float,
    height: float,
    wood: Material,
    glass: bool,
) -> Mesh:
    """Draw the legs and apron, centred on the origin."""
    m = style.modern
    kinds: tuple[str, ...]
    weights: tuple[float, ...]
    if form == "round":
        kinds, weights = ("pedestal", "square", "tapered", "crossed"), (0.5, 0.15, 0.2, 0.15)
    else:
        kinds = ("square", "turned", "tapered", "trestle", "sled", "pedestal", "crossed")
        weights = (0.25, 0.25 * (1 - m), 0.2, 0.18, 0.12 * m, 0.12 if form == "oval" else 0.05, 0.12)
    kind = choose(rng, kinds, weights)
    if kind == "pedestal":
        foot = textured(_pedestal(rng, min(d, 1.2) * 0.32, height), quarter=True).of(wood)
        return join(foot.moved(-w * 0.24), foot.moved(w * 0.24)) if w > 1.5 else foot
    if kind == "trestle":
        parts = []
        spread = min(d * 0.38, 0.38)
        for side in (-1, 1):
            x = side * (w / 2 - 0.28)
            beams = [
                sideways([(-spread, 0), (spread, 0), (spread - 0.06, 0.07), (-spread + 0.06, 0.07)], 0.08),
                box(0.08, 0.12, height - 0.12, 0.004).moved(y=-0.06, z=0.06),
                sideways(
                    [
                        (-spread + 0.08, height - 0.07),
                        (spread - 0.08, height - 0.07),
                        (spread - 0.02, height),
                        (-spread + 0.02, height),
                    ],
                    0.07,
                ),
            ]
            parts.append(join(beams).moved(x))
        parts.append(box(w - 0.5, 0.035, 0.1, 0.003).moved(0, -0.017, 0.28))
        return join(parts).of(wood)
    if kind == "crossed":
        parts = []
        for side in (-1, 1):
            x = side * (w / 2 - 0.25) if form != "round" else 0.0
            half = min(d * 0.38, 0.36)
            for lean in (-1, 1):
                path = [(x, -lean * half, 0.022), (x, lean * half, height)]
                bar = tube(path, 0.028, 8) if form != "round" else tube(path, 0.03, 8).turned(45 + 45 * side)
                parts.append(textured(bar, quarter=True))
        if form != "round":
            parts.append(tube([(-w / 2 + 0.25, 0, height / 2), (w / 2 - 0.25, 0, height / 2)], 0.018, 8))
        return join(parts).of(style.metal if glass or chance(rng, 0.3) else wood)
    factor = 0.62 if form != "rectangle" else 1.0
    inset = 0.03 if form == "rectangle" else 0.0
    lw, ld = w * factor - 2 * inset, d * factor - 2 * inset
    thickness = {"square": 0.075, "turned": 0.095, "tapered": 0.07, "sled": 0.06}[kind]
    metal = kind == "sled" or (glass and kind != "turned")
    body = legs(kind, lw, ld, height, style.metal if metal else wood, thickness).moved(y=-ld / 2)
    body = textured(body, quarter=True)
    if kind == "sled" or glass:
        return body
    rail, inner = 0.08, 0.02
    parts = [body]
    for side in (-1, 1):
        y = side * (ld / 2 - thickness / 2) - inner / 2
        parts.append(block(wood, (lw - thickness, inner, rail), (0, y, height - rail)))
        x = side * (lw / 2 - thickness / 2)
        parts.append(block(wood, (inner, ld - thickness, rail), (x, -(ld - thickness) / 2, height - rail)))
    return join(parts)


def _pedestal(rng: np.random.Generator, reach: float, height: float) -> Mesh:
    low = [(0, 0.1), (0.07, 0.1), (0.075, 0.16), (0.04, 0.24), (0.06, 0.36), (0.035, 0.5)]
    column = lathe([*low, (0.06, height - 0.06), (0.14, height - 0.03), (0.14, height), (0, height)], 16)
    if chance(rng, 0.35):
        disc = lathe([(0, 0), (reach, 0), (reach, 0.02), (0.6 * reach, 0.05), (0.06, 0.12), (0, 0.12)], 24)
        return join(disc, column)
    feet = []
    for k in range(4):
        path = [(0.03, 0, 0.2), (0.45 * reach, 0, 0.17), (0.8 * reach, 0, 0.07), (1.05 * reach, 0, 0.03)]
        feet.append(tube(path, 0.028, 8).turned(45 + 90 * k))
    return join(column, feet)


def table_cloth(
    rng: np.random.Generator,
    style: Style,
    *,
    outline: list[tuple[float, float]] | None = None,
    drop: float = 0.25,
) -> Mesh:
    """Draw a tablecloth that hangs in folds around a table top.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    outline
        Counter-clockwise outline of the centred table top; a 1.2 m by 0.8 m rectangle if None.
    drop
        Length of the overhang in metres.

    Returns
    -------
    Mesh
        A tablecloth centred on the origin at table height.
    """
    corners = np.array(outline or rectangle(1.2, 0.8, 0.012))
    closed = np.vstack([corners, corners[:1]])
    along = np.r_[0.0, np.cumsum(np.linalg.norm(np.diff(closed, axis=0), axis=1))]
    n = 120
    places = np.linspace(0, along[-1], n, endpoint=False)
    edge = np.stack([np.interp(places, along, closed[:, k]) for k in (0, 1)], axis=1)
    for corner in corners:
        edge[int(np.argmin(np.linalg.norm(edge - corner, axis=1)))] = corner
    radial = np.roll(edge, -1, axis=0) - np.roll(edge, 1, axis=0)
    outward = np.stack([radial[:, 1], -radial[:, 0]], axis=1)
    outward /= np.linalg.norm(outward, axis=1, keepdims=True)
    phase = float(rng.uniform(0, 6))
    waves = np.sin(2 * math.pi * places / between(rng, 0.16, 0.26) + phase)
    waves += 0.6 * np.sin(2 * math.pi * places / 0.41 + 2 * phase)
    rings = [np.c_[edge * 0.999, np.full(n, HEIGHT + 0.003)]]
    uvs = [edge]
    for t in (0.03, 0.35, 0.7, 1.0):
        swing = 0.012 + 0.02 * t + 0.014 * t * waves
        z = HEIGHT + 0.002 - drop * t
        rings.append(np.c_[edge + outward * np.maximum(swing, 0.009)[:, None], np.full(n, z)])
        uvs.append(edge + outward * (drop * t))
    skirt = loft(rings[::-1])
    uv = np.stack([np.vstack([each, each[:1]]) for each in uvs[::-1]], axis=1).reshape(-1, 2)
    skirt = replace(skirt, uv=uv.astype(np.float32))
    top = extrude([(float(x), float(y)) for x, y in edge], 0.002).moved(z=HEIGHT + 0.001)
    plain = chance(rng, 0.45)
    cloth = palette.plain_fabric(rng) if plain else style.any_fabric(rng)
    return join(skirt, top).of(cloth)


def small_table(rng: np.random.Generator, style: Style, *, width: float | None = None) -> Mesh:
    """Draw a small kitchen table."""
    if chance(rng, 0.35):
        return dining_table(rng, style, shape="round", width=width or between(rng, 0.75, 0.9))
    return dining_table(
        rng, style, shape="rectangle", width=width or between(rng, 0.8, 1.2), depth=between(rng, 0.65, 0.75)
    )


def folding_table(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a narrow folding table that goes against the wall of a small kitchen."""
    wood = style.any_wood(rng)
    w, d = between(rng, 0.8, 1.1), between(rng, 0.45, 0.55)
    top = box(w, d, 0.03, 0.005).moved(z=HEIGHT - 0.03).of(wood)
    brackets = []
    for side in (-1, 1):
        x = side * (w / 2 - 0.12)
        board = sideways([(0, HEIGHT - 0.4), (d * 0.75, HEIGHT - 0.03), (0, HEIGHT - 0.03)], 0.03)
        brackets.append(textured(board).moved(x))
    post = block(wood, (0.04, 0.04, HEIGHT - 0.03), (0, d - 0.08, 0))
    foot = [textured(post, quarter=True).moved(side * (w / 2 - 0.05)) for side in (-1, 1)]
    return join(top, join(brackets).of(wood), foot)
