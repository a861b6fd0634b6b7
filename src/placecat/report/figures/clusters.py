"""Thesis 4.4.4, Figures 12 to 14: patches from the largest clusters of salient regions."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import cv2
import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from placecat import seeds, settings
from placecat.drawing.palette import place_colors, place_title
from placecat.errors import PlacecatError, SettingError
from placecat.ranges import Count, Index
from placecat.report.figures.panels import Sheet, frame_in, place_legend, share_bar
from placecat.report.run import Run, home_of
from placecat.vision.regions import radius

SHOWN = 3
PIXELS = 128
COLUMNS, PATCH, GAP, LEFT = 10, 0.62, 0.07, 0.06


@dataclass(frozen=True)
class Cluster:
    """One cluster of salient regions.

    `total` is the number of regions in all clusters, and `shares` contains the (classes,) shares of the
    places in this cluster. The other attributes have one entry per region: `labels` is the place shown in its
    frame, `distance` is its distance from the cluster's centre, and `home` and `frame` say where it comes
    from. `patches` contains the squares around the regions, (n, PIXELS, PIXELS, 3) uint8 BGR.
    """

    total: int
    shares: NDArray[np.float64]
    labels: NDArray[np.int16]
    distance: NDArray[np.float64]
    home: NDArray[np.int64]
    frame: NDArray[np.int64]
    patches: NDArray[np.uint8]

    def contrast(self) -> NDArray[np.float64]:
        """Return the (n,) standard deviations of the patches' grey levels."""
        return np.array([cv2.cvtColor(patch, cv2.COLOR_BGR2GRAY).std() for patch in self.patches])


def draw_cluster(
    run: Run, rank: int, by_contrast: bool, *, cue: str, home: Count, patches: Count, apart: Index
) -> Figure:
    """Draw patches from the cluster of a given rank, using the settings in ``figures.clusters``.

    Ranks run from 1 (the largest cluster) to `SHOWN`. With `by_contrast`, there are two random samples: one
    from the third of the patches with the highest contrast, and one from the third with the lowest.
    Otherwise, there is one random sample from all patches.
    """
    test = home_of(run, home)
    largest = _largest(run, cue, test)
    if len(largest) < rank:
        raise PlacecatError(
            f"the training regions for {test} form only {len(largest)} clusters: use another cue"
        )
    cluster = largest[rank - 1]
    rng = np.random.default_rng(seeds.derive("figures", "clusters", rank))
    mixed = rng.permutation(len(cluster.labels))
    blocks = [("nearest to the centre", np.argsort(cluster.distance, kind="stable"))]
    if by_contrast:
        rank_of = np.argsort(np.argsort(cluster.contrast(), kind="stable"))[mixed]
        third = len(mixed) / 3
        blocks += [
            ("random sample from the third with the highest contrast", mixed[rank_of >= 2 * third]),
            ("random sample from the third with the lowest contrast", mixed[rank_of < third]),
        ]
    else:
        blocks += [("random sample", mixed)]
    chosen = [(title, spread(order, cluster.home, cluster.frame, patches, apart)) for title, order in blocks]
    return _sheet(run.classes, f"Cluster {rank}, learned without {place_title(test)}", cluster, chosen)


def spread(
    order: NDArray[np.integer], home: NDArray[np.int64], frame: NDArray[np.int64], count: int, apart: int
) -> list[int]:
    """Take the first `count` regions in order, but skip any from the same moment as one already taken.

    `order` contains indices into `home` and `frame`. Two frames of a home are from the same moment if they
    are fewer than `apart` frames apart.
    """
    taken: list[int] = []
    for one in order.tolist():
        near = any(home[one] == home[other] and abs(frame[one] - frame[other]) < apart for other in taken)
        if not near:
            taken.append(one)
            if len(taken) == count:
                break
    return taken


def cut_patch(frame: NDArray[np.uint8], region: NDArray[np.float32]) -> NDArray[np.uint8]:
    """Crop the square around a salient region from a frame.

    `region` is (4,): x, y, scale and saliency. `frame` is (H, W, 3) uint8 BGR, and the square is (PIXELS,
    PIXELS, 3) uint8 BGR. If it extends beyond the frame, the frame's border pixels are repeated.
    """
    x, y, scale = (float(value) for value in region[:3])
    side = max(2, round(2 * float(radius(scale, frame.shape[1]))))
    square = cv2.getRectSubPix(frame, (side, side), (x, y))
    how = cv2.INTER_AREA if side > PIXELS else cv2.INTER_LINEAR
    return np.asarray(cv2.resize(square, (PIXELS, PIXELS), interpolation=how), np.uint8)


