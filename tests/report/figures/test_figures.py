"""All figures in general, and Figures 2 to 7, 9, 12 to 14, 18 and 19 on a small run with known content."""

import re

import matplotlib
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.patches import Circle, Rectangle

import made_run
from made_run import BLANK, CLASSES, CLUSTERS, HOMES, LABELS
from number_of_examples import examples
from placecat.config.check import check
from placecat.drawing import palette
from placecat.drawing.style import house_style
from placecat.errors import PlacecatError
from placecat.learning.knn import ModifiedKNN
from placecat.report import figures
from placecat.report.figures import clusters, filtered
from placecat.report.figures.panels import share_bar
from placecat.report.run import Run
from placecat.settings import read_yaml
from project import ROOT

MINE = ["02", "03", "04", "05", "06", "07", "09", "12", "13", "14", "18", "19"]


@pytest.fixture
def run(made):
    made["filters"]["informative"]["threshold"] = 0.05
    return Run(made)


def texts(figure):
    return [text.get_text() for text in figure.findobj(matplotlib.text.Text) if text.get_text()]


def test_figures_are_found_by_name():
    names = figures.names()
    assert {f"figure_{number}" for number in MINE} <= set(names)
    of_thesis = [name for name in names if re.fullmatch(r"figure_\d\d", name)]
    numbers = [figures.number(name) for name in of_thesis]
    assert numbers == sorted(numbers)
    # Additional figures have no number and come last.
    assert names == [*of_thesis, "figure_reliability"]
    assert figures.number("figure_reliability") is None
    with pytest.raises(PlacecatError, match="there is no figure 'figure_99'"):
        figures.draw("figure_99", None)


@pytest.mark.parametrize("name", figures.names())
def test_every_figure_has_a_caption(name):
    assert figures.caption(name).endswith(".") and len(figures.caption(name)) > 20


@pytest.mark.parametrize(
    "number", ["13", *(pytest.param(one, marks=pytest.mark.slow) for one in MINE if one != "13")]
)
def test_figures_do_not_depend_on_the_users_style(number, run, made, tmp_path):
    first, second = tmp_path / "first.png", tmp_path / "second.png"
    figures.render(f"figure_{number}", run, first)
    with matplotlib.rc_context({"font.size": 30, "axes.facecolor": "red", "savefig.dpi": 30}):
        figures.render(f"figure_{number}", Run(made), second)
        assert matplotlib.rcParams["font.size"] == 30
    assert first.read_bytes() == second.read_bytes()
    assert b"Software" not in first.read_bytes() and b"tIME" not in first.read_bytes()


@pytest.mark.parametrize("number", MINE)
def test_text_is_at_least_seven_points_and_inside_the_figure(number, run):
    with house_style():
        figure = figures.draw(f"figure_{number}", run)
        FigureCanvasAgg(figure).draw()
        width, height = figure.bbox.size
        for text in figure.findobj(matplotlib.text.Text):
            if text.get_text() and text.get_visible():
                assert text.get_fontsize() >= 7, text
                box = text.get_window_extent()
                assert box.x0 >= -1 and box.y0 >= -1 and box.x1 <= width + 1 and box.y1 <= height + 1, text


@pytest.mark.parametrize("number", ["07", "09", "18", "19"])
def test_an_unknown_setting_is_rejected_when_a_stage_starts(number):
    params = read_yaml(ROOT / "params.yaml")
    params["figures"][f"figure_{number}"]["hose"] = 3
    with pytest.raises(PlacecatError, match=rf"figures\.figure_{number}.*'hose'"):
        check(params)


def test_an_unlabelled_frame_can_be_the_example(made):
    made["figures"]["example"] = {"home": 1, "frame": 7}
    assert "flat 1, frame 8: no label" in texts(figures.draw("figure_02", Run(made)))


def test_every_intensity_map_is_shown(run):
    maps, fused = run.maps(*run.example), run.saliency(*run.example).channels["intensity"]
    shown = [axes.images[0].get_array() for axes in figures.draw("figure_03", run).axes]
    contrast = maps.intensity_contrast.values()
    expected = [plane for stack in contrast for radius in stack for plane in radius]
    expected += [*fused.subchannels, fused.conspicuity]
    assert len(shown) == len(expected) == 4 * 2 * 2 + 3
    for plane in expected:
        assert sum(np.array_equal(plane, one) for one in shown) == 1


@pytest.mark.parametrize(
    ("number", "channel", "names"),
    [
        ("04", "color", ["C′ red", "C′ green", "C′ blue", "C′ yellow"]),
        ("05", "orientation", ["O′ 0°", "O′ 45°", "O′ 90°", "O′ 135°"]),
    ],
)
def test_subchannels_are_labelled_with_names_and_weights(number, channel, names, run):
    fused = run.saliency(*run.example).channels[channel]
    figure = figures.draw(f"figure_{number}", run)
    for axes, plane in zip(figure.axes[:4], fused.subchannels, strict=True):
        np.testing.assert_array_equal(axes.images[0].get_array(), plane)
    np.testing.assert_array_equal(figure.axes[4].images[0].get_array(), fused.conspicuity)
    written = texts(figure)
    assert [text for text in written if text in names] == names
    for weight in fused.subchannel_weights:
        assert f"× 1/√{1 / weight**2:.0f}" in written


