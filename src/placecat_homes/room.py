"""A room that is being furnished: what stands where, and where there is still place.

Walls are numbered 0 to 3, such that a thing with its back on wall k is turned by 90 k degrees: wall 0 is
y = 0, wall 1 is x = width, wall 2 is y = depth, wall 3 is x = 0. Positions along a wall are metres from its
left end as seen from inside.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

from placecat.seeds import derive
from placecat_homes.mesh import Mesh, join
from placecat_homes.style import Style

CELL = 0.05
"""Edge of the cells of the floor lattice in metres."""

PERSON = 0.25
"""Radius of a walking person in metres."""

_WIDE = 0.28

_PAD = 8
_GAP = 0.02
_HEAD = 1.9
_FLAT = 0.08
_SHALLOW = 0.15
_FRAME = 0.1
_POCKET = 0.5
_TRIES = 40

Floats = NDArray[np.float64]
Bools = NDArray[np.bool_]


@dataclass(frozen=True)
class Opening:
    """A door or window in a wall of a room.

    Attributes
    ----------
    wall
        0 to 3.
    start, end
        Metres along the wall.
    sill, top
        Heights in metres; the sill of a door is 0.
    kind
        "window" or "door".
    leaf
        A door's leaf swings into this room.
    hinge
        Of a door's leaf, as seen from inside this room: "left" or "right".
    passage
        People walk through it (false for windows and doors that stay closed).
    """

    wall: int
    start: float
    end: float
    sill: float
    top: float
    kind: str = "window"
    leaf: bool = False
    hinge: str = "left"
    passage: bool = False

    @property
    def width(self) -> float:
        """Metres along the wall."""
        return self.end - self.start

    @property
    def middle(self) -> float:
        """Metres along the wall to its middle."""
        return (self.start + self.end) / 2


@dataclass(frozen=True)
class Span:
    """A free stretch of wall.

    Attributes
    ----------
    wall
        0 to 3.
    start, length
        Metres along the wall.
    """

    wall: int
    start: float
    length: float


@dataclass(frozen=True, eq=False)
class Placed:
    """A thing that stands, hangs or lies in a room.

    Attributes
    ----------
    model
        The thing in its own frame.
    x, y, z
        Of the thing's origin in the frame of the room, metres.
    turn
        Degrees, counter-clockwise seen from above.
    wall
        The wall it stands or hangs on; None if it is free-standing.
    """

    model: Mesh
    x: float
    y: float
    z: float
    turn: float
    wall: int | None = None

    def mesh(self) -> Mesh:
        """Give the thing in the frame of the room."""
        return self.model.turned(self.turn).moved(self.x, self.y, self.z)

    def corners(self) -> Floats:
        """Give the (4, 2) corners of its footprint in the frame of the room, counter-clockwise."""
        (x0, y0), (x1, y1) = self.model.low[:2], self.model.high[:2]
        local = np.array([(x0, y0), (x1, y0), (x1, y1), (x0, y1)], dtype=np.float64)
        return local @ rotation(self.turn).T + (self.x, self.y)

    def box(self) -> Floats:
        """Give x0, y0, x1, y1, z0, z1 of the box around it in the frame of the room."""
        corners = self.corners()
        z0, z1 = float(self.model.low[2]) + self.z, float(self.model.high[2]) + self.z
        return np.array([*corners.min(axis=0), *corners.max(axis=0), z0, z1])


class Room:
    """A room of a building, into which furniture is put.

    Attributes
    ----------
    kind, name
        E.g. "bedroom" and "bedroom_1".
    width, depth, height
        Metres; x runs from 0 to width, y from 0 to depth.
    openings
        Its doors and windows.
    style
        Of the whole building.
    rng
        Where this room's randomness comes from.
    placed
        All things put into it so far.
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
        """Make an empty room; `size` is width, depth and height."""
        self.kind, self.name = kind, name
        self.width, self.depth, self.height = (float(value) for value in size)
        self.openings = tuple(openings)
        self.style, self.rng = style, rng
        self.placed: list[Placed] = []
        self.blocking: list[Placed] = []
        self._boxes: list[Floats] = []
        self._fronts: list[Floats] = []
        self._zones = [self._zone(door) for door in self.doors]
        self._solid = self._empty_floor()

    @property
    def windows(self) -> list[Opening]:
        """The windows."""
        return [opening for opening in self.openings if opening.kind == "window"]

    @property
    def doors(self) -> list[Opening]:
        """The doors."""
        return [opening for opening in self.openings if opening.kind == "door"]

    def length(self, wall: int) -> float:
        """Metres of a wall from corner to corner."""
        return self.width if wall % 2 == 0 else self.depth

    def mesh(self) -> Mesh:
        """Everything placed, in the frame of the room."""
        return join(thing.mesh() for thing in self.placed)

    def against(
        self,
        model: Mesh,
        *,
        front: float = 0.5,
        wall: int | None = None,
        at: float | None = None,
        corner: bool = False,
        z: float = 0.0,
    ) -> Placed | None:
        """Stand a thing with its back on a wall, where it blocks neither doors nor windows nor other things.

        Parameters
        ----------
        model
            The thing.
        front
            Metres before it that must be free.
        wall
            0 to 3; None tries all.
        at
            Where along the wall the middle of the thing comes; None draws a place.
        corner
            Prefer corners.
        z
            Height of the thing's origin.

        Returns
        -------
        Placed | None
            None if there is no place from which all doors can still be reached.
        """
        spots: list[tuple[float, Placed, Floats]] = []
        for number in range(4) if wall is None else (wall,):
            spots += self._stands(model, number, at, front, corner, z)
        for _, thing, ahead in sorted(spots, key=lambda spot: spot[0])[:_TRIES]:
            if self._walkable_with(thing):
                self._fronts.append(ahead)
                return self._keep(thing)
        return None

    def span(self, *, tall: bool = False, least: float = 0.0) -> Span | None:
        """Find the longest free stretch of wall, 0.65 m deep.

        Parameters
        ----------
        tall
            Without any window; else windows whose sill is 0.9 m or more above the floor do not matter.
        least
            Shortest useful length in metres.

        Returns
        -------
        Span | None
            None if no stretch is as long as `least`.
        """
        best: Span | None = None
        for wall in (int(k) for k in self.rng.permutation(4)):
            edges = np.arange(0.0, self.length(wall) + 1e-9, 0.05)
            if len(edges) < 2:
                continue
            rects = self._strip(wall, edges[:-1], edges[1:], 0.0, 0.65)
            free = self._clear(rects, 0.0, 2.0 if tall else 0.88, self._boxes + self._zones)
            for opening in self._on_wall(wall):
                if opening.kind == "door" or tall or opening.sill < 0.88:
                    margin = _FRAME if opening.kind == "door" else 0.05
                    free &= (edges[1:] <= opening.start - margin) | (edges[:-1] >= opening.end + margin)
            runs, count = ndimage.label(free)
            for run in range(1, count + 1):
                cells = np.flatnonzero(runs == run)
                start, end = float(edges[cells[0]]), float(edges[cells[-1] + 1])
                if cells[-1] == len(free) - 1:
                    end = self.length(wall)
                if best is None or end - start > best.length + 1e-9:
                    best = Span(wall, start, end - start)
        return best if best is not None and best.length >= least else None

    def middle(self, model: Mesh, *, clearance: float = 0.6, turn: float | None = None) -> Placed | None:
        """Stand a thing free, at least `clearance` metres from walls and other things, rather central.

        Parameters
        ----------
        model
            The thing; the middle of its footprint is moved onto the place.
        clearance
            Metres.
        turn
            Degrees; None draws among the four right angles.

        Returns
        -------
        Placed | None
            None if there is no place.
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
            good &= self._clear(around, _FLAT, _HEAD, self._boxes)
            distance = np.linalg.norm(centres - aim, axis=1)
            spots += [(distance[k], degrees, centres[k] - offset) for k in np.flatnonzero(good)]
        # The right angles are tried in random order where they are equally central.
        for _, degrees, origin in sorted(spots, key=lambda spot: round(float(spot[0]), 1))[:_TRIES]:
            thing = Placed(model, float(origin[0]), float(origin[1]), 0.0, degrees)
            if self._walkable_with(thing):
                return self._keep(thing)
        return None

    def hang(self, model: Mesh, *, bottom: float, above: Placed | None = None) -> Placed | None:
        """Hang a thing on a free place of a wall.

        Parameters
        ----------
        model
            The thing.
        bottom
            Height of its origin in metres; lowered a little under low ceilings, raised over a higher `above`.
        above
            Hang it over the middle of this, on the same wall.

        Returns
        -------
        Placed | None
            None if there is no place.
        """
        if above is not None:
            if above.wall is None:
                return None
            top = above.box()[5]
            if top > bottom + model.low[2]:
                bottom = top + 0.04 - float(model.low[2])
        tallest = self.height - 0.03 - float(model.high[2])
        if tallest < bottom - 0.3:
            return None
        bottom = min(bottom, tallest)
        if above is not None and above.wall is not None:
            x, y = above.corners().mean(axis=0)
            places = [(above.wall, self._along(above.wall, x, y))]
        else:
            places = [(wall, float(place)) for wall in range(4) for place in self._places(model, wall)]
        for k in self.rng.permutation(len(places)):
            wall, place = places[k]
            thing = self._hangs(model, wall, place, bottom)
            if thing is not None and self._walkable_with(thing):
                return self._keep(thing)
        return None

    def dress(self, window: Opening, model: Mesh, *, bottom: float | None = None) -> Placed | None:
        """Hang a curtain or blind over a window.

        Parameters
        ----------
        window
            One of `windows`.
        model
            The curtain, z = 0 at its bottom.
        bottom
            Height of its origin in metres; None lets it end 0.15 m above the window.

        Returns
        -------
        Placed | None
            None if it does not fit on the wall, or something tall stands there.
        """
        top = float(model.high[2])
        if bottom is None:
            bottom = window.top + 0.15 - top
        bottom = max(min(bottom, self.height - 0.01 - top), 0.01 - float(model.low[2]))
        half = float(model.size[0]) / 2
        length = self.length(window.wall)
        if 2 * half > length:
            return None
        place = min(max(window.middle, half), length - half)
        thing = self._at_wall(model, window.wall, place, bottom, 0.004)
        for door in self.doors:
            if door.wall == window.wall and door.start < place + half and place - half < door.end:
                return None
        box = thing.box()
        box[4] = max(box[4], window.sill)
        if not self._clear(box[None, :4], box[4], box[5], self._boxes)[0]:
            return None
        self.placed.append(thing)
        self._boxes.append(box)
        return thing

    def beside(self, other: Placed, model: Mesh, *, side: str = "left", gap: float = 0.05) -> Placed | None:
        """Put a thing beside another, looking the same way, their backs in line.

        Parameters
        ----------
        other
            Stands or hangs already.
        model
            The thing.
        side
            "left" or "right", as seen when facing `other`.
        gap
            Metres between the two.

        Returns
        -------
        Placed | None
            None if there is no place.
        """
        if side == "left":
            x = float(other.model.high[0]) + gap - float(model.low[0])
        else:
            x = float(other.model.low[0]) - gap - float(model.high[0])
        y = float(other.model.low[1]) - float(model.low[1])
        return self._try(self._in_frame(other, model, x, y, 0.0, 0.0, other.wall))

    def facing(self, other: Placed, model: Mesh, *, distance: float) -> Placed | None:
        """Put a thing in front of another, looking back at it.

        Parameters
        ----------
        other
            Stands already.
        model
            The thing.
        distance
            Metres between their fronts. From 1 m on, a thing that would come near the wall or beyond it is
            put against the wall.

        Returns
        -------
        Placed | None
            None if there is no place.
        """
        x = float(other.model.low[0] + other.model.high[0] + model.low[0] + model.high[0]) / 2
        y = float(other.model.high[1]) + distance + float(model.high[1])
        thing = self._in_frame(other, model, x, y, -other.z, 180.0, None)
        quarter = thing.turn / 90
        if distance >= 1.0 and abs(quarter - round(quarter)) < 1e-6:
            wall = round(quarter) % 4
            back = self._back(thing, wall)
            if back < 0.6:
                box = thing.box()
                place = self._along(wall, (box[0] + box[2]) / 2, (box[1] + box[3]) / 2)
                thing = self._at_wall(model, wall, place, 0.0, _GAP)
        return self._try(thing)

    def on(self, other: Placed, model: Mesh, x: float, y: float, z: float, turn: float = 0.0) -> Placed:
        """Put a thing somewhere in the frame of another, whatever else is there.

        Parameters
        ----------
        other
            Stands already.
        model
            The thing.
        x, y, z
            Of its origin in the frame of `other`, metres.
        turn
            Degrees relative to `other`.

        Returns
        -------
        Placed
            The thing.
        """
        thing = self._in_frame(other, model, x, y, z, turn, other.wall)
        if thing.wall is not None and (turn % 360 != 0 or self._back(thing, thing.wall) > 0.15):
            thing = replace(thing, wall=None)
        return self._keep(thing, blocks=self._blocks(thing) and self._walkable_with(thing))

    def floor(self, model: Mesh, *, under: Placed | None = None) -> Placed | None:
        """Lay a flat thing on the floor.

        Parameters
        ----------
        model
            Rug or mat.
        under
            Lay it with its middle under that of this thing; else where much floor is free.

        Returns
        -------
        Placed | None
            None if the room is too small for it.
        """
        if under is not None:
            turns = [under.turn, under.turn + 90.0]
            aim = under.corners().mean(axis=0)
        else:
            alike = (self.width >= self.depth) == (model.size[0] >= model.size[1])
            turns = [0.0, 90.0] if alike else [90.0, 0.0]
            inside = ndimage.distance_transform_edt(~self._solid)[_PAD:-_PAD, _PAD:-_PAD]
            best = np.argwhere(inside >= inside.max() - 4)
            aim = (best[self.rng.integers(len(best))] + 0.5) * CELL
        room = np.array([self.width, self.depth])
        for turn in turns:
            size, offset = self._extent(model, turn)
            if np.any(size > room - 0.1):
                continue
            centre = np.clip(aim, size / 2 + 0.05, room - size / 2 - 0.05)
            x, y = centre - offset
            lifted = 0.001 * (1 + sum(thing.z < 0.02 and thing.box()[5] < _FLAT for thing in self.placed))
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
        """Fix a thing to the ceiling.

        Parameters
        ----------
        model
            Its z = 0 is the ceiling.
        above
            Over the middle of this thing.
        x, y
            Else here; None is the middle of the room.

        Returns
        -------
        Placed
            The thing.
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

    def walkable(self) -> bool:
        """Tell whether all doors are connected by free floor."""
        return self._reached(self._solid)[0]

    def _keep(self, thing: Placed, blocks: bool | None = None) -> Placed:
        self.placed.append(thing)
        self._boxes.append(self._bulk(thing))
        if self._blocks(thing) if blocks is None else blocks:
            self.blocking.append(thing)
            self._solid |= self._drawn(thing)
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
            ends = self._ends(thing, thing.wall)
            if self._covers_opening(thing.wall, ends, box[4], box[5], 0.0):
                return None
        return self._keep(thing) if self._walkable_with(thing) else None

    @staticmethod
    def _extent(model: Mesh, turn: float) -> tuple[Floats, Floats]:
        """Size of the turned footprint, and where its middle is from the model's origin."""
        corners = Placed(model, 0.0, 0.0, 0.0, turn).corners()
        low, high = corners.min(axis=0), corners.max(axis=0)
        return high - low, (low + high) / 2

    def _in_frame(
        self, other: Placed, model: Mesh, x: float, y: float, z: float, turn: float, wall: int | None
    ) -> Placed:
        dx, dy = rotation(other.turn) @ (x, y)
        origin = (other.x + float(dx), other.y + float(dy), other.z + z)
        return Placed(model, *origin, (other.turn + turn) % 360, wall)

    def _places(self, model: Mesh, wall: int) -> Floats:
        """Middles along a wall at which a model of this width fits between the corners."""
        length, width = self.length(wall), float(model.size[0])
        margin = min(_GAP, (length - width) / 2)
        if margin < -0.005:
            return np.zeros(0)
        low, high = width / 2 + margin, length - width / 2 - margin
        return np.unique(np.r_[np.arange(low, high, 0.05), high]) if high > low else np.array([length / 2])

    def _stands(
        self, model: Mesh, wall: int, at: float | None, front: float, corner: bool, z: float
    ) -> list[tuple[float, Placed, Floats]]:
        """Places on a wall that are free, with what to prefer (small values) and the floor before them."""
        width, depth = float(model.size[0]), float(model.size[1])
        length = self.length(wall)
        if at is None:
            places = self._places(model, wall)
        else:
            fits = at - width / 2 > -0.03 and at + width / 2 < length + 0.03
            places = np.array([min(max(at, width / 2), length - width / 2)]) if fits else np.zeros(0)
        reach = self.length(wall + 1)
        z0, z1 = z + float(model.low[2]), z + float(model.high[2])
        if len(places) == 0 or depth + _GAP + front > reach + 0.005 or z1 > self.height:
            return []
        left, right = places - width / 2, places + width / 2
        bodies = self._strip(wall, left, right, 0.0, _GAP + depth)
        aheads = self._strip(wall, left, right, _GAP + depth, _GAP + depth + front)
        good = self._clear(bodies, z0, z1, self._boxes + self._zones)
        good &= self._clear(bodies, z0, z1, self._fronts)
        if front > 0:
            good &= self._clear(aheads, _FLAT, _HEAD, self._boxes)
        # Who names the exact place may let a tap or kettle stand before the window.
        slack = 0.05 if at is None else 0.4
        good &= ~np.array(
            [self._covers_opening(wall, ends, z0, z1 - slack, 0.02) for ends in zip(left, right, strict=True)]
        )
        near = np.minimum(left, length - right)
        if corner:
            worth = near + self.rng.uniform(0, 0.3, len(places))
        else:
            worth = self.rng.uniform(0, 1, len(places)) + ((near > 0.03) & (near < 0.3))
        spots = []
        for k in np.flatnonzero(good):
            thing = self._at_wall(model, wall, float(places[k]), z, _GAP)
            spots.append((float(worth[k]), thing, np.r_[aheads[k], 0.0, _HEAD]))
        return spots

    def _hangs(self, model: Mesh, wall: int, place: float, bottom: float) -> Placed | None:
        half = float(model.size[0]) / 2
        ends = (place - half, place + half)
        z0, z1 = bottom + float(model.low[2]), bottom + float(model.high[2])
        if ends[0] < -0.005 or ends[1] > self.length(wall) + 0.005:
            return None
        if self._covers_opening(wall, ends, z0, z1, _FRAME):
            return None
        thing = self._at_wall(model, wall, place, bottom, 0.004)
        box = self._bulk(thing)
        boxes = self._boxes + (self._zones if self._blocks(thing) else [])
        return thing if self._clear(box[None, :4], box[4], box[5], boxes)[0] else None

    def _at_wall(self, model: Mesh, wall: int, place: float, z: float, gap: float) -> Placed:
        along = place + float(model.low[0] + model.high[0]) / 2
        x, y = self.point(wall, along, gap - float(model.low[1]))
        return Placed(model, x, y, z, 90.0 * wall, wall)

    def point(self, wall: int, along: float, inwards: float) -> tuple[float, float]:
        """Give x and y of a point `along` metres from a wall's left end, `inwards` metres from the wall."""
        w, d = self.width, self.depth
        return (
            (w - along, inwards),
            (w - inwards, d - along),
            (along, d - inwards),
            (inwards, along),
        )[wall]

    def _along(self, wall: int, x: float, y: float) -> float:
        return float((self.width - x, self.depth - y, x, y)[wall])

    def _back(self, thing: Placed, wall: int) -> float:
        """Distance of a thing's back from a wall; negative beyond it."""
        box = thing.box()
        return float((box[1], self.width - box[2], self.depth - box[3], box[0])[wall])

    def _ends(self, thing: Placed, wall: int) -> tuple[float, float]:
        box = thing.box()
        a, b = self._along(wall, box[0], box[1]), self._along(wall, box[2], box[3])
        return min(a, b), max(a, b)

    def _strip(self, wall: int, start: Floats, end: Floats, near: float, far: float) -> Floats:
        """Rectangles (n, 4) before a wall."""
        w, d = self.width, self.depth
        low, high = np.full_like(start, near), np.full_like(start, far)
        columns = (
            (w - end, low, w - start, high),
            (w - high, d - end, w - low, d - start),
            (start, d - high, end, d - low),
            (low, start, high, end),
        )[wall]
        return np.stack(columns, axis=1)

    def _on_wall(self, wall: int) -> list[Opening]:
        return [opening for opening in self.openings if opening.wall == wall]

    def _covers_opening(
        self, wall: int, ends: tuple[float, float], z0: float, z1: float, margin: float
    ) -> bool:
        return any(
            opening.start - margin < ends[1]
            and ends[0] < opening.end + margin
            and opening.sill < z1
            and z0 < opening.top + margin
            for opening in self._on_wall(wall)
        )

    @staticmethod
    def _clear(rects: Floats, z0: float, z1: float, boxes: Sequence[Floats]) -> Bools:
        """Tell which of (n, 4) rectangles, from height z0 to z1, touch none of the boxes."""
        if len(boxes) == 0:
            return np.ones(len(rects), bool)
        b = np.array(boxes)
        b = b[(b[:, 4] < z1 - 0.005) & (z0 < b[:, 5] - 0.005)]
        r, slack = rects[:, None, :], 0.008
        meets = (
            (r[..., 0] < b[:, 2] - slack)
            & (b[:, 0] < r[..., 2] - slack)
            & (r[..., 1] < b[:, 3] - slack)
            & (b[:, 1] < r[..., 3] - slack)
        )
        return np.asarray(~meets.any(axis=1))

    def _bulk(self, thing: Placed) -> Floats:
        """Box of a thing; what hangs on a wall is at least 0.12 m deep, so that nothing hides it."""
        box = thing.box()
        if thing.wall is not None and thing.z > 0.3:
            near = min(max(self._back(thing, thing.wall), 0.0), 0.12)
            side = (1, 2, 3, 0)[thing.wall]
            if near < 0.05:
                box[side] = (0.0, self.width, self.depth, 0.0)[thing.wall]
                far = (3, 0, 1, 2)[thing.wall]
                inner = box[side] + (0.12 if thing.wall in (0, 3) else -0.12)
                box[far] = max(box[far], inner) if thing.wall in (0, 3) else min(box[far], inner)
        return box

    def _zone(self, door: Opening) -> Floats:
        """Floor before a door that must stay free."""
        deep = 0.1 if not door.passage else (door.width + 0.05 if door.leaf else 0.6)
        start, end = door.start - 0.05, door.end + 0.05
        if door.leaf and door.hinge == "left":
            start -= 0.2
        elif door.leaf:
            end += 0.2
        rect = self._strip(door.wall, np.array([start]), np.array([end]), 0.0, deep)[0]
        return np.r_[rect, 0.0, 2.1]

    @staticmethod
    def _blocks(thing: Placed) -> bool:
        """Tell whether a person must walk around it."""
        z0, z1 = thing.z + float(thing.model.low[2]), thing.z + float(thing.model.high[2])
        shallow = thing.wall is not None and float(thing.model.size[1]) < _SHALLOW
        return z0 < _HEAD and z1 > _FLAT and not shallow

    def _empty_floor(self) -> Bools:
        nx, ny = (round(value / CELL) for value in (self.width, self.depth))
        solid = np.ones((nx + 2 * _PAD, ny + 2 * _PAD), bool)
        solid[_PAD : _PAD + nx, _PAD : _PAD + ny] = False
        self._sills: list[tuple[int, int]] = []
        for door in self.doors:
            if not door.passage:
                continue
            ends = np.array([door.start]), np.array([door.end])
            x0, y0, x1, y1 = self._strip(door.wall, *ends, -_PAD * CELL, CELL)[0]
            i, j = self._cell(x0, y0), self._cell(x1, y1)
            solid[max(i[0], 0) : j[0], max(i[1], 0) : j[1]] = False
            if door.leaf:
                solid |= drawn(self._swing(door), (-_PAD * CELL, -_PAD * CELL), solid.shape)
            cell = self._cell(*self.point(door.wall, door.middle, -3 * CELL))
            self._sills.append((min(cell[0], solid.shape[0] - 1), min(cell[1], solid.shape[1] - 1)))
        return solid

    def _swing(self, door: Opening) -> Floats:
        """Corners of the floor where the leaf of an open door may stand, counter-clockwise."""
        inwards = 1.0 if door.hinge == "left" else -1.0
        hinge = door.start if door.hinge == "left" else door.end
        tips = [(hinge + inwards * side, door.width) for side in (0.1, -0.1)]
        foot = [(hinge + inwards * side, 0.0) for side in (0.0, 0.05)]
        points = np.array([self.point(door.wall, along, deep) for along, deep in (*tips, *foot)])
        (ax, ay), (bx, by) = points[1] - points[0], points[2] - points[1]
        return points if ax * by - ay * bx > 0 else points[::-1]

    @staticmethod
    def _cell(x: float, y: float) -> tuple[int, int]:
        return round(x / CELL + 1e-6) + _PAD, round(y / CELL + 1e-6) + _PAD

    def _drawn(self, thing: Placed) -> Bools:
        return drawn(thing.corners(), (-_PAD * CELL, -_PAD * CELL), self._solid.shape)

    def _walkable_with(self, thing: Placed) -> bool:
        if not self._blocks(thing) or not self._sills:
            return True
        before, _ = self._reached(self._solid)
        solid = self._solid | self._drawn(thing)
        after, still = self._reached(solid)
        if not after:
            return not before
        lost = room_for_person(solid, _WIDE) & ~still
        inside = np.s_[_PAD:-_PAD, _PAD:-_PAD]
        least = 0.4 + 0.08 * self.width * self.depth
        if still[inside].sum() * CELL**2 < least:
            return False
        return bool(lost.sum() * CELL**2 < _POCKET)

    def _reached(self, solid: Bools) -> tuple[bool, Bools]:
        """Tell whether all doors are connected, and what can be reached from the first."""
        labels, _ = ndimage.label(room_for_person(solid, _WIDE))
        numbers = {int(labels[cell]) for cell in self._sills}
        if not numbers:
            return True, labels > 0
        connected = len(numbers) == 1 and 0 not in numbers
        return connected, labels == labels[self._sills[0]] if connected else np.zeros(solid.shape, bool)


