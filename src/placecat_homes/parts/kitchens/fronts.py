"""Doors, drawers and their handles."""

from placecat_homes.furniture.blocks import block
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, empty, join
from placecat_homes.parts.kitchens.design import SHADOW, Design
from placecat_homes.parts.outlines import textured
from placecat_homes.shapes import box, lathe, tube

GAP = 0.004
THICK = 0.02


def handle(design: Design, kind: str, length: float, *, upright: bool) -> Mesh:
    """Draw a handle in front of the plane y = 0, centred on the origin."""
    if kind == "bar":
        h = length / 2
        bar = tube([(-h, 0.032, 0), (h, 0.032, 0)], 0.006, 8)
        feet = [tube([(x, 0, 0), (x, 0.032, 0)], 0.0045, 6) for x in (-0.8 * h, 0.8 * h)]
        mesh = join(bar, feet)
        return (mesh.turned(90, "y") if upright else mesh).of(design.metal)
    if kind == "cup" and not upright:
        shell = lathe([(0.05, 0), (0.045, 0.02), (0.03, 0.032), (0, 0.036)], 12)
        return shell.scaled(1, 0.5, 0.8).turned(-90, "x").moved(z=0.005).of(design.metal)
    if kind in ("knob", "cup"):
        knob = lathe([(0, 0), (0.007, 0), (0.007, 0.012), (0.017, 0.02), (0.013, 0.03), (0, 0.031)], 10)
        return knob.turned(-90, "x").of(design.metal)
    return empty()


def front(design: Design, width: float, height: float, material: Material, *, glass: bool = False) -> Mesh:
    """Draw a door leaf or drawer front without a handle, standing on z = 0 with its back at y = 0."""
    w, h = width - GAP, height - GAP
    upright = h > w
    kind = "frame" if glass else design.door
    if min(w, h) < 0.2 and not glass:
        kind = "flat"
    if kind == "flat":
        leaf = textured(box(w, THICK, h, 0.003), quarter=upright, u=width * 3.1, v=height)
        return leaf.moved(z=GAP / 2).of(material)
    if kind == "boards":
        number = max(2, round(w / 0.1))
        each = w / number
        parts = [block(SHADOW, (w, 0.006, h))]
        for k in range(number):
            strip = textured(box(each - 0.003, THICK, h, 0.004), quarter=True, v=0.13 * k)
            parts.append(strip.moved(-w / 2 + each * (k + 0.5)).of(material))
        return join(parts).moved(z=GAP / 2)
    rail = min(0.075, 0.24 * min(w, h))
    stile = textured(box(rail, THICK, h, 0.002), quarter=True)
    beam = box(w - 2 * rail, THICK, rail, 0.002)
    parts = [
        stile.moved(-(w - rail) / 2),
        textured(stile, v=0.11).moved((w - rail) / 2),
        beam,
        textured(beam, v=0.17).moved(z=h - rail),
    ]
    inner_w, inner_h = w - 2 * rail, h - 2 * rail
    frame = join(parts).of(material)
    if glass:
        pane = block(
            Material((0.9, 0.95, 0.95), gloss=0.08, roughness=0.0, opacity=0.16), (inner_w, 0.004, inner_h)
        )
        bars = []
        if inner_h > 0.4:
            bars.append(block(material, (inner_w, 0.014, 0.018), (0, 0.003, inner_h / 2)))
            bars.append(block(material, (0.018, 0.014, inner_h), (0, 0.003, 0)))
        return join(frame, join(pane, bars).moved(y=0.006, z=rail)).moved(z=GAP / 2)
    panel = textured(box(inner_w, 0.008, inner_h, 0), quarter=upright, v=0.29).of(material).moved(z=rail)
    middle = empty()
    if kind == "panel" and min(inner_w, inner_h) > 0.12:
        raised = box(inner_w - 0.05, 0.016, inner_h - 0.05, 0.012)
        middle = textured(raised, quarter=upright, v=0.29).of(material).moved(z=rail + 0.025)
    return join(frame, panel, middle).moved(z=GAP / 2)


def door(
    design: Design,
    width: float,
    height: float,
    *,
    hinge: int = 1,
    upper: bool = False,
    glass: bool = False,
) -> Mesh:
    """Draw a door with its handle opposite the hinge, which is at -x or +x (`hinge` is -1 or 1)."""
    leaf = front(design, width, height, design.upper_fronts if upper else design.fronts, glass=glass)
    length = min(0.16, height * 0.4)
    x = -hinge * (width / 2 - 0.045)
    from_edge = 0.05 if design.handle in ("knob", "cup") else 0.05 + length / 2
    z = from_edge if upper else height - from_edge
    pull = handle(design, design.handle, length, upright=True).moved(x, THICK - 0.001, z)
    return join(leaf, pull)


def doors(
    design: Design, width: float, height: float, *, hinge: int = 1, upper: bool = False, glass: bool = False
) -> Mesh:
    """Draw one door, or two if the width exceeds 0.62 m."""
    if width <= 0.62:
        return door(design, width, height, hinge=hinge, upper=upper, glass=glass)
    return join(
        door(design, width / 2, height, hinge=side, upper=upper, glass=glass).moved(side * width / 4)
        for side in (-1, 1)
    )


def drawer(design: Design, width: float, height: float) -> Mesh:
    """Draw a drawer front with a handle."""
    length = min(0.5 * width, 0.32) if design.handle == "bar" else 0.1
    z = height / 2 if height < 0.24 else height - 0.07
    pull = handle(design, design.handle, length, upright=False)
    pulls = [pull.moved(0, THICK - 0.001, z)]
    if design.handle in ("knob", "cup") and width > 0.55:
        pulls = [pull.moved(side * width / 4, THICK - 0.001, z) for side in (-1, 1)]
    return join(front(design, width, height, design.fronts), pulls)
