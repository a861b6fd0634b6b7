"""A room that is being furnished."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from placecat_homes.mesh import Mesh
from placecat_homes.placing.at_walls import GAP, TRIES, AtWalls
from placecat_homes.placing.lattice import CELL
from placecat_homes.placing.occupied import FLAT, HEAD
from placecat_homes.placing.opening import Opening
from placecat_homes.placing.placed import Floats, Placed, rotation
from placecat_homes.style import Style


class Room(AtWalls):
    """A room in a building, to be filled with furniture.

    Attributes
    ----------
    kind, name
        Kind and name of the room, such as "bedroom" and "bedroom_1".
    style
        Style of the building.
    """

    def __init__(
        self,
        kind: str,
        name: str,
        size: tuple[float, float, float],
        openings: Sequence[Opening],
        style: Style,
        rng: np.random.Generator,
    ) -> None:
        """Create an empty room. `size` is width, depth and height."""
        super().__init__(size, openings, rng)
        self.kind, self.name, self.style = kind, name, style

    def middle(self, model: Mesh, *, clearance: float = 0.6, turn: float | None = None) -> Placed | None:
        """Place a free-standing object near the middle of the room.

        Parameters
        ----------
        model
            The object. The middle of its footprint is moved to the chosen place.
        clearance
            Minimum distance in metres from walls and other objects.
        turn
            Angle in degrees; a random multiple of 90 if None.

        Returns
        -------
        Placed | None
            The placed object, or None if there is no free place.
        """
        turns = [90.0 * float(k) for k in self.rng.permutation(4)] if turn is None else [turn]
        aim = np.array([self.width, self.depth]) / 2 + self.rng.normal(0, 0.15, 2)
        spots = []
        for degrees in turns:
            size, offset = self._extent(model, degrees)
            grids = [
                np.arange(half + clearance, full - half - clearance + 1e-9, 0.1)
                for half, full in zip(size / 2, (self.width, self.depth), strict=True)
            ]
            if any(len(grid) == 0 for grid in grids):
                continue
            centres = np.stack(np.meshgrid(*grids, indexing="ij"), -1).reshape(-1, 2)
            rects = np.concatenate([centres - size / 2, centres + size / 2], axis=1)
            around = rects + np.array([-1, -1, 1, 1]) * clearance
            good = self._clear(rects, 0.0, float(model.high[2]), self._boxes + self._zones + self._fronts)
            good &= self._clear(around, FLAT, HEAD, self._boxes)
            distance = np.linalg.norm(centres - aim, axis=1)
            spots += [(distance[k], degrees, centres[k] - offset) for k in np.flatnonzero(good)]
        # Angles at equally central positions are tried in random order.
        for _, degrees, origin in sorted(spots, key=lambda spot: round(float(spot[0]), 1))[:TRIES]:
            thing = Placed(model, float(origin[0]), float(origin[1]), 0.0, degrees)
            if self._walkable_with(thing):
                return self._keep(thing)
        return None

    def beside(self, other: Placed, model: Mesh, *, side: str = "left", gap: float = 0.05) -> Placed | None:
        """Put an object beside another one, facing the same way, with their backs aligned.

        Parameters
        ----------
        other
            The other object, which is already in the room.
        model
            The object.
        side
            "left" or "right", as seen when facing `other`.
        gap
            Metres between the two.

        Returns
        -------
        Placed | None
            The placed object, or None if there is no free place.
        """
        if side == "left":
            x = float(other.model.high[0]) + gap - float(model.low[0])
        else:
            x = float(other.model.low[0]) - gap - float(model.high[0])
        y = float(other.model.low[1]) - float(model.low[1])
        return self._try(self._in_frame(other, model, x, y, 0.0, 0.0, other.wall))

    def facing(self, other: Placed, model: Mesh, *, distance: float) -> Placed | None:
        """Put an object in front of another one, facing it.

        Parameters
        ----------
        other
            The other object, which is already in the room.
        model
            The object.
        distance
            Metres between their fronts. If this is 1 m or more and the object would end up close to or behind
            a wall, it is put against that wall.

        Returns
        -------
        Placed | None
            The placed object, or None if there is no free place.
        """
        x = float(other.model.low[0] + other.model.high[0] + model.low[0] + model.high[0]) / 2
        y = float(other.model.high[1]) + distance + float(model.high[1])
        thing = self._in_frame(other, model, x, y, -other.z, 180.0, None)
        quarter = thing.turn / 90
        if distance >= 1.0 and abs(quarter - round(quarter)) < 1e-6:
            wall = round(quarter) % 4
            back = self.back(thing, wall)
            if back < 0.6:
                box = thing.box()
                place = self.along(wall, (box[0] + box[2]) / 2, (box[1] + box[3]) / 2)
                thing = self.at_wall(model, wall, place, 0.0, GAP)
        return self._try(thing)

    def on(self, other: Placed, model: Mesh, x: float, y: float, z: float, turn: float = 0.0) -> Placed:
        """Put an object at a position relative to another one, regardless of what else is there.

        Parameters
        ----------
        other
            The other object, which is already in the room.
        model
            The object.
        x, y, z
            Position of its origin in the frame of `other`, in metres.
        turn
            Degrees relative to `other`.

        Returns
        -------
        Placed
            The object.
        """
        thing = self._in_frame(other, model, x, y, z, turn, other.wall)
        if thing.wall is not None and (turn % 360 != 0 or self.back(thing, thing.wall) > 0.15):
            thing = replace(thing, wall=None)
        return self._keep(thing, blocks=self._blocks(thing) and self._walkable_with(thing))

    def floor(self, model: Mesh, *, under: Placed | None = None) -> Placed | None:
        """Lay a flat object on the floor.

        Parameters
        ----------
        model
            A rug or mat.
        under
            Object to centre it under. If None, it is laid on a large clear area of the floor.

        Returns
        -------
        Placed | None
            The placed object, or None if the room is too small for it.
        """
        if under is not None:
            turns = [under.turn, under.turn + 90.0]
            aim = under.corners().mean(axis=0)
        else:
            alike = (self.width >= self.depth) == (model.size[0] >= model.size[1])
            turns = [0.0, 90.0] if alike else [90.0, 0.0]
            inside = self._floor.distances()
            best = np.argwhere(inside >= inside.max() - 4)
            aim = (best[self.rng.integers(len(best))] + 0.5) * CELL
        room = np.array([self.width, self.depth])
        for turn in turns:
            size, offset = self._extent(model, turn)
            if np.any(size > room - 0.1):
                continue
            centre = np.clip(aim, size / 2 + 0.05, room - size / 2 - 0.05)
            x, y = centre - offset
            lifted = 0.001 * (1 + sum(thing.z < 0.02 and thing.box()[5] < FLAT for thing in self.placed))
            thing = Placed(model, float(x), float(y), lifted, turn)
            self.placed.append(thing)
            return thing
        return None

    def ceiling(
        self,
        model: Mesh,
        *,
        above: Placed | None = None,
        x: float | None = None,
        y: float | None = None,
    ) -> Placed:
        """Attach an object to the ceiling.

        Parameters
        ----------
        model
            The object, whose z = 0 is placed at the ceiling.
        above
            Object to hang it over, centred.
        x, y
            Position if `above` is None; by default, the middle of the room.

        Returns
        -------
        Placed
            The object.
        """
        if above is not None:
            x, y = (float(value) for value in above.corners().mean(axis=0))
        thing = Placed(
            model,
            self.width / 2 if x is None else x,
            self.depth / 2 if y is None else y,
            self.height,
            0.0,
        )
        self.placed.append(thing)
        self._boxes.append(thing.box())
        return thing

    def _try(self, thing: Placed) -> Placed | None:
        box = self._bulk(thing)
        limits = np.array([self.width, self.depth, self.width, self.depth])
        if np.any(box[:4] < -0.01) or np.any(box[:4] > limits + 0.01) or box[5] > self.height:
            return None
        boxes = self._boxes + (self._zones if self._blocks(thing) else [])
        if not self._clear(box[None, :4], box[4], box[5], boxes)[0]:
            return None
        if thing.wall is not None:
            ends = self.ends(thing, thing.wall)
            if self.covers_opening(thing.wall, ends, box[4], box[5], 0.0):
                return None
        return self._keep(thing) if self._walkable_with(thing) else None

    @staticmethod
    def _extent(model: Mesh, turn: float) -> tuple[Floats, Floats]:
        """Return the size of the rotated footprint, and its middle relative to the model's origin."""
        corners = Placed(model, 0.0, 0.0, 0.0, turn).corners()
        low, high = corners.min(axis=0), corners.max(axis=0)
        return high - low, (low + high) / 2

    def _in_frame(
        self, other: Placed, model: Mesh, x: float, y: float, z: float, turn: float, wall: int | None
    ) -> Placed:
        dx, dy = rotation(other.turn) @ (x, y)
        origin = (other.x + float(dx), other.y + float(dy), other.z + z)
        return Placed(model, *origin, (other.turn + turn) % 360, wall)
