"""Microwave ovens."""

import numpy as np

from placecat_homes import palette
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.shapes import box, cylinder, tube
from placecat_homes.style import Style

SHELLS = (
    Material(colour=(0.06, 0.06, 0.065), gloss=0.05, roughness=0.2),
    Material(colour=(0.72, 0.72, 0.73), gloss=0.5, roughness=0.35),
    Material(colour=(0.92, 0.92, 0.91), gloss=0.04, roughness=0.2),
)
DARK = Material(colour=(0.03, 0.03, 0.035), gloss=0.08, roughness=0.1)
DISPLAY = Material(colour=(0.2, 0.9, 0.65), emission=0.7)
BUTTON = Material(colour=(0.75, 0.75, 0.75), gloss=0.03)


def microwave(rng: np.random.Generator, style: Style, *, width: float | None = None) -> Mesh:
    """Draw a microwave oven with a window in the door, a handle, a display and buttons or dials."""
    w = width or float(rng.uniform(0.45, 0.53))
    height, depth = w * 0.58, 0.34
    shell = SHELLS[int(rng.integers(3))] if rng.random() < 0.85 else palette.plastic(rng)
    panel = 0.11
    left = w / 2 - panel
    door = w - panel
    middle = -w / 2 + door / 2
    parts = [
        box(w, depth, height - 0.012, 0.006).moved(z=0.012).of(shell),
        box(door - 0.008, 0.02, height - 0.03, 0.004).moved(middle, depth, 0.022).of(shell),
        box(door * 0.76, 0.004, height * 0.62, 0).moved(middle - 0.012, depth + 0.019, height * 0.2).of(DARK),
        box(panel - 0.008, 0.016, height - 0.03, 0.003).moved(left + panel / 2, depth, 0.022).of(shell),
    ]
    x = left + panel / 2
    front = depth + 0.016
    parts.append(box(0.075, 0.003, 0.03, 0).moved(x, front, height - 0.07).of(DARK))
    parts.append(box(0.05, 0.002, 0.016, 0).moved(x, front + 0.003, height - 0.063).of(DISPLAY))
    if rng.random() < 0.5:
        for row in range(4):
            for column in range(3):
                key = box(0.018, 0.003, 0.016, 0).of(BUTTON)
                parts.append(key.moved(x + 0.026 * (column - 1), front, 0.05 + 0.027 * row))
    else:
        for z in (0.07, 0.15):
            dial = cylinder(0.026, 0.02, 14).turned(-90, "x").of(BUTTON)
            parts.append(dial.moved(x, front, z))
    handle = left - 0.028
    path = [(handle, depth + 0.015, 0.06), (handle, depth + 0.045, 0.07)]
    path += [(handle, depth + 0.045, height - 0.07), (handle, depth + 0.015, height - 0.06)]
    parts.append(tube(path, 0.007, 8).of(SHELLS[1]))
    for sx in (-1, 1):
        for y in (0.04, depth - 0.04):
            parts.append(cylinder(0.015, 0.014, 8, 0).moved(sx * (w / 2 - 0.04), y).of(DARK))
    # Seen from the front, +x is on the left, and the buttons belong on the right.
    return join(parts).mirrored()
