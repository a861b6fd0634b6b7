"""Thesis 3.1.1.1, Figure 3: the intensity channel."""

from matplotlib.figure import Figure

from placecat.report.figures.panels import Sheet, show_map, weight_text
from placecat.report.run import Run

TITLE = (
    "The intensity channel on the example frame: the feature maps I'' of bright and of dark spots at "
    "every scale, for both neighbourhoods of the centre; their sums I' across scales and neighbourhoods; "
    "and the conspicuity map I, which adds these with the weights 1/√m. Dark is strong; the strongest "
    "half percent of every map is black."
)
SUBCHANNELS = ("bright spots", "dark spots")
SMALL, LARGE, GAP, LEFT, TOP, ARROW = 0.87, 1.24, 0.06, 0.42, 0.34, 0.62


def draw(run: Run) -> Figure:
    """Draw the figure."""
    home, index = run.example
    maps, fused = run.maps(home, index), run.saliency(home, index).channels["intensity"]
    radii = list(run.params["attention"]["radii"])
    aspect = maps.height / maps.width
    small, large = SMALL * aspect, LARGE * aspect
    block = len(radii) * (small + GAP)
    sums = LEFT + len(maps.scales) * (SMALL + GAP) - GAP + ARROW / 2
    last = sums + LARGE + ARROW
    height = TOP + len(SUBCHANNELS) * block + GAP + 0.06
    sheet = Sheet(last + LARGE + 0.06, height)
    middle = TOP + (len(SUBCHANNELS) * block + GAP) / 2
    for number, name in enumerate(SUBCHANNELS):
        top = TOP + number * (block + GAP)
        for r, size in enumerate(radii):
            for column, scale in enumerate(maps.scales):
                left = LEFT + column * (SMALL + GAP)
                show_map(
                    sheet.panel(left, top + r * (small + GAP), SMALL, small),
                    maps.intensity_contrast[scale][r, number],
                )
            side = 2 * size + 1
            sheet.text(LEFT - 0.1, top + r * (small + GAP) + small / 2, f"{side} × {side}", rotation=90)
        centre = top + (block - GAP) / 2
        sheet.text(0.12, centre, name, rotation=90, fontsize=8)
        show_map(sheet.panel(sums, centre - large / 2, LARGE, large), fused.subchannels[number])
        sheet.text(sums + LARGE / 2, centre - large / 2 - 0.09, f"I′ {name}")
        sheet.arrow((sums - ARROW / 2 + 0.06, centre), (sums - 0.05, centre))
        weight = float(fused.subchannel_weights[number])
        sheet.arrow((sums + LARGE + 0.05, centre), (last - 0.05, middle), weight_text(weight))
    for column, scale in enumerate(maps.scales):
        rows, columns = maps.grey[scale].shape
        sheet.text(
            LEFT + column * (SMALL + GAP) + SMALL / 2,
            TOP - 0.17,
            f"scale {scale}\n{columns} × {rows}",
            linespacing=1.1,
        )
    show_map(sheet.panel(last, middle - large / 2, LARGE, large), fused.conspicuity)
    sheet.text(last + LARGE / 2, middle - large / 2 - 0.09, "conspicuity map I")
    return sheet.figure


FIGURES = {"figure_03": (TITLE, draw)}
