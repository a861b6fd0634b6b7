"""Sensor of a cheap video camera, which turns light into frames."""

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from placecat.seeds import derive
from placecat_homes.mesh import Floats, floats
from placecat_homes.view import Lens, Pose


@dataclass(frozen=True)
class Sensor:
    """Properties that determine how a camera records light.

    Attributes
    ----------
    key
        Linear grey level, from 0 to 1, that automatic exposure aims for as the logarithmic mean of a frame.
    lag
        Share of the exposure error that is corrected in each frame. If it is below 1, exposure lags behind.
    drift
        Standard deviation of the slow random drift in exposure, in stops.
    balance
        Share of a colour cast that automatic white balance removes.
    gains
        Sensitivity of the camera to red, green and blue.
    saturation
        1 keeps the colours as they are; lower values fade them.
    shutter
        Share of the time between two frames for which the shutter is open. It determines the amount of motion
        blur.
    blur
        Standard deviation of the lens blur in pixels.
    sharpen
        Amount of sharpening by the camera's electronics.
    noise
        Standard deviation of the sensor noise at mid-grey, on a scale from 0 to 255.
    vignette
        Share of light lost in the corners.
    """

    key: float = 0.16
    lag: float = 0.3
    drift: float = 0.15
    balance: float = 0.6
    gains: tuple[float, float, float] = (1.0, 1.0, 1.0)
    saturation: float = 1.0
    shutter: float = 0.1
    blur: float = 0.6
    sharpen: float = 0.4
    noise: float = 2.0
    vignette: float = 0.15


def exposures(previews: NDArray[np.floating], sensor: Sensor, seed: int) -> Floats:
    """Compute the automatic exposure and white balance for a sequence of frames.

    Parameters
    ----------
    previews
        (frames, h, w, 3) linear radiance of small versions of all frames, in order.
    sensor
        The camera.
    seed
        Seed of the exposure drift.

    Returns
    -------
    numpy.ndarray
        (frames, 3) float32, factors for red, green and blue in each frame.
    """
    grey = np.maximum(previews.mean(axis=3), 1e-4)
    # Give more weight to the middle of the frame.
    h, w = grey.shape[1:]
    weight = np.outer(np.hanning(h + 2)[1:-1] + 0.3, np.hanning(w + 2)[1:-1] + 0.3)
    mean = (np.log(np.minimum(grey, 1.5)) * weight).sum(axis=(1, 2)) / weight.sum()
    wanted = np.log(sensor.key) - mean
    bright = np.percentile(previews.max(axis=3).reshape(len(previews), -1), 90, axis=1)
    # Large bright windows lower the exposure, but only partly.
    wanted = np.minimum(wanted, np.log(1.6 / np.maximum(bright, 1e-3)) + 0.7)
    cast = np.log(np.maximum(previews.mean(axis=(1, 2)), 1e-4))
    cast = cast - cast.mean(axis=1, keepdims=True)
    rng = np.random.default_rng(derive("exposure", seed))
    out = np.empty((len(previews), 3), np.float32)
    level, tint, walk = wanted[0], cast[0], 0.0
    for k in range(len(previews)):
        level = level + sensor.lag * (wanted[k] - level)
        tint = tint + 0.3 * sensor.lag * (cast[k] - tint)
        walk = 0.97 * walk + 0.24 * rng.normal(0, sensor.drift * np.log(2))
        out[k] = np.exp(level + walk - sensor.balance * tint) * np.asarray(sensor.gains)
    return out


