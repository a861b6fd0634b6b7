"""What a lit screen shows: windows, text, or a film."""

import numpy as np

from placecat_homes.noise import Field, grid, mix, smooth


def draw(rng: np.random.Generator, colours: list[Field], pixels: int) -> Field:
    """Draw a desktop with windows of text lines, or a blurred scene."""
    x, y = grid(pixels)
    if rng.random() < 0.35:
        fields = np.stack([smooth(rng, pixels, 1.7) for _ in range(3)], -1)
        return np.clip(0.42 + 0.2 * fields + 0.15 * colours[0], 0, 1).astype(np.float32)
    picture = mix(colours[0], colours[0] * 0.5, y)
    for _ in range(int(rng.integers(1, 4))):
        x0, y0 = rng.uniform(0.02, 0.45), rng.uniform(0.04, 0.4)
        x1, y1 = x0 + rng.uniform(0.3, 0.55), y0 + rng.uniform(0.3, 0.5)
        inside = (x > x0) & (x < x1) & (y > y0) & (y < y1)
        paper = np.array([0.95, 0.95, 0.96]) if rng.random() < 0.7 else np.array([0.12, 0.13, 0.16])
        picture = np.where(inside[..., None], paper, picture)
        line = np.floor((y - y0) * 45).astype(int)
        ends = rng.uniform(0.3, 1, 64)[np.clip(line, 0, 63)]
        text = (
            inside
            & ((y - y0) * 45 % 1 < 0.45)
            & (x < x0 + (x1 - x0) * ends - 0.02)
            & (x > x0 + 0.02)
            & (y > y0 + 0.04)
        )
        picture = np.where(text[..., None], np.abs(paper - 0.6), picture)
        picture = np.where((inside & (y < y0 + 0.03))[..., None], np.array([0.3, 0.45, 0.7]), picture)
    return np.where((y > 0.96)[..., None], np.array([0.15, 0.16, 0.2]), picture).astype(np.float32)
