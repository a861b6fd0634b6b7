"""Spectral residual saliency (thesis 3.1.1.2; Hou and Zhang)."""

import cv2
import numpy as np
import scipy.fft

from placecat.vision.center_surround import GREY_ROUNDING
from placecat.vision.maps import FloatArray


def spectral_residual(
    grey: FloatArray,
    *,
    residual_box: int = 3,
    residual_sigma: float = 1.0,
    residual_width: int | None = None,
    residual_floor: float = 0.1,
) -> FloatArray:
    """Return the spectral residual saliency of an image (thesis 3.1.1.2).

    The function subtracts the box mean from the log amplitude spectrum, restores the original phase and
    inverts the transform. Like the authors' code, it smooths the squared magnitude and stretches it to
    [0, 1], so that scales can be added. Like the spectrum, the box filter is periodic, so the inverse
    transform is real.

    Parameters
    ----------
    grey
        (h, w) float32, from 0 to 255, at least 2x2 pixels.
    residual_box
        Side length of the box filter for the log amplitude; must be odd. Hou and Zhang use 3. The thesis does
        not specify this.
    residual_sigma
        Standard deviation, in pixels, of the Gaussian that smooths the squared magnitude. 0 turns smoothing
        off. The thesis does not specify this. The authors' code uses 2.5 for a single image 64 pixels wide.
        With several scales, less smoothing is needed.
    residual_width
        Width in pixels to which a wider image is reduced. The authors use 64. None keeps every image at its
        full size, as the thesis does for pyramid levels.
    residual_floor
        Lower limit f of the amplitude, in grey levels. The function takes the logarithm of sqrt(amplitude^2 +
        f^2). Smaller amplitudes are float32 rounding errors, which the method would amplify. The thesis does
        not specify this.

    Returns
    -------
    (h, w) float32, from 0 to 1, and 0 everywhere for a flat image.

    References
    ----------
    X. Hou and L. Zhang, Saliency detection: a spectral residual approach, CVPR 2007.
    """
    height, width = grey.shape
    small = grey
    if residual_width is not None and residual_width < width:
        size = (residual_width, max(2, round(height * residual_width / width)))
        small = np.asarray(cv2.resize(grey, size, interpolation=cv2.INTER_AREA), np.float32)
    if float(small.max()) - float(small.min()) <= GREY_ROUNDING:
        return np.zeros_like(grey)
    spectrum = scipy.fft.rfft2(small)
    # This is twice the log amplitude. exp(log a - mean) e^(i phase) equals the spectrum times exp(-mean).
    logarithm = np.square(spectrum.real)
    logarithm += np.square(spectrum.imag)
    logarithm += np.float32(residual_floor**2)
    np.log(logarithm, out=logarithm)
    mean = _periodic_mean(logarithm, small.shape[1], residual_box)
    spectrum *= np.exp(np.float32(-0.5) * mean)
    power = np.square(scipy.fft.irfft2(spectrum, s=small.shape))
    # Stretch before blurring, because the values of the whitened image are about 1 / number of pixels.
    power /= power.max()
    if residual_sigma > 0:
        power = cv2.GaussianBlur(power, (0, 0), residual_sigma, borderType=cv2.BORDER_REFLECT_101)
    if small is not grey:
        power = cv2.resize(power, (width, height), interpolation=cv2.INTER_LINEAR)
    low, high = float(power.min()), float(power.max())
    if high <= low:
        return np.zeros_like(grey)
    stretched: FloatArray = (power - np.float32(low)) / np.float32(high - low)
    return stretched


def _periodic_mean(half: FloatArray, width: int, box: int) -> FloatArray:
    """Compute the box mean of an even periodic map, stored as its columns 0 to width // 2."""
    height, stored = half.shape
    reach = box // 2
    padded = np.empty((height + 2 * reach, stored + 2 * reach), np.float32)
    inner = padded[reach : reach + height]
    inner[:, reach : reach + stored] = half
    rows = -np.arange(height) % height
    for column in (*range(-reach, 0), *range(stored, stored + reach)):
        wrapped = column % width
        inner[:, reach + column] = half[:, wrapped] if wrapped < stored else half[rows, width - wrapped]
    around = np.arange(reach)
    padded[:reach] = inner[(around - reach) % height]
    padded[reach + height :] = inner[around % height]
    mean: FloatArray = cv2.blur(padded, (box, box)).astype(np.float32, copy=False)
    return mean[reach : reach + height, reach : reach + stored]