def room_for_person(solid: Bools, radius: float = PERSON) -> Bools:
    """Tell in which cells of a lattice of edge `CELL` the middle of a person of this radius fits."""
    return np.asarray(ndimage.distance_transform_edt(~solid) >= radius / CELL)


def drawn(corners: Floats, origin: tuple[float, float], shape: tuple[int, int]) -> Bools:
    """Draw a convex polygon, corners counter-clockwise, on a lattice of edge `CELL`.

    Parameters
    ----------
    corners
        (n, 2) metres.
    origin
        Of the lattice's first corner.
    shape
        Of the lattice.

    Returns
    -------
    NDArray[bool]
        Cells whose middles are inside.
    """
    mask = np.zeros(shape, bool)
    low = np.floor((corners.min(axis=0) - origin) / CELL).astype(int).clip(0, shape)
    high = np.ceil((corners.max(axis=0) - origin) / CELL).astype(int).clip(0, shape)
    x = origin[0] + (np.arange(low[0], high[0]) + 0.5)[:, None] * CELL
    y = origin[1] + (np.arange(low[1], high[1]) + 0.5)[None, :] * CELL
    inside = np.ones((high[0] - low[0], high[1] - low[1]), bool)
    for (ax, ay), (bx, by) in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        inside &= (bx - ax) * (y - ay) - (by - ay) * (x - ax) >= -1e-9
    mask[low[0] : high[0], low[1] : high[1]] = inside
    return mask


