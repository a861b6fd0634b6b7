import numpy as np
import pytest
from fake_categorizer import CLASSES, FakeCategorizer
from helpers_sequences import HEIGHT, WIDTH, coded
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import to_rgb

from placecat.drawing import palette
from placecat.drawing.lettering import mask, write
from placecat.drawing.style import house_style
from placecat.predict import report, timeline
from placecat.predict.annotate import Annotator
from placecat.predict.frame import Frame, clock
from placecat.predict.prediction import Prediction


def prediction(places, *, seconds=None, numbers=None, length=None):
    proba = np.full((len(places), 3), 0.1)
    proba[np.arange(len(places)), places] = 0.8
    numbers = np.arange(1, len(places) + 1) if numbers is None else np.array(numbers)
    return Prediction(
        classes=CLASSES,
        fps=10.0,
        length=length or int(numbers[-1]),
        numbers=numbers,
        seconds=(numbers - 1) / 10.0 if seconds is None else np.array(seconds),
        names=(),
        proba=proba,
        integrated=proba[::-1],
    )


def test_timeline_strips_show_the_colours_of_the_places():
    # The second frame lasts three times as long as the first.
    figure = timeline.draw(prediction([0, 2, 1], seconds=[0.0, 1.0, 4.0]), "", np.array([-1, 2, 2]))
    label, decision, alone = (axes.images[0].get_array()[0] for axes in figure.axes[:3])
    colors = [to_rgb(color) for color in palette.place_colors(CLASSES).values()]
    white = (1.0, 1.0, 1.0)
    # The footage ends at 6 s, because the last frame lasts as long as the median, 2 s.
    moments = [int(timeline.COLUMNS * second / 6) for second in (0.5, 2.5, 5.5)]
    for strip, expected in (
        (decision, [colors[0], colors[2], colors[1]]),
        (alone, [colors[1], colors[2], colors[0]]),
        (label, [white, colors[2], colors[2]]),
    ):
        assert np.allclose(strip[moments], expected)
    FigureCanvasAgg(figure).draw()


@pytest.mark.parametrize("seconds", [[0.0], [0.0, 0.04], [0.0, 7200.0]])
def test_short_and_long_footage_is_drawn(seconds):
    figure = timeline.draw(prediction([0] * len(seconds), seconds=seconds), "")
    FigureCanvasAgg(figure).draw()
    ticks = [label.get_text() for label in figure.axes[-1].get_xticklabels()]
    assert len(set(ticks)) == len(ticks) >= 3


def test_segments_include_frames_that_were_not_categorized():
    parts = prediction([0, 0, 2, 1], numbers=[1, 6, 11, 16], length=18).segments()
    assert [(part.start, part.end, part.label) for part in parts] == [
        (1, 10, "bedroom"),
        (11, 15, "kitchen"),
        (16, 18, "living_room"),
    ]


def test_share_of_time_depends_on_frame_durations():
    facts = report.facts(prediction([0, 2, 2], seconds=[0.0, 3.0, 4.0]), None)
    # The last frame lasts as long as the median, 2 s.
    assert facts["share_of_time"] == {"bedroom": 0.5, "living_room": 0.0, "kitchen": 0.5}


def test_regions_are_drawn_as_circles():
    shown = Annotator(CLASSES, (WIDTH, HEIGHT))
    decision = FakeCategorizer().update(coded(0))
    picture = shown(Frame(1, 0.0, "", coded(0)), decision).astype(int)
    assert picture.shape == (shown.size[1], shown.size[0], 3)
    # The frame is enlarged ten times. The region at (32, 24) with scale 2 has radius 64 / 128 * 4 = 2, drawn
    # as 20.
    yellow = (np.abs(picture[:480, :640] - (120, 235, 255)).max(axis=2) < 60).nonzero()
    distance = np.hypot(yellow[1] - 325, yellow[0] - 245)
    assert (np.abs(distance[distance < 60] - 20) < 2.5).all() and (distance < 60).sum() > 60


@pytest.mark.parametrize("size", [(63, 47), (160, 120), (1921, 1081)])
def test_pictures_have_even_sides_and_fit_many_places(size):
    classes = [f"a_place_with_a_long_name_{number}" for number in range(20)]
    proba = np.full(20, 0.05)
    regions = np.zeros((0, 4), np.float32)
    decision = type("D", (), {"place": classes[3], "is_known": True, "confidence": 0.05, "proba": proba})()
    decision.integrated, decision.regions = proba, regions
    shown = Annotator(classes, size)
    picture = shown(Frame(1, 0.0, "", np.zeros((size[1], size[0], 3), np.uint8)), decision, "")
    assert picture.shape == (shown.size[1], shown.size[0], 3)
    assert shown.size[0] % 2 == shown.size[1] % 2 == 0
    # Nothing is drawn at the right edge.
    assert (picture[:, -3:] > 250).all()


def test_lettering():
    assert mask("il", 20).shape[1] < mask("WM", 20).shape[1]
    assert 0.9 < mask("WM", 20).max() <= 1.0
    picture = np.full((10, 10, 3), 255, np.uint8)
    write(picture, "much too long", (-5, -3), 20, (0, 0, 0))
    write(picture, "much too long", (8, 8), 20, (0, 0, 0), align="right")
    write(picture, "outside", (50, 50), 20, (0, 0, 0))
    assert picture.min() < 255


def test_clock():
    assert [clock(value) for value in (0, 7.9, 60, 3723)] == ["0:00", "0:07", "1:00", "1:02:03"]


def test_a_long_title_fits_into_the_figure():
    with house_style():
        figure = timeline.draw(prediction([0, 1]), "home_6: " + "HOG, SIFT, Centrist and Gist, " * 6)
        FigureCanvasAgg(figure).draw()
        words = figure._suptitle.get_window_extent()
        assert words.x1 <= figure.bbox.x1 and words.y0 > figure.axes[0].get_window_extent().y1
