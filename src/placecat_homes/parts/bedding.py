"""Bedclothes: sheets, pillows, duvets and blankets."""

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat_homes import palette
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.lofts import pillow, rumples
from placecat_homes.shapes import box, sheet
from placecat_homes.style import Style

Array = NDArray[np.float64]


def cover(
    rng: np.random.Generator,
    width: float,
    start: float,
    end: float,
    top: float,
    *,
    side: float = 0.25,
    foot: float = 0.25,
    thickness: float = 0.05,
    crease: float = 0.012,
    slant: float = 0.0,
    centre: float = 0.0,
    quilt: float = 0.0,
    clear: float = 0.0,
    cells: tuple[int, int] = (32, 26),
) -> Mesh:
    """Draw a blanket over a mattress.

    Parameters
    ----------
    rng
        Random number generator.
    width
        Width of the mattress in metres.
    start, end
        Positions along y in metres: the blanket's edge near the head, and the foot of the bed.
    top
        Height of the top of the mattress in metres.
    side, foot
        How far the blanket hangs down at each side and at the foot, in metres. If `foot` is 0, the blanket
        ends on the mattress.
    thickness, crease
        Thickness of the blanket and height of its creases in metres.
    slant
        How much farther from the head the edge is at +x than at -x, in metres. Nonzero for a blanket that is
        half thrown back.
    centre
        Shift of the blanket along x in metres.
    quilt
        Side length of the stitched squares in metres; 0 for none.
    clear
        Distance in metres between the hanging parts and the mattress, to clear the frame.
    cells
        Number of mesh cells along the width and the length.

    Returns
    -------
    Mesh
        A blanket that is visible from both sides.
    """
    bump = rumples(rng, crease, rng.uniform(0.35, 0.7))
    folds, phase = rng.uniform(0.16, 0.3), rng.uniform(0, 6, 2)
    radius = 0.06
    half = width / 2 + 0.015
    reach = half - radius + radius * math.pi / 2 + max(side - radius, 0.01)
    length = end - start
    foot_arc = radius * math.pi / 2 + max(foot - radius, 0.0) - radius if foot > 0 else 0.0

    def bent(arc: Array, edge: float) -> tuple[Array, Array]:
        """Convert a distance along the blanket into a horizontal position and a drop over the edge."""
        over = np.maximum(arc - (edge - radius), 0.0)
        turn = np.minimum(over / radius, math.pi / 2)
        down = radius * (1 - np.cos(turn)) + np.maximum(over - radius * math.pi / 2, 0.0)
        return np.minimum(arc, edge - radius) + radius * np.sin(turn), down

    def surface(s: Array, t: Array) -> tuple[Array, ...]:
        arc = (2 * s - 1) * reach
        x, fall_x = bent(np.abs(arc), half)
        x = x * np.sign(arc)
        first = start + slant * (s - 0.3) if slant else np.full_like(s, start)
        along = first + t * (end + foot_arc - first)
        y, fall_y = bent(along, end + (0.015 if foot > 0 else 1.0))
        fall = np.maximum(fall_x, fall_y) + 0.3 * np.minimum(fall_x, fall_y)
        near = np.minimum((along - first) / 0.05, 1.0)
        if foot <= 0:
            near = np.minimum(near, (end - along) / 0.05 + 0.0)
        near = np.clip(near, 0.0, 1.0)
        puff = thickness * np.sqrt(np.maximum(1 - (1 - near) ** 2, 0.0))
        on_top = np.exp(-fall / 0.05)
        wrinkle = bump(x, y) * on_top * near
        if quilt > 0:
            seams = np.abs(np.sin(math.pi * arc / quilt) * np.sin(math.pi * (along - start) / quilt))
            wrinkle = wrinkle + 0.02 * (np.sqrt(seams) - 0.6) * on_top * near
        z = top + np.maximum(puff + wrinkle, 0.004) - fall
        sway = np.minimum(fall_x / 0.2, 1.0) * 0.022
        x = x + np.sign(arc) * clear * np.minimum(fall_x / 0.08, 1.0)
        x = x + np.sign(arc) * (
            sway * (1 + np.sin(2 * math.pi * y / folds + phase[0])) + puff * 0.3 * (1 - on_top)
        )
        sway = np.minimum(fall_y / 0.2, 1.0) * 0.022
        y = (
            y
            + clear * np.minimum(fall_y / 0.08, 1.0)
            + sway * (1 + np.sin(2 * math.pi * x / folds + phase[1]))
        )
        return x + centre, y, z

    return sheet(surface, cells[0], cells[1], (2 * reach, length))


