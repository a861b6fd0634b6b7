"""Indirect light, computed once for every vertex of a scene."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.stats import qmc

from placecat_homes import kernels
from placecat_homes.mesh import Floats, Lamp
from placecat_homes.scene import Scene, linear
from placecat_homes.tracer import Tracer


@dataclass(frozen=True, eq=False)
class Daylight:
    """Light from outside.

    Attributes
    ----------
    panorama
        (h, w, 3) float32 linear radiance, with rows from straight up to straight down. A bright overcast sky
        has a radiance of 1.
    sun
        (3,) float32, a unit vector towards the sun.
    sunlight
        (3,) float32, irradiance of a surface facing the sun, divided by pi; 0 if there is no sun.
    """

    panorama: Floats
    sun: Floats
    sunlight: Floats


@dataclass(frozen=True)
class Quality:
    """How accurately the light is baked.

    Attributes
    ----------
    directions
        Number of rays from each vertex; a power of two.
    bounces
        Number of times that light is passed from surface to surface.
    lamp_rays
        Number of shadow rays from each vertex to each lamp.
    chunk
        Number of vertices processed at once. Lower values need less memory.
    """

    directions: int = 256
    bounces: int = 3
    lamp_rays: int = 4
    chunk: int = 4096


LIFT = 0.004
"""Height above the surface at which rays start, in metres."""
SETS = 8
"""Number of ray sets. Each vertex of a large surface uses one of them."""
INWARDS = 0.25
"""How far from the vertex rays start, as a share of the way to the middle of the surrounding triangles."""


def bake(scene: Scene, daylight: Daylight, quality: Quality) -> Floats:
    """Compute all light that reaches each vertex, except direct sunlight.

    This is radiosity: each vertex casts one set of rays to find what it sees, and light is then passed along
    these rays. Light from the sky and from lamps is included. Vertices inside closed bodies are lit like
    their neighbours.

    Parameters
    ----------
    scene
        From `prepare`.
    daylight
        Light from outside.
    quality
        Number of rays and bounces.

    Returns
    -------
    numpy.ndarray
        (n, 4) float32: the irradiance divided by pi in red, green and blue, then the share of direct
        sunlight, including the cosine, for use in reflections.
    """
    solid = scene.surface[scene.material, 3] >= 0.999
    tracer = Tracer(scene.vertices, scene.triangles[solid])
    number = np.flatnonzero(solid).astype(np.int32)
    start = _starts(scene)
    sunshine = _sunshine(tracer, scene, start, daylight)
    lamps = _lamplight(tracer, scene, start, quality)
    hits, sky, buried = _views(tracer, number, scene, start, daylight, quality)
    albedo, emission = _vertex_colours(scene)
    fixed = sky + lamps
    light = fixed
    for _ in range(quality.bounces):
        given = albedo * (light + sunshine[:, None] * daylight.sunlight) + emission
        corners = given[scene.triangles].mean(axis=1)
        passed = np.empty_like(light)
        kernels.gather(hits, corners, passed)
        light = fixed + passed / quality.directions
    together = np.concatenate([light, sunshine[:, None]], axis=1)
    return _heal(scene, together, buried)


def _starts(scene: Scene) -> Floats:
    # Rays start above the surface, shifted slightly towards the middle of the surrounding triangles.
    # Otherwise, rays from room corners and furniture feet could start inside or behind an adjacent surface.
    centres = scene.vertices[scene.triangles].mean(axis=1)
    total, count = np.zeros_like(scene.vertices), np.zeros(len(scene.vertices), np.float32)
    for corner in range(3):
        np.add.at(total, scene.triangles[:, corner], centres)
        np.add.at(count, scene.triangles[:, corner], 1)
    middle = np.where(count[:, None] > 0, total / np.maximum(count, 1)[:, None], scene.vertices)
    return scene.vertices + INWARDS * (middle - scene.vertices) + LIFT * scene.normals


def _vertex_colours(scene: Scene) -> tuple[Floats, Floats]:
    albedo = np.zeros_like(scene.vertices)
    emission = np.zeros_like(scene.vertices)
    for corner in range(3):
        albedo[scene.triangles[:, corner]] = scene.albedo[scene.material]
        glow = scene.albedo[scene.material] * scene.surface[scene.material, 2, None]
        emission[scene.triangles[:, corner]] = glow
    # No surface in a room is whiter than plaster.
    return np.minimum(albedo, 0.85), emission


def _frames(normals: Floats) -> tuple[Floats, Floats]:
    # A branchless basis that turns slowly with the normal, so that neighbouring vertices cast rays in similar
    # directions (Duff et al. 2017).
    sign = np.where(normals[:, 2] >= 0, 1.0, -1.0).astype(np.float32)
    a = -1 / (sign + normals[:, 2])
    b = normals[:, 0] * normals[:, 1] * a
    first = np.stack([1 + sign * normals[:, 0] ** 2 * a, sign * b, -sign * normals[:, 0]], axis=1)
    second = np.stack([b, sign + normals[:, 1] ** 2 * a, -normals[:, 1]], axis=1)
    return first.astype(np.float32), second.astype(np.float32)


def _hemispheres(count: int) -> Floats:
    # The directions are cosine-weighted: the mean over the rays is the irradiance divided by pi.
    points = np.stack([qmc.Sobol(2, scramble=True, seed=k).random(count) for k in range(SETS)])
    radius, angle = np.sqrt(points[..., 0]), 2 * np.pi * points[..., 1]
    return np.stack(
        [radius * np.cos(angle), radius * np.sin(angle), np.sqrt(1 - points[..., 0])], axis=2
    ).astype(np.float32)


def _sets(scene: Scene) -> NDArray[np.intp]:
    # On large plain surfaces, neighbours use different rays, and `_heal` evens out the differences.
    # Otherwise, a window's outline would show up as many faint shadows. On finely meshed furniture,
    # neighbours use the same rays.
    edge = np.linalg.norm(
        scene.vertices[scene.triangles[:, 0]] - scene.vertices[scene.triangles[:, 1]], axis=1
    )
    longest = np.zeros(len(scene.vertices), np.float32)
    for corner in range(3):
        np.maximum.at(longest, scene.triangles[:, corner], edge)
    mixed = (np.arange(len(scene.vertices), dtype=np.uint32) * np.uint32(2654435761)) >> np.uint32(20)
    return np.where(longest > 0.06, mixed % SETS, 0).astype(np.intp)


def _views(
    tracer: Tracer,
    number: NDArray[np.int32],
    scene: Scene,
    start: Floats,
    daylight: Daylight,
    quality: Quality,
) -> tuple[NDArray[np.int32], Floats, NDArray[np.bool_]]:
    sets, chosen = _hemispheres(quality.directions), _sets(scene)
    first, second = _frames(scene.normals)
    count = len(start)
    hits = np.full((count, quality.directions), -1, np.int32)
    sky = np.zeros((count, 3), np.float32)
    buried = np.zeros(count, bool)
    a, b, c = (scene.vertices[scene.triangles[:, k]] for k in range(3))
    facing = np.cross(b - a, c - a)
    for low in range(0, count, quality.chunk):
        part = slice(low, low + quality.chunk)
        turned = sets[chosen[part]]
        rays = (
            turned[:, :, 0, None] * first[part, None]
            + turned[:, :, 1, None] * second[part, None]
            + turned[:, :, 2, None] * scene.normals[part, None]
        ).reshape(-1, 3)
        origins = np.repeat(start[part], quality.directions, axis=0)
        prim = tracer.hits(origins, rays).triangle
        missed = prim < 0
        prim = np.where(missed, -1, number[prim])
        hits[part] = prim.reshape(-1, quality.directions)
        behind = np.einsum("ij,ij->i", facing[prim], rays) > 0
        buried[part] = (behind & ~missed).reshape(-1, quality.directions).mean(axis=1) > 0.6
        seen = np.zeros((int(missed.sum()), 3), np.float32)
        kernels.sky(rays[missed], daylight.panorama, seen)
        radiance = np.zeros_like(rays)
        radiance[missed] = seen
        sky[part] = radiance.reshape(-1, quality.directions, 3).mean(axis=1)
    return hits, sky, buried


def _sunshine(tracer: Tracer, scene: Scene, start: Floats, daylight: Daylight) -> Floats:
    share = np.maximum(scene.normals @ daylight.sun, 0)
    if not daylight.sunlight.any():
        return np.zeros_like(share)
    lit = share > 0
    rays = np.tile(daylight.sun, (int(lit.sum()), 1))
    blocked = tracer.blocked(start[lit], rays, np.full(len(rays), 100, np.float32))
    share[lit] *= ~blocked
    return share


def _lamplight(tracer: Tracer, scene: Scene, start: Floats, quality: Quality) -> Floats:
    light = np.zeros_like(start)
    offsets = _sphere(quality.lamp_rays)
    for lamp in scene.lamps:
        light += _one_lamp(tracer, scene, start, lamp, offsets)
    return light


def _sphere(count: int) -> Floats:
    points = qmc.Sobol(2, scramble=True, seed=1).random(count)
    z, angle = 2 * points[:, 0] - 1, 2 * np.pi * points[:, 1]
    radius = np.sqrt(1 - z**2)
    return np.stack([radius * np.cos(angle), radius * np.sin(angle), z], axis=1).astype(np.float32)


def _one_lamp(tracer: Tracer, scene: Scene, start: Floats, lamp: Lamp, offsets: Floats) -> Floats:
    light = np.zeros_like(start)
    towards = np.asarray(lamp.position, np.float32) - start
    squared = np.maximum(np.einsum("ij,ij->i", towards, towards), 0.04)
    cosine = np.einsum("ij,ij->i", towards, scene.normals) / np.sqrt(squared)
    near = np.flatnonzero((cosine > 0) & (lamp.power / squared > 0.002))
    strength = np.zeros(len(near), np.float32)
    for offset in offsets:
        rays = towards[near] + offset * lamp.radius
        distance = np.linalg.norm(rays, axis=1)
        # A lamp's body does not block its own light.
        reach = np.maximum(distance - max(2.5 * lamp.radius, 0.15), 0.02).astype(np.float32)
        blocked = tracer.blocked(start[near], rays / np.maximum(distance, 1e-6)[:, None], reach)
        strength += ~blocked
    strength *= lamp.power / squared[near] * cosine[near] / len(offsets)
    light[near] = strength[:, None] * linear(lamp.colour)
    return light


def _heal(scene: Scene, light: Floats, buried: NDArray[np.bool_]) -> Floats:
    # Buried vertices get their light from neighbours on the surface, ring by ring. Vertices that no ring
    # reaches stay dark.
    edges = np.concatenate(
        [scene.triangles[:, [0, 1]], scene.triangles[:, [1, 2]], scene.triangles[:, [2, 0]]]
    )
    ones = np.ones(2 * len(edges), np.float32)
    rows = np.concatenate([edges[:, 0], edges[:, 1]])
    columns = np.concatenate([edges[:, 1], edges[:, 0]])
    count = len(light)
    near = sparse.csr_matrix((ones, (rows, columns)), shape=(count, count))
    healed, open_ = light.copy(), ~buried
    healed[buried] = 0
    for _ in range(6):
        total = near @ (healed * open_[:, None])
        weight = near @ open_.astype(np.float32)
        take = ~open_ & (weight > 0)
        healed[take] = total[take] / weight[take, None]
        open_ |= take
    degree = np.maximum(np.asarray(near.sum(axis=1)).ravel(), 1)[:, None]
    for _ in range(3):
        healed = 0.4 * healed + 0.6 * (near @ healed) / degree
    return np.concatenate([healed[:, :3], light[:, 3:]], axis=1).astype(np.float32)
