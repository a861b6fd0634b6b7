"""Seamless random fields for textures."""

import numpy as np
from numpy.typing import NDArray

Field = NDArray[np.floating]


def smooth(rng: np.random.Generator, pixels: int, power: float, stretch: float = 1.0) -> Field:
    """Draw seamlessly repeating noise with a power-law spectrum.

    Parameters
    ----------
    rng
        Random number generator.
    pixels
        Width and height of the field.
    power
        The amplitude is divided by the frequency raised to this power: 0 gives white noise, 1 clouds, and 2
        soft blots.
    stretch
        Length of blots along x relative to that along y.

    Returns
    -------
    numpy.ndarray
        (pixels, pixels) float32 with mean 0 and standard deviation 1.
    """
    spectrum = np.fft.rfft2(rng.standard_normal((pixels, pixels)))
    fy, fx = np.fft.fftfreq(pixels)[:, None], np.fft.rfftfreq(pixels)[None, :]
    radius = np.hypot(fy, fx * stretch) * pixels
    spectrum *= np.where(radius > 0, 1 / np.maximum(radius, 1) ** power, 0)
    field = np.fft.irfft2(spectrum, s=(pixels, pixels))
    return (field / max(float(field.std()), 1e-9)).astype(np.float32)


def grid(pixels: int) -> tuple[Field, Field]:
    """Return the x and y coordinates of the pixel centres in [0, 1), with y pointing downwards.

    Parameters
    ----------
    pixels
        Width and height of the field.

    Returns
    -------
    tuple of numpy.ndarray
        Two (pixels, pixels) float32 fields.
    """
    line = (np.arange(pixels, dtype=np.float32) + 0.5) / pixels
    x, y = np.meshgrid(line, line)
    return x.astype(np.float32), y.astype(np.float32)


def mix(first: NDArray[np.floating], second: NDArray[np.floating], share: Field) -> Field:
    """Blend two colours pixel by pixel.

    Parameters
    ----------
    first, second
        (3,) colours or (pixels, pixels, 3) images.
    share
        (pixels, pixels); 0 for the first, 1 for the second.

    Returns
    -------
    numpy.ndarray
        (pixels, pixels, 3) float32.
    """
    weight = np.clip(share, 0, 1)[..., None]
    return (np.asarray(first) * (1 - weight) + np.asarray(second) * weight).astype(np.float32)


def cells(pixels: int, columns: int, rows: int, shift: float = 0.0) -> tuple[NDArray[np.intp], Field, Field]:
    """Divide an image into cells, such as bricks, tiles or planks, with every other row shifted.

    Parameters
    ----------
    pixels
        Width and height of the field.
    columns, rows
        Number of cells; unless `shift` is 0, `rows` must be even to avoid a seam.
    shift
        Shift of every other row, in cells.

    Returns
    -------
    tuple of numpy.ndarray
        Number of the cell at each pixel, and the distances to the nearest vertical and horizontal edges in
        cells, in [0, 0.5].
    """
    x, y = grid(pixels)
    row = np.floor(y * rows).astype(int)
    u = x * columns + shift * (row % 2)
    column = np.floor(u).astype(int) % columns
    fu, fv = u - np.floor(u), y * rows - row
    return row * columns + column, np.minimum(fu, 1 - fu), np.minimum(fv, 1 - fv)
