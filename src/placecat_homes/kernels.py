"""Compiled loops for the renderer."""

# mypy: disallow-untyped-defs=False

import math

import numpy as np
from numba import njit

# Each kernel is a single loop over pixels or vertices in single precision; all other code uses array
# operations.


@njit(cache=False)
def _texel(atlas, base, width, x, y, channel, decode):
    return decode[atlas[base + ((y % width) * width + (x % width)) * 3 + channel]]


@njit(cache=False)
def _bilinear(atlas, base, width, s, t, decode, out):
    fx, fy = s * width - 0.5, t * width - 0.5
    x, y = math.floor(fx), math.floor(fy)
    ax, ay = fx - x, fy - y
    for k in range(3):
        out[k] = (
            _texel(atlas, base, width, x, y, k, decode) * (1 - ax)
            + _texel(atlas, base, width, x + 1, y, k, decode) * ax
        ) * (1 - ay) + (
            _texel(atlas, base, width, x, y + 1, k, decode) * (1 - ax)
            + _texel(atlas, base, width, x + 1, y + 1, k, decode) * ax
        ) * ay


@njit(cache=False)
def surfaces(
    prim,
    u,
    v,
    distance,
    directions,
    spread,
    triangles,
    normals,
    uv,
    light,
    material,
    properties,
    atlas,
    pixels,
    levels,
    decode,
    colour,
    normal,
    irradiance,
):
    """Look up the surfaces that rays have hit.

    Fills `colour` (r, 3) with linear albedo, `normal` (r, 3) turned towards the eye, and `irradiance` (r, c),
    interpolated from `light` (n, c). Rows for rays that hit nothing are left unchanged. `spread` is the angle
    between neighbouring pixels in radians. It determines the resolution at which the texture is sampled.
    `decode` (256,) converts sRGB to linear light.
    """
    first, second = np.empty(3, np.float32), np.empty(3, np.float32)
    sizes = np.empty(levels, np.int64)
    starts = np.empty(levels, np.int64)
    total = 0
    for k in range(levels):
        sizes[k], starts[k] = pixels >> k, total
        total += sizes[k] * sizes[k] * 3
    for r in range(len(prim)):
        p = prim[r]
        if p < 0:
            continue
        a, b, c = triangles[p, 0], triangles[p, 1], triangles[p, 2]
        wb, wc = u[r], v[r]
        wa = 1 - wb - wc
        facing = 0.0
        length = 0.0
        for k in range(3):
            n = wa * normals[a, k] + wb * normals[b, k] + wc * normals[c, k]
            normal[r, k] = n
            length += n * n
            facing += n * directions[r, k]
        scale = 1 / math.sqrt(max(length, 1e-12))
        if facing > 0:
            scale = -scale
        for k in range(3):
            normal[r, k] *= scale
        for k in range(light.shape[1]):
            irradiance[r, k] = wa * light[a, k] + wb * light[b, k] + wc * light[c, k]
        m = material[p]
        number = int(properties[m, 3])
        for k in range(3):
            colour[r, k] = properties[m, k]
        if number < 0:
            continue
        s = (wa * uv[a, 0] + wb * uv[b, 0] + wc * uv[c, 0]) * properties[m, 4]
        t = 1 - (wa * uv[a, 1] + wb * uv[b, 1] + wc * uv[c, 1]) * properties[m, 5]
        grazing = max(abs(facing * scale), 0.2)
        texels = distance[r] * spread * properties[m, 6] / grazing
        level = min(max(math.log2(max(texels, 1e-6)), 0.0), levels - 1.001)
        low = int(level)
        part = level - low
        base = number * total
        _bilinear(atlas, base + starts[low], sizes[low], s, t, decode, first)
        _bilinear(atlas, base + starts[low + 1], sizes[low + 1], s, t, decode, second)
        for k in range(3):
            colour[r, k] *= first[k] * (1 - part) + second[k] * part


@njit(cache=False)
def sky(directions, picture, out):
    """Look up (r, 3) directions in an (h, w, 3) panorama whose rows run from straight up to straight down."""
    height, width = picture.shape[0], picture.shape[1]
    for r in range(len(directions)):
        x, y, z = directions[r, 0], directions[r, 1], directions[r, 2]
        column = (math.atan2(y, x) / (2 * math.pi) % 1.0) * width - 0.5
        row = math.acos(min(max(z, -1.0), 1.0)) / math.pi * height - 0.5
        j = math.floor(column)
        i = min(max(math.floor(row), 0), height - 2)
        ax, ay = column - j, min(max(row - i, 0.0), 1.0)
        for k in range(3):
            top = picture[i, j % width, k] * (1 - ax) + picture[i, (j + 1) % width, k] * ax
            low = picture[i + 1, j % width, k] * (1 - ax) + picture[i + 1, (j + 1) % width, k] * ax
            out[r, k] = top * (1 - ay) + low * ay


@njit(cache=False)
def gather(hits, given, out):
    """Sum the light `given` (m, 3) from the triangles `hits` (n, r) that the rays of each vertex have hit."""
    for i in range(hits.shape[0]):
        for k in range(3):
            out[i, k] = 0
        for j in range(hits.shape[1]):
            p = hits[i, j]
            if p >= 0:
                for k in range(3):
                    out[i, k] += given[p, k]
