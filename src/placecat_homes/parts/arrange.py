"""Arrangements of small objects on tables, worktops and shelves."""

from collections.abc import Iterable, Sequence

import numpy as np

from placecat_homes.mesh import Mesh, join


def grounded(*parts: Mesh | Iterable[Mesh]) -> Mesh:
    """Join meshes into one that stands on z = 0, centred on x = 0, with its back at y = 0."""
    mesh = join(*parts)
    low, high = mesh.low, mesh.high
    return mesh.moved(-float(low[0] + high[0]) / 2, -float(low[1]), -float(low[2]))


def centred(mesh: Mesh) -> Mesh:
    """Move a mesh in x and y so that its centre is above the origin."""
    low, high = mesh.low, mesh.high
    return mesh.moved(-float(low[0] + high[0]) / 2, -float(low[1] + high[1]) / 2)


def in_a_row(
    rng: np.random.Generator, things: Sequence[Mesh], width: float, *, depth: float = 0.0, gap: float = 0.02
) -> Mesh:
    """Put objects side by side on a shelf, with random gaps. Objects that do not fit are left out.

    Parameters
    ----------
    rng
        Random number generator.
    things
        Objects to place, standing upright, in order of increasing x.
    width
        Width of the shelf in metres. The shelf is centred on x = 0, with its back at y = 0.
    depth
        Depth of the shelf in metres; 0 puts all objects at the back edge.
    gap
        Minimum distance between objects in metres.

    Returns
    -------
    Mesh
        A mesh with its base at z = 0.
    """
    chosen: list[Mesh] = []
    used = 0.0
    for thing in things:
        size = float(thing.size[0]) + gap
        if used + size <= width:
            chosen.append(thing)
            used += size
    if not chosen:
        return join()
    spare = (width - used) * rng.dirichlet(np.ones(len(chosen) + 1))
    x = -width / 2
    placed = []
    for thing, space in zip(chosen, spare[:-1], strict=True):
        x += float(space) + gap / 2
        room = max(depth - float(thing.size[1]), 0.0)
        back = float(rng.uniform(0.1, 0.9)) * room - float(thing.low[1])
        placed.append(thing.moved(x - float(thing.low[0]), back))
        x += float(thing.size[0]) + gap / 2
    return join(placed)


def scattered(
    rng: np.random.Generator,
    things: Sequence[Mesh],
    width: float,
    depth: float,
    *,
    gap: float = 0.02,
    tries: int = 20,
) -> Mesh:
    """Place objects at random on a table top, without overlaps. Any that do not fit are left out.

    Parameters
    ----------
    rng
        Random number generator.
    things
        Objects to place, standing upright. They are not rotated.
    width, depth
        Width and depth of the table top in metres. The top is centred on the origin.
    gap
        Minimum distance between objects in metres.
    tries
        Number of positions tried for each object.

    Returns
    -------
    Mesh
        A mesh with its base at z = 0.
    """
    taken: list[tuple[float, float, float, float]] = []
    placed = []
    for thing in things:
        half_x, half_y = float(thing.size[0]) / 2 + gap / 2, float(thing.size[1]) / 2 + gap / 2
        if half_x > width / 2 or half_y > depth / 2:
            continue
        for _ in range(tries):
            x = float(rng.uniform(-width / 2 + half_x, width / 2 - half_x))
            y = float(rng.uniform(-depth / 2 + half_y, depth / 2 - half_y))
            if all(abs(x - a) >= half_x + c or abs(y - b) >= half_y + d for a, b, c, d in taken):
                taken.append((x, y, half_x, half_y))
                placed.append(centred(thing).moved(x, y))
                break
    return join(placed)
