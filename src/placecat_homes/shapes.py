"""Basic shapes for building furniture.

Dimensions are in metres, and most shapes stand on z = 0. Each shape is either a closed body with
outward-facing triangles or a thin surface.
"""

import math
from collections.abc import Callable, Sequence
from functools import cache
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from placecat_homes.mesh import Mesh, from_arrays, join


def quad(width: float, height: float) -> Mesh:
    """Build an upright rectangle on z = 0, facing +y and centred on x = 0.

    Its texture starts in the lower left corner.

    Parameters
    ----------
    width, height
        Metres.

    Returns
    -------
    Mesh
        Two triangles in the plane y = 0.
    """
    x = width / 2
    # Seen from +y, the +x direction is on the left.
    points = [(x, 0, 0), (-x, 0, 0), (-x, 0, height), (x, 0, height)]
    uv = [(0, 0), (width, 0), (width, height), (0, height)]
    return _flat(points, uv)


def slab(width: float, depth: float) -> Mesh:
    """Build a horizontal rectangle facing up, with its back edge on y = 0.

    Parameters
    ----------
    width, depth
        Metres.

    Returns
    -------
    Mesh
        Two triangles in the plane z = 0.
    """
    x = width / 2
    points = [(-x, 0, 0), (x, 0, 0), (x, depth, 0), (-x, depth, 0)]
    return _flat(points, [(0, 0), (width, 0), (width, depth), (0, depth)])


def box(width: float, depth: float, height: float, bevel: float = 0.006) -> Mesh:
    """Build a box with bevelled edges and its back on y = 0.

    Parameters
    ----------
    width, depth, height
        Metres.
    bevel
        Width of the bevel in metres; 0 for sharp edges.

    Returns
    -------
    Mesh
        The box. Texture coordinates run along the sides; on upright sides, v is the height.
    """
    half = np.array([width, depth, height], dtype=np.float64) / 2
    r = float(min(bevel, half.min() * 0.49))
    form = _box(bevelled=r > 0)
    vertices = form.signs * np.where(form.is_outer, half, half - r)
    u, v = (vertices[np.arange(len(vertices)), one] + half[one] for one in form.columns)
    uv = np.stack([u, np.where(form.is_bevel, form.across * r, v)], axis=1)
    return from_arrays(vertices, form.faces, normals=form.normals, uv=uv).moved(0, depth / 2, height / 2)


class _Box(NamedTuple):
    """Parts of a box that do not depend on its size.

    For each of the n vertices, `signs` (n, 3) contains the signs of its coordinates. `is_outer` (n, 3) is
    true for coordinates on the surface, and false for those one bevel width further in. The two `columns`,
    each (n,), select the coordinates used as texture coordinates. On a bevel, the second is `across` times
    the bevel width.
    """

    signs: NDArray[np.float64]
    is_outer: NDArray[np.bool_]
    normals: NDArray[np.float64]
    columns: tuple[NDArray[np.intp], NDArray[np.intp]]
    is_bevel: NDArray[np.bool_]
    across: NDArray[np.float64]
    faces: NDArray[np.int32]


@cache
def _box(*, bevelled: bool) -> _Box:
    parts = [_side(axis, sign) for axis in range(3) for sign in (-1, 1)]
    if bevelled:
        parts += [_bevel(axis, su, sv) for axis in range(3) for su in (-1, 1) for sv in (-1, 1)]
        parts += [_tip(s) for s in np.array(np.meshgrid((-1, 1), (-1, 1), (-1, 1))).T.reshape(-1, 3)]
    signs, is_outer, normals, columns, across = zip(*parts, strict=True)
    counts = [len(one) for one in signs]
    faces, start = [], 0
    for count, *part in zip(counts, signs, is_outer, normals, strict=True):
        faces.append(_outwards(*part) + start)
        start += count
    first, second = (np.repeat([one[k] for one in columns], counts) for k in range(2))
    return _Box(
        np.concatenate(signs),
        np.concatenate(is_outer),
        np.concatenate(normals),
        (first, second),
        np.repeat([one is not None for one in across], counts),
        np.concatenate([np.zeros(n) if one is None else one for n, one in zip(counts, across, strict=True)]),
        np.concatenate(faces).astype(np.int32),
    )


_Part = tuple[
    NDArray[np.float64],
    NDArray[np.bool_],
    NDArray[np.float64],
    tuple[int, int],
    NDArray[np.float64] | None,
]
_OTHERS = ((1, 2), (0, 2), (0, 1))


