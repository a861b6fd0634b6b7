"""Lofted shapes such as basins, bowls and tubs, and soft shapes such as cushions and cloth."""

import math
from collections.abc import Callable, Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from placecat_homes.mesh import Mesh, from_arrays, join
from placecat_homes.shapes import sheet

Outline = NDArray[np.float64]
Radii = float | tuple[float, float]


def rounded(
    width: float,
    depth: float,
    front: Radii,
    back: Radii | None = None,
    *,
    y: float = 0.0,
    points: int = 5,
) -> Outline:
    """Return a rectangle with rounded corners, counter-clockwise and centred on x = 0.

    Parameters
    ----------
    width, depth
        Size in metres.
    front, back
        Radius of the corners at +y and at -y, or their radii along x and y. If `back` is None, it equals
        `front`.
    y
        Position of the back edge in metres.
    points
        Number of points per corner. Lofted outlines must have the same number of points.

    Returns
    -------
    Outline
        Points in metres, shape (4 * points, 2).
    """
    angle = np.linspace(0, math.pi / 2, points)
    outline = []
    for k, radii in enumerate((front, front, back, back)):
        rx, ry = _pair(front if radii is None else radii)
        rx, ry = min(rx, width / 2), min(ry, depth)
        sx, sy = ((1, 1), (-1, 1), (-1, -1), (1, -1))[k]
        middle = (sx * (width / 2 - rx), (depth - ry) if sy > 0 else ry)
        c, s = np.cos(angle + k * math.pi / 2), np.sin(angle + k * math.pi / 2)
        outline.append(np.stack([middle[0] + rx * c, y + middle[1] + ry * s], 1))
    return np.concatenate(outline)


def _pair(radii: Radii) -> tuple[float, float]:
    return radii if isinstance(radii, tuple) else (radii, radii)


def loft(rings: Sequence[tuple[Outline, float]], *, bottom: bool = True, top: bool = True) -> Mesh:
    """Draw a skin through horizontal outlines.

    Parameters
    ----------
    rings
        Outlines with the same number of points, and their heights, from the bottom up. For a vessel, they go
        up the outside and then down the inside. The edge stays sharp wherever the profile turns by more than
        40 degrees.
    bottom, top
        Whether to close the first outline (visible from below) and the last (visible from above).

    Returns
    -------
    Mesh
        A skin. Its texture coordinates are in metres: u runs around the skin and v along the profile.
    """
    levels = np.stack([np.c_[outline, np.full(len(outline), z)] for outline, z in rings])
    middle = levels.mean(axis=1, keepdims=True)
    radius = np.linalg.norm((levels - middle)[..., :2], axis=2).mean(axis=1)
    profile = np.stack([radius, levels[:, 0, 2]], 1)
    steps = np.diff(profile, axis=0)
    angle = np.arctan2(steps[:, 1], steps[:, 0])
    turn = np.abs((np.diff(angle) + math.pi) % (2 * math.pi) - math.pi)
    bounds = [0, *(int(k) + 1 for k in np.flatnonzero(turn > math.radians(40))), len(levels) - 1]
    length = np.r_[0.0, np.cumsum(np.linalg.norm(steps, axis=1))]
    parts = [_skin(levels[first : last + 1], length[first : last + 1]) for first, last in pairwise(bounds)]
    if bottom:
        parts.append(_cap(levels[0], -1.0))
    if top:
        parts.append(_cap(levels[-1], 1.0))
    return join(parts)


def _skin(levels: NDArray[np.float64], length: NDArray[np.float64]) -> Mesh:
    rows, n = levels.shape[:2]
    i, j = np.meshgrid(np.arange(rows - 1), np.arange(n), indexing="ij")

    def faces(width: int) -> NDArray[np.int64]:
        a, b = (i * width + j).ravel(), (i * width + (j + 1) % width).ravel()
        c, d = b + width, a + width
        return np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])

    normals = from_arrays(levels.reshape(-1, 3), faces(n)).normals.reshape(rows, n, 3)
    seam = np.concatenate([levels, levels[:, :1]], axis=1)
    around = np.linalg.norm(np.diff(seam, axis=1), axis=2)
    widest = around[int(around.sum(axis=1).argmax())]
    u = np.r_[0.0, np.cumsum(widest)]
    uv = np.stack(np.broadcast_arrays(u[None, :], length[:, None]), -1)
    return from_arrays(
        seam.reshape(-1, 3),
        faces(n + 1),
        normals=np.concatenate([normals, normals[:, :1]], axis=1).reshape(-1, 3),
        uv=uv.reshape(-1, 2),
    )