def rotation(degrees: float) -> Floats:
    """Give the (2, 2) matrix that turns counter-clockwise."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    if degrees % 90 == 0:
        c, s = round(c), round(s)
    return np.array([[c, -s], [s, c]], dtype=np.float64)


_SIZES = {
    "bedroom": ((2.9, 4.2), (3.4, 4.8)),
    "bathroom": ((1.8, 2.6), (2.2, 3.3)),
    "kitchen": ((2.3, 3.6), (3.0, 4.2)),
    "living_room": ((3.6, 5.2), (4.4, 6.0)),
    "dining_room": ((2.8, 3.9), (3.2, 4.5)),
    "corridor": ((1.2, 1.9), (3.5, 8.0)),
    "office": ((2.8, 4.2), (3.8, 5.5)),
    "printer_area": ((2.2, 3.6), (2.6, 4.2)),
    "closet": ((1.6, 2.2), (1.9, 2.6)),
    "lavatory": ((1.9, 3.0), (2.8, 4.2)),
    "kitchenette": ((2.2, 3.2), (2.8, 4.2)),
    "hallway": ((1.8, 2.4), (10.0, 16.0)),
}


def example(kind: str, seed: int, width: float | None = None, depth: float | None = None) -> Room:
    """Make a lone empty room with a door and one or two windows, as furnishers meet them.

    Parameters
    ----------
    kind
        Of room, e.g. "bedroom".
    seed
        Of its size, openings and style.
    width, depth
        Metres; None draws what is usual for the kind.

    Returns
    -------
    Room
        Empty.
    """
    rng = np.random.default_rng(derive("example room", kind, seed))
    short, long = (float(rng.uniform(*limits)) for limits in _SIZES.get(kind, ((3.0, 4.0), (3.5, 5.0))))
    if rng.random() < 0.5:
        short, long = long, short
    size = (
        round((short if width is None else width) / CELL) * CELL,
        round((long if depth is None else depth) / CELL) * CELL,
        float(rng.uniform(2.4, 2.8)),
    )
    walls = [int(k) for k in rng.permutation(4)]
    openings = [_door(rng, walls[0], size[walls[0] % 2])]
    if kind in ("corridor", "hallway"):
        openings.append(_door(rng, (walls[0] + 2) % 4, size[walls[0] % 2]))
        walls.remove((walls[0] + 2) % 4)
    for wall in walls[1 : 2 + int(rng.random() < 0.4)]:
        length = size[wall % 2]
        wide = float(min(rng.uniform(0.6, 0.9) if "bath" in kind else rng.uniform(0.9, 1.8), length - 0.8))
        if wide < 0.5:
            continue
        start = (length - wide) / 2 + float(rng.uniform(-1, 1)) * (length - wide - 0.6) / 4
        sill = 1.2 if kind in ("bathroom", "lavatory") else (1.05 if kind == "kitchen" else 0.85)
        openings.append(Opening(wall, start, start + wide, sill, min(2.15, size[2] - 0.2)))
    style = Style.draw(np.random.default_rng(derive("example style", kind, seed)))
    return Room(kind, f"{kind}_1", size, openings, style, rng)


def _door(rng: np.random.Generator, wall: int, length: float) -> Opening:
    side, near = bool(rng.random() < 0.5), 0.25 + float(rng.uniform(0, max(length / 2 - 0.7, 0.0)))
    start = near if side else length - near - 0.85
    hinge = "left" if start + 0.42 < length / 2 else "right"
    return Opening(wall, start, start + 0.85, 0.0, 2.05, "door", bool(rng.random() < 0.6), hinge, True)
