"""Small kitchen appliances, such as kettles, toasters and coffee machines."""

import numpy as np

from placecat_homes import palette
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.arrange import grounded
from placecat_homes.parts.outlines import loft, rectangle, ring, sideways
from placecat_homes.shapes import box, cylinder, lathe, superellipsoid, tube
from placecat_homes.style import Style

BLACK = Material(colour=(0.04, 0.04, 0.045), gloss=0.05, roughness=0.3)
STEEL = Material(colour=(0.74, 0.74, 0.75), gloss=0.55, roughness=0.3)
CLEAR = Material(colour=(0.85, 0.88, 0.88), gloss=0.08, roughness=0.05, opacity=0.25)
COFFEE = Material(colour=(0.08, 0.04, 0.02), gloss=0.04)


def _shell(rng: np.random.Generator) -> Material:
    kind = rng.random()
    if kind < 0.4:
        return STEEL
    return BLACK if kind < 0.6 else palette.plastic(rng)


def kettle(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw an electric kettle on its base."""
    shell = _shell(rng)
    r, height = float(rng.uniform(0.07, 0.082)), float(rng.uniform(0.18, 0.23))
    top = float(rng.uniform(0.55, 0.85)) * r
    base = cylinder(r + 0.012, 0.022, 16, 0.004).of(BLACK)
    body = lathe(
        [
            (0, 0.022),
            (r, 0.022),
            (r, 0.05),
            (0.5 * (r + top) + 0.004, 0.6 * height),
            (top, height),
            (0.5 * top, height + 0.012),
            (0, height + 0.015),
        ],
        18,
    ).of(shell)
    knob = cylinder(0.013, 0.018, 8, 0.004).moved(z=height + 0.012).of(BLACK)
    spout = tube([(top * 0.8, 0, height - 0.05), (top + 0.035, 0, height - 0.005)], 0.016, 8).of(shell)
    handle = tube(
        [
            (-top * 0.85, 0, height - 0.015),
            (-r - 0.035, 0, height - 0.01),
            (-r - 0.05, 0, height - 0.05),
            (-r - 0.02, 0, 0.08),
            (-r + 0.01, 0, 0.06),
        ],
        0.011,
        8,
    ).of(BLACK)
    mesh = join(base, body, knob, spout, handle)
    return grounded(mesh.turned(float(rng.uniform(-60, 60)) + (180 if rng.random() < 0.5 else 0)))


def toaster(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a toaster with two slots, a lever, and perhaps some toast."""
    shell = _shell(rng)
    width, depth, height = float(rng.uniform(0.26, 0.32)), 0.17, float(rng.uniform(0.17, 0.2))
    rounding = float(rng.choice([0.02, 0.05]))
    rings = [
        ring(rectangle(width, depth, rounding), 0.015),
        ring(rectangle(width, depth, rounding), height - 0.03),
        ring(rectangle(width - 0.012, depth - 0.012, rounding), height - 0.01),
        ring(rectangle(width - 0.04, depth - 0.04, rounding), height),
    ]
    body = loft(rings, close=True).of(shell)
    foot = box(width - 0.02, depth - 0.02, 0.02, 0.0).moved(y=-depth / 2 + 0.01).of(BLACK)
    parts = [body, foot]
    for y in (-0.028, 0.028):
        parts.append(box(width * 0.68, 0.03, 0.004, 0.0).moved(0, y - 0.015, height - 0.001).of(BLACK))
        if rng.random() < 0.35:
            toast = Material(colour=(0.72, 0.48, 0.22))
            parts.append(box(0.1, 0.013, 0.05, 0.002).moved(0, y - 0.006, height - 0.005).of(toast))
    parts.append(box(0.03, 0.05, 0.014, 0.003).moved(width / 2 + 0.008, -0.025, height * 0.6).of(BLACK))
    knob = cylinder(0.014, 0.012, 10).turned(90, "y").moved(width / 2, 0.0, height * 0.3)
    parts.append(knob.of(STEEL if shell is BLACK else BLACK))
    return grounded(join(parts).turned(float(rng.uniform(-15, 15))))


def coffee_machine(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a filter coffee machine with a jug, or an espresso machine."""
    shell = _shell(rng)
    if rng.random() < 0.55:
        width, depth, height = 0.2, 0.25, float(rng.uniform(0.31, 0.36))
        back = box(width, 0.1, height, 0.012).of(shell)
        foot = box(width, depth, 0.035, 0.008).of(shell)
        head = box(width, depth - 0.02, 0.1, 0.012).moved(z=height - 0.1).of(shell)
        funnel = lathe([(0, height - 0.15), (0.04, height - 0.15), (0.065, height - 0.1)], 14).moved(y=0.165)
        r = 0.062
        jug = lathe(
            [(0, 0), (r, 0), (r + 0.005, 0.05), (0.75 * r, 0.12), (0.7 * r, 0.12), (r - 0.003, 0.05)], 16
        ).moved(0, 0.165, 0.036)
        coffee = cylinder(r - 0.004, 0.055, 14).moved(0, 0.165, 0.037).of(COFFEE)
        ear = tube([(0, 0.2, 0.15), (0, 0.265, 0.15), (0, 0.255, 0.07)], 0.008, 6).of(BLACK)
        lamp = (
            box(0.03, 0.004, 0.015, 0).moved(0.06, depth, 0.01).of(Material((0.8, 0.1, 0.05), emission=0.6))
        )
        return grounded(back, foot, head, funnel.of(BLACK), jug.of(CLEAR), coffee, ear, lamp)
    width, depth, height = float(rng.uniform(0.22, 0.3)), 0.3, float(rng.uniform(0.29, 0.35))
    back = box(width, 0.17, height, 0.01).of(shell)
    head = box(width, depth - 0.03, 0.12, 0.012).moved(z=height - 0.12).of(shell)
    tray = box(width, depth, 0.05, 0.008).of(BLACK)
    grate = box(width - 0.04, 0.11, 0.006, 0).moved(0, 0.18, 0.05).of(STEEL)
    group = cylinder(0.035, 0.04, 14).moved(0, 0.225, height - 0.16).of(STEEL)
    handle = tube([(0, 0.25, height - 0.15), (0, 0.36, height - 0.16)], 0.012, 8).of(BLACK)
    dial = cylinder(0.024, 0.014, 14).turned(-90, "x").moved(width / 2 - 0.06, depth - 0.03, height - 0.06)
    gauge = cylinder(0.02, 0.01, 14).turned(-90, "x").moved(-width / 2 + 0.06, depth - 0.03, height - 0.06)
    wand = tube([(width / 2 - 0.04, 0.2, height - 0.12), (width / 2 - 0.02, 0.25, 0.09)], 0.005, 6).of(STEEL)
    mug = cylinder(0.033, 0.06, 12).moved(0, 0.22, 0.056).of(palette.ceramic(rng))
    return grounded(back, head, tray, grate, group, handle, dial.of(BLACK), gauge.of(STEEL), wand, mug)


def mixer(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a stand mixer with a bowl, or a blender."""
    shell = palette.plastic(rng) if rng.random() < 0.7 else STEEL
    if rng.random() < 0.6:
        foot = loft(
            [
                ring(rectangle(0.2, 0.34, 0.08), 0),
                ring(rectangle(0.2, 0.34, 0.08), 0.02),
                ring(rectangle(0.17, 0.3, 0.08), 0.035),
            ],
            close=True,
        )
        neck = sideways([(-0.16, 0.02), (-0.04, 0.02), (-0.06, 0.16), (-0.05, 0.26), (-0.15, 0.26)], 0.09)
        head = superellipsoid(0.13, 0.36, 0.13, 0.75, 0.7, 16).moved(0, 0.0, 0.23)
        vessel = lathe(
            [
                (0, 0),
                (0.06, 0),
                (0.1, 0.05),
                (0.115, 0.13),
                (0.118, 0.13),
                (0.112, 0.128),
                (0.095, 0.05),
                (0, 0.01),
            ],
            18,
        ).moved(0, 0.07, 0.033)
        shaft = cylinder(0.02, 0.12, 10).moved(0, 0.09, 0.14).of(STEEL)
        mesh = join(foot.of(shell), neck.of(shell), head.of(shell), vessel.of(STEEL), shaft)
        return grounded(mesh.turned(float(rng.uniform(-50, 50))))
    foot = lathe([(0, 0), (0.085, 0), (0.08, 0.03), (0.06, 0.13), (0, 0.13)], 16).of(shell)
    vessel = lathe([(0.05, 0.13), (0.075, 0.32), (0.072, 0.32), (0.046, 0.14), (0, 0.14)], 16).of(CLEAR)
    lid = cylinder(0.076, 0.025, 16, 0.005).moved(z=0.318).of(BLACK)
    ear = tube([(0.07, 0, 0.29), (0.12, 0, 0.28), (0.11, 0, 0.17), (0.06, 0, 0.17)], 0.009, 6).of(BLACK)
    dial = cylinder(0.02, 0.02, 12).turned(-90, "x").moved(0, 0.06, 0.06).of(BLACK)
    return grounded(foot, vessel, lid, ear, dial)


def radio(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a small kitchen radio."""
    shell = palette.wood(rng) if rng.random() < 0.5 else palette.plastic(rng)
    body = box(0.26, 0.11, 0.16, 0.012).of(shell)
    cloth = box(0.13, 0.004, 0.12, 0).moved(-0.05, 0.11, 0.02).of(BLACK)
    dial = cylinder(0.022, 0.015, 12).turned(-90, "x").moved(0.075, 0.11, 0.05).of(STEEL)
    scale = box(0.08, 0.003, 0.03, 0).moved(0.075, 0.11, 0.1).of(Material((0.9, 0.85, 0.7)))
    aerial = tube([(0.11, 0.03, 0.155), (0.05, 0.03, 0.36)], 0.003, 5).of(STEEL)
    return grounded(body, cloth, dial, scale, aerial)
