"""A video of a lit building, filmed on a walk through it."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from placecat.seeds import derive
from placecat_homes import outside, sensor, shapes
from placecat_homes.bake import Quality, bake
from placecat_homes.building import Building, build
from placecat_homes.floorplan import FloorPlan
from placecat_homes.materials import Material
from placecat_homes.mesh import Lamp, Mesh, join
from placecat_homes.scene import prepare
from placecat_homes.sensor import Sensor
from placecat_homes.view import Lens, Pose, Viewer
from placecat_homes.walking.carriage import Carriage
from placecat_homes.walking.walk import Walk, walk
from placecat_homes.walking.walk_statistics import Statistics


@dataclass(frozen=True)
class Shot:
    """The content of a video.

    Attributes
    ----------
    name
        Name of the video. It seeds the walk and the camera noise.
    building
        Seed of the furniture and surfaces.
    weather, azimuth, elevation
        See `outside.draw`, but the angles are in degrees.
    lamps
        Share of rooms with the lights on.
    frames, fps
        Number of frames, and frames per second.
    rooms
        Names of the rooms to stay in; all rooms if None.
    """

    name: str
    building: int
    weather: str
    azimuth: float
    elevation: float
    lamps: float
    frames: int
    fps: int
    rooms: tuple[str, ...] | None = None


@dataclass(frozen=True)
class Finish:
    """The level of detail of a rendering.

    Attributes
    ----------
    edge
        Longest edge, in metres, of the triangles that store the baked light.
    texture
        Width of a texture in pixels.
    preview
        Width in pixels of the small frames that the automatic exposure measures.
    glare
        Brightness of the world outside; see `Viewer`.
    light
        Settings for baking the light.
    """

    edge: float
    texture: int
    preview: int
    glare: float
    light: Quality


class Film:
    """A walk whose frames can be rendered in any order.

    Parameters
    ----------
    shot
        What the video shows.
    plan
        Plan of the building.
    statistics
        Statistics of the walk.
    carriage
        What carries the camera.
    lens, sensor_
        The camera's lens and sensor.
    finish
        The level of detail.

    Attributes
    ----------
    building
        The furnished building.
    walk
        The camera pose and label of each frame.
    """

    def __init__(
        self,
        shot: Shot,
        plan: FloorPlan,
        statistics: Statistics,
        carriage: Carriage,
        lens: Lens,
        sensor_: Sensor,
        finish: Finish,
    ) -> None:
        self._shot, self._lens, self._sensor = shot, lens, sensor_
        self._finish = finish
        self.building: Building = build(plan, shot.building)
        rng = np.random.default_rng(derive("walk", shot.name))
        self.walk: Walk = walk(
            self.building.ground(), rng, statistics, carriage, shot.frames, shot.fps, rooms=shot.rooms
        )
        self._viewer = self._lit()
        self._factors: NDArray[np.float32] | None = None

    @property
    def labels(self) -> list[str]:
        """The label of each frame."""
        return self.walk.label

    def frame(self, number: int) -> NDArray[np.uint8]:
        """Render one frame.

        Parameters
        ----------
        number
            Number of the frame, from 0.

        Returns
        -------
        numpy.ndarray
            (height, width, 3) uint8, BGR.
        """
        if self._factors is None:
            self._factors = self._exposures()
        pose = self.pose(number)
        radiance, distance = self._viewer.frame(pose, self._lens)
        following = self.pose(min(number + 1, self._shot.frames - 1))
        flow = sensor.motion(pose, following, self._lens, distance, self._sensor.shutter)
        seed = derive("frame", self._shot.name, number)
        return sensor.develop(sensor.smear(radiance, flow), self._factors[number], self._sensor, seed)

    def frames(self) -> Iterator[NDArray[np.uint8]]:
        """Render all frames, in order."""
        for number in range(self._shot.frames):
            yield self.frame(number)

    def pose(self, number: int) -> Pose:
        """Return the camera pose in a frame; frames are counted from 0."""
        path = self.walk
        x, y, z = (float(value) for value in path.position[number])
        return Pose(x, y, z, float(path.yaw[number]), float(path.pitch[number]), float(path.roll[number]))

    def _exposures(self) -> NDArray[np.float32]:
        scale = self._finish.preview / self._lens.width
        small = replace(self._lens, width=self._finish.preview, height=round(self._lens.height * scale))
        previews = [self._viewer.frame(self.pose(k), small)[0] for k in range(self._shot.frames)]
        return sensor.exposures(np.stack(previews), self._sensor, derive("exposure", self._shot.name))

    def _lit(self) -> Viewer:
        shot = self._shot
        daylight = outside.draw(
            np.random.default_rng(derive("outside", shot.building)),
            weather=shot.weather,
            azimuth=float(np.radians(shot.azimuth)),
            elevation=float(np.radians(shot.elevation)),
        )
        mesh = replace(join(self.building.mesh, self._roof()), lamps=self._lamps())
        scene = prepare(mesh, edge=self._finish.edge, pixels=self._finish.texture)
        light = bake(scene, daylight, self._finish.light)
        return Viewer(scene, light, daylight, glare=self._finish.glare)

    def _roof(self) -> Mesh:
        # Without a roof, the sky would shine into the hollow walls.
        mesh = self.building.mesh
        (x0, y0, _), (x1, y1, _) = mesh.low - 0.5, mesh.high + 0.5
        lid = shapes.slab(float(x1 - x0), float(y1 - y0)).of(Material((0.2, 0.2, 0.2)))
        return lid.moved(float(x0 + x1) / 2, float(y0), self.building.plan.height + 0.02)

    def _lamps(self) -> tuple[Lamp, ...]:
        on = []
        for room in self.building.plan.rooms:
            rng = np.random.default_rng(derive("lamps", self._shot.name, room.name))
            if rng.uniform() >= self._shot.lamps:
                continue
            x0, y0, x1, y1 = room.rect
            lamps = self.building.mesh.lamps
            on += [lamp for lamp in lamps if x0 <= lamp.position[0] < x1 and y0 <= lamp.position[1] < y1]
        return tuple(on)