def test_the_saliency_map_is_the_sum_of_the_maps_in_figure_6(run):
    figure = figures.draw("figure_06", run)
    planes = [axes.images[0].get_array() for axes in figure.axes]
    counts = [int(match[1]) for text in texts(figure) if (match := re.fullmatch(r"× 1/√(\d+)", text))]
    total = sum(plane / np.sqrt(count) for plane, count in zip(planes[:-1], counts, strict=True))
    np.testing.assert_allclose(planes[-1], total, rtol=1e-5, atol=1e-6)


def test_circles_match_the_regions(made):
    made["figures"]["figure_07"] = {"regions": 5}
    run = Run(made)
    figure = figures.draw("figure_07", run)
    regions = run.regions(*run.example)[:5]
    circles = [patch for patch in figure.axes[1].patches if isinstance(patch, Circle)][1::2]
    drawn = [(*circle.center, circle.radius) for circle in circles]
    expected = [(x, y, made_run.WIDTH / 128 * 2**scale) for x, y, scale, _ in regions]
    np.testing.assert_allclose(drawn, expected)
    scales = {int(scale) for scale in regions[:, 2]}
    assert len({circle.get_edgecolor() for circle in circles}) == len(scales)


def test_the_product_in_figure_9_follows_from_its_shares(run):
    figure = figures.draw("figure_09", run)
    bars = figure.axes[2]
    rows = [[patch.get_width() for patch in bars.patches[i : i + 2]] for i in range(0, len(bars.patches), 2)]
    np.testing.assert_allclose(np.sum(rows, axis=1), 1)
    *regions, everything, product = np.array(rows)
    own = np.prod(regions, axis=0) / everything
    np.testing.assert_allclose(product, own / own.sum(), rtol=1e-6)
    # The estimator computes the same product for the frame that the figure shows.
    named = next(text for text in texts(figure) if text.startswith("flat 1, frame "))
    frame = int(re.search(r"frame (\d+)", named)[1]) - 1
    train = run.training_regions("hog_y", "flat_1")
    tree = run.codebook("hog_y", "flat_1").trees[0]
    # The figure shows equation (2) as printed.
    model = ModifiedKNN(n_clusters=CLUSTERS, codebook=tree, class_weighting="once")
    model.fit(train.x, train.labels)
    query = run.descriptors("flat_1", "hog_y", [frame]).x[:, :3]
    np.testing.assert_allclose(model.predict_proba_sets(query, [3])[0], product, rtol=1e-6)
    assert LABELS[frame] >= 0


def test_training_regions_record_their_origin(run):
    train = run.training_regions("hog_y", "flat_1")
    assert train.homes == ("flat_2", "flat_3")
    assert set(train.frame.tolist()) == {0, 3, 6}
    np.testing.assert_array_equal(train.labels, LABELS[train.frame])
    some = len(train.x) // 2
    home, frame, number = train.homes[train.home[some]], int(train.frame[some]), int(train.number[some])
    np.testing.assert_array_equal(train.x[some], run.descriptors(home, "hog_y", [frame]).x[0, number])


def test_patches_of_a_cluster_are_cut_from_its_regions(run):
    train = run.training_regions("hog_y", "flat_1")
    tree = run.codebook("hog_y", "flat_1").trees[0]
    sizes = np.bincount(tree.assign(train.x, CLUSTERS), minlength=CLUSTERS)
    found = clusters._largest(run, "hog_y", "flat_1")
    assert [len(one.labels) for one in found] == sorted(sizes.tolist(), reverse=True)[:3]
    for rank, one in enumerate(found, 1):
        assert one.total == len(train.x)
        np.testing.assert_allclose(one.shares, np.bincount(one.labels, minlength=2) / len(one.labels))
        figure = figures.draw(f"figure_{11 + rank}", run)
        assert f"{len(one.labels)} of {len(train.x)} regions" in " ".join(texts(figure))
        nearest = figure.axes[1].images[0].get_array()
        np.testing.assert_array_equal(nearest, one.patches[one.distance.argmin()][:, :, ::-1])
    contrast = found[0].contrast()
    shown = [axes.images[0].get_array()[:, :, ::-1] for axes in figures.draw("figure_12", run).axes[1:]]
    of_shown = [
        next(i for i, patch in enumerate(found[0].patches) if np.array_equal(patch, one)) for one in shown
    ]
    # Each of the two homes has a single moment, so each block has one patch from each home.
    assert len(of_shown) == 6
    assert contrast[of_shown[2:4]].min() > contrast[of_shown[4:6]].max()


