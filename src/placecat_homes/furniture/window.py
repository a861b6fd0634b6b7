"""Windows with a frame, sashes, muntins and a sill. The panes are left out so that light passes through."""

import numpy as np

from placecat_homes import palette
from placecat_homes.mesh import Mesh, join
from placecat_homes.shapes import box, tube
from placecat_homes.style import Style


def window(
    rng: np.random.Generator,
    style: Style,
    width: float = 1.2,
    height: float = 1.3,
    depth: float = 0.2,
    to_floor: bool = False,
) -> Mesh:
    """Build a window for an opening in an exterior wall.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the building.
    width, height
        Width and height of the opening in metres.
    depth
        Distance from the inner face of the wall to the window in metres.
    to_floor
        Whether to build a balcony door without a sill.

    Returns
    -------
    Mesh
        The bottom of the opening is at z = 0, the inner face of the wall at y = 0 and the window at
        y = -depth. Only the sill extends into the room.
    """
    bar, thick = float(rng.uniform(0.04, 0.065)), 0.06
    parts = _border(width, height, bar, thick)
    sashes = 1 if width < 0.75 else (2 if width < 1.7 else 3)
    if sashes == 2 and rng.random() < 0.25:
        sashes = 1
    inner = (width - 2 * bar) / sashes
    columns, rows = ((0, 0), (0, 0), (0, 1), (1, 2), (1, 1))[int(rng.integers(5))]
    for k in range(sashes):
        x = -width / 2 + bar + (k + 0.5) * inner
        sash = _border(inner, height - 2 * bar, bar, 0.05)
        clear, tall = inner - 2 * bar, height - 4 * bar
        for c in range(1, columns + 1):
            sash.append(box(0.022, 0.03, tall, 0.0).moved(-clear / 2 + c * clear / (columns + 1), 0.01, bar))
        for r in range(1, rows + 1):
            sash.append(box(clear, 0.03, 0.022, 0.0).moved(0, 0.01, bar + r * tall / (rows + 1) - 0.011))
        parts += [part.moved(x, 0.025, bar) for part in sash]
    body = join(parts).moved(0, -depth - 0.02).of(style.trim)
    z, side = height * 0.45, (-width / 2 + bar + inner - bar / 2)
    near, far = -depth + 0.05, -depth + 0.095
    handle = tube([(side, near, z), (side, far, z), (side, far, z - 0.11)], 0.009, 6)
    whole = [body, handle.of(style.metal)]
    if not to_floor:
        overhang = float(rng.uniform(0.03, 0.12))
        board = box(width + 0.06, overhang + 0.02, 0.03, 0.006).moved(0, -0.02, -0.022)
        inside = box(width + 0.002, depth, 0.01, 0.0).moved(0, -depth, -0.004)
        sill = style.trim if rng.random() < 0.6 else palette.stone(rng)
        whole.append(join(board, inside).of(sill))
    return join(whole)


def _border(width: float, height: float, bar: float, thick: float) -> list[Mesh]:
    parts = [box(bar, thick, height, 0.004).moved(sign * (width - bar) / 2) for sign in (-1, 1)]
    return parts + [box(width - 2 * bar, thick, bar, 0.004).moved(0, 0, z) for z in (0.0, height - bar)]
