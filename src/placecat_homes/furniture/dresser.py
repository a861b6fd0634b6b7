"""Chests of drawers, dressing tables and benches for bedrooms."""

import math

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.books import stack
from placecat_homes.furniture.laundry_basket import heap
from placecat_homes.furniture.picture import picture
from placecat_homes.furniture.plant import plant
from placecat_homes.furniture.table_lamp import table_lamp
from placecat_homes.furniture.vase import vase
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.arrange import grounded
from placecat_homes.parts.fittings import FRONTS, fronts, handle
from placecat_homes.parts.lofts import loft, rounded
from placecat_homes.parts.toiletries import flacon, jar
from placecat_homes.shapes import box, lathe, superellipsoid, tube
from placecat_homes.style import Style


def _stand(mesh: Mesh, x: float, y: float, z: float) -> Mesh:
    """Move an object so that its footprint is centred on (x, y) and its base is at z."""
    middle = (mesh.low + mesh.high) / 2
    return mesh.moved(x - float(middle[0]), y - float(middle[1]), z - float(mesh.low[2]))


def jewel_box(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a small jewellery box, sometimes with its lid open."""
    width, depth, height = rng.uniform(0.16, 0.26), rng.uniform(0.12, 0.18), rng.uniform(0.06, 0.1)
    material = style.any_wood(rng) if rng.random() < 0.6 else palette.leather(rng)
    lid = box(width, depth, 0.025, bevel=0.004)
    opened = rng.random() < 0.4
    lid = lid.turned(100, "x").moved(0, 0.012, height) if opened else lid.moved(z=height)
    mesh = join(box(width, depth, height, bevel=0.004), lid).of(material)
    return mesh.moved(0, -float(mesh.low[1]))


def standing_mirror(rng: np.random.Generator, style: Style, width: float = 0.5, height: float = 0.6) -> Mesh:
    """Draw a slightly tilted oval or square mirror on a stand, for a chest of drawers or dressing table."""
    outline = (
        rounded(width, height, (width / 2, height / 2), points=8)
        if rng.random() < 0.55
        else rounded(width, height, 0.04, points=4)
    )
    # The glass is drawn face down, then turned upright to face +y.
    glass = loft([(outline, 0.0), (outline, 0.006)]).turned(90, "x").moved(0, 0.02, 0)
    frame = style.any_wood(rng) if rng.random() < 0.7 else style.metal
    rim = tube([(float(x), 0.012, float(z)) for x, z in [*outline, outline[0]]], 0.016, 6)
    back = loft([(outline * 0.97, 0.0), (outline * 0.97, 0.006)]).turned(90, "x").moved(0, 0.01, 0.01)
    raised = (
        join(glass.of(palette.MIRROR), join(rim, back).of(frame))
        .turned(rng.uniform(2, 8), "x")
        .moved(0, 0.1, 0.06)
    )
    posts = [
        tube([(x, 0.1, 0.0), (x, 0.1, height * 0.6)], 0.012, 6).of(frame)
        for x in (-width / 2 - 0.02, width / 2 + 0.02)
    ]
    return join(raised, posts, box(width + 0.08, 0.16, 0.02, bevel=0.004).moved(0, 0.02).of(frame))


def _decoration(rng: np.random.Generator, style: Style, width: float, depth: float, top: float) -> Mesh:
    """Put objects on a chest, such as a mirror, a lamp, perfume bottles, framed photographs and clothes."""
    parts: list[Mesh] = []
    room = [(-width / 2 + 0.03, width / 2 - 0.03)]
    if width > 0.75 and rng.random() < 0.4:
        wide = min(0.55, width * 0.45)
        x = rng.uniform(-0.15, 0.15) * width
        mirror = standing_mirror(rng, style, wide, rng.uniform(0.5, 0.7))
        parts.append(mirror.moved(x, 0.0, top))
        room = [(room[0][0], x - wide / 2 - 0.05), (x + wide / 2 + 0.05, room[0][1])]
        for k in range(int(rng.integers(0, 4))):
            bottle = flacon(rng) if rng.random() < 0.7 else jar(rng)
            parts.append(bottle.moved(x + 0.1 * (k - 1), depth - 0.1, top))
    for low, high in room:
        x = low
        while high - x > 0.14:
            wide = min(rng.uniform(0.16, 0.3), high - x)
            thing = _thing(rng, style, wide)
            parts.append(_stand(thing, x + wide / 2, depth * rng.uniform(0.4, 0.55), top))
            x += wide + rng.uniform(0.0, 0.25) * (1.3 - style.clutter)
    return join(parts)


def _thing(rng: np.random.Generator, style: Style, width: float) -> Mesh:
    choice = rng.random()
    if choice < 0.16:
        thing = table_lamp(rng, style)
    elif choice < 0.32:
        size = rng.uniform(0.13, 0.22)
        thing = picture(rng, style, size, size * rng.uniform(1.0, 1.4)).turned(10, "x")
    elif choice < 0.45:
        thing = jewel_box(rng, style)
    elif choice < 0.58:
        spots = [(-0.06, 0.0), (0.0, 0.05), (0.05, -0.02)]
        thing = join(flacon(rng).moved(x, y) for x, y in spots[: int(rng.integers(2, 4))])
    elif choice < 0.68:
        thing = plant(rng, style, rng.uniform(0.2, 0.35))
    elif choice < 0.8:
        thing = vase(rng, style)
    elif choice < 0.9:
        thing = heap(rng, style.any_fabric(rng), 0.3, 0.08)
    else:
        thing = stack(rng, 3)
    fit = min(1.0, width / float(thing.size[0]), 0.36 / float(thing.size[1]), 0.5 / float(thing.size[2]))
    return thing.scaled(fit)


def dresser(rng: np.random.Generator, style: Style, *, width: float | None = None) -> Mesh:
    """Draw a chest of drawers with objects on top.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    width
        Width in metres; 0.6 to 1.5 if None.

    Returns
    -------
    Mesh
        A chest 0.75 to 1.25 m high, not counting the objects on top.
    """
    width = width or rng.uniform(0.6, 1.5)
    depth = rng.uniform(0.4, 0.5)
    columns = 1 if width < 0.85 else 2 if width < 1.3 else int(rng.integers(2, 4))
    rows = int(rng.integers(3, 6)) if width < 1.1 else int(rng.integers(3, 5))
    height = min(0.12 + rows * rng.uniform(0.18, 0.24), 1.25)
    choice = rng.random()
    material = style.wood if choice < 0.35 else style.fronts if choice < 0.55 else style.any_wood(rng)
    face = material if rng.random() < 0.75 else palette.paint(rng)
    design = "flat" if style.modern > 0.55 else str(rng.choice(FRONTS[:3]))
    legs = rng.random() < 0.45
    low = rng.uniform(0.12, 0.2) if legs else 0.07
    parts = [
        box(width, depth - 0.02, height - low, bevel=0.003).moved(z=low).of(material),
        box(width + 0.03, depth + 0.015, 0.025, bevel=0.006).moved(z=height).of(material),
        fronts(
            width - 0.02,
            height - low - 0.01,
            face,
            style.metal,
            rows=rows,
            columns=columns,
            design=design,
            grip=style.handle,
        ).moved(0, depth - 0.02, low + 0.005),
    ]
    if legs:
        leg = lathe([(0, 0), (0.014, 0), (0.024, low), (0, low)], 8).of(material)
        parts += [
            leg.moved(x, y) for x in (-width / 2 + 0.06, width / 2 - 0.06) for y in (0.05, depth - 0.06)
        ]
    else:
        parts.append(box(width - 0.02, depth - 0.05, low, bevel=0.0).of(material))
    parts.append(_decoration(rng, style, width, depth, height + 0.025))
    return grounded(parts)


def vanity_table(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a dressing table with a mirror, drawers and perfume bottles, and a stool in front of it."""
    width, depth, height = rng.uniform(0.85, 1.15), rng.uniform(0.4, 0.48), 0.75
    material = style.any_wood(rng)
    design = "flat" if style.modern > 0.5 else "raised"
    drawer = rng.uniform(0.12, 0.16)
    parts = [
        box(width, depth, 0.025, bevel=0.006).moved(z=height - 0.025).of(material),
        box(width - 0.06, depth - 0.04, drawer, bevel=0.0)
        .moved(0, 0.01, height - drawer - 0.025)
        .of(material),
        fronts(
            width - 0.06,
            drawer,
            material,
            style.metal,
            columns=int(rng.integers(1, 4)),
            design=design,
            grip=style.handle,
        ).moved(0, depth - 0.03, height - drawer - 0.025),
    ]
    if rng.random() < 0.4:
        for x in (-width / 2 + 0.17, width / 2 - 0.17):
            parts.append(
                box(0.3, depth - 0.04, height - drawer - 0.07, bevel=0.003).moved(x, 0.01, 0.05).of(material)
            )
            parts.append(
                fronts(
                    0.3,
                    height - drawer - 0.07,
                    material,
                    style.metal,
                    rows=3,
                    design=design,
                    grip=style.handle,
                ).moved(x, depth - 0.03, 0.05)
            )
    else:
        leg = lathe([(0, 0), (0.014, 0), (0.03, height - drawer - 0.03), (0, height - drawer - 0.03)], 8).of(
            material
        )
        parts += [
            leg.moved(x, y) for x in (-width / 2 + 0.06, width / 2 - 0.06) for y in (0.05, depth - 0.06)
        ]
    parts.append(_vanity_mirror(rng, style, width, height, material))
    for k in range(int(rng.integers(3, 8))):
        x = (k / 7 - 0.5) * (width - 0.1)
        thing = flacon(rng) if rng.random() < 0.6 else jar(rng)
        parts.append(thing.moved(x, depth - rng.uniform(0.08, 0.2), height))
    if rng.random() < 0.5:
        parts.append(_stand(jewel_box(rng, style), width / 2 - 0.15, 0.2, height))
    parts.append(_stool(rng, style, material).moved(rng.uniform(-0.08, 0.08), depth - 0.1))
    return join(parts)


def _vanity_mirror(
    rng: np.random.Generator, style: Style, width: float, height: float, material: Material
) -> Mesh:
    choice = rng.random()
    if choice < 0.4:
        return standing_mirror(rng, style, width * 0.55, rng.uniform(0.55, 0.75)).moved(z=height)
    tall = rng.uniform(0.55, 0.75)

    def wing(wide: float) -> Mesh:
        return join(
            box(wide, 0.02, tall, bevel=0.004).of(material),
            box(wide - 0.05, 0.004, tall - 0.05, bevel=0.0).moved(0, 0.02, 0.025).of(palette.MIRROR),
        )

    centre = width * 0.45
    if choice < 0.75:
        side = width * 0.24
        left = wing(side).moved(-side / 2).turned(-28).moved(-centre / 2 - 0.002, 0.01)
        right = wing(side).moved(side / 2).turned(28).moved(centre / 2 + 0.002, 0.01)
        return join(wing(centre), left, right).moved(0, 0.01, height)
    return wing(width * 0.8).moved(0, 0, height)


def _stool(rng: np.random.Generator, style: Style, material: Material) -> Mesh:
    """Draw a padded stool centred on y = 0.2."""
    width, high = rng.uniform(0.36, 0.46), rng.uniform(0.4, 0.45)
    seat = superellipsoid(width, 0.34, 0.09, 0.45, 0.4 if rng.random() < 0.5 else 1.0, 16)
    parts = [
        seat.moved(0, 0.2, high - 0.02).of(style.any_fabric(rng)),
        box(width * 0.85, 0.28, 0.03, bevel=0.004).moved(0, 0.06, high - 0.03).of(material),
    ]
    for x in (-width * 0.36, width * 0.36):
        parts += [tube([(x * 1.1, y, 0), (x, y, high - 0.03)], 0.015, 8).of(material) for y in (0.09, 0.31)]
    return join(parts)


def bed_bench(rng: np.random.Generator, style: Style, *, width: float | None = None) -> Mesh:
    """Draw a padded bench or chest for the end of a bed, perhaps with a blanket or clothes on it.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    width
        Width in metres; 0.9 to 1.4 if None.

    Returns
    -------
    Mesh
        A bench or chest 0.45 m high.
    """
    width = width or rng.uniform(0.9, 1.4)
    depth, high = rng.uniform(0.36, 0.44), rng.uniform(0.42, 0.48)
    wood = style.any_wood(rng)
    cloth = style.any_fabric(rng)
    parts: list[Mesh] = []
    if rng.random() < 0.4:
        parts += [
            box(width, depth, high - 0.08, bevel=0.006)
            .moved(z=0.02)
            .of(wood if rng.random() < 0.6 else cloth),
            box(width + 0.02, depth + 0.02, 0.06, bevel=0.02).moved(0, -0.01, high - 0.06).of(cloth),
            handle(style.handle, style.metal).moved(0, depth, high - 0.14),
        ]
    else:
        parts += [
            superellipsoid(width, depth, 0.12, 0.3, 0.12, 20).moved(0, depth / 2, high - 0.12).of(cloth),
            box(width - 0.04, depth - 0.04, 0.03, bevel=0.0).moved(0, 0.02, high - 0.14).of(wood),
        ]
        slant = rng.uniform(0.0, 0.06)
        for x in (-width / 2 + 0.08, width / 2 - 0.08):
            out = math.copysign(slant, x)
            parts += [
                tube([(x + out, y, 0), (x, y, high - 0.13)], 0.018, 8).of(wood) for y in (0.05, depth - 0.05)
            ]
    if rng.random() < 0.5:
        fold = superellipsoid(0.4, depth * 0.8, 0.08, 0.4, 0.2, 14)
        parts.append(
            fold.moved(rng.uniform(-0.25, 0.25) * width, depth / 2, high - 0.005).of(style.any_fabric(rng))
        )
    elif rng.random() < 0.5:
        parts.append(
            heap(rng, style.any_fabric(rng), 0.36, 0.1).moved(
                rng.uniform(-0.3, 0.3) * width, depth / 2, high - 0.01
            )
        )
    return grounded(parts)


def tall_mirror(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a full-length mirror leaning against the wall."""
    width, height, frame = rng.uniform(0.42, 0.7), rng.uniform(1.5, 1.8), rng.uniform(0.02, 0.06)
    material = style.any_wood(rng) if rng.random() < 0.7 else style.metal
    post = box(frame, 0.03, height, bevel=0.006).of(material)
    rail = box(width - 2 * frame, 0.03, frame, bevel=0.006).of(material)
    x = (width - frame) / 2
    glass = box(width - 2 * frame + 0.01, 0.006, height - 2 * frame + 0.01, bevel=0.0).moved(
        0, 0.012, frame - 0.005
    )
    whole = join(post.moved(x), post.moved(-x), rail, rail.moved(z=height - frame), glass.of(palette.MIRROR))
    leaning = whole.turned(5, "x").moved(0, height * math.sin(math.radians(5)), 0)
    return leaning.moved(0, -float(leaning.low[1]), -float(leaning.low[2]))