@settings(deadline=None)
@given(
    st.lists(st.tuples(st.integers(0, 2), st.integers(0, 40)), min_size=1, max_size=30),
    st.integers(1, 8),
    st.integers(0, 12),
    st.randoms(use_true_random=False),
)
def test_each_moment_is_shown_once(places, count, apart, random):
    home, frame = np.array(places).T
    order = np.array(random.sample(range(len(places)), len(places)))
    taken = clusters.spread(order, home, frame, count, apart)

    def near(one, other):
        return home[one] == home[other] and abs(frame[one] - frame[other]) < apart

    assert taken[0] == order[0] and len(taken) <= count and len(set(taken)) == len(taken)
    assert not any(near(one, other) for i, one in enumerate(taken) for other in taken[:i])
    assert taken == [one for one in order if one in taken]
    # No region was skipped without a reason.
    if len(taken) < count:
        assert all(any(near(one, other) for other in taken) or one in taken for one in order)


def test_a_patch_is_the_square_around_its_region():
    frame = np.zeros((90, 128, 3), np.uint8)
    frame[:, 64:] = (10, 20, 30)
    # Radius 128 / 128 * 2^3 = 8 pixels.
    patch = clusters.cut_patch(frame, np.array([63.5, 40, 3, 1], np.float32))
    middle = clusters.PIXELS // 2
    assert patch.shape == (clusters.PIXELS, clusters.PIXELS, 3)
    assert (patch[:, : middle - 8] == 0).all() and (patch[:, middle + 8 :] == (10, 20, 30)).all()
    corner = clusters.cut_patch(frame, np.array([127, 0, 3, 1], np.float32))
    assert (corner == (10, 20, 30)).all()


def test_the_most_certain_mistakes_are_found(run):
    results = [f"cues/{cue}/5-5-1" for cue in made_run.CUES]
    found = filtered.failures(run, results, 0.05)
    assert [(one.home, one.frame, one.place) for one in found] == [("flat_1", 1, 0), ("flat_3", 4, 1)]
    assert found[0].certainty > found[1].certainty
    everything = filtered.failures(run, results, 0.0)
    assert (everything[0].home, everything[0].frame) == BLANK
    written = texts(figures.draw("figure_18", run))
    assert "(a) bedroom: flat 1, frame 2" in written and written.count("sauna") >= 5


def test_certainty_is_relative_to_the_same_cue():
    largest = np.array([[0.99, 0.98, 0.97, 0.5], [0.21, 0.22, 0.23, 0.9]])
    labelled = np.array([True, True, True, False])
    np.testing.assert_allclose(filtered.surety(largest, labelled), [2 / 3, 2 / 3, 2 / 3, 1 / 2])


def test_figure_18_needs_a_mistake(made):
    made["figures"]["figure_18"]["cues"] = {"Gist": "cues/gist/5-5-1"}
    made["filters"]["informative"]["threshold"] = 0.2
    with pytest.raises(PlacecatError, match="no informative frame is misclassified by all of Gist"):
        figures.draw("figure_18", Run(made))


def test_figure_19_shows_the_most_and_least_informative_rejected_frames(run, made):
    rejected = {
        (home, index): run.information(home)[index]
        for home in HOMES
        for index in range(made_run.FRAMES)
        if LABELS[index] >= 0 and run.information(home)[index] < 0.05
    }
    written = "\n".join(texts(figures.draw("figure_19", run)))
    assert f"information measure {max(rejected.values()):.5f}, threshold 0.05000" in written
    assert f"(b) bedroom: flat 3, frame {BLANK[1] + 1}\ninformation measure 0.00000" in written
    made["filters"]["informative"]["threshold"] = 0.0
    with pytest.raises(PlacecatError, match="rejects no labelled frame"):
        figures.draw("figure_19", Run(made))


@settings(deadline=None, max_examples=examples(20))
@given(st.lists(st.floats(0.01, 1), min_size=2, max_size=9))
def test_shares_fill_the_bar(amounts):
    shares = np.array(amounts) / np.sum(amounts)
    axes = Figure().subplots()
    share_bar(axes, 2.0, shares, [f"place {number}" for number in range(len(shares))])
    bars = [patch for patch in axes.patches if isinstance(patch, Rectangle)]
    np.testing.assert_allclose([bar.get_width() for bar in bars], shares)
    np.testing.assert_allclose([bar.get_x() for bar in bars], np.cumsum(shares) - shares, atol=1e-12)


def grey(color):
    return float(np.dot(matplotlib.colors.to_rgb(color), (0.299, 0.587, 0.114)))


def test_place_colours_differ_even_in_greyscale():
    thesis = ["bedroom", "bathroom", "kitchen", "living_room", "dining_room"]
    lightness = sorted(grey(color) for color in palette.place_colors(thesis).values())
    assert np.diff(lightness).min() > 0.1
    everywhere = palette.place_colors([*palette.PLACES, *CLASSES, *(f"room {n}" for n in range(6))])
    assert len(set(everywhere.values())) == len(everywhere)
    assert palette.place_colors(["kitchen"])["kitchen"] == everywhere["kitchen"]
    for count in range(1, 8):
        assert len(set(palette.steps(count))) == count
        shades = [grey(color) for color in palette.steps(count)]
        assert shades == sorted(shades, reverse=True)
