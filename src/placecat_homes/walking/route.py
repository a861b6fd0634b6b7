"""Shortest paths that keep clear of walls and furniture."""

import heapq
import itertools
import math

import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError
from placecat_homes.walking.ground import Ground

STEP = 0.05
"""Distance in metres between the points of a path."""

_COMFORT = 0.3
_NARROW = 2.0
_ROUNDS = 80


def clearance(free: NDArray[np.bool_], most: int) -> NDArray[np.int16]:
    """Count the cells from each free cell to the nearest cell that is not free, up to `most`."""
    distance = np.zeros(free.shape, dtype=np.int16)
    left = free.copy()
    for round_ in range(most):
        distance += left
        grown = np.pad(left, 1)
        nearer = grown[1:-1, 1:-1] & grown[2:, 1:-1] & grown[:-2, 1:-1] & grown[1:-1, 2:] & grown[1:-1, :-2]
        if round_ % 2:
            nearer &= grown[2:, 2:] & grown[:-2, 2:] & grown[2:, :-2] & grown[:-2, :-2]
        left = nearer
    return distance


class Router:
    """Finds paths across the floor of a building.

    Parameters
    ----------
    ground
        The floor of the building.
    """

    def __init__(self, ground: Ground) -> None:
        self.ground = ground
        most = max(1, round(_COMFORT / ground.cell))
        near = 1.0 - clearance(ground.free, most) / most
        self._columns = ground.free.shape[1] + 2
        costs = np.where(ground.free, 1.0 + _NARROW * near**2, 0.0)
        self._costs: list[float] = np.pad(costs, 1).ravel().tolist()

    def path(self, *stations: NDArray[np.float64]) -> NDArray[np.float64]:
        """Find a path through the given (2,) points over free ground.

        Returns
        -------
        NDArray[np.float64]
            (n, 2) points of a smooth path, all free and about 5 cm apart.

        Raises
        ------
        PlacecatError
            If no path exists.
        """
        cells = [(int(i), int(j)) for i, j in self.ground.cells(np.array(stations))]
        way = [cells[0]]
        for start, goal in itertools.pairwise(cells):
            way += self._search(start, goal)[1:]
        points = self.ground.points(np.array(way))
        points[0], points[-1] = stations[0], stations[-1]
        return self._smooth(_resample(points))

    def _search(self, start: tuple[int, int], goal: tuple[int, int]) -> list[tuple[int, int]]:
        columns, costs = self._columns, self._costs
        first = (start[0] + 1) * columns + start[1] + 1
        last = (goal[0] + 1) * columns + goal[1] + 1
        straight = ((columns, 1), (-columns, 1), (1, columns), (-1, columns))
        neighbours = [(offset, 1.0, 0, 0) for offset, _ in straight]
        neighbours += [(a + b, math.sqrt(2), a, b) for a in (columns, -columns) for b in (1, -1)]
        goal_row, goal_column = goal[0] + 1, goal[1] + 1
        best, before, closed = {first: 0.0}, {first: first}, set()
        queue = [(0.0, first)]
        while queue:
            _, node = heapq.heappop(queue)
            if node == last:
                break
            if node in closed:
                continue
            closed.add(node)
            base, cost = best[node], costs[node]
            for offset, length, one, other in neighbours:
                following = node + offset
                step = costs[following]
                if not step or (one and not (costs[node + one] and costs[node + other])):
                    continue
                reached = base + length * 0.5 * (cost + step)
                if reached < best.get(following, math.inf):
                    best[following], before[following] = reached, node
                    row, column = divmod(following, columns)
                    rest = math.hypot(row - goal_row, column - goal_column)
                    heapq.heappush(queue, (reached + rest, following))
        else:
            raise PlacecatError("no free path connects two places in the building")
        nodes = [last]
        while nodes[-1] != first:
            nodes.append(before[nodes[-1]])
        return [(node // columns - 1, node % columns - 1) for node in reversed(nodes)]

    def _smooth(self, points: NDArray[np.float64]) -> NDArray[np.float64]:
        if len(points) < 4:
            return points
        for _ in range(_ROUNDS):
            moved = points[1:-1] + 0.5 * (0.5 * (points[:-2] + points[2:]) - points[1:-1])
            free = self.ground.is_free(moved)
            points[1:-1][free] = moved[free]
        smooth = _resample(points)
        return self.ground.nearest_free(smooth)


def lengths(path: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the length of an (n, 2) path up to each of its points, (n,)."""
    return np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(path, axis=0).T))])


def _resample(points: NDArray[np.float64]) -> NDArray[np.float64]:
    along = lengths(points)
    count = max(2, math.ceil(along[-1] / STEP) + 1)
    where = np.linspace(0.0, along[-1], count)
    return np.column_stack([np.interp(where, along, points[:, axis]) for axis in (0, 1)])
