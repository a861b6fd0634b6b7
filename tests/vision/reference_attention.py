"""A slow float64 implementation of thesis 3.1.1, used as a reference for the fast one."""

import math

import numpy as np
from scipy import ndimage

KERNEL = np.array([1, 4, 6, 4, 1]) / 16


def frame(seed, height, width, black=True):
    """Return a soft colourful frame with a hard-edged patch and, optionally, black pixels."""
    rng = np.random.default_rng(seed)
    noise = ndimage.gaussian_filter(rng.normal(size=(height, width, 3)), (4, 4, 0))
    image = np.clip(110 + 90 * noise / noise.std(), 0, 255).astype(np.uint8)
    image[height // 3 : height // 2, width // 4 : width // 2] = (20, 40, 230)
    if black:
        image[: height // 4, width // 2 : width // 2 + width // 5] = 0
        image[rng.random((height, width)) < 0.02] = 0
    return image


def opponent(image):
    """Return R, G, B, Y of every pixel by the formulas of the thesis, with 0 for a black pixel."""
    out = np.zeros((4, *image.shape[:2]))
    for y in range(image.shape[0]):
        for x in range(image.shape[1]):
            b, g, r = (float(v) for v in image[y, x])
            i = (r + g + b) / 3
            if i == 0:
                continue
            r, g, b = r / i, g / i, b / i
            out[:, y, x] = r - (g + b) / 2, g - (r + b) / 2, b - (r + g) / 2, r + g - 2 * (abs(r - g) + b)
    return out


def reduce(plane):
    padded = np.pad(plane, 2, mode="reflect")
    height, width = plane.shape
    out = np.zeros((-(-height // 2), -(-width // 2)))
    for dy in range(5):
        for dx in range(5):
            out += KERNEL[dy] * KERNEL[dx] * padded[dy : dy + height : 2, dx : dx + width : 2]
    return out


def level(plane, number):
    for _ in range(number):
        plane = reduce(plane)
    return plane


def expand(plane, height, width):
    """Insert zeros and apply the kernel. The left and top borders are mirrored, the others repeated."""
    out = plane
    for axis, size in enumerate((height, width)):
        out = np.moveaxis(out, axis, 0)
        padded = np.concatenate([out[1:2] if len(out) > 1 else out[:1], out, out[-1:]])
        wide = np.zeros((2 * len(out), *out.shape[1:]))
        wide[::2] = (padded[:-2] + 6 * padded[1:-1] + padded[2:]) / 8
        wide[1::2] = (padded[1:-1] + padded[2:]) / 2
        out = np.moveaxis(wide[:size], 0, axis)
    return out


def surround_difference(plane, radius):
    height, width = plane.shape
    padded = np.pad(plane, radius, mode="reflect")
    out = np.zeros(plane.shape)
    for y in range(height):
        for x in range(width):
            window = padded[y : y + 2 * radius + 1, x : x + 2 * radius + 1].ravel()
            out[y, x] = plane[y, x] - np.delete(window, window.size // 2).mean()
    return out


def gabor_magnitude(plane, angle, size=9, sigma=2.0, wavelength=4.0, aspect=1.0):
    half = size // 2
    theta = math.radians(angle)
    kernel = np.zeros((size, size), complex)
    total = 0.0
    for y in range(-half, half + 1):
        for x in range(-half, half + 1):
            u = x * math.cos(theta) + y * math.sin(theta)
            v = -x * math.sin(theta) + y * math.cos(theta)
            envelope = math.exp(-(u * u + aspect * aspect * v * v) / (2 * sigma * sigma))
            total += envelope
            kernel[y + half, x + half] = envelope * np.exp(2j * math.pi * u / wavelength)
    kernel *= 2 / total
    return np.hypot(
        ndimage.correlate(plane, kernel.real, mode="mirror"),
        ndimage.correlate(plane, kernel.imag, mode="mirror"),
    )


def spectral_residual(plane, box=3, sigma=1.0, floor=0.1):
    spectrum = np.fft.fft2(plane)
    amplitude = np.abs(spectrum)
    log_amplitude = np.log(np.sqrt(amplitude**2 + floor**2))
    residual = log_amplitude - ndimage.uniform_filter(log_amplitude, box, mode="wrap")
    # Near the floor, the amplitude of the floored logarithm is multiplied by a / sqrt(a^2 + floor^2).
    damped = amplitude / np.sqrt(amplitude**2 + floor**2)
    power = np.abs(np.fft.ifft2(np.exp(residual + 1j * np.angle(spectrum)) * damped)) ** 2
    if sigma:
        power = ndimage.gaussian_filter(power, sigma, mode="mirror", truncate=4)
    return (power - power.min()) / (power.max() - power.min())


def local_maxima(plane, window=3):
    """Flood every plateau, and keep its first pixel if no pixel in any of its windows is higher."""
    height, width = plane.shape
    reach = window // 2
    seen = np.zeros(plane.shape, bool)
    found = []
    for start in np.ndindex(height, width):
        if seen[start]:
            continue
        value, top, plateau, stack = plane[start], True, 0, [start]
        seen[start] = True
        while stack:
            y, x = stack.pop()
            plateau += 1
            for j in range(max(y - reach, 0), min(y + reach + 1, height)):
                for i in range(max(x - reach, 0), min(x + reach + 1, width)):
                    if plane[j, i] > value:
                        top = False
                    touching = abs(j - y) <= 1 and abs(i - x) <= 1
                    if touching and plane[j, i] == value and not seen[j, i]:
                        seen[j, i] = True
                        stack.append((j, i))
        if top and value > 0 and plateau < plane.size:
            found.append(start[0] * width + start[1])
    return found


def weight(peaks):
    count = sum(1 for p in peaks if p > np.median(peaks))
    return 1 / math.sqrt(count) if count else 0.0


def expand_to(plane, up, shape):
    y, x = np.mgrid[: shape[0], : shape[1]] / 2**up
    return ndimage.map_coordinates(plane, [y, x], order=1, mode="nearest")


def positive(plane, rounding):
    return np.where(plane > rounding, plane, 0)


def feature_maps(image, scales=(2, 3, 4, 5), radii=(1, 3)):
    """Return ``{channel: {(subchannel, scale): [map per radius]}}``."""
    b, g, r = np.moveaxis(image.astype(float), 2, 0)
    grey = (r + g + b) / 3
    colors = opponent(image)
    out = {"intensity": {}, "color": {}, "orientation": {}, "residual": {}}
    for s in scales:
        plane = level(grey, s)
        differences = [surround_difference(plane, radius) for radius in radii]
        out["intensity"][0, s] = [positive(d, 1e-3) for d in differences]
        out["intensity"][1, s] = [positive(-d, 1e-3) for d in differences]
        for c in range(4):
            color = level(colors[c], s)
            out["color"][c, s] = [positive(surround_difference(color, radius), 1e-5) for radius in radii]
        band = plane - expand(reduce(plane), *plane.shape)
        for c, angle in enumerate((0, 45, 90, 135)):
            out["orientation"][c, s] = [gabor_magnitude(band, angle)]
        out["residual"][0, s] = [spectral_residual(plane)]
    return out


def fuse(features, shape, units, scales=(2, 3, 4, 5)):
    """Return the saliency map, the terms of its sum, and the terms of each conspicuity map."""
    terms, subterms = {}, {}
    for channel, maps in features.items():
        added = {}
        for (c, s), by_radius in maps.items():
            for plane in by_radius:
                added[c] = added.get(c, 0) + expand_to(plane, s - scales[0], shape)
        peaks = {c: [plane.ravel()[k] for k in local_maxima(plane)] for c, plane in added.items()}
        subterms[channel] = {c: weight(peaks[c]) * plane for c, plane in added.items()}
        plane = sum(subterms[channel].values())
        largest = max(max(p) for p in peaks.values() if p) / units[channel]
        plane = (plane - plane.min()) / (plane.max() - plane.min()) * largest
        terms[channel] = weight([plane.ravel()[k] for k in local_maxima(plane)]) * plane
    return sum(terms.values()), terms, subterms


def accept(points, width, max_regions):
    accepted = []
    for n, (qx, qy, qs) in enumerate(points):
        far = all(
            math.sqrt((px - qx) ** 2 + (py - qy) ** 2 + (width / 256) ** 2 * (ps - qs) ** 2) > qs * width / 40
            for px, py, ps in (points[k] for k in accepted)
        )
        if far:
            accepted.append(n)
        if len(accepted) == max_regions:
            break
    return accepted


def regions(features, fused, width, max_regions=25, scales=(2, 3, 4, 5)):
    total, terms, subterms = fused
    points = []
    for k in sorted(local_maxima(total), key=lambda k: -total.ravel()[k]):
        channel = max(terms, key=lambda c: terms[c].ravel()[k])
        sub = max(subterms[channel], key=lambda c: subterms[channel][c].ravel()[k])

        def response(s, channel=channel, sub=sub, k=k):
            planes = features[channel][sub, s]
            return max(expand_to(plane, s - scales[0], total.shape).ravel()[k] for plane in planes)

        y, x = divmod(k, total.shape[1])
        points.append((x * 2 ** scales[0], y * 2 ** scales[0], max(scales, key=response), total.ravel()[k]))
    kept = accept([p[:3] for p in points], width, max_regions)
    return np.array([points[n] for n in kept])
