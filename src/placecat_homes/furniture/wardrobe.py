"""Wardrobes."""

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.laundry_basket import heap
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.arrange import grounded
from placecat_homes.parts.fittings import FRONTS, fronts, handle
from placecat_homes.parts.lofts import pillow
from placecat_homes.shapes import box, cylinder, extrude, superellipsoid, tube
from placecat_homes.style import Style

KINDS = ("hinged", "sliding", "open", "antique")


def wardrobe(
    rng: np.random.Generator,
    style: Style,
    *,
    width: float | None = None,
    kind: str | None = None,
    height: float | None = None,
) -> Mesh:
    """Draw a wardrobe.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    width
        Width in metres; 0.95 to 2.4 if None.
    kind
        "hinged" (two to five doors, sometimes mirrored), "sliding" (two or three doors, often mirrored),
        "open" (no doors) or "antique" (a cornice and drawers); chosen at random if None.
    height
        Height in metres; chosen at random if None.

    Returns
    -------
    Mesh
        A wardrobe 0.55 to 0.65 m deep.
    """
    if kind is None:
        old, new = 1 - style.modern, style.modern
        shares = np.array([0.5, 0.12 + 0.25 * new, 0.12, 0.05 + 0.25 * old])
        kind = str(rng.choice(KINDS, p=shares / shares.sum()))
    choice = rng.random()
    material = style.fronts if choice < 0.35 else style.wood if choice < 0.6 else style.any_wood(rng)
    depth = rng.uniform(0.56, 0.62)
    height = height or rng.uniform(1.95, 2.25)
    if kind == "hinged":
        mesh = _hinged(rng, style, material, width or rng.uniform(0.95, 2.3), depth, height)
    elif kind == "sliding":
        mesh = _sliding(rng, style, material, width or rng.uniform(1.5, 2.4), depth, height)
    elif kind == "open":
        mesh = _open(rng, style, material, width or rng.uniform(1.0, 1.7), depth, height)
    else:
        mesh = _antique(rng, style, style.any_wood(rng), width or rng.uniform(1.0, 1.5), depth, height - 0.05)
    if kind != "antique" and rng.random() < 0.35 * style.clutter + 0.1 and height < 2.15:
        mesh = join(mesh, _on_top(rng, style, float(mesh.size[0]), height))
    return grounded(mesh)


def _on_top(rng: np.random.Generator, style: Style, width: float, height: float) -> Mesh:
    """Put boxes, a suitcase or blankets on top of a wardrobe."""
    parts, x = [], -width / 2 + 0.05
    while x < width / 2 - 0.35:
        wide, high = rng.uniform(0.3, 0.55), rng.uniform(0.1, 0.22)
        if x + wide > width / 2:
            break
        if rng.random() < 0.6:
            cloth = (palette.paint, palette.fabric, palette.plastic)[int(rng.integers(3))](rng)
            parts.append(box(wide, 0.36, high, bevel=0.02).moved(x + wide / 2, 0.08, height).of(cloth))
        elif rng.random() < 0.5:
            parts.append(pillow(wide, 0.4, 0.2).moved(x + wide / 2, 0.08, height).of(style.any_fabric(rng)))
        x += wide + rng.uniform(0.02, 0.2)
    return join(parts)


