"""Figures 11, 15 to 17 and 20, and reliability diagrams, on a mock run with known distributions."""

from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st
from matplotlib.figure import Figure

from placecat.errors import PlacecatError
from placecat.evaluation.accuracy import confusion_matrix
from placecat.report import figures
from placecat.report.figures import figure_11, figure_15, strips
from placecat.report.figures.figure_11 import changes, most_smoothed
from placecat.report.figures.panels import stretches
from placecat.report.run import home_of
from placecat.results.measured import Measured, Quality, Results
from placecat.results.sources import Source

CONF = Path(__file__).parents[3] / "conf/figures/figures.yaml"
CLASSES = ("bedroom", "kitchen", "sauna")
HOMES = ("flat", "house", "barn", "hut")
TESTS = ("south", "north")
FRAMES = 90
# The model removes flickers in this home, starting at this frame.
PLANTED = ("house", 30)
LENGTH = 20


def one_hot(decision):
    return 0.05 + 0.85 * np.eye(len(CLASSES))[decision]


def truth_of(home):
    truth = np.repeat([0, 1, 2], FRAMES // 3).astype(np.int16)
    if home != "hut":
        truth[:5] = -1
    return truth


class Run:
    """A stand-in for `placecat.report.run.Run`."""

    classes = CLASSES

    def __init__(self, homes=HOMES, **options):
        self.homes = homes
        self.params = {"probabilities": {"bins": 10, "smallest": 1e-15}}
        self.settings = yaml.safe_load(CONF.read_text(encoding="utf-8"))
        self.settings["figure_11"]["frames"] = LENGTH
        for figure, own in options.items():
            self.settings[figure] |= own

    def options(self, figure):
        return self.settings[figure]

    def source(self, result):
        if result == "nothing":
            raise PlacecatError("there are no distributions of 'nothing'")
        site = result.split("/")[1] if result.startswith("splits/") else ""
        return Source(Path("nowhere"), "test", TESTS if site else self.homes, site, CLASSES)

    def labels(self, home):
        assert home in self.homes or home.startswith("university/")
        return truth_of(home)

    def sequence_slices(self, home):
        self.labels(home)
        return [slice(0, 60), slice(60, FRAMES)] if home == "barn" else [slice(0, FRAMES)]

    def proba(self, result, home, seed=None):
        decision = np.maximum(truth_of(home), 0).astype(int)
        if result.startswith(("integration/", "cues/")):
            decision[70:80] = 0
            if home == PLANTED[0]:
                decision[PLANTED[1] : PLANTED[1] + LENGTH : 2] = 2
        return one_hot(decision)

    @property
    def results(self):
        names = ("integration/das_551_best", "smoothing/das_551_best")
        confusion = {
            name: np.array(
                [[confusion_matrix(truth_of(h), self.proba(name, h).argmax(1), 3) for h in self.homes]] * 2
            )
            for name in names
        }
        for one in confusion.values():
            one[1] += 1000
        measured = {
            name: Measured(self.homes, ("seed-0", "seed-1"), CLASSES, confusion[name]) for name in names
        }
        values = dict.fromkeys(("log_loss", "calibration_error", "stay_accuracy"), np.ones((2, 4)))
        values["log_loss"] = np.array([[1.0, 2.0, 2.0, 2.0], [1.2, 2.2, 2.2, 2.2]])
        quality = Quality(self.homes, ("seed-0", "seed-1"), values)
        names = self.settings["figure_reliability"]["panels"].values()
        return Results(self.homes, CLASSES, measured, {}, quality=dict.fromkeys(names, quality))


def texts(figure):
    return [text.get_text() for axes in figure.axes for text in axes.texts]


def titles(figure):
    return [axes.get_title(loc="left").strip() for axes in figure.axes if axes.get_title(loc="left")]


@pytest.mark.parametrize(
    "number", [11, 15, *(pytest.param(one, marks=pytest.mark.slow) for one in (16, 17, 20, "reliability"))]
)
def test_figures_are_reproducible(number, tmp_path):
    assert figures.caption(f"figure_{number}").endswith(".")
    first, second = tmp_path / "first.png", tmp_path / "second.png"
    for target in (first, second):
        figures.render(f"figure_{number}", Run(), target)
    assert first.read_bytes() == second.read_bytes()
    assert first.stat().st_size > 5000


@pytest.mark.parametrize("number", [11, 15, 16, 17, 20, "reliability"])
def test_no_text_is_smaller_than_seven_points(number):
    figure = figures.draw(f"figure_{number}", Run())
    written = figure.findobj(lambda artist: hasattr(artist, "get_fontsize") and artist.get_text())
    assert written and min(text.get_fontsize() for text in written) >= 7


@pytest.mark.parametrize(("homes", "expected"), [(HOMES, "barn"), (HOMES[:2], "house"), (HOMES[:1], "flat")])
def test_figures_show_home_3_or_the_last_home(homes, expected):
    run = Run(homes)
    assert home_of(run, 3) == expected
    assert figures.draw("figure_16", run).axes[4].get_xlabel() == f"frame of {expected}"
    assert figures.draw("figure_15", run).axes[0].get_ylabel() == f"true place of {expected}"


def test_probable_places_are_dark_in_a_strip():
    axes = Figure().subplots()
    proba = one_hot(np.array([0, 0, 2, 1]))
    image = strips.draw(axes, proba, np.array([0, 0, 2, -1]), CLASSES, cuts=[], span=(0.0, 1.0))
    # In the image, rows are places and columns are frames; 0 is black and 255 is white.
    drawn = image.to_rgba(image.get_array(), bytes=True)[..., 0]
    assert drawn.shape == (3, 4)
    dark = np.zeros((3, 4), bool)
    dark[[0, 0, 2, 1], [0, 1, 2, 3]] = True
    assert drawn[dark].max() < 60 and drawn[~dark].min() > 230
    left, right, bottom, top = image.get_extent()
    assert (left, right, bottom, top) == (0, 4, 2.5, -0.5)


def test_the_true_place_is_a_blue_line_with_a_separate_row_for_unlabelled_frames():
    axes = Figure().subplots()
    truth = np.array([0, 0, -1, 2, 2], np.int16)
    strips.draw(axes, one_hot(np.maximum(truth, 0)), truth, CLASSES, cuts=[3], span=(0.0, 1.0))
    rows = axes.collections[0]
    assert [line.tolist() for line in rows.get_segments()] == [
        [[0, 0], [2, 0]],
        [[2, 3], [3, 3]],
        [[3, 2], [5, 2]],
    ]
    assert np.allclose(rows.get_color()[0][:3], [0.0, 0.2, 0.8])
    assert [label.get_text() for label in axes.get_yticklabels()] == [*CLASSES, "no label"]
    assert any(line.get_xdata()[0] == 3 and line.get_linestyle() == "--" for line in axes.lines)
    assert axes.get_title(loc="right") == "accuracy 100.0%"


def test_there_is_no_row_for_unlabelled_frames_without_any():
    figure = figures.draw("figure_17", Run(figure_17={"home": 4}))
    assert [label.get_text() for label in figure.axes[0].get_yticklabels()] == list(CLASSES)


def test_the_greys_span_the_values_of_a_strip():
    rng = np.random.default_rng(0)
    near_uniform = 1 / 3 + 0.01 * rng.uniform(-1, 1, (500, 3))
    low, high = strips.greys(near_uniform)
    assert 0.32 < low < 0.325 and 0.342 < high < 0.35
    assert strips.greys(np.full((10, 3), 1 / 3)) == (0.0, 1.0)


@given(st.integers(1, 400), st.integers(1, 50))
def test_columns_average_neighbouring_frames(frames, limit):
    proba = np.random.default_rng(frames).dirichlet(np.ones(3), frames)
    averaged = strips.columns(proba, limit)
    assert averaged.shape == (min(frames, limit), 3)
    assert np.allclose(averaged.sum(axis=1), 1)
    if frames % limit == 0:
        assert np.allclose(averaged, proba.reshape(limit, -1, 3).mean(axis=1))


def test_figure_16_has_one_strip_per_cue_and_marks_cuts():
    figure = figures.draw("figure_16", Run())
    assert titles(figure) == [
        "(a) HOG on salient regions",
        "(b) SIFT on salient regions",
        "(c) Centrist on salient regions",
        "(d) Gist",
        "(e) Holistic Centrist",
    ]
    assert [text.get_text() for text in figure.legends[0].get_texts()][1:] == ["true place", "cut"]
    # Ten of the thirty frames of the sauna are confused with the bedroom.
    assert figure.axes[0].get_title(loc="right") == "accuracy 88.9%"
    with pytest.raises(PlacecatError, match="there are no distributions of 'nothing'"):
        figures.draw("figure_16", Run(figure_16={"panels": {"Nothing": "nothing"}}))


def test_figure_20_shows_all_test_sequences_side_by_side():
    figure = figures.draw("figure_20", Run())
    assert [axes.get_xlabel() for axes in figure.axes if axes.get_xlabel()] == [
        "frame of south",
        "frame of north",
    ]
    assert titles(figure) == ["(a) After the integration of HOG, Gist and Centrist", "(b) After smoothing"]
    with pytest.raises(PlacecatError, match="panels is empty"):
        figures.draw("figure_20", Run(figure_20={"panels": {}}))


def test_a_reliability_diagram_shows_its_bins_and_quality_measures():
    figure = figures.draw("figure_reliability", Run())
    above = [axes for axes in figure.axes if axes.get_title(loc="left")]
    assert [axes.get_title(loc="left").split("\n")[0] for axes in above] == [
        "(a) Gist",
        "(b) Spatial PACT",
        "(c) HOG + y-Pos",
        "(d) Integration",
        "(e) Smoothing",
    ]
    # All decisions have a probability of 0.9. In every home, 10 of 30 frames of one place are wrong; in one
    # of the four homes, so are 10 frames of another place.
    right = [(8 / 9 + 8 / 9 + 8 / 9 + 7 / 9) / 4] * 4 + [1.0]
    for axes, expected in zip(above, right, strict=True):
        np.testing.assert_allclose(axes.collections[-1].get_offsets(), [[0.9, expected]])
    below = [axes for axes in figure.axes if axes.patches]
    assert len(below) == len(above)
    for axes in below:
        heights = {round(bar.get_x() + bar.get_width() / 2, 3): bar.get_height() for bar in axes.patches}
        assert heights[0.85] == pytest.approx(100.0) and sum(heights.values()) == pytest.approx(100.0)
    assert above[0].get_title(loc="left") == "(a) Gist\nlog loss 1.85, error 1.0%"


def test_reliability_diagrams_need_results_and_labels():
    with pytest.raises(PlacecatError, match="panels is empty"):
        figures.draw("figure_reliability", Run(figure_reliability={"panels": {}}))
    with pytest.raises(PlacecatError, match="there are no distributions of 'nothing'"):
        figures.draw("figure_reliability", Run(figure_reliability={"panels": {"Nothing": "nothing"}}))
    run = Run()
    run.labels = lambda home: np.full(FRAMES, -1)
    with pytest.raises(PlacecatError, match="none of the frames on which cues/gist/5-5-1 was tested"):
        figures.draw("figure_reliability", run)


def test_figure_15_shows_percentages_and_counts():
    figure = figures.draw("figure_15", Run())
    before, after = figure.axes
    assert before.get_title(loc="left") == "(a) After integration, accuracy 88.9%"
    assert after.get_title(loc="left") == "(b) After smoothing, accuracy 100.0%"
    written = [text.get_text() for text in before.texts]
    assert written[-6:] == ["33.3", "10", "0.0", "0", "66.7", "20"]


def test_a_place_without_frames_has_a_row_of_dashes():
    axes = Figure().subplots()
    figure_15.matrix(axes, np.array([[3, 1, 0], [0, 0, 0], [0, 2, 2]]), CLASSES)
    assert [text.get_text() for text in axes.texts if text.get_position()[1] == 1] == ["–"] * 3


def test_figure_11_finds_the_window_with_the_most_removed_changes():
    run = Run()
    own = run.options("figure_11")
    home, window = figure_11.choose(run, own["classifier"], own["hmm"], home=None, start=None, frames=LENGTH)
    assert home == PLANTED[0]
    assert abs(window.start - PLANTED[1]) <= 1 and window.stop - window.start == LENGTH
    figure = figures.draw("figure_11", run)
    assert titles(figure) == [
        "(a) Integration",
        "(b) Hidden Markov model",
        "(c) Hidden Markov model with delay",
    ]
    assert figure.axes[-1].get_xlabel() == "frame of house"
    assert "kitchen" in texts(figure)


def test_the_window_of_figure_11_can_be_set():
    figure = figures.draw("figure_11", Run(figure_11={"home": 1, "start": 62}))
    assert figure.axes[-1].get_xlabel() == "frame of flat"
    assert figure.axes[-1].get_xlim() == (62, 82)
    with pytest.raises(PlacecatError, match="start must be 0 to 88"):
        figures.draw("figure_11", Run(figure_11={"home": 1, "start": 89}))


def test_changes_count_only_between_labelled_frames_of_one_sequence():
    truth = np.array([0, 0, -1, 0, 0, 0, 0, 0])
    jumping, calm = one_hot(np.array([0, 1, 0, 1, 0, 1, 1, 1])), one_hot(np.zeros(8, int))
    assert changes(jumping, truth).tolist() == [1, 0, 0, 1, 1, 0, 0]
    assert most_smoothed(jumping, calm, truth, [slice(0, 8)], frames=3) == (2, slice(3, 6))
    assert most_smoothed(jumping, calm, truth, [slice(0, 4), slice(4, 8)], frames=3) == (1, slice(0, 3))
    assert most_smoothed(jumping, calm, truth, [slice(0, 8)], frames=100) == (3, slice(0, 8))


@given(st.lists(st.integers(-1, 3), max_size=30))
def test_stretches_cover_all_frames_in_order_and_are_maximal(places):
    parts = stretches(np.array(places, int))
    assert [i for part in parts for i in range(part.start, part.stop)] == list(range(len(places)))
    assert all(len(set(places[part])) == 1 for part in parts)
    assert all(places[a.start] != places[b.start] for a, b in pairwise(parts))