def motion(pose: Pose, following: Pose, lens: Lens, distance: Floats, shutter: float) -> Floats:
    """Compute how far each part of the image moves while the shutter is open.

    Parameters
    ----------
    pose, following
        Camera poses in this frame and the next.
    lens
        Lens of the camera.
    distance
        (height, width), distance along each ray in metres.
    shutter
        Share of the time between the two frames for which the shutter is open.

    Returns
    -------
    numpy.ndarray
        (height, width, 2) float32, movement in pixels, rightwards and downwards.
    """
    forward, right, down = pose.axes()
    x, y = lens.plane()
    rays = forward + x[..., None] * right + y[..., None] * down
    points = rays / np.linalg.norm(rays, axis=2, keepdims=True) * distance[..., None]
    points -= floats(following.x - pose.x, following.y - pose.y, following.z - pose.z)
    ahead, aside, below = following.axes()
    depth = np.maximum(points @ ahead, 0.05)
    focus = lens.width / (2 * np.tan(np.radians(lens.field) / 2))
    flow = np.stack([(points @ aside) / depth - x, (points @ below) / depth - y], axis=2) * focus
    return (np.clip(flow, -lens.width / 2, lens.width / 2) * shutter).astype(np.float32)


def smear(radiance: Floats, flow: Floats, most: int = 9) -> Floats:
    """Blur a frame along its motion.

    Parameters
    ----------
    radiance
        (height, width, 3) float32.
    flow
        (height, width, 2) float32 pixels.
    most
        Maximum number of copies to average.

    Returns
    -------
    numpy.ndarray
        The blurred frame, with the same shape as `radiance`.
    """
    reach = float(np.percentile(np.hypot(flow[..., 0], flow[..., 1]), 90))
    count = min(most, round(reach / 1.5))
    if count < 2:
        return radiance
    h, w = radiance.shape[:2]
    x, y = np.meshgrid(np.arange(w, dtype=np.float32), np.arange(h, dtype=np.float32))
    total = np.zeros_like(radiance)
    for step in np.linspace(-0.5, 0.5, count, dtype=np.float32):
        total += cv2.remap(
            radiance,
            x + step * flow[..., 0],
            y + step * flow[..., 1],
            cv2.INTER_LINEAR,
            borderMode=cv2.BORDER_REPLICATE,
        )
    return (total / count).astype(np.float32)


def develop(radiance: Floats, factors: Floats, sensor: Sensor, seed: int) -> NDArray[np.uint8]:
    """Convert light to an 8-bit frame.

    Parameters
    ----------
    radiance
        (height, width, 3) float32, linear red, green and blue.
    factors
        (3,) from `exposures`.
    sensor
        The camera.
    seed
        Seed of this frame's noise.

    Returns
    -------
    numpy.ndarray
        (height, width, 3) uint8, BGR.
    """
    light: NDArray[np.floating] = radiance * factors
    h, w = light.shape[:2]
    if sensor.vignette:
        r2 = (np.linspace(-1, 1, w)[None, :] ** 2 + np.linspace(-1, 1, h)[:, None] ** 2) / 2
        light = light * (1 - sensor.vignette * r2[..., None]).astype(np.float32)
    if sensor.blur:
        light = np.asarray(cv2.GaussianBlur(light.astype(np.float32), (0, 0), sensor.blur), np.float32)
    if sensor.saturation != 1:
        grey = light @ floats(0.299, 0.587, 0.114)
        light = np.maximum(grey[..., None] + sensor.saturation * (light - grey[..., None]), 0)
    # Apply a soft shoulder instead of hard clipping, and then the sRGB curve.
    light = np.minimum(1.25 * light * (1 + light / 9) / (1 + light), 1)
    frame = np.where(light <= 0.0031308, 12.92 * light, 1.055 * np.power(light, 1 / 2.4) - 0.055)
    frame = (frame * 255).astype(np.float32)
    if sensor.sharpen:
        frame += sensor.sharpen * (frame - cv2.GaussianBlur(frame, (0, 0), 1.2))
    if sensor.noise:
        rng = np.random.default_rng(derive("noise", seed))
        grain = rng.standard_normal((h, w, 1), dtype=np.float32) + 0.5 * rng.standard_normal(
            (h, w, 3), dtype=np.float32
        )
        gain = np.sqrt(float(factors.mean()))
        frame += sensor.noise * min(0.6 + 0.15 * gain, 2.0) * grain
    return np.clip(frame[..., ::-1] + 0.5, 0, 255).astype(np.uint8)