def _hinged(
    rng: np.random.Generator, style: Style, material: Material, width: float, depth: float, height: float
) -> Mesh:
    doors = max(2, round(width / 0.5))
    design = "flat" if rng.random() < 0.3 + 0.5 * style.modern else str(rng.choice(FRONTS[1:]))
    plinth = 0.08
    drawers = rng.random() < 0.25
    low = plinth + (0.42 if drawers else 0.0)
    grip = style.handle
    door_material = material if rng.random() < 0.75 else style.fronts
    parts = [
        box(width, depth - 0.022, height - plinth, bevel=0.003).moved(z=plinth).of(material),
        box(width - 0.01, depth - 0.06, plinth, bevel=0.0).of(material),
        fronts(
            width,
            height - low - 0.02,
            door_material,
            style.metal,
            columns=doors,
            design=design,
            grip=grip,
            doors=True,
        ).moved(0, depth - 0.022, low),
    ]
    if drawers:
        columns = max(1, doors // 2)
        parts.append(
            fronts(
                width,
                low - plinth - 0.005,
                door_material,
                style.metal,
                rows=2,
                columns=columns,
                design="flat",
                grip=grip,
            ).moved(0, depth - 0.022, plinth)
        )
    share = width / doors
    if rng.random() < 0.35:
        mirrored = (doors // 2,) if doors % 2 else (doors // 2 - 1, doors // 2)
        border = 0.012 if design == "flat" else min(0.07, share * 0.18)
        pane = box(share - 2 * border - 0.006, 0.003, height - low - 0.03 - 2 * border, bevel=0.0).of(
            palette.MIRROR
        )
        lift = 0.0 if design == "flat" else -0.009
        if design in ("flat", "framed"):
            parts += [
                pane.moved((k + 0.5) * share - width / 2, depth - 0.002 + lift, low + border + 0.005)
                for k in mirrored
            ]
    if style.modern < 0.5:
        parts.append(box(width + 0.05, depth + 0.03, 0.04, bevel=0.015).moved(z=height).of(material))
    return join(parts)


def _sliding(
    rng: np.random.Generator, style: Style, material: Material, width: float, depth: float, height: float
) -> Mesh:
    doors = 2 if width < 1.9 else 3
    share = width / doors + 0.03
    mirrors = int(rng.integers(0, doors + 1))
    frame = style.metal if rng.random() < 0.6 else material
    second = palette.paint(rng) if rng.random() < 0.4 else material
    parts = [
        box(width, depth - 0.07, height, bevel=0.003).of(material),
        box(width, 0.07, 0.04, bevel=0.0).moved(0, depth - 0.07).of(material),
        box(width, 0.07, 0.05, bevel=0.0).moved(0, depth - 0.07, height - 0.05).of(material),
    ]
    parts += [
        box(0.02, 0.07, height, bevel=0.0).moved(x, depth - 0.07).of(material)
        for x in (-width / 2 + 0.01, width / 2 - 0.01)
    ]
    tall = height - 0.09
    panels = int(rng.integers(1, 4))
    for k in range(doors):
        x = (k + 0.5) * (width / doors) - width / 2
        y = depth - 0.065 if k % 2 else depth - 0.035
        face = palette.MIRROR if k < mirrors else second if k % 2 else material
        edge = 0.025
        leaf = [box(share - 2 * edge, 0.014, tall - 2 * edge, bevel=0.0).moved(0, 0.004, edge).of(face)]
        leaf += [
            box(edge, 0.026, tall, bevel=0.002).moved(side * (share - edge) / 2).of(frame) for side in (-1, 1)
        ]
        leaf += [
            box(share - 2 * edge, 0.024, edge, bevel=0.0).moved(z=z).of(frame) for z in (0.0, tall - edge)
        ]
        leaf += [
            box(share - 2 * edge, 0.022, 0.015, bevel=0.0).moved(z=tall * part / panels).of(frame)
            for part in range(1, panels)
        ]
        parts.append(join(leaf).moved(min(max(x, -width / 2 + share / 2), width / 2 - share / 2), y, 0.04))
    return join(parts)


def _antique(
    rng: np.random.Generator, style: Style, material: Material, width: float, depth: float, height: float
) -> Mesh:
    low = 0.4
    metal = palette.METALS[2] if rng.random() < 0.6 else style.metal
    crown = box(width + 0.1, depth + 0.06, 0.07, bevel=0.03).moved(z=height - 0.09)
    parts = [
        box(width, depth, height - 0.18, bevel=0.006).moved(z=0.1).of(material),
        crown.of(material),
        box(width + 0.05, depth + 0.03, 0.06, bevel=0.02).moved(z=low - 0.05).of(material),
        box(width + 0.04, depth + 0.02, 0.06, bevel=0.01).moved(z=0.08).of(material),
        fronts(
            width * 0.92,
            height - low - 0.2,
            material,
            metal,
            columns=2,
            design="raised",
            grip="knob",
            doors=True,
        ).moved(0, depth, low + 0.05),
        fronts(width * 0.92, low - 0.2, material, metal, design="flat", grip="bar").moved(0, depth, 0.15),
    ]
    foot = superellipsoid(0.1, 0.1, 0.1, 0.8, 1.0, 10).of(material)
    parts += [foot.moved(x, y) for x in (-width / 2 + 0.06, width / 2 - 0.06) for y in (0.06, depth - 0.05)]
    if rng.random() < 0.5:
        arc = [(width / 2 * np.cos(a), 0.12 * np.sin(a)) for a in np.linspace(0, np.pi, 15)]
        arch = extrude([(float(a), float(b)) for a, b in arc], 0.03, smooth=False)
        parts.append(arch.turned(90, "x").moved(0, depth, height - 0.03).of(material))
    if rng.random() < 0.35:
        pane = box(width * 0.3, 0.004, height - low - 0.45, bevel=0.0).of(palette.MIRROR)
        parts += [pane.moved(x, depth + 0.02, low + 0.17) for x in (-width * 0.23, width * 0.23)]
    return join(parts)


def garment(rng: np.random.Generator, cloth: Material) -> Mesh:
    """Draw a garment on a hanger at the origin, with its shoulders along y."""
    long, wide = rng.uniform(0.65, 1.15), rng.uniform(0.4, 0.48)
    thick = rng.uniform(0.025, 0.05)
    half, sleeve = wide / 2, wide / 2 + 0.05
    outline = [
        (0.0, -0.02),
        (-0.06, 0.0),
        (-half, -0.06),
        (-sleeve, -0.5),
        (-half * 0.8, -0.5),
        (-half * 0.8, -long),
        (half * 0.8, -long),
        (half * 0.8, -0.5),
        (sleeve, -0.5),
        (half, -0.06),
        (0.06, 0.0),
    ]
    body = extrude(outline, thick).moved(z=-thick / 2).turned(90, "x").turned(90)
    hook = tube([(0, 0, -0.02), (0, 0, 0.03), (0, 0.02, 0.05)], 0.003, 5).of(palette.METALS[0])
    return join(body.of(cloth).moved(z=-0.03), hook)


def _open(
    rng: np.random.Generator, style: Style, material: Material, width: float, depth: float, height: float
) -> Mesh:
    """Draw an open wardrobe with a rail of clothes, shelves of folded clothes, and shoes below."""
    thick, shelf_width = 0.022, min(0.5, width * 0.38)
    split = width / 2 - shelf_width
    parts = [
        box(width, 0.012, height, bevel=0.0).of(material),
        *(
            box(thick, depth, height, bevel=0.0).moved(x).of(material)
            for x in (-width / 2 + 0.011, split, width / 2 - 0.011)
        ),
        *(
            box(width, depth, thick, bevel=0.0).moved(z=z).of(material)
            for z in (0.07, height - 0.35, height - thick)
        ),
    ]
    rail_z = height - 0.42
    parts.append(
        tube([(-width / 2, depth / 2, rail_z), (split, depth / 2, rail_z)], 0.012, 8).of(style.metal)
    )
    x = -width / 2 + 0.08
    while x < split - 0.06:
        cloth = palette.fabric(rng) if rng.random() < 0.5 else palette.plain_fabric(rng)
        piece = garment(rng, cloth).turned(rng.uniform(-8, 8)).scaled(1, 1, min(1.0, (rail_z - 0.25) / 1.15))
        parts.append(piece.moved(x, depth / 2, rail_z - 0.02))
        x += rng.uniform(0.05, 0.11)
    middle = split + shelf_width / 2
    for k in range(4):
        z = 0.09 + k * (height - 0.45) / 4
        if k:
            parts.append(box(shelf_width, depth, thick, bevel=0.0).moved(middle, 0, z - thick).of(material))
        pile = z
        for _ in range(int(rng.integers(1, 5))):
            thickness = rng.uniform(0.04, 0.07)
            cloth = palette.plain_fabric(rng) if rng.random() < 0.6 else style.any_fabric(rng)
            fold = superellipsoid(shelf_width * 0.75, 0.34, thickness, 0.5, 0.2, 12)
            parts.append(fold.moved(middle + rng.uniform(-0.02, 0.02), 0.3, pile).of(cloth))
            pile += thickness - 0.006
    for k in range(int(rng.integers(1, 4))):
        shoe = palette.leather(rng)
        for side in (-0.05, 0.05):
            foot = superellipsoid(0.085, 0.26, 0.07, 0.7, 0.7, 12).moved(
                -width / 2 + 0.15 + 0.24 * k + side, depth - 0.2, 0.09
            )
            if -width / 2 + 0.15 + 0.24 * k + 0.1 < split:
                parts.append(foot.of(shoe))
    if rng.random() < 0.7:
        cube = box(0.32, 0.34, 0.22, bevel=0.01).of(style.any_fabric(rng))
        parts.append(cube.moved(-width / 4, 0.12, height - 0.33))
        parts.append(heap(rng, style.any_fabric(rng), 0.3, 0.12).moved(width / 4, 0.3, height - 0.33))
    return join(parts)


def clothes_rail(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a free-standing rail of clothes."""
    width, height, depth = rng.uniform(0.8, 1.3), rng.uniform(1.5, 1.65), 0.44
    metal = style.metal
    parts = [tube([(-width / 2, depth / 2, height), (width / 2, depth / 2, height)], 0.014, 8).of(metal)]
    for x in (-width / 2, width / 2):
        parts.append(tube([(x, depth / 2, 0.05), (x, depth / 2, height + 0.01)], 0.014, 8).of(metal))
        parts.append(tube([(x, 0.0, 0.05), (x, depth, 0.05)], 0.014, 8).of(metal))
        parts += [cylinder(0.025, 0.04, 8).moved(x, y).of(palette.RUBBER) for y in (0.02, depth - 0.02)]
    parts.append(box(width, 0.3, 0.015, bevel=0.0).moved(0, 0.07, 0.1).of(style.any_wood(rng)))
    x = -width / 2 + 0.1
    while x < width / 2 - 0.08:
        cloth = palette.fabric(rng) if rng.random() < 0.5 else palette.plain_fabric(rng)
        parts.append(garment(rng, cloth).turned(rng.uniform(-8, 8)).moved(x, depth / 2, height - 0.025))
        x += rng.uniform(0.06, 0.16)
    mesh = join(parts)
    return mesh.moved(0, -float(mesh.low[1]))


def hanging_clothes(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a garment hanging from a hook on a wall or door. Its hem is at z = 0."""
    piece = garment(rng, style.any_fabric(rng)).turned(90).moved(0, 0.07, 0)
    hook = handle("knob", style.metal).moved(0, 0, 0.03)
    mesh = join(piece, hook)
    return mesh.moved(
        -float(mesh.low[0] + mesh.high[0]) / 2, -min(0.0, float(mesh.low[1])), -float(mesh.low[2])
    )
