"""The view from the windows, with sky, trees, houses and ground in all directions."""

import numpy as np

from placecat_homes.bake import Daylight
from placecat_homes.mesh import Floats, floats
from placecat_homes.noise import smooth

HEIGHT, WIDTH = 640, 2560
"""Size of the panorama in pixels."""


def draw(rng: np.random.Generator, *, weather: str, azimuth: float = 0.8, elevation: float = 0.6) -> Daylight:
    """Draw the surroundings of a home.

    Parameters
    ----------
    rng
        Random number generator.
    weather
        ``sunny``, ``cloudy``, ``dusk`` or ``night``.
    azimuth, elevation
        Azimuth and elevation of the sun in radians.

    Returns
    -------
    Daylight
        The panorama and the sun.
    """
    level = {"sunny": 0.9, "cloudy": 0.8, "dusk": 0.22, "night": 0.006}[weather]
    up = np.linspace(np.pi / 2, -np.pi / 2, HEIGHT, dtype=np.float32)[:, None] * np.ones(
        (1, WIDTH), np.float32
    )
    around = np.linspace(0, 1, WIDTH, endpoint=False, dtype=np.float32)[None, :] * np.ones(
        (HEIGHT, 1), np.float32
    )
    clouds = _around(rng, 1.6)
    zenith, horizon = floats(0.35, 0.55, 1.0), floats(0.85, 0.93, 1.0)
    if weather in ("cloudy", "night"):
        zenith, horizon = floats(0.9, 0.95, 1.0), floats(1.0, 1.0, 1.0)
    if weather == "dusk":
        zenith, horizon = floats(0.45, 0.55, 0.95), floats(1.0, 0.75, 0.5)
    blend = np.clip(up / 0.9, 0, 1)[..., None]
    picture = horizon * (1 - blend) + zenith * blend
    picture = picture * (1 + 0.12 * clouds[..., None]) * level
    ground = floats(0.2, 0.24, 0.12) if rng.uniform() < 0.6 else floats(0.3, 0.29, 0.27)
    near = ground * (1 + 0.15 * _around(rng, 0.8))[..., None] * level
    picture = np.where((up < 0)[..., None], near, picture)
    picture = _houses(rng, picture, up, around, level)
    picture = _trees(rng, picture, up, around, level)
    sun = floats(np.cos(elevation) * np.cos(azimuth), np.cos(elevation) * np.sin(azimuth), np.sin(elevation))
    strength = {"sunny": 2.6, "cloudy": 0.0, "dusk": 0.0, "night": 0.0}[weather]
    return Daylight(
        np.ascontiguousarray(picture, np.float32),
        sun,
        (strength * floats(1.0, 0.93, 0.8)).astype(np.float32),
    )


def _around(rng: np.random.Generator, power: float) -> Floats:
    return np.tile(smooth(rng, HEIGHT, power), (1, WIDTH // HEIGHT))


def _houses(rng: np.random.Generator, picture: Floats, up: Floats, around: Floats, level: float) -> Floats:
    for _ in range(int(rng.integers(3, 9))):
        left, width = rng.uniform(0, 1), rng.uniform(0.025, 0.08)
        floors = int(rng.integers(1, 4))
        storey = rng.uniform(0.07, 0.12)
        top = floors * storey
        along = (around - left) % 1
        body = along < width
        wall = body & (up < top) & (up > -0.07)
        colour = rng.uniform(0.2, 0.75) * (1 + rng.uniform(-0.2, 0.2, 3))
        picture = np.where(wall[..., None], (colour * level).astype(np.float32), picture)
        pitch = rng.uniform(0.03, 0.12)
        roof = (
            body & (up >= top) & (up < top + pitch * np.minimum(1, 3 * (1 - np.abs(along / width * 2 - 1))))
        )
        tone = rng.uniform(0.08, 0.2) * np.array([1.0, rng.uniform(0.5, 0.9), rng.uniform(0.4, 0.8)])
        picture = np.where(roof[..., None], (tone * level).astype(np.float32), picture)
        columns = int(rng.integers(3, 7))
        u, v = along / width * columns % 1, up / storey % 1
        frame = wall & (np.abs(u - 0.5) < 0.28) & (np.abs(v - 0.52) < 0.3) & (up > 0)
        pane = frame & (np.abs(np.abs(u - 0.5) - 0.125) < 0.11) & (np.abs(v - 0.52) < 0.26)
        number = (along / width * columns).astype(int) + columns * np.floor(up / storey).astype(int)
        lit = rng.uniform(size=64)[np.clip(number, 0, 63)]
        dark, glow = floats(0.1, 0.12, 0.15) * level, floats(0.5, 0.36, 0.16)
        shown = np.where((lit > 0.6)[..., None] & (level < 0.4), glow, dark)
        picture = np.where(frame[..., None], floats(0.8, 0.8, 0.78) * level, picture)
        picture = np.where(pane[..., None], shown, picture)
    return picture


def _trees(rng: np.random.Generator, picture: Floats, up: Floats, around: Floats, level: float) -> Floats:
    rough, leaf = 0.035 * _around(rng, 0.95), _around(rng, 0.55)
    for _ in range(int(rng.integers(8, 22))):
        x, size = rng.uniform(0, 1), rng.uniform(0.08, 0.3)
        along = ((around - x + 0.5) % 1 - 0.5) * 2 * np.pi
        crown = (along**2 + (up - size * 0.8) ** 2) < (size * 0.75 + rough) ** 2
        trunk = (np.abs(along) < size * 0.07) & (up < size * 0.5) & (up > -0.05)
        green = floats(rng.uniform(0.06, 0.2), rng.uniform(0.14, 0.26), 0.05) * level
        shade = np.clip(1 + 0.45 * leaf + 2.5 * (up - size * 0.8), 0.25, 2.5)
        picture = np.where(trunk[..., None], floats(0.12, 0.09, 0.06) * level, picture)
        picture = np.where(crown[..., None], green * shade[..., None], picture)
    hedge = (up < 0.02 + 0.4 * rough) & (up > -0.06)
    picture = np.where(
        hedge[..., None], floats(0.07, 0.13, 0.05) * level * (1 + 0.4 * leaf)[..., None], picture
    )
    return np.maximum(picture, 0)
