"""Thesis 3.1.1.1, Figures 4 and 5: the colour and orientation channels, around their conspicuity maps."""

from collections.abc import Sequence

from matplotlib.figure import Figure

from placecat.report.figures.panels import Sheet, show_map, weight_text
from placecat.report.run import Run
from placecat.vision.orientation import ANGLES

WIDTH, GAP, ARROW, HEAD = 1.55, 0.14, 0.95, 0.2


def draw_channel(run: Run, channel: str, symbol: str, subchannels: Sequence[str]) -> Figure:
    """Draw the feature maps of one channel's four sub-channels, added across scales, and their weighted sum.

    `subchannels` names them in order; `symbol` names the conspicuity map, e.g. "C".
    """
    home, index = run.example
    fused = run.saliency(home, index).channels[channel]
    stack, weights = fused.subchannels, fused.subchannel_weights
    height = WIDTH * stack.shape[1] / stack.shape[2]
    step = height + HEAD + GAP
    left, right = 0.06, 0.06 + 2 * (WIDTH + ARROW)
    middle = left + WIDTH + ARROW
    sheet = Sheet(right + WIDTH + 0.06, 2 * step - GAP + 0.06)
    centre = step + HEAD / 2 - GAP / 2
    for number, name in enumerate(subchannels):
        row, side = divmod(number, 2)
        x = left if side == 0 else right
        top = row * step + HEAD
        show_map(sheet.panel(x, top, WIDTH, height), stack[number])
        sheet.text(x + WIDTH / 2, top - 0.09, f"{symbol}′ {name}")
        start = x + WIDTH + 0.05 if side == 0 else x - 0.05
        end = middle - 0.05 if side == 0 else middle + WIDTH + 0.05
        toward = -1 if row == 0 else 1
        sheet.arrow(
            (start, top + height / 2),
            (end, centre + toward * height / 4),
            weight_text(float(weights[number])),
        )
    show_map(sheet.panel(middle, centre - height / 2, WIDTH, height), fused.conspicuity)
    sheet.text(middle + WIDTH / 2, centre - height / 2 - 0.09, f"conspicuity map {symbol}")
    return sheet.figure


FIGURES = {
    "figure_04": (
        "The colour channel on the example frame: the feature maps C' of red, green, blue and yellow, added "
        "across scales and neighbourhoods, and the conspicuity map C, which adds these with the weights 1/√m."
        " Dark is strong; the strongest half percent of every map is black.",
        lambda run: draw_channel(run, "color", "C", ("red", "green", "blue", "yellow")),
    ),
    "figure_05": (
        "The orientation channel on the example frame: the feature maps O' at 0°, 45°, 90° and 135° (the "
        "direction of the Gabor filter's wave: 0° responds to vertical edges), added across scales, "
        "and the conspicuity map O, which adds these with the weights 1/√m. Dark is strong; the strongest "
        "half percent of every map is black.",
        lambda run: draw_channel(run, "orientation", "O", [f"{angle:.0f}°" for angle in ANGLES]),
    ),
}