def pillows(
    rng: np.random.Generator,
    width: float,
    top: float,
    cloth: Callable[[], Material],
    *,
    upright: bool | None = None,
) -> Mesh:
    """Draw one or two rows of pillows at the head (y = 0). Single beds get one per row, wider beds two.

    Parameters
    ----------
    rng
        Random number generator.
    width
        Width of the mattress in metres.
    top
        Height of the top of the mattress in metres.
    cloth
        Function that returns the material for the next row of pillows.
    upright
        Whether the pillows lean against the headboard; chosen at random if None.

    Returns
    -------
    Mesh
        Pillows within the outline of the mattress.
    """
    across = 1 if width < 1.25 else 2
    size = min(0.78, width / across * 0.88)
    deep = rng.uniform(0.42, 0.52)
    rows = 2 if rng.random() < 0.4 else 1
    upright = bool(rng.random() < 0.35) if upright is None else upright
    parts = []
    for row in range(rows):
        material = cloth()
        for k in range(across):
            x = (k - (across - 1) / 2) * width / across + rng.uniform(-0.02, 0.02)
            one = pillow(size * rng.uniform(0.95, 1.02) * (1 - 0.1 * row), deep, rng.uniform(0.18, 0.24))
            if upright:
                one = one.turned(rng.uniform(58, 72), "x").moved(0, 0.18 + 0.16 * row, 0.0)
            elif row:
                one = one.turned(rng.uniform(28, 42), "x").moved(0, 0.2, 0.07)
            else:
                one = one.turned(rng.uniform(4, 12), "x").moved(0, 0.04, -0.01)
            parts.append(one.turned(rng.uniform(-5, 5)).moved(x, 0, top).of(material))
    return join(parts)


def cushions(rng: np.random.Generator, style: Style, width: float, top: float, y: float) -> Mesh:
    """Draw a row of one to four small leaning cushions."""
    count = int(rng.integers(1, 5 if width > 1.2 else 3))
    parts = []
    for k in range(count):
        size = rng.uniform(0.34, 0.46)
        one = pillow(size, size * rng.uniform(0.65, 1.0), 0.13).turned(rng.uniform(55, 70), "x")
        x = (k - (count - 1) / 2) * min(0.4, width / max(count, 1) * 0.9)
        parts.append(one.turned(rng.uniform(-12, 12)).moved(x, y, top).of(style.any_fabric(rng)))
    return join(parts)


def linen(rng: np.random.Generator, style: Style) -> Material:
    """Choose a material for bed linen."""
    choice = rng.random()
    if choice < 0.25:
        white = palette.shade((0.93, 0.92, 0.9), rng.uniform(0.92, 1.0))
        return Material(white)
    return style.any_fabric(rng) if choice < 0.7 else palette.plain_fabric(rng)


