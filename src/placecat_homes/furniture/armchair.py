"""Armchairs."""

import itertools
import math

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, block, chance, choose, legs
from placecat_homes.furniture.cushions import scatter, seat, upright
from placecat_homes.furniture.sofa import cover, sofa
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.arrange import grounded
from placecat_homes.shapes import box, cylinder, extrude, sheet, tube
from placecat_homes.style import Style


def armchair(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a sofa-like armchair, wing chair, tub chair, rocking chair, recliner or bentwood chair.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.

    Returns
    -------
    Mesh
        A mesh with its base at z = 0.
    """
    modern = style.modern
    kinds = (_like_sofa, wing_chair, tub_chair, rocking_chair, recliner, bent_chair)
    weights = (2, 2 - 1.5 * modern, 1.2, 1.3 - modern, 0.8, 1.0)
    return grounded(choose(rng, kinds, weights)(rng, style))


def _like_sofa(rng: np.random.Generator, style: Style) -> Mesh:
    return sofa(rng, style, 1)


def wing_chair(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a wing chair with a high back."""
    skin = cover(rng, style)
    width, depth, tall = between(rng, 0.7, 0.82), between(rng, 0.78, 0.88), between(rng, 1.02, 1.16)
    arm, inner, foot, top = 0.11, width - 0.22, 0.16, 0.44
    kind = choose(rng, ("turned", "tapered", "square"))
    parts = [
        legs(kind, width - 0.06, depth - 0.14, foot + 0.02, style.any_wood(rng), 0.05).moved(0, 0.09, 0),
        box(inner + 0.1, depth - 0.12, top - 0.13 - foot, 0.02).moved(0, 0.1, foot).of(skin),
        seat(inner, depth - 0.25, 0.16, 0.35).moved(0, 0.23, top - 0.14).of(skin),
        upright(inner + 0.1, 0.16, tall - top + 0.12, 0.3).turned(9, "x").moved(0, 0.21, top - 0.1).of(skin),
    ]
    for side in (-1, 1):
        x = side * (inner + arm) / 2
        parts.append(box(arm, depth - 0.15, 0.62 - foot, 0.03).moved(x, 0.12, foot).of(skin))
        parts.append(tube([(x, 0.12, 0.6), (x, depth - 0.02, 0.6)], arm * 0.58, 12).of(skin))
        profile = [
            (0.09, 0.55),
            (0.3, 0.55),
            (0.34, 0.7),
            (0.36, 0.85),
            (0.3, tall - 0.06),
            (0.22, tall - 0.02),
            (0.08, tall - 0.02),
        ]
        wing = _plate(profile, 0.07).moved(x - side * 0.015, -0.01, 0)
        parts.append(wing.of(skin))
    if chance(rng, 0.5):
        parts.append(scatter(rng, style, inner, 1).moved(0, 0.32, top + 0.02))
    return join(parts)


def _plate(profile: list[tuple[float, float]], thickness: float) -> Mesh:
    """Draw an upright plate whose outline (y, z) is counter-clockwise when seen from +x."""
    flat = extrude(profile, thickness, smooth=True)
    # The outline (y, z) is drawn in the x-y plane. A 90-degree turn about x, then z, makes it upright.
    return flat.turned(90, "x").turned(90).moved(-thickness / 2)


def tub_chair(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a tub chair whose back and arms form one round shell."""
    skin = cover(rng, style)
    radius, height = between(rng, 0.34, 0.4), between(rng, 0.68, 0.82)
    low, thick, foot = between(rng, 0.5, 0.66), 0.08, between(rng, 0.03, 0.18)
    middle = radius + 0.02
    span = math.radians(between(rng, 215, 250))

    def shell(inside: bool) -> Mesh:
        def surface(s: np.ndarray, t: np.ndarray) -> tuple[np.ndarray, ...]:
            # The inner surface is traced in the opposite direction so that it faces inwards.
            s = 1 - s if inside else s
            a = -math.pi / 2 + (s - 0.5) * span
            rim = low + (height - low) * np.cos((s - 0.5) * math.pi) ** 1.5
            r = radius * (0.9 + 0.1 * t)
            z = foot + 0.02 + t * (rim - foot - 0.02)
            if inside:
                r = r - thick
            return r * np.cos(a), middle + r * np.sin(a), z

        return sheet(surface, 26, 4, (radius * span, height))

    def edge(s: np.ndarray, t: np.ndarray) -> tuple[np.ndarray, ...]:
        a = -math.pi / 2 + (s - 0.5) * span
        rim = low + (height - low) * np.cos((s - 0.5) * math.pi) ** 1.5
        r = radius - thick * t
        return r * np.cos(a), middle + r * np.sin(a), rim + 0.025 * np.sin(math.pi * t)

    parts = [shell(False).of(skin), shell(True).of(skin), sheet(edge, 26, 4, (radius * span, thick)).of(skin)]
    for side in (-1, 1):
        a = -math.pi / 2 + side * span / 2
        x, y = (radius - thick / 2) * math.cos(a), middle + (radius - thick / 2) * math.sin(a)
        parts.append(tube([(x * 0.92, y, foot + 0.02), (x, y, low)], thick / 2, 10).of(skin))
    parts.append(cylinder(radius - thick * 0.6, 0.3 - foot, 24, 0.01).moved(0, middle, foot).of(skin))
    cushion = seat(2 * (radius - thick) - 0.01, 2 * (radius - thick) + 0.04, 0.17, 0.3)
    parts.append(cushion.moved(0, thick + 0.02, 0.28).of(skin))
    parts.append(
        legs(
            choose(rng, ("tapered", "splayed", "round")),
            radius * 1.5,
            radius * 1.4,
            foot + 0.03,
            style.any_wood(rng),
            0.04,
        ).moved(0, middle - radius * 0.7, 0)
    )
    return join(parts)


def rocking_chair(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a wooden rocking chair on two runners."""
    wood = style.any_wood(rng)
    width, tall, top = between(rng, 0.5, 0.58), between(rng, 1.0, 1.12), 0.42
    parts = []
    for side in (-1, 1):
        x = side * (width / 2 - 0.03)
        run = [(x, float(y), 0.015 + 0.22 * (float(y) - 0.5) ** 2) for y in np.linspace(0, 0.98, 9)]
        parts.append(tube(run, 0.018, 6))
        parts.append(tube([(x, 0.72, 0.03), (x, 0.7, top), (x, 0.69, 0.64)], 0.018, 8))
        parts.append(tube([(x, 0.3, 0.03), (x, 0.29, top), (x, 0.1, tall)], 0.018, 8))
        parts.append(box(0.06, 0.56, 0.025, 0.008).moved(x, 0.2, 0.635))
    parts.append(box(width, 0.48, 0.035, 0.01).moved(0, 0.26, top - 0.03))
    parts.append(box(width - 0.04, 0.03, 0.09, 0.008).moved(0, 0.09, tall - 0.1))
    for k in range(6):
        x = (k - 2.5) * (width - 0.12) / 5
        parts.append(tube([(x, 0.28, top), (x, 0.11, tall - 0.04)], 0.009, 6))
    chair = join(parts).of(wood)
    if chance(rng, 0.7):
        cloth = style.any_fabric(rng)
        chair = join(chair, seat(width - 0.06, 0.44, 0.06, 0.4).moved(0, 0.27, top).of(cloth))
    return chair


def recliner(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a wide padded recliner, sometimes with its footrest raised."""
    skin = palette.leather(rng) if chance(rng, 0.6) else cover(rng, style)
    width, arm = between(rng, 0.82, 0.95), 0.18
    inner, top, tall = width - 2 * arm, 0.46, between(rng, 0.98, 1.1)
    parts = [
        box(width - 0.08, 0.7, 0.28, 0.02).moved(0, 0.1, 0.02).of(skin),
        seat(inner, 0.62, 0.2, 0.4).moved(0, 0.26, top - 0.18).of(skin),
    ]
    for k, rise in enumerate((0.0, 0.21, 0.42)):
        pad = upright(inner + 0.02, 0.2, 0.25, 0.5).turned(14, "x")
        parts.append(pad.moved(0, 0.26 - 0.055 * k, top - 0.04 + rise * (tall - top) / 0.62).of(skin))
    parts.append(upright(inner, 0.14, tall - 0.16, 0.25).turned(12, "x").moved(0, 0.17, 0.1).of(skin))
    for side in (-1, 1):
        x = side * (inner + arm) / 2
        parts.append(box(arm, 0.76, 0.5, 0.04).moved(x, 0.12, 0.02).of(skin))
        parts.append(seat(arm + 0.02, 0.72, 0.13, 0.5).moved(x, 0.15, 0.49).of(skin))
    if chance(rng, 0.4):
        parts.append(seat(inner, 0.42, 0.13, 0.35).turned(-12, "x").moved(0, 0.9, 0.4).of(skin))
    else:
        parts.append(box(inner, 0.08, 0.26, 0.03).moved(0, 0.8, 0.08).of(skin))
    mesh = join(parts)
    return mesh.moved(0, -float(mesh.low[1]), 0)


def bent_chair(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a lightweight chair with a long cushion on two springy bentwood frames."""
    frame, skin = style.any_wood(rng), cover(rng, style)
    width, depth = between(rng, 0.62, 0.7), 0.78
    parts = []
    for side in (-1, 1):
        x = side * (width / 2 - 0.02)
        loop = [(0.1, 0.03), (0.6, 0.025), (0.72, 0.08), (0.76, 0.3), (0.72, 0.52), (0.6, 0.57), (0.2, 0.55)]
        for a, b in itertools.pairwise(loop):
            parts.append(tube([(x, *a), (x, *b)], 0.024, 8))
        parts.append(tube([(x, 0.66, 0.4), (x * 0.95, 0.25, 0.33), (x * 0.95, 0.02, 1.0)], 0.02, 8))
    parts.append(block(frame, (width, 0.05, 0.02), (0, 0.3, 0.02)))
    wood = join(parts).of(frame)
    cushion = seat(width - 0.1, 0.52, 0.11, 0.3).turned(7, "x").moved(0, 0.22, 0.36).of(skin)
    back = upright(width - 0.1, 0.11, 0.68, 0.3).turned(18, "x").moved(0, 0.27, 0.38).of(skin)
    mesh = join(wood, cushion, back)
    return mesh.moved(0, -float(mesh.low[1]), 0).scaled(1, depth / 0.8, 1)