# Cached so that the three figures share a single pass over the videos.
@lru_cache(maxsize=1)
def _largest(run: Run, cue: str, test_home: str) -> list[Cluster]:
    chosen = settings.get(run.params, f"cues.{cue}")
    name, number = chosen["codebook"], chosen["classifier"].get("clusters")
    if name is None or number is None:
        raise SettingError(f"figures.clusters.cue {cue!r} has no codebook: use a cue on salient regions")
    train = run.training_regions(name, test_home)
    tree = run.codebook(name, test_home).trees[0]
    words, centers = tree.assign(train.x, number), tree.centers(number)
    sizes = np.bincount(words, minlength=number)
    largest = [cluster for cluster in np.argsort(-sizes, kind="stable")[:SHOWN] if sizes[cluster]]
    members = [np.flatnonzero(words == cluster) for cluster in largest]
    patches: dict[int, NDArray[np.uint8]] = {}
    for position, home in enumerate(train.homes):
        wanted = np.concatenate([some[train.home[some] == position] for some in members])
        for index, frame in run.frames(home, train.frame[wanted]):
            regions = run.regions(home, index)
            for row in wanted[train.frame[wanted] == index].tolist():
                patches[row] = cut_patch(frame, regions[train.number[row]])
    return [
        Cluster(
            total=len(words),
            shares=np.bincount(train.labels[some], minlength=len(run.classes)) / len(some),
            labels=train.labels[some],
            distance=np.linalg.norm(train.x[some] - centers[cluster], axis=1),
            home=train.home[some],
            frame=train.frame[some],
            patches=np.stack([patches[row] for row in some.tolist()]),
        )
        for cluster, some in zip(largest, members, strict=True)
    ]


def _sheet(
    classes: Sequence[str], name: str, cluster: Cluster, blocks: list[tuple[str, list[int]]]
) -> Figure:
    step, head, title = PATCH + GAP, 0.62, 0.24
    rows = [-(-len(some) // COLUMNS) for _, some in blocks]
    width = 2 * LEFT + COLUMNS * step - GAP
    sheet = Sheet(width, head + sum(title + count * step for count in rows))
    size = len(cluster.labels)
    sheet.text(LEFT, 0.15, name, ha="left", fontsize=8)
    share = f"{size} of {cluster.total} regions ({100 * size / cluster.total:.1f}%)"
    sheet.text(LEFT, 0.42, share, ha="left", fontsize=8)
    bar = sheet.panel(LEFT + 3.0, 0.05, width - 2 * LEFT - 3.0, 0.2)
    share_bar(bar, 0.0, cluster.shares, classes, height=1.0)
    bar.set_xlim(0, 1)
    bar.set_ylim(-0.5, 0.5)
    bar.set_axis_off()
    place_legend(sheet.figure, classes, ((LEFT + 3.0) / width, 1 - 0.42 / sheet.height))
    colors = list(place_colors(classes).values())
    top = head
    for number, ((kind, some), count) in enumerate(zip(blocks, rows, strict=True)):
        sheet.text(LEFT, top + title / 2, f"({chr(ord('a') + number)}) {kind}", ha="left", fontsize=8)
        for position, one in enumerate(some):
            row, column = divmod(position, COLUMNS)
            axes = sheet.panel(LEFT + column * step, top + title + row * step, PATCH, PATCH)
            axes.imshow(cv2.cvtColor(cluster.patches[one], cv2.COLOR_BGR2RGB))
            frame_in(axes, colors[cluster.labels[one]], 2.2)
        top += title + count * step
    return sheet.figure


FIGURES = {
    "figure_12": (
        "Salient regions in the largest cluster of the localized HOG descriptor, from the training frames of "
        "one fold. The colour of each patch's border shows the place in its frame. The bar shows the places "
        "of all regions in the cluster, in percent. (a) Patches nearest to the cluster's centre; (b) and (c) "
        "random samples from the thirds of the patches with the highest and the lowest contrast (standard "
        "deviation of the grey levels).",
        lambda run: draw_cluster(run, 1, True, **run.options("clusters")),
    ),
    "figure_13": (
        "Salient regions in the second-largest cluster of the localized HOG descriptor, from the training "
        "frames of one fold. The colour of each patch's border shows the place in its frame. The bar shows "
        "the places of all regions in the cluster, in percent. (a) Patches nearest to the cluster's centre; "
        "(b) a random sample.",
        lambda run: draw_cluster(run, 2, False, **run.options("clusters")),
    ),
    "figure_14": (
        "Salient regions in the third-largest cluster of the localized HOG descriptor, from the training "
        "frames of one fold. The colour of each patch's border shows the place in its frame. The bar shows "
        "the places of all regions in the cluster, in percent. (a) Patches nearest to the cluster's centre; "
        "(b) a random sample.",
        lambda run: draw_cluster(run, 3, False, **run.options("clusters")),
    ),
}
