"""Books, magazines and papers."""

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, block, chance, choose
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.shapes import quad

PAGES = Material((0.9, 0.87, 0.78))


def covers(rng: np.random.Generator, count: int = 9) -> list[Material]:
    """Choose cover materials for the books in a home."""
    found = []
    for _ in range(count):
        base = palette.colour(rng, 0.85, 0.12, 0.9)
        found.append(Material(base, gloss=float(rng.choice([0.0, 0.03])), roughness=0.5))
    return found


def row(
    rng: np.random.Generator,
    length: float = 0.6,
    height: float = 0.3,
    depth: float = 0.24,
    pool: list[Material] | None = None,
) -> Mesh:
    """Draw a row of upright books.

    Parameters
    ----------
    rng
        Random number generator.
    length
        Length of the row in metres.
    height
        Height of the shelf in metres; the books are shorter.
    depth
        Depth of the shelf in metres.
    pool
        Covers to choose from; a random selection if None.

    Returns
    -------
    Mesh
        Books standing on z = 0, with their spines facing +y.
    """
    pool = covers(rng) if pool is None else pool
    parts: list[Mesh] = []
    x, deep = -length / 2, min(depth - 0.02, 0.22)
    tall, series, cover = height * 0.7, 0, pool[0]
    thick = 0.03
    while True:
        if series == 0:
            tall = min(height * between(rng, 0.55, 0.95), 0.34)
            thick, cover = between(rng, 0.014, 0.05), choose(rng, pool)
            series = int(rng.integers(3, 8)) if chance(rng, 0.15) else 1
        series -= 1
        if x + thick > length / 2:
            break
        d = deep * between(rng, 0.75, 1.0)
        book = block(cover, (thick, d, tall), (0, 0, 0))
        if thick > 0.022 and chance(rng, 0.75):
            label = choose(rng, (PAGES, palette.METALS[2], palette.RUBBER))
            band = tall * between(rng, 0.08, 0.3)
            mark = quad(thick * 0.75, band).moved(0, d + 0.001, tall * between(rng, 0.45, 0.65)).of(label)
            book = join(book, mark)
        parts.append(book.moved(x + thick / 2, 0, 0))
        x += thick + 0.001
        if chance(rng, 0.03):
            x += between(rng, 0.02, 0.12)
    if not parts:
        return block(cover, (length * 0.9, deep, tall))
    room = length / 2 - x
    if room > 0.09 and tall > 0.15:
        lean = min(18.0, float(np.degrees(np.arcsin(min(room / tall, 0.9)))) * 0.7)
        parts.append(
            block(choose(rng, pool), (0.025, deep * 0.9, tall * 0.95), (-0.0125, 0, 0))
            .turned(-lean, "y")
            .moved(x + room * 0.75, 0, 0.004)
        )
    return join(parts)


def stack(rng: np.random.Generator, count: int | None = None, pool: list[Material] | None = None) -> Mesh:
    """Draw a pile of books or magazines.

    Parameters
    ----------
    rng
        Random number generator.
    count
        Number of books; 2 to 6 if None.
    pool
        Covers to choose from; a random selection if None.

    Returns
    -------
    Mesh
        A mesh with its base at z = 0.
    """
    pool = covers(rng) if pool is None else pool
    count = int(rng.integers(2, 7)) if count is None else count
    width, depth = between(rng, 0.2, 0.3), between(rng, 0.15, 0.22)
    parts, z = [], 0.0
    for k in range(count):
        thick = between(rng, 0.008, 0.04)
        w, d = (
            width * (1 - 0.06 * k) * between(rng, 0.9, 1.0),
            depth * (1 - 0.05 * k) * between(rng, 0.9, 1.0),
        )
        cover = choose(rng, pool)
        book = [
            block(cover, (w, d, 0.003), (0, -d / 2, z)),
            block(cover, (w, d, 0.003), (0, -d / 2, z + thick - 0.003)),
        ]
        book.append(block(PAGES, (w - 0.008, d - 0.008, thick - 0.006), (0, -d / 2 + 0.004, z + 0.003)))
        book.append(block(cover, (w, 0.004, thick), (0, d / 2 - 0.004, z)))
        parts.append(join(book).turned(rng.normal(0, 8)))
        z += thick
    mesh = join(parts)
    return mesh.moved(0, -float(mesh.low[1]), 0)


def magazine(rng: np.random.Generator) -> Mesh:
    """Draw a magazine lying flat, with a picture on its cover."""
    w, d = between(rng, 0.2, 0.23), between(rng, 0.27, 0.3)
    cover = palette.art(rng, w, d)
    top = quad(w, d).turned(90, "x").moved(0, d, 0.008).of(cover)
    return join(block(PAGES, (w, d, 0.007)), top)
