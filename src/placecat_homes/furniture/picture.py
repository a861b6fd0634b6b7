"""Pictures and posters."""

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, block, chance, choose
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.shapes import quad
from placecat_homes.style import Style

MOUNT = Material((0.93, 0.92, 0.88))
"""Card mount around a picture."""


def picture(
    rng: np.random.Generator, style: Style, width: float | None = None, height: float | None = None
) -> Mesh:
    """Draw a framed picture to hang on a wall.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    width, height
        Size including the frame, in metres; chosen at random if None.

    Returns
    -------
    Mesh
        A mesh whose lowest point is at z = 0.
    """
    if width is None and height is None:
        long, short = between(rng, 0.3, 1.0), between(rng, 0.62, 0.85)
        width, height = (long, long * short) if chance(rng, 0.6) else (long * short, long)
    elif width is None:
        assert height is not None
        width = height * between(rng, 0.65, 1.5)
    elif height is None:
        height = width * between(rng, 0.65, 1.4)
    kind = choose(rng, ("frame", "frame", "canvas", "ornate"), (2, 2, 1 + style.modern, 2 - 2 * style.modern))
    if kind == "canvas":
        back = block(palette.WHITE, (width, 0.03, height))
        return join(back, quad(width, height).moved(0, 0.031).of(palette.art(rng, width, height)))
    bar = min(width, height) * (between(rng, 0.1, 0.16) if kind == "ornate" else between(rng, 0.03, 0.08))
    bar = min(max(bar, 0.012), 0.07)
    wood = choose(rng, (palette.wood(rng), palette.paint(rng), style.metal, style.wood))
    parts = [_frame(width, height, bar, 0.028, wood)]
    if kind == "ornate":
        inner = palette.metal(rng)
        parts.append(
            _frame(width - 1.2 * bar, height - 1.2 * bar, 0.4 * bar, 0.034, inner).moved(0, 0, 0.6 * bar)
        )
    w, h = width - 2 * bar, height - 2 * bar
    mount = min(w, h) * between(rng, 0.1, 0.22) if chance(rng, 0.5) else 0.0
    if mount:
        parts.append(quad(w, h).moved(0, 0.012, bar).of(MOUNT))
    w, h = w - 2 * mount, h - 2 * mount
    parts.append(quad(w, h).moved(0, 0.014, bar + mount).of(palette.art(rng, w, h)))
    return join(parts)


def _frame(width: float, height: float, bar: float, depth: float, material: Material) -> Mesh:
    return join(
        [block(material, (width, depth, bar), (0, 0, z), 0.003) for z in (0, height - bar)]
        + [
            block(material, (bar, depth, height - 2 * bar), (s * (width - bar) / 2, 0, bar), 0.003)
            for s in (-1, 1)
        ]
    )


def group(rng: np.random.Generator, style: Style, count: int | None = None) -> Mesh:
    """Draw a group of pictures.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    count
        Number of pictures; 2 to 6 if None.

    Returns
    -------
    Mesh
        A group whose lowest point is at z = 0.
    """
    count = int(rng.integers(2, 7)) if count is None else count
    gap = between(rng, 0.04, 0.1)
    if count <= 3 and chance(rng, 0.6):
        width, height = between(rng, 0.25, 0.45), between(rng, 0.3, 0.6)
        step = width + gap
        return join(
            [picture(rng, style, width, height).moved((k - (count - 1) / 2) * step) for k in range(count)]
        )
    parts: list[Mesh] = []
    rows = 2 if count > 2 else 1
    columns = (count + rows - 1) // rows
    edge, middle = 0.0, between(rng, 0.35, 0.5)
    for column in range(columns):
        width = between(rng, 0.22, 0.5)
        for row in range(rows):
            if column * rows + row >= count:
                break
            w, h = width * between(rng, 0.7, 1.0), between(rng, 0.2, middle - gap)
            z = middle - h if row == 0 else middle + gap
            parts.append(picture(rng, style, w, h).moved(edge + width / 2, 0, z))
        edge += width + gap
    mesh = join(parts)
    return mesh.moved(-(edge - gap) / 2, 0, -float(mesh.low[2]))


def poster(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw an unframed poster.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.

    Returns
    -------
    Mesh
        A mesh whose lowest point is at z = 0.
    """
    width = choose(rng, (0.42, 0.5, 0.6, 0.7))
    height = width * 1.414
    if chance(rng, 0.25):
        width, height = height, width
    sheet = quad(width, height).moved(0, 0.004).of(palette.art(rng, width, height))
    return join(block(MOUNT, (width, 0.003, height)), sheet)
