"""The oriented pyramid: Gabor magnitudes on the Laplacian pyramid (thesis 3.1.1.1)."""

from functools import lru_cache

import cv2
import numpy as np
from numpy.typing import NDArray

from placecat.vision.center_surround import GREY_ROUNDING, without_rounding
from placecat.vision.maps import FloatArray

ANGLES = (0.0, 45.0, 90.0, 135.0)

Separable = tuple[tuple[FloatArray, FloatArray], ...]


def orientation_maps(
    laplacian: FloatArray,
    *,
    gabor_size: int = 9,
    gabor_sigma: float = 2.0,
    gabor_wavelength: float = 4.0,
    gabor_aspect: float = 1.0,
    gabor_phase: float | None = None,
) -> FloatArray:
    """Return the Gabor magnitude at 0, 45, 90 and 135 degrees (thesis 3.1.1.1).

    The thesis does not specify the parameters. The defaults follow the steerable pyramid of Itti et al., with
    a round envelope and a frequency of a quarter of a cycle per pixel, where the energy of a Laplacian level
    is concentrated.

    From the centre, x points right and y points down. With u = x cos(angle) + y sin(angle) and
    v = -x sin(angle) + y cos(angle), the kernel follows cv2.getGaborKernel, because the thesis mentions only
    Gabor filters and four angles::

        2 exp(-(u^2 + aspect^2 v^2) / (2 sigma^2)) cos(2 pi u / wavelength + phase) / sum of the exponentials

    With this scaling, the magnitude of a quadrature pair is the amplitude of a matching wave. The angle is
    the direction in which the wave travels. The kernel at 0 degrees responds to vertical edges, the one at 90
    to horizontal edges, and the one at 45 to edges that rise to the right.

    Parameters
    ----------
    laplacian
        (h, w) float32, one level of the Laplacian pyramid, in grey levels.
    gabor_size
        Side length of the kernel in pixels; must be odd.
    gabor_sigma, gabor_wavelength
        Standard deviation of the envelope, and wavelength, both in pixels.
    gabor_aspect
        Ratio of the extent of the envelope along the wave to its extent along the crests.
    gabor_phase
        Phase in radians. A kernel with phase 0 is even and responds to lines. A kernel with phase pi / 2 is
        odd and responds to edges. None combines the two responses. With a fixed phase, the magnitude is the
        absolute value of the response.

    Returns
    -------
    (4, h, w) float32 amplitudes in grey levels, >= 0. Values within the float32 rounding error are set to 0.
    The border is mirrored (reflect-101), which the thesis does not specify.
    """
    bank = _bank(gabor_size, gabor_sigma, gabor_wavelength, gabor_aspect, gabor_phase)
    responses = [_respond(laplacian, parts) for parts in bank]
    # Work in place, because the last bit of cv2.magnitude depends on where its arrays lie in memory.
    out = responses[0]
    if len(responses) == 1:
        np.abs(out, out=out)
    else:
        np.square(out, out=out)
        out += np.square(responses[1], out=responses[1])
        np.sqrt(out, out=out)
    return without_rounding(out, GREY_ROUNDING)


@lru_cache(maxsize=16)
def _bank(
    size: int, sigma: float, wavelength: float, aspect: float, phase: float | None
) -> tuple[tuple[Separable, ...], ...]:
    """Return the separated kernels for each phase.

    These are the kernels at 0 and 90 degrees, and the even and odd parts (in x) of the kernel at 45 degrees.
    """
    phases = (0.0, np.pi / 2) if phase is None else (phase,)
    bank = []
    for shift in phases:
        level, rising, upright = (
            _gabor_kernel(angle, shift, size, sigma, wavelength, aspect) for angle in ANGLES[:3]
        )
        mirrored = rising[:, ::-1]
        bank.append(tuple(map(_separate, (level, upright, (rising + mirrored) / 2, (rising - mirrored) / 2))))
    return tuple(bank)


def _gabor_kernel(
    angle: float, phase: float, size: int, sigma: float, wavelength: float, aspect: float
) -> NDArray[np.float64]:
    half = size // 2
    y, x = np.mgrid[-half : half + 1, -half : half + 1].astype(np.float64)
    theta = np.deg2rad(angle)
    u = x * np.cos(theta) + y * np.sin(theta)
    v = -x * np.sin(theta) + y * np.cos(theta)
    envelope = np.exp(-(u**2 + (aspect * v) ** 2) / (2 * sigma**2))
    kernel: NDArray[np.float64] = 2 * envelope * np.cos(2 * np.pi * u / wavelength + phase) / envelope.sum()
    return kernel


def _respond(plane: FloatArray, parts: tuple[Separable, ...]) -> FloatArray:
    """Return the (4, h, w) responses at the four angles."""
    out = np.empty((len(ANGLES), *plane.shape), np.float32)
    level, rising, upright, falling = out
    _filter(plane, parts[0], level)
    _filter(plane, parts[1], upright)
    # The kernel at 135 degrees is the kernel at 45 degrees, mirrored in x.
    even, odd = _filter(plane, parts[2]), _filter(plane, parts[3])
    np.add(even, odd, out=rising)
    np.subtract(even, odd, out=falling)
    return out


def _separate(kernel: NDArray[np.float64]) -> Separable:
    """Write a kernel as a sum of outer products. For a round envelope, one is enough."""
    columns, strength, rows = np.linalg.svd(kernel)
    kept = np.flatnonzero(strength > max(1e-7 * strength[0], 1e-12))
    return tuple(
        (_clean(rows[k] * strength[k] ** 0.5), _clean(columns[:, k] * strength[k] ** 0.5)) for k in kept
    )


def _clean(factor: NDArray[np.float64]) -> FloatArray:
    """Remove rounding errors from an even or odd factor, because exact symmetry halves OpenCV's work."""
    for sign in (1, -1):
        if np.abs(factor - sign * factor[::-1]).max() < 1e-9 * np.abs(factor).max():
            factor = (factor + sign * factor[::-1]) / 2
    return factor.astype(np.float32)


def _filter(plane: FloatArray, terms: Separable, out: FloatArray | None = None) -> FloatArray:
    total = np.empty_like(plane) if out is None else out
    if not terms:
        total[...] = 0
    for number, (row, column) in enumerate(terms):
        if number == 0:
            cv2.sepFilter2D(plane, cv2.CV_32F, row, column, dst=total, borderType=cv2.BORDER_REFLECT_101)
        else:
            total += cv2.sepFilter2D(plane, cv2.CV_32F, row, column, borderType=cv2.BORDER_REFLECT_101)
    return total