def _side(axis: int, sign: int) -> _Part:
    u, v = _OTHERS[axis]
    signs = np.full((4, 3), sign, np.float64)
    signs[:, [u, v]] = (-1, -1), (1, -1), (1, 1), (-1, 1)
    normals = np.zeros((4, 3))
    normals[:, axis] = sign
    return signs, normals != 0, normals, (u, v), None


def _bevel(axis: int, su: int, sv: int) -> _Part:
    u, v = _OTHERS[axis]
    signs, normals = np.zeros((4, 3)), np.zeros((4, 3))
    signs[:, axis], signs[:, u], signs[:, v] = (-1, 1, 1, -1), su, sv
    normals[:2, u], normals[2:, v] = su, sv
    return signs, normals != 0, normals, (axis, axis), normals[:, v]


def _tip(signs: NDArray[np.int_]) -> _Part:
    return np.tile(signs.astype(np.float64), (3, 1)), np.eye(3) > 0, np.eye(3) * signs, (0, 1), None


def _outwards(
    signs: NDArray[np.float64], is_outer: NDArray[np.bool_], normals: NDArray[np.float64]
) -> NDArray[np.int_]:
    faces = np.array([[0, 1, 2], [0, 2, 3]][: len(signs) - 2])
    corners = signs * np.where(is_outer, 1.0, 0.75)
    across = np.cross(corners[1] - corners[0], corners[2] - corners[0])
    return faces[:, ::-1] if np.dot(across, normals.sum(axis=0)) < 0 else faces


def _flat(points: Sequence[tuple[float, ...]], uv: Sequence[tuple[float, ...]]) -> Mesh:
    return from_arrays(np.array(points, float), np.array([[0, 1, 2], [0, 2, 3]]), uv=np.array(uv, float))


def lathe(profile: Sequence[tuple[float, float]], segments: int = 20) -> Mesh:
    """Revolve a profile around the z axis, as on a lathe or a potter's wheel.

    Parameters
    ----------
    profile
        (radius, height) pairs from bottom to top along the outside, in metres. For a vessel, the profile goes
        up on the outside and back down on the inside. Corners of less than 140 degrees stay sharp.
    segments
        Number of segments around the axis.

    Returns
    -------
    Mesh
        A body centred on the axis. u runs around the axis, in metres at the largest radius, and v along the
        profile.
    """
    points = np.asarray(profile, dtype=np.float64)
    points = points[np.r_[True, np.any(np.abs(np.diff(points, axis=0)) > 1e-9, axis=1)]]
    runs = _smooth_runs(points)
    reach = 2 * math.pi * float(points[:, 0].max())
    parts = []
    for first, last in runs:
        parts.append(_turned(points[first : last + 1], segments, reach))
    return join(parts)


def _smooth_runs(points: NDArray[np.float64]) -> list[tuple[int, int]]:
    steps = np.diff(points, axis=0)
    angle = np.arctan2(steps[:, 1], steps[:, 0])
    turn = np.abs((np.diff(angle) + math.pi) % (2 * math.pi) - math.pi)
    sharp = [int(k) + 1 for k in np.flatnonzero(turn > math.radians(40))]
    bounds = [0, *sharp, len(points) - 1]
    return list(pairwise(bounds))


def _turned(points: NDArray[np.float64], segments: int, reach: float) -> Mesh:
    angle = np.linspace(0, 2 * math.pi, segments + 1)
    n = len(points)
    steps = np.diff(points, axis=0)
    length = np.r_[0.0, np.cumsum(np.linalg.norm(steps, axis=1))]
    tangent = np.zeros_like(points)
    unit = steps / np.maximum(np.linalg.norm(steps, axis=1, keepdims=True), 1e-12)
    tangent[:-1] += unit
    tangent[1:] += unit
    normal = np.stack([tangent[:, 1], -tangent[:, 0]], axis=1)
    normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-12)
    c, s = np.cos(angle)[:, None], np.sin(angle)[:, None]
    vertices = np.stack([c * points[:, 0], s * points[:, 0], np.tile(points[:, 1], (segments + 1, 1))], -1)
    normals = np.stack([c * normal[:, 0], s * normal[:, 0], np.tile(normal[:, 1], (segments + 1, 1))], -1)
    uv = np.stack(np.broadcast_arrays(angle[:, None] / (2 * math.pi) * reach, length[None, :]), -1)
    return from_arrays(
        vertices.reshape(-1, 3),
        _lattice(segments + 1, n),
        normals=normals.reshape(-1, 3),
        uv=uv.reshape(-1, 2),
    )


