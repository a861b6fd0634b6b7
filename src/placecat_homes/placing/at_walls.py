"""Place objects against the walls of a room."""

from collections.abc import Sequence

import numpy as np
from scipy import ndimage

from placecat_homes.mesh import Mesh
from placecat_homes.placing.occupied import FLAT, HEAD, Occupied
from placecat_homes.placing.opening import Opening, Span
from placecat_homes.placing.placed import Floats, Placed

GAP = 0.02
"""Gap in metres between a wall and an object that stands against it."""

TRIES = 40
"""Maximum number of places tried for an object."""

_FRAME = 0.1


class AtWalls(Occupied):
    """Four walls, with objects that stand against them or hang on them.

    Attributes
    ----------
    rng
        Random number generator.
    """

    def __init__(
        self, size: tuple[float, float, float], openings: Sequence[Opening], rng: np.random.Generator
    ) -> None:
        """Start without objects. `size` is width, depth and height."""
        super().__init__(size, openings)
        self.rng = rng

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
        """Place an object with its back to a wall so that it does not block any door, window or other object.

        Parameters
        ----------
        model
            The object.
        front
            Depth in metres of the floor space to keep free in front of it.
        wall
            Number of the wall, from 0 to 3; if None, all walls are tried.
        at
            Position of the object's middle along the wall; drawn at random if None.
        corner
            Whether to prefer corners.
        z
            Height of the object's origin.

        Returns
        -------
        Placed | None
            The placed object, or None if there is no place that keeps all doors reachable.
        """
        spots: list[tuple[float, Placed, Floats]] = []
        for number in range(4) if wall is None else (wall,):
            spots += self._stands(model, number, at, front, corner, z)
        for _, thing, ahead in sorted(spots, key=lambda spot: spot[0])[:TRIES]:
            if self._walkable_with(thing):
                self._fronts.append(ahead)
                return self._keep(thing)
        return None

    def span(self, *, tall: bool = False, least: float = 0.0) -> Span | None:
        """Find the longest free stretch of wall, 0.65 m deep.

        Parameters
        ----------
        tall
            Do not allow windows. Otherwise, windows whose sill is at least about 0.9 m above the floor are
            ignored.
        least
            Shortest useful length in metres.

        Returns
        -------
        Span | None
            The stretch, or None if all are shorter than `least`.
        """
        best: Span | None = None
        for wall in (int(k) for k in self.rng.permutation(4)):
            edges = np.arange(0.0, self.length(wall) + 1e-9, 0.05)
            if len(edges) < 2:
                continue
            rects = self.strip(wall, edges[:-1], edges[1:], 0.0, 0.65)
            free = self._clear(rects, 0.0, 2.0 if tall else 0.88, self._boxes + self._zones)
            for opening in self.on_wall(wall):
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

    def hang(self, model: Mesh, *, bottom: float, above: Placed | None = None) -> Placed | None:
        """Hang an object on a free stretch of wall.

        Parameters
        ----------
        model
            The object.
        bottom
            Height of the object's origin in metres. The object is hung a little lower if the ceiling is low,
            and higher if `above` reaches above this height.
        above
            Another object at the same wall, above the middle of which this one is hung.

        Returns
        -------
        Placed | None
            The placed object, or None if there is no free place.
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
            places = [(above.wall, self.along(above.wall, x, y))]
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
            The curtain, whose bottom is at z = 0.
        bottom
            Height of its origin in metres. If None, the curtain's top is 0.15 m above the window's top.

        Returns
        -------
        Placed | None
            The placed curtain, or None if it does not fit on the wall or a door or tall object is in the way.
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
        thing = self.at_wall(model, window.wall, place, bottom, 0.004)
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

    def _places(self, model: Mesh, wall: int) -> Floats:
        """Return positions along a wall for the middle of a model, so that it fits between the corners."""
        length, width = self.length(wall), float(model.size[0])
        margin = min(GAP, (length - width) / 2)
        if margin < -0.005:
            return np.zeros(0)
        low, high = width / 2 + margin, length - width / 2 - margin
        return np.unique(np.r_[np.arange(low, high, 0.05), high]) if high > low else np.array([length / 2])

    def _stands(
        self, model: Mesh, wall: int, at: float | None, front: float, corner: bool, z: float
    ) -> list[tuple[float, Placed, Floats]]:
        """Return free spots along a wall, with a rating (lower is better) and the floor in front of each."""
        width, depth = float(model.size[0]), float(model.size[1])
        length = self.length(wall)
        if at is None:
            places = self._places(model, wall)
        else:
            fits = at - width / 2 > -0.03 and at + width / 2 < length + 0.03
            places = np.array([min(max(at, width / 2), length - width / 2)]) if fits else np.zeros(0)
        reach = self.length(wall + 1)
        z0, z1 = z + float(model.low[2]), z + float(model.high[2])
        if len(places) == 0 or depth + GAP + front > reach + 0.005 or z1 > self.height:
            return []
        left, right = places - width / 2, places + width / 2
        bodies = self.strip(wall, left, right, 0.0, GAP + depth)
        aheads = self.strip(wall, left, right, GAP + depth, GAP + depth + front)
        good = self._clear(bodies, z0, z1, self._boxes + self._zones)
        good &= self._clear(bodies, z0, z1, self._fronts)
        if front > 0:
            good &= self._clear(aheads, FLAT, HEAD, self._boxes)
        # If the caller chooses the exact place, allow a tap or kettle to stand in front of a window.
        slack = 0.05 if at is None else 0.4
        good &= ~np.array(
            [self.covers_opening(wall, ends, z0, z1 - slack, 0.02) for ends in zip(left, right, strict=True)]
        )
        near = np.minimum(left, length - right)
        if corner:
            worth = near + self.rng.uniform(0, 0.3, len(places))
        else:
            worth = self.rng.uniform(0, 1, len(places)) + ((near > 0.03) & (near < 0.3))
        spots = []
        for k in np.flatnonzero(good):
            thing = self.at_wall(model, wall, float(places[k]), z, GAP)
            spots.append((float(worth[k]), thing, np.r_[aheads[k], 0.0, HEAD]))
        return spots

    def _hangs(self, model: Mesh, wall: int, place: float, bottom: float) -> Placed | None:
        half = float(model.size[0]) / 2
        ends = (place - half, place + half)
        z0, z1 = bottom + float(model.low[2]), bottom + float(model.high[2])
        if ends[0] < -0.005 or ends[1] > self.length(wall) + 0.005:
            return None
        if self.covers_opening(wall, ends, z0, z1, _FRAME):
            return None
        thing = self.at_wall(model, wall, place, bottom, 0.004)
        box = self._bulk(thing)
        boxes = self._boxes + (self._zones if self._blocks(thing) else [])
        return thing if self._clear(box[None, :4], box[4], box[5], boxes)[0] else None
