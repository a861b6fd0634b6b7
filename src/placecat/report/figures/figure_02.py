"""Thesis 3.1.1, Figure 2: the example frame of Figures 3 to 7."""

from matplotlib.figure import Figure

from placecat.drawing.palette import place_title
from placecat.report.figures.panels import show_frame
from placecat.report.run import Run

TITLE = "The example frame on which Figures 3 to 7 show how saliency is computed."


def draw(run: Run) -> Figure:
    """Draw the figure."""
    home, index = run.example
    place = run.labels(home)[index]
    named = place_title(run.classes[place]) if place >= 0 else "no label"
    figure = Figure(figsize=(4.5, 2.75))
    axes = figure.subplots()
    show_frame(axes, run.frame(home, index))
    axes.set_xlabel(f"{place_title(home)}, frame {index + 1}: {named}")
    return figure


FIGURES = {"figure_02": (TITLE, draw)}