@cache
def _lattice(rows: int, columns: int) -> NDArray[np.int32]:
    """Return triangles of a lattice with vertices stored row by row. Normals point along rows x columns."""
    i, j = np.meshgrid(np.arange(rows - 1), np.arange(columns - 1), indexing="ij")
    a = (i * columns + j).ravel()
    b, c, d = a + columns, a + columns + 1, a + 1
    triangles = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)]).astype(np.int32)
    # Many meshes share this array.
    triangles.flags.writeable = False
    return triangles


def _cross(one: NDArray[np.float64], other: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the cross product of two vectors. This is much faster than NumPy."""
    (a, b, c), (x, y, z) = one.tolist(), other.tolist()
    return np.array([b * z - c * y, c * x - a * z, a * y - b * x])


def cylinder(radius: float, height: float, segments: int = 20, bevel: float = 0.003) -> Mesh:
    """Build an upright cylinder around the z axis, with caps and bevelled rims.

    Parameters
    ----------
    radius, height, bevel
        Metres.
    segments
        Number of segments around the axis.

    Returns
    -------
    Mesh
        The cylinder, centred on the axis.
    """
    r = min(bevel, radius / 2, height / 2)
    return lathe(
        [(0, 0), (radius - r, 0), (radius, r), (radius, height - r), (radius - r, height), (0, height)],
        segments,
    )


def superellipsoid(
    width: float, depth: float, height: float, e1: float = 0.5, e2: float = 0.5, segments: int = 20
) -> Mesh:
    """Build a shape between a box (exponents near 0) and an ellipsoid (1), such as a pillow or stone.

    Parameters
    ----------
    width, depth, height
        Metres.
    e1, e2
        Exponents of the outline as seen from the side and from above.
    segments
        Number of segments around the body; half as many run from bottom to top.

    Returns
    -------
    Mesh
        The body, centred in x and y and standing on z = 0.
    """

    def power(value: NDArray[np.float64], e: float) -> NDArray[np.float64]:
        small = np.abs(value) < 1e-9
        return np.where(small, 0.0, np.sign(value) * np.abs(value) ** e)

    across = np.linspace(-math.pi, math.pi, segments + 1)[:, None]
    up = np.linspace(-math.pi / 2, math.pi / 2, segments // 2 + 1)[None, :]
    shape = (segments + 1, segments // 2 + 1)
    x = power(np.cos(up), e1) * power(np.cos(across), e2) * width / 2
    y = power(np.cos(up), e1) * power(np.sin(across), e2) * depth / 2
    z = np.broadcast_to(power(np.sin(up), e1) * height / 2, shape)
    vertices = np.stack([x, y, z], -1).reshape(-1, 3)
    nx = power(np.cos(up), 2 - e1) * power(np.cos(across), 2 - e2) / (width / 2)
    ny = power(np.cos(up), 2 - e1) * power(np.sin(across), 2 - e2) / (depth / 2)
    nz = np.broadcast_to(power(np.sin(up), 2 - e1) / (height / 2), shape)
    normals = np.stack([nx, ny, nz], -1).reshape(-1, 3)
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
    uv = vertices[:, :2] + np.array([width / 2, depth / 2])
    return from_arrays(vertices, _lattice(*shape), normals=normals, uv=uv).moved(0, 0, height / 2)


def extrude(
    outline: Sequence[tuple[float, float]], length: float, *, smooth: bool = False, caps: bool = True
) -> Mesh:
    """Extrude a horizontal outline upwards.

    Parameters
    ----------
    outline
        (x, y) corners in metres, counter-clockwise as seen from above. The outline must not cross itself.
        Caps are fans around the first corner, so all other corners must be visible from it.
    length
        Height in metres.
    smooth
        Shade the sides as one smooth surface, without sharp edges.
    caps
        Close the top and bottom.

    Returns
    -------
    Mesh
        A body standing on z = 0. u runs along the outline, and v upwards.
    """
    points = np.asarray(outline, dtype=np.float64)
    n = len(points)
    following = np.roll(points, -1, axis=0)
    along = following - points
    side = np.linalg.norm(along, axis=1)
    start = np.r_[0.0, np.cumsum(side)]
    outward = np.stack([along[:, 1], -along[:, 0]], 1) / np.maximum(side[:, None], 1e-12)
    parts = []
    corner = outward + np.roll(outward, 1, axis=0)
    corner /= np.maximum(np.linalg.norm(corner, axis=1, keepdims=True), 1e-12)
    vertices: list[tuple[float, ...]] = []
    normals: list[tuple[float, ...]] = []
    uv: list[tuple[float, float]] = []
    faces: list[tuple[int, int, int]] = []
    for k in range(n):
        base = len(vertices)
        ends = (corner[k], corner[(k + 1) % n]) if smooth else (outward[k], outward[k])
        for point, normal, u in ((points[k], ends[0], start[k]), (following[k], ends[1], start[k + 1])):
            for z in (0.0, length):
                vertices.append((*point, z))
                normals.append((*normal, 0.0))
                uv.append((u, z))
        faces += [(base, base + 2, base + 3), (base, base + 3, base + 1)]
    parts.append(from_arrays(np.array(vertices), np.array(faces), normals=np.array(normals), uv=np.array(uv)))
    if caps:
        fan = np.array([(0, k, k + 1) for k in range(1, n - 1)])
        for z, up in ((0.0, -1.0), (length, 1.0)):
            level = np.c_[points, np.full(n, z)]
            parts.append(
                from_arrays(
                    level,
                    fan if up > 0 else fan[:, ::-1],
                    normals=np.tile([0.0, 0.0, up], (n, 1)),
                    uv=points,
                )
            )
    return join(parts)


def tube(path: Sequence[tuple[float, float, float]], radius: float, segments: int = 10) -> Mesh:
    """Build a round bar along a path, for rails, taps, handles, wires and chair frames.

    Parameters
    ----------
    path
        At least two points, in metres.
    radius
        Metres.
    segments
        Number of segments around the bar.

    Returns
    -------
    Mesh
        A bar with flat ends.
    """
    points = np.asarray(path, dtype=np.float64)
    steps = np.diff(points, axis=0)
    unit = steps / np.maximum(np.linalg.norm(steps, axis=1, keepdims=True), 1e-12)
    tangent = np.vstack([unit[:1], unit[:-1] + unit[1:], unit[-1:]])
    tangent /= np.maximum(np.linalg.norm(tangent, axis=1, keepdims=True), 1e-12)
    helper = np.array([0.0, 0.0, 1.0]) if abs(tangent[0, 2]) < 0.9 else np.array([1.0, 0.0, 0.0])
    angle = np.linspace(0, 2 * math.pi, segments + 1)
    length = np.r_[0.0, np.cumsum(np.linalg.norm(steps, axis=1))]
    rings, normals, uv = [], [], []
    for k, t in enumerate(tangent):
        a = _cross(t, helper)
        a /= max(float(np.linalg.norm(a)), 1e-12)
        b = _cross(t, a)
        helper = _cross(a, t)
        normal = np.cos(angle)[:, None] * a + np.sin(angle)[:, None] * b
        rings.append(points[k] + radius * normal)
        normals.append(normal)
        uv.append(np.stack([angle * radius, np.full(len(angle), length[k])], 1))
    body = from_arrays(
        np.concatenate(rings),
        _lattice(len(points), segments + 1)[:, ::-1],
        normals=np.concatenate(normals),
        uv=np.concatenate(uv),
    )
    caps = []
    for ring, centre, direction in (
        (rings[0], points[0], -tangent[0]),
        (rings[-1], points[-1], tangent[-1]),
    ):
        fan = np.array([(0, k + 1, k + 2) for k in range(segments)])
        vertices = np.vstack([centre, ring])
        across = np.cross(vertices[1] - centre, vertices[2] - centre)
        if np.dot(across, direction) < 0:
            fan = fan[:, ::-1]
        caps.append(from_arrays(vertices, fan, normals=np.tile(direction, (len(vertices), 1))))
    return join(body, caps)


def sheet(
    surface: Callable[[NDArray[np.float64], NDArray[np.float64]], tuple[NDArray[np.float64], ...]],
    rows: int,
    columns: int,
    size: tuple[float, float] = (1.0, 1.0),
) -> Mesh:
    """Build a smooth surface defined by a function, for blankets, towels, leaves and basins.

    Parameters
    ----------
    surface
        Function of s and t in [0, 1], each (rows + 1, columns + 1), that returns x, y, z in metres. The cross
        product of its derivatives along s and t points outwards.
    rows, columns
        Number of cells along s and t.
    size
        Largest texture coordinates along s and t, in metres.

    Returns
    -------
    Mesh
        An open surface, visible from both sides.
    """
    s, t = np.meshgrid(np.linspace(0, 1, rows + 1), np.linspace(0, 1, columns + 1), indexing="ij")
    x, y, z = (np.broadcast_to(np.asarray(value, float), s.shape) for value in surface(s, t))
    uv = np.stack([s.ravel() * size[0], t.ravel() * size[1]], 1)
    return from_arrays(np.stack([x, y, z], -1).reshape(-1, 3), _lattice(rows + 1, columns + 1), uv=uv)
