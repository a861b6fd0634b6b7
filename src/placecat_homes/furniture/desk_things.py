"""Small objects on desks."""

import math

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, block, chance, choose
from placecat_homes.materials import Material
from placecat_homes.mesh import Lamp, Mesh, join
from placecat_homes.parts.arrange import scattered
from placecat_homes.parts.prints import ink, leaf, lying, stack
from placecat_homes.shapes import box, cylinder, lathe, superellipsoid, tube
from placecat_homes.style import Style

GREY = Material((0.12, 0.12, 0.13), gloss=0.03)


def paper_stack(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a pile of papers."""
    return stack(rng, between(rng, 0.004, 0.11), loose=0.008).turned(between(rng, -20, 20))


def pen_cup(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a cup full of pens and pencils."""
    radius, high = between(rng, 0.035, 0.045), between(rng, 0.09, 0.11)
    cup = lathe(
        [(0, 0), (radius, 0), (radius, high), (radius - 0.003, high), (radius - 0.004, 0.01), (0, 0.01)], 12
    )
    parts = [cup.of(choose(rng, (palette.plastic(rng), style.metal, palette.ceramic(rng))))]
    for _ in range(int(rng.integers(4, 10))):
        angle, lean = between(rng, 0, 2 * math.pi), between(rng, 0.3, 0.95) * radius
        c, s = math.cos(angle), math.sin(angle)
        pen = [(-0.4 * lean * c, -0.4 * lean * s, 0.012), (lean * c, lean * s, between(rng, 0.14, 0.19))]
        parts.append(tube(pen, 0.004, 5).of(Material(ink(rng))))
    return join(parts)


def desk_lamp(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a desk lamp with a bent arm, shining down and forwards."""
    material = choose(rng, (style.metal, palette.paint(rng), Material((0.05, 0.05, 0.05), gloss=0.03)))
    high, reach = between(rng, 0.32, 0.45), between(rng, 0.15, 0.28)
    lean = between(rng, -0.12, 0.02)
    elbow = (0.0, lean, high)
    head = (0.0, reach, high + between(rng, -0.06, 0.1))
    parts = [
        cylinder(between(rng, 0.075, 0.1), 0.02, 18).of(material),
        tube([(0, 0, 0.01), elbow], 0.009, 6).of(material),
        tube([elbow, head], 0.009, 6).of(material),
        cylinder(0.016, 0.03, 8).turned(90, "y").moved(-0.015, lean, high).of(material),
    ]
    light = Lamp((0.0, head[1] + 0.04, head[2] - 0.13), (1.0, 0.86, 0.66), 0.25, 0.03)
    glow = Material((1.0, 0.9, 0.7), emission=2.0)
    if chance(rng, 0.35):
        parts.append(box(0.3, 0.06, 0.03, 0.006).moved(0, head[1], head[2] - 0.02).of(material))
        parts.append(box(0.27, 0.045, 0.004, 0).moved(0, head[1] + 0.007, head[2] - 0.0235).of(glow))
    else:
        shade = lathe([(0.068, 0.0), (0.06, 0.05), (0.035, 0.09), (0.02, 0.12), (0, 0.125)], 16)
        inner = lathe([(0, 0.08), (0.03, 0.08), (0.055, 0.045), (0.066, 0.001)], 16)
        hood = join(shade.of(material), inner.of(Material((0.95, 0.93, 0.88))))
        bulb = superellipsoid(0.05, 0.05, 0.06, 1, 1, 10).moved(z=0.015).of(glow)
        parts.append(join(hood, bulb).turned(22, "x").moved(0, head[1], head[2] - 0.09))
    return join(parts).lit(light)


def phone(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a desk telephone with a handset and a coiled cord."""
    case = Material(choose(rng, ((0.07, 0.07, 0.08), (0.75, 0.74, 0.7), (0.3, 0.3, 0.32))), gloss=0.04)
    parts = [
        block(case, (0.2, 0.2, 0.03), bevel=0.008),
        block(case, (0.19, 0.12, 0.025), (0, 0.005, 0.028), 0.008),
    ]
    r, g, b = case.colour
    keys = Material((1 - 0.8 * r, 1 - 0.8 * g, 1 - 0.8 * b))
    for i in range(3):
        for j in range(4):
            parts.append(block(keys, (0.016, 0.013, 0.004), (-0.01 - 0.024 * i, 0.125 + 0.018 * j, 0.03)))
    display = Material((0.55, 0.65, 0.5), emission=0.15)
    parts.append(block(display, (0.09, 0.035, 0.003), (-0.035, 0.06, 0.052)))
    handset = [(0.065, 0.0, 0.055), (0.065, 0.02, 0.068), (0.065, 0.17, 0.068), (0.065, 0.195, 0.055)]
    parts.append(tube(handset, 0.017, 6).of(case))
    for y in (0.015, 0.18):
        parts.append(box(0.05, 0.045, 0.03, 0.008).moved(0.065, y - 0.022, 0.032).of(case))
    turns = np.linspace(0, 1, 33)
    cord = [
        (
            0.1 + 0.03 * math.sin(3 * t) + 0.006 * math.cos(50 * t),
            0.02 + 0.16 * t,
            0.008 + 0.006 * math.sin(50 * t),
        )
        for t in turns
    ]
    parts.append(tube(cord, 0.002, 4).of(case))
    return join(parts)


def book_pile(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a small pile of books."""
    parts = []
    z = 0.0
    wide = between(rng, 0.19, 0.24)
    for _ in range(int(rng.integers(1, 5))):
        thick, w, d = between(rng, 0.015, 0.045), wide * between(rng, 0.7, 1), between(rng, 0.17, 0.26)
        cover = Material(ink(rng), gloss=0.02)
        book = join(
            box(w, d, thick, 0).of(cover),
            box(w + 0.0005, d - 0.006, thick - 0.006, 0).moved(0.001, -0.001, 0.003).of(leaf(rng, white=1)),
        )
        parts.append(book.moved(y=-d / 2).turned(between(rng, -14, 14)).moved(z=z))
        z += thick
    return join(parts)


def mug(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a mug of coffee."""
    glaze = palette.ceramic(rng) if chance(rng, 0.4) else Material(ink(rng), gloss=0.05, roughness=0.1)
    profile = [(0, 0), (0.036, 0), (0.04, 0.01), (0.04, 0.09), (0.037, 0.09), (0.037, 0.07), (0, 0.07)]
    handle = [(0.038, 0, 0.075), (0.06, 0, 0.07), (0.066, 0, 0.045), (0.055, 0, 0.02), (0.037, 0, 0.018)]
    coffee = cylinder(0.0365, 0.002, 12, 0).moved(z=0.07).of(Material((0.15, 0.08, 0.04), gloss=0.03))
    cup = join(lathe(profile, 14).of(glaze), tube(handle, 0.005, 5).of(glaze), coffee)
    return cup.turned(between(rng, 0, 360))


def in_tray(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw stacked letter trays holding papers."""
    tray = choose(rng, (palette.plastic(rng), Material((0.1, 0.1, 0.1)), style.metal))
    parts = []
    for k in range(int(rng.integers(1, 5))):
        z = 0.068 * k
        parts.append(box(0.26, 0.34, 0.004, 0).moved(z=z + 0.004).of(tray))
        parts.append(box(0.26, 0.006, 0.045, 0).moved(z=z + 0.004).of(tray))
        for side in (-1, 1):
            parts.append(box(0.005, 0.34, 0.045, 0).moved(side * 0.1275, 0, z + 0.004).of(tray))
            for y in (0.01, 0.32):
                parts.append(box(0.008, 0.01, 0.07, 0).moved(side * 0.126, y, z).of(tray))
        if chance(rng, 0.8):
            parts.append(stack(rng, between(rng, 0.004, 0.04), loose=0.004).moved(0, 0.17, z + 0.009))
    return join(parts)


def loose_papers(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a few loose sheets of paper, perhaps with a pen."""
    parts = []
    for k in range(int(rng.integers(1, 4))):
        sheet = lying(rng).turned(between(rng, -30, 30))
        parts.append(sheet.moved(between(rng, -0.05, 0.05), between(rng, -0.04, 0.04), 0.001 * k))
    if chance(rng, 0.6):
        pen = tube([(-0.07, 0, 0.009), (0.07, 0, 0.009)], 0.004, 5).turned(between(rng, 0, 180))
        parts.append(pen.of(Material(ink(rng))))
    return join(parts)


def small_thing(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a stapler, a pad of sticky notes, a calculator, a bottle or a pair of glasses."""
    kind = choose(rng, ("stapler", "notes", "calculator", "bottle", "glasses"))
    if kind == "stapler":
        return join(
            box(0.035, 0.14, 0.02, 0.004).of(GREY),
            box(0.03, 0.13, 0.022, 0.006).turned(8, "x").moved(z=0.02).of(Material(ink(rng), gloss=0.04)),
        )
    if kind == "notes":
        colours = ((0.98, 0.93, 0.4), (0.98, 0.6, 0.75), (0.6, 0.9, 0.6))
        return box(0.076, 0.076, between(rng, 0.01, 0.05), 0).of(Material(choose(rng, colours)))
    if kind == "calculator":
        keys = [
            box(0.013, 0.01, 0.003, 0).moved(-0.024 + 0.016 * i, 0.05 + 0.02 * j, 0.015)
            for i in range(4)
            for j in range(4)
        ]
        return join(
            box(0.08, 0.14, 0.015, 0.003).of(GREY),
            box(0.066, 0.025, 0.002, 0).moved(0, 0.012, 0.015).of(Material((0.6, 0.68, 0.55))),
            join(keys).of(Material((0.8, 0.8, 0.78))),
        )
    if kind == "bottle":
        water = [(0, 0), (0.034, 0.003), (0.034, 0.15), (0.012, 0.2), (0.012, 0.215), (0, 0.215)]
        cap = cylinder(0.014, 0.015, 10).moved(z=0.212).of(Material(ink(rng)))
        clear = Material((0.75, 0.88, 0.95), gloss=0.06, opacity=0.4)
        body = clear if chance(rng, 0.6) else palette.plastic(rng)
        return join(lathe(water, 12).of(body), cap)
    rims = [
        tube(
            [(x + 0.025 * math.cos(a), 0, 0.022 + 0.02 * math.sin(a)) for a in np.linspace(0, 6.283, 9)],
            0.002,
            4,
        )
        for x in (-0.035, 0.035)
    ]
    arms = [tube([(x, 0, 0.03), (x * 0.9, -0.13, 0.01)], 0.002, 4) for x in (-0.06, 0.06)]
    return join(rims, arms).of(GREY)


def clutter(
    rng: np.random.Generator,
    style: Style,
    width: float,
    depth: float,
    *,
    middle: float = 0.7,
    amount: float = 0.6,
) -> Mesh:
    """Draw the small objects on a desk, to the left and right of the computer.

    Parameters
    ----------
    rng, style
        Random number generator and style of the home.
    width, depth
        Width and depth of the desk top in metres. The desk top is at z = 0, centred on x = 0, with its back
        edge at y = 0.
    middle
        Width of the free space in the middle, in metres.
    amount
        How untidy the desk is, from 0 (tidy) to 1 (untidy).
    """
    makers = [paper_stack, pen_cup, loose_papers, book_pile, mug, phone, small_thing, in_tray, desk_lamp]
    weights = np.array([2.0, 1.2, 1.6, 1.3, 1.3, 1.0, 1.5, 0.8, 0.9])
    parts = []
    flat = (width - middle) / 2
    counts = rng.multinomial(round(2 + 7 * amount), [0.5, 0.5])
    chosen = list(rng.choice(len(makers), 2 + int(counts.sum()), p=weights / weights.sum()))
    for side in (-1, 1):
        count = int(counts[(side + 1) // 2]) + 1
        things = [makers[chosen.pop()](rng, style) for _ in range(count)]
        things.sort(key=lambda thing: -float(thing.high[2]))
        area = scattered(rng, things, flat - 0.02, depth - 0.04)
        if len(area.triangles):
            parts.append(area.moved(side * (middle / 2 + flat / 2), depth / 2))
    return join(parts)
