"""View of a lit scene through a pinhole camera."""

import math
from dataclasses import dataclass

import numpy as np

from placecat_homes import kernels
from placecat_homes.bake import LIFT, Daylight
from placecat_homes.mesh import Floats, floats
from placecat_homes.scene import LEVELS, Scene, linear
from placecat_homes.tracer import Tracer

DECODE = linear(np.arange(256) / 255)
METAL = 0.3
"""Minimum gloss for a surface to tint reflections."""


@dataclass(frozen=True)
class Pose:
    """Position and direction of a camera.

    Attributes
    ----------
    x, y, z
        Metres.
    yaw
        In radians, 0 along +x, and counter-clockwise as seen from above.
    pitch
        In radians, positive upwards.
    roll
        In radians, clockwise as seen by the camera.
    """

    x: float
    y: float
    z: float
    yaw: float
    pitch: float = 0.0
    roll: float = 0.0

    def axes(self) -> tuple[Floats, Floats, Floats]:
        """Return the camera's forward, right and down directions, each (3,) float32."""
        cy, sy, cp, sp = math.cos(self.yaw), math.sin(self.yaw), math.cos(self.pitch), math.sin(self.pitch)
        forward = np.array([cy * cp, sy * cp, sp])
        right = np.array([sy, -cy, 0.0])
        down = np.cross(forward, right)
        c, s = math.cos(self.roll), math.sin(self.roll)
        return (
            forward.astype(np.float32),
            (c * right + s * down).astype(np.float32),
            (c * down - s * right).astype(np.float32),
        )


@dataclass(frozen=True)
class Lens:
    """How a camera maps directions to pixels.

    Attributes
    ----------
    width, height
        Pixels.
    field
        Horizontal field of view in degrees.
    distortion
        Radial distortion. The tangent of a ray's angle is r * (1 - distortion * r**2), where r is the
        distance from the centre of the image plane. Negative values give barrel distortion.
    """

    width: int
    height: int
    field: float
    distortion: float = 0.0

    def plane(self) -> tuple[Floats, Floats]:
        """Return the x and y coordinates in the image plane at distance 1, each (height, width) float32."""
        reach = math.tan(math.radians(self.field) / 2)
        x = ((np.arange(self.width) + 0.5) / self.width * 2 - 1) * reach
        y = ((np.arange(self.height) + 0.5) * 2 - self.height) / self.width * reach
        px, py = np.meshgrid(x.astype(np.float32), y.astype(np.float32))
        factor = 1 - self.distortion * (px**2 + py**2)
        return px * factor, py * factor