def _cap(level: NDArray[np.float64], up: float) -> Mesh:
    n = len(level)
    k = np.arange(n)
    fan = np.stack([np.full(n, n), k, (k + 1) % n], 1)
    points = np.vstack([level, level.mean(axis=0)])
    return from_arrays(
        points,
        fan if up > 0 else fan[:, ::-1],
        normals=np.tile([0.0, 0.0, up], (n + 1, 1)),
        uv=points[:, :2],
    )


def plate(outline: Outline, height: float, bevel: float = 0.004) -> Mesh:
    """Draw a horizontal plate with a bevelled upper edge, lying on z = 0."""
    bevel = min(bevel, height * 0.45)
    middle = outline.mean(axis=0)
    reach = float(np.linalg.norm(outline - middle, axis=1).mean())
    inner = middle + (outline - middle) * (1 - min(bevel / reach, 0.5))
    return loft([(outline, 0.0), (outline, height - bevel), (inner, height)])


def ring(outer: Outline, inner: Outline, height: float, bevel: float = 0.004) -> Mesh:
    """Draw a horizontal frame between two outlines, lying on z = 0."""
    a = outer + (inner - outer) * 0.15
    b = inner + (outer - inner) * 0.15
    return loft(
        [
            (outer, 0.0),
            (outer, height - bevel),
            (a, height),
            (b, height),
            (inner, height - bevel),
            (inner, 0.0),
            (outer, 0.0),
        ],
        bottom=False,
        top=False,
    )


def pillow(width: float, depth: float, height: float, cells: int = 10) -> Mesh:
    """Draw a pillow with pointed corners, lying on z = 0 with its back edge at y = 0."""

    def half(sign: float) -> Mesh:
        def surface(s: NDArray[np.float64], t: NDArray[np.float64]) -> tuple[NDArray[np.float64], ...]:
            u, v = -np.cos(math.pi * s), -np.cos(math.pi * t)
            if sign < 0:
                u = -u
            bulge = np.maximum((1 - u**2) * (1 - v**2), 0.0) ** 0.42
            x = width / 2 * u * (1 - 0.07 * (1 - v**2))
            y = depth / 2 * v * (1 - 0.10 * (1 - u**2))
            return x, y + depth / 2, height / 2 * (1 + sign * bulge)

        return sheet(surface, cells, cells - 2, (width, depth))

    return join(half(1.0), half(-1.0))


def rumples(
    rng: np.random.Generator, size: float = 0.012, scale: float = 0.5
) -> Callable[[NDArray[np.float64], NDArray[np.float64]], NDArray[np.float64]]:
    """Draw a random height map of soft creases.

    Parameters
    ----------
    rng
        Random number generator.
    size
        Typical height in metres.
    scale
        Typical wavelength in metres.

    Returns
    -------
    Callable
        A function of x and y in metres that returns the height in metres.
    """
    angle = rng.uniform(0, math.pi, 6)
    wave = 2 * math.pi / (scale * np.exp(rng.uniform(-0.5, 0.7, 6)))
    phase = rng.uniform(0, 2 * math.pi, 6)

    def height(x: NDArray[np.float64], y: NDArray[np.float64]) -> NDArray[np.float64]:
        total = np.zeros(np.broadcast(x, y).shape)
        for a, k, p in zip(angle, wave, phase, strict=True):
            total = total + 0.6 - np.abs(np.sin((x * math.cos(a) + y * math.sin(a)) * k / 2 + p))
        return size * total / 2

    return height


def hung(rng: np.random.Generator, width: float, front: float, back: float, radius: float = 0.015) -> Mesh:
    """Draw a cloth, such as a towel, hanging over a bar along the x axis.

    Parameters
    ----------
    rng
        Random number generator.
    width, front, back
        Width of the cloth and its lengths in front of and behind the bar, in metres.
    radius
        Radius of the bar in metres, including the cloth.

    Returns
    -------
    Mesh
        A cloth that hangs down from z = `radius`.
    """
    over = math.pi * radius
    phase, folds = rng.uniform(0, 6), rng.uniform(1.5, 3.0)
    lean = rng.uniform(-0.03, 0.03)

    def surface(s: NDArray[np.float64], t: NDArray[np.float64]) -> tuple[NDArray[np.float64], ...]:
        arc = t * (front + back + over) - back
        down = np.where(arc < 0, -arc, np.where(arc > over, arc - over, 0.0))
        angle = np.clip(arc / radius, 0, math.pi)
        z = radius * np.sin(angle) - down
        y = -radius * np.cos(angle)
        wave = 0.25 * radius * np.sin(s * folds * 2 * math.pi + phase) * np.minimum(down / 0.2, 1.0)
        x = (s - 0.5) * width * (1 - 0.06 * np.minimum(down, 0.5)) + lean * np.where(arc > over, down, 0.0)
        return x, y + wave + np.where(arc > over, 0.003, -0.003), z

    return sheet(surface, 10, 12, (width, front + back + over))
