"""Thesis 3.3.1.1, Figure 9: the modified nearest-neighbour classifier."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Circle, Wedge
from numpy.typing import NDArray
from threadpoolctl import threadpool_limits

from placecat import seeds
from placecat.drawing.palette import INK, place_colors, place_title
from placecat.errors import PlacecatError, SettingError
from placecat.learning.knn import ModifiedKNN
from placecat.learning.nearest import nearest_centers
from placecat.ranges import Count, Index
from placecat.report.figures.panels import Sheet, draw_regions, place_legend, share_rows, show_frame
from placecat.report.run import Run, home_of
from placecat.vision.regions import radius

TITLE = (
    "The modified nearest-neighbour classifier with K = 1. The dots are the descriptors of training regions, "
    "projected onto the first two principal components and coloured by cluster. Each pie shows a cluster's "
    "class frequencies. Each region of a query frame (black diamond) takes the class frequencies of the "
    "cluster whose centre is nearest in the full descriptor space. The product of these frequencies is "
    "divided by the class frequencies of all training regions, as in equation (2). Bars are in percent."
)
PLANE, RIGHT, GAP, PIE, ROW = 4.1, 2.75, 0.25, 0.13, 0.27
LABEL_GAP = 0.025
# Text style of the region numbers.
NUMBER: dict[str, Any] = {
    "fontsize": 8,
    "fontweight": "bold",
    "bbox": {"facecolor": "white", "edgecolor": "none", "alpha": 0.8, "pad": 0.6},
}


@dataclass(frozen=True)
class Query:
    """A frame of the test home, and its index in the home.

    `x` contains the (n, D) descriptors of its regions, and `clusters` the (n,) nearest clusters. `proba` is
    the (classes,) distribution computed from all its regions.
    """

    index: int
    x: NDArray[np.float32]
    clusters: NDArray[np.int32]
    proba: NDArray[np.float64]


def draw(
    run: Run,
    *,
    codebook: str,
    clusters: Count,
    home: Count,
    frame: Index | None,
    regions: Count,
    points: Index,
) -> Figure:
    """Draw the figure, using the settings in ``figures.figure_09``."""
    from sklearn.decomposition import PCA

    test = home_of(run, home)
    train = run.training_regions(codebook, test)
    tree = run.codebook(codebook, test).trees[0]
    # The thesis's figure uses equation (2) as printed.
    model = ModifiedKNN(n_clusters=clusters, codebook=tree, class_weighting="once")
    model.fit(train.x, train.labels)
    # Use one thread, because the last bits of a sum depend on the number of threads.
    with threadpool_limits(limits=1, user_api="blas"):
        pca = PCA(2, svd_solver="full").fit(train.x)
    query = _query(run, model, pca, codebook, test, frame, regions)
    rng = np.random.default_rng(seeds.derive("figure_09", "points"))
    dots = train.x[np.sort(rng.permutation(len(train.x))[:points])]
    picture = run.frame(test, query.index)
    height = RIGHT * picture.shape[0] / picture.shape[1]
    span = np.ptp(pca.transform(dots), axis=0) + 1e-9
    tall = max(PLANE * span[1] / span[0], height + 0.35 + (regions + 2) * ROW)
    sheet = Sheet(PLANE + GAP + RIGHT + 0.08, tall + 0.36)
    plane = sheet.panel(0.04, 0.04, PLANE, tall)
    _draw_plane(plane, pca, dots, model, query, run.classes)
    left = 0.04 + PLANE + GAP
    view = sheet.panel(left, 0.04, RIGHT, height)
    show_frame(view, picture)
    found = run.regions(test, query.index)[:regions]
    draw_regions(view, found, picture.shape[1], ["black"] * len(found))
    middle = np.array([picture.shape[1], picture.shape[0]]) / 2
    for number, (x, y, scale, _) in enumerate(found.tolist(), 1):
        # Put each number on the side of its circle facing the centre, since the border cuts some circles off.
        inward = (middle - (x, y)) / max(float(np.hypot(*(middle - (x, y)))), 1.0)
        apart = float(radius(scale, picture.shape[1])) + LABEL_GAP * picture.shape[1]
        at = np.array((x, y)) + inward * apart
        view.text(at[0], at[1], str(number), ha="center", va="center", **NUMBER)
    view.set_xlim(-0.5, picture.shape[1] - 0.5)
    view.set_ylim(picture.shape[0] - 0.5, -0.5)
    truth = place_title(run.classes[run.labels(test)[query.index]])
    sheet.text(left + RIGHT / 2, height + 0.15, f"{place_title(test)}, frame {query.index + 1}: {truth}")
    bars = sheet.panel(left + 0.62, height + 0.35, RIGHT - 0.62, (len(found) + 2) * ROW)
    _draw_product(bars, model, query, run.classes)
    place_legend(sheet.figure, run.classes, (0.04 / sheet.width, 0.13 / sheet.height))
    return sheet.figure


def _query(
    run: Run, model: ModifiedKNN, pca: Any, codebook: str, home: str, frame: int | None, regions: int
) -> Query:
    """Return the query for `frame` or, if that is None, for a frame that illustrates the principle well.

    Such a frame must have a label and enough regions. There are four preferences, each of which outweighs all
    later ones. First, the regions fall into different clusters. Second, the decision is correct. Third, the
    frame's information measure is at least the median. Fourth, the clusters are also the nearest ones in the
    plane. Ties are broken in favour of the frame with the largest probability.
    """
    found = run.descriptors(home, codebook)
    assert found.counts is not None
    labels = run.labels(home)
    x, counts = found.x[:, :regions], np.minimum(found.counts, regions)
    proba = model.predict_proba_sets(x, counts)
    tree = model.codebook
    assert tree is not None
    nearest = tree.assign(x.reshape(-1, x.shape[2]), model.n_clusters).reshape(x.shape[:2])
    if frame is None:
        able = (labels >= 0) & (counts == regions)
        if not able.any():
            raise PlacecatError(
                f"{home} has no labelled frame with {regions} salient regions: use fewer regions"
            )
        apart = np.array([len(np.unique(row)) == regions for row in nearest])
        flat = nearest_centers(pca.transform(x.reshape(-1, x.shape[2])), pca.transform(model.centers_))
        agree = (flat[:, 0].reshape(nearest.shape) == nearest).all(axis=1)
        right = model.classes_[proba.argmax(axis=1)] == labels
        information = run.information(home)
        rich = information >= np.median(information[labels >= 0])
        wishes = 8 * apart + 4 * right + 2 * rich + 1 * agree
        score = np.where(able, proba.max(axis=1) + wishes, -1.0)
        frame = int(score.argmax())
    elif not 0 <= frame < len(x):
        raise SettingError(f"figures.figure_09.frame must be 0 to {len(x) - 1}, not {frame}")
    some = slice(0, int(counts[frame]))
    return Query(frame, x[frame, some], nearest[frame, some], proba[frame])


def _draw_plane(
    axes: Axes, pca: Any, dots: NDArray[np.float32], model: ModifiedKNN, query: Query, classes: Sequence[str]
) -> None:
    tree = model.codebook
    assert tree is not None
    colors = colormaps["tab20"](np.arange(model.n_clusters) % 20)
    at_dots, assigned = pca.transform(dots), tree.assign(dots, model.n_clusters)
    axes.scatter(at_dots[:, 0], at_dots[:, 1], s=5, c=colors[assigned], alpha=0.55, linewidths=0)
    centers = pca.transform(model.centers_)
    place = place_colors(classes)
    size = PIE / PLANE * float(np.ptp(at_dots[:, 0]))
    for number, (center, counts) in enumerate(zip(centers, model.frequencies_, strict=True)):
        start = 90.0
        for column, share in zip(model.classes_, counts / max(counts.sum(), 1), strict=True):
            color = place[classes[int(column)]]
            wedge = Wedge(center, size, start - 360 * share, start, facecolor=color, edgecolor="white")
            wedge.set(linewidth=0.4, zorder=3)
            axes.add_patch(wedge)
            start -= 360 * share
        rings = [(1.08, "white", 3.2), (1.08, colors[number], 1.8)]
        if number in query.clusters:
            rings.append((1.3, INK, 1.4))
        for wider, edge, width in rings:
            ring = Circle(center, size * wider, fill=False, edgecolor=edge, linewidth=width, zorder=3.5)
            axes.add_patch(ring)
    for number, (at, cluster) in enumerate(zip(pca.transform(query.x), query.clusters, strict=True), 1):
        axes.plot(*zip(at, centers[cluster], strict=True), color=INK, linewidth=1.1, zorder=2.5)
        axes.scatter(
            at[0], at[1], s=52, marker="D", color="black", edgecolors="white", linewidths=0.9, zorder=5
        )
        axes.annotate(str(number), at, (7, 5), textcoords="offset points", zorder=6, **NUMBER)
    axes.set_aspect("equal", adjustable="datalim")
    axes.margins(0.02)
    axes.set_axis_off()


def _draw_product(axes: Axes, model: ModifiedKNN, query: Query, classes: Sequence[str]) -> None:
    counts = model.frequencies_ + model.smoothing
    rows = {
        f"{'× ' if number > 1 else ''}region {number}": counts[cluster]
        for number, cluster in enumerate(query.clusters, 1)
    }
    rows |= {"÷ all regions": counts.sum(axis=0), "= the frame": query.proba}
    # A place without training frames keeps a share of 0.
    shares = {name: np.zeros(len(classes)) for name in rows}
    for name, values in rows.items():
        shares[name][model.classes_] = values / values.sum()
    share_rows(axes, shares, classes, height=0.72)
    axes.get_yticklabels()[-1].set_fontweight("bold")
    axes.axhline(-len(rows) + 1.5, color=INK, linewidth=0.6)


FIGURES = {"figure_09": (TITLE, draw)}