class Viewer:
    """Renderer for frames of a lit scene.

    Parameters
    ----------
    scene
        From `prepare`.
    light
        (n, 4) float32 from `bake`.
    daylight
        The daylight used to bake the light.
    glare
        Factor that brightens the view outside, because cameras overexpose it. The light that comes in is
        unchanged.
    """

    def __init__(self, scene: Scene, light: Floats, daylight: Daylight, *, glare: float = 1.0) -> None:
        self._glare = np.float32(glare)
        self._scene, self._light, self._daylight = scene, light, daylight
        self._all = Tracer(scene.vertices, scene.triangles)
        solid = scene.surface[scene.material, 3] >= 0.999
        self._solid = Tracer(scene.vertices, scene.triangles[solid]) if not solid.all() else self._all

    def frame(self, pose: Pose, lens: Lens) -> tuple[Floats, Floats]:
        """Render one frame.

        Parameters
        ----------
        pose
            The camera's pose.
        lens
            The camera's lens.

        Returns
        -------
        tuple of numpy.ndarray
            (height, width, 3) float32 linear radiance, and (height, width) float32 distance in metres along
            the ray (100 where there is nothing).
        """
        forward, right, down = pose.axes()
        x, y = lens.plane()
        rays = forward + x[..., None] * right + y[..., None] * down
        rays = (rays / np.linalg.norm(rays, axis=2, keepdims=True)).reshape(-1, 3).astype(np.float32)
        origins = np.broadcast_to(np.array([pose.x, pose.y, pose.z], np.float32), rays.shape)
        spread = math.radians(lens.field) / lens.width
        radiance, distance = self._look(origins, rays, spread)
        shape = (lens.height, lens.width)
        return radiance.reshape(*shape, 3), np.minimum(distance, 100).reshape(shape)

    def _look(self, origins: Floats, rays: Floats, spread: float) -> tuple[Floats, Floats]:
        radiance, opacity, reflection, normal, distance = self._surface(origins, rays, spread, sun=True)
        seen = np.flatnonzero(reflection.max(axis=1) > 0.015)
        if len(seen):
            n, d = normal[seen], rays[seen]
            mirrored = d - 2 * np.einsum("ij,ij->i", d, n)[:, None] * n
            points = origins[seen] + distance[seen, None] * d + LIFT * n
            other, *_ = self._surface(points, mirrored, spread * 2, sun=False)
            radiance[seen] += reflection[seen] * other
        # Follow rays through up to three layers of glass and net curtains.
        share, at = 1 - opacity, distance
        behind = np.flatnonzero(share > 0.01)
        points = origins[behind] + (at[behind, None] + LIFT) * rays[behind]
        for _ in range(3):
            if not len(behind):
                break
            other, solid, _, _, far = self._surface(points, rays[behind], spread, sun=True)
            radiance[behind] += share[behind, None] * other
            share[behind] *= 1 - solid
            keep = share[behind] > 0.01
            points = (points + (far[:, None] + LIFT) * rays[behind])[keep]
            behind = behind[keep]
        return radiance, distance

    def _surface(
        self, origins: Floats, rays: Floats, spread: float, *, sun: bool
    ) -> tuple[Floats, Floats, Floats, Floats, Floats]:
        scene, day = self._scene, self._daylight
        prim, u, v, distance, across = self._all.hits(origins, rays)
        count = len(prim)
        colour, normal = np.zeros((count, 3), np.float32), np.zeros((count, 3), np.float32)
        light = np.zeros((count, 4), np.float32)
        kernels.surfaces(
            prim, u, v, distance, rays, spread, scene.triangles, scene.normals, scene.uv, self._light,
            scene.material, scene.properties, scene.atlas, scene.pixels, LEVELS, DECODE,
            colour, normal, light,
        )  # fmt: skip
        hit = prim >= 0
        surface = np.where(hit[:, None], scene.surface[scene.material[prim]], floats(0, 0, 0, 1))
        gloss, roughness, emission, opacity = surface.T
        shine = light[:, 3]
        if sun and day.sunlight.any():
            shine = self._sunshine(origins, rays, distance, normal, hit)
        received = light[:, :3] + shine[:, None] * day.sunlight + emission[:, None]
        radiance = colour * received * (opacity * (1 - 0.9 * gloss))[:, None]
        outside = np.zeros((int((~hit).sum()), 3), np.float32)
        kernels.sky(rays[~hit], day.panorama, outside)
        radiance[~hit] = self._glare * outside
        # Schlick's approximation. Rough surfaces reflect less at grazing angles.
        cosine = np.clip(-np.einsum("ij,ij->i", rays, normal), 0, 1)
        grazing = (1 - cosine) ** 5 * (1 - 0.8 * roughness) * (gloss > 0)
        reflection = gloss * (1 - 0.5 * roughness) + (1 - gloss) * grazing
        # Omit rays that the smoothed normal would send into the body.
        mirrored = rays + 2 * cosine[:, None] * normal
        leaving = np.einsum("ij,ij->i", mirrored, across) * np.einsum("ij,ij->i", rays, across) < 0
        reflection *= hit & leaving
        # Metals and mirrors tint what they reflect.
        tint = np.where((gloss >= METAL)[:, None], colour, np.float32(1))
        return radiance, opacity, reflection[:, None] * tint, normal, distance

    def _sunshine(
        self, origins: Floats, rays: Floats, distance: Floats, normal: Floats, hit: np.ndarray
    ) -> Floats:
        sun = self._daylight.sun
        share = np.maximum(normal @ sun, 0) * hit
        lit = np.flatnonzero(share > 0)
        points = origins[lit] + distance[lit, None] * rays[lit] + LIFT * normal[lit]
        towards = np.tile(sun, (len(lit), 1))
        share[lit] *= ~self._solid.blocked(points, towards, np.full(len(lit), 100, np.float32))
        return share
