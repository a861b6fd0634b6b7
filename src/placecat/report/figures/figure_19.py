"""Thesis 4.6, Figure 19: views that the information filter rejects."""

from matplotlib.figure import Figure

from placecat.drawing.palette import place_title
from placecat.errors import PlacecatError
from placecat.report.figures.panels import Sheet, show_frame
from placecat.report.run import Run

TITLE = (
    "Uninformative views: among the labelled frames that the information filter rejects, the frame with the "
    "highest information measure, just below the threshold, and the frame with the lowest."
)
WIDTH, GAP = 3.2, 0.15


def draw(run: Run, *, filter: str) -> Figure:
    """Draw the figure; settings in ``figures.figure_19``."""
    threshold = run.threshold(filter)
    rejected = [
        (float(value), home, index)
        for home in run.homes
        for index, (value, label) in enumerate(zip(run.information(home), run.labels(home), strict=True))
        if label >= 0 and value < threshold
    ]
    if not rejected:
        raise PlacecatError(f"the filter {filter} (threshold {threshold}) rejects no labelled frame")
    chosen = list(dict.fromkeys([max(rejected), min(rejected)]))
    facts = run.home_facts(chosen[0][1])
    height = WIDTH * facts["height"] / facts["width"]
    sheet = Sheet(0.12 + len(chosen) * (WIDTH + GAP) - GAP, height + 0.48)
    for number, (value, home, index) in enumerate(chosen):
        left = 0.06 + number * (WIDTH + GAP)
        show_frame(sheet.panel(left, 0.06, WIDTH, height), run.frame(home, index))
        place = place_title(run.classes[run.labels(home)[index]])
        where = f"({chr(ord('a') + number)}) {place}: {place_title(home)}, frame {index + 1}"
        measure = f"information measure {value:.5f}, threshold {threshold:.5f}"
        sheet.text(left + WIDTH / 2, height + 0.27, f"{where}\n{measure}", linespacing=1.3)
    return sheet.figure


FIGURES = {"figure_19": (TITLE, draw)}