def bedding(
    rng: np.random.Generator,
    style: Style,
    width: float,
    length: float,
    top: float,
    *,
    thick: float = 0.2,
    free: bool = True,
    footboard: bool = False,
    clear: float = 0.0,
    kind: str | None = None,
) -> Mesh:
    """Draw a mattress, pillows, a duvet or bedspread, and perhaps a throw and cushions.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    width, length
        Width and length of the mattress in metres.
    top
        Height of the top of the mattress in metres.
    thick
        Thickness of the mattress in metres.
    free
        Whether blankets hang over the sides and the foot. Otherwise they end inside the frame.
    footboard
        Whether the bed has a footboard. If it does, nothing hangs over the foot.
    clear
        How far the frame extends beyond the mattress in metres.
    kind
        "made" (up to the pillows, with a folded edge), "spread" (everything covered), "open" (thrown back),
        "two" (two duvets side by side) or "folded" (folded at the foot); chosen at random if None.

    Returns
    -------
    Mesh
        The bedclothes, with the head at y = 0.
    """
    kinds = ("made", "spread", "open", "two", "folded")
    kind = kind or str(rng.choice(kinds, p=(0.42, 0.14, 0.22, 0.12, 0.1)))
    if kind == "two" and width < 1.35:
        kind = "made"
    bottom_sheet = linen(rng, style)
    duvet, under = linen(rng, style), linen(rng, style)
    pillow_cloth = duvet if rng.random() < 0.5 else linen(rng, style)
    clothes = [pillow_cloth, linen(rng, style)]
    parts = [box(width, length, thick, bevel=0.04).moved(z=top - thick).of(bottom_sheet)]
    hang = rng.uniform(0.18, 0.34) if free else 0.09
    foot = hang if free and not footboard else 0.07
    crease = rng.uniform(0.01, 0.022)
    puff = rng.uniform(0.04, 0.08)
    quilt = float(rng.uniform(0.2, 0.35)) if rng.random() < 0.25 else 0.0
    start = rng.uniform(0.5, 0.66)
    common: dict[str, Any] = {"side": hang, "crease": crease, "quilt": quilt, "clear": clear}
    if kind == "spread":
        parts.append(cover(rng, width, 0.03, length, top, foot=foot, thickness=0.13, **common).of(duvet))
        parts.append(pillows(rng, width, top + 0.1, lambda: clothes.pop(0), upright=True))
    else:
        parts.append(pillows(rng, width, top, lambda: clothes.pop(0)))
    if kind == "made":
        parts.append(cover(rng, width, start, length, top, foot=foot, thickness=puff, **common).of(duvet))
        if rng.random() < 0.75:
            band = cover(
                rng,
                width,
                start - 0.03,
                start + rng.uniform(0.22, 0.35),
                top + puff * 0.75 + crease,
                side=hang + 0.02,
                clear=clear + 0.01,
                foot=0.0,
                thickness=puff * 0.7,
                crease=crease * 0.6,
                cells=(32, 8),
            )
            parts.append(band.of(under))
    elif kind == "open":
        slant = rng.uniform(0.45, 0.9) * float(rng.choice((-1, 1)))
        first = start + (0.12 if slant > 0 else 0.2)
        options: dict[str, Any] = {
            "foot": foot,
            "thickness": puff + 0.02,
            "slant": slant,
            "side": hang,
            "crease": crease * 1.5,
            "clear": clear,
        }
        parts.append(cover(rng, width, first, length, top, **options).of(duvet))
        band = cover(
            rng,
            width,
            first - 0.02,
            first + abs(slant) * 0.4 + 0.2,
            top + puff * 0.7 + crease * 1.6,
            side=hang + 0.03,
            foot=0.0,
            clear=clear + 0.01,
            thickness=puff,
            crease=crease,
            slant=slant,
            cells=(32, 9),
        )
        parts.append(band.of(under))
    elif kind == "two":
        second = duvet if rng.random() < 0.6 else under
        for sign, cloth in ((-1, duvet), (1, second)):
            one = cover(
                rng,
                width / 2 - 0.07,
                start,
                length - 0.03,
                top,
                side=0.05,
                foot=0.0,
                thickness=puff + 0.05,
                crease=crease,
                centre=sign * width / 4,
                cells=(20, 24),
            )
            parts.append(one.of(cloth))
    elif kind == "folded":
        low = length - rng.uniform(0.55, 0.8)
        for layer in range(2):
            one = cover(
                rng,
                width - 0.1,
                low + 0.02 * layer,
                length - 0.02,
                top + layer * puff * 0.9,
                side=0.05,
                foot=0.0,
                thickness=puff + 0.03,
                crease=crease,
                cells=(28, 12),
            )
            parts.append(one.of(duvet))
    if kind in ("made", "spread") and rng.random() < 0.45:
        lift = top + (puff if kind == "made" else 0.13) + crease + (0.012 if quilt else 0.0)
        from_foot = rng.uniform(0.1, 0.35)
        wide = rng.uniform(0.4, 0.7)
        throw = cover(
            rng,
            width + 0.03,
            length - from_foot - wide,
            length - from_foot,
            lift,
            side=hang + 0.1 if free else 0.1,
            clear=clear + 0.015,
            foot=0.0,
            thickness=0.025,
            crease=0.008,
            cells=(32, 10),
        )
        parts.append(throw.of(style.any_fabric(rng)))
    if rng.random() < 0.35:
        parts.append(cushions(rng, style, width, top + (0.13 if kind == "spread" else 0.04), 0.5))
    return join(parts)
