"""Thesis 3.1.1, Figures 2 to 7: how salient regions are found in the example frame."""

from collections.abc import Sequence

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from placecat.drawing import palette
from placecat.ranges import Count
from placecat.report.figures.panels import Sheet, draw_regions, show_frame, show_map, weight_text
from placecat.report.run import Run
from placecat.vision.orientation import ANGLES
from placecat.vision.regions import radius

SUBCHANNELS = ("bright spots", "dark spots")
NAMES = {
    "intensity": "I intensity",
    "color": "C colour",
    "orientation": "O orientation",
    "residual": "R residual",
}


def draw_example(run: Run) -> Figure:
    """Draw the frame whose saliency map the other figures derive step by step."""
    home, index = run.example
    place = run.labels(home)[index]
    named = palette.place_title(run.classes[place]) if place >= 0 else "no label"
    figure = Figure(figsize=(4.5, 2.75))
    axes = figure.subplots()
    show_frame(axes, run.frame(home, index))
    axes.set_xlabel(f"{palette.place_title(home)}, frame {index + 1}: {named}")
    return figure


def draw_intensity(run: Run) -> Figure:
    """Draw the intensity channel: the feature maps at every scale, their sums, and the conspicuity map."""
    # Inches.
    small_width, large_width, gap, margin, above, arrow = 0.87, 1.24, 0.06, 0.42, 0.34, 0.62
    home, index = run.example
    maps, fused = run.maps(home, index), run.saliency(home, index).channels["intensity"]
    radii = list(run.params["attention"]["radii"])
    aspect = maps.height / maps.width
    small, large = small_width * aspect, large_width * aspect
    block = len(radii) * (small + gap)
    sums = margin + len(maps.scales) * (small_width + gap) - gap + arrow / 2
    last = sums + large_width + arrow
    height = above + len(SUBCHANNELS) * block + gap + 0.06
    sheet = Sheet(last + large_width + 0.06, height)
    middle = above + (len(SUBCHANNELS) * block + gap) / 2
    for number, name in enumerate(SUBCHANNELS):
        top = above + number * (block + gap)
        for r, size in enumerate(radii):
            for column, scale in enumerate(maps.scales):
                left = margin + column * (small_width + gap)
                panel = sheet.panel(left, top + r * (small + gap), small_width, small)
                show_map(panel, maps.intensity_contrast[scale][r, number])
            side = 2 * size + 1
            sheet.text(margin - 0.1, top + r * (small + gap) + small / 2, f"{side} × {side}", rotation=90)
        centre = top + (block - gap) / 2
        sheet.text(0.12, centre, name, rotation=90, fontsize=8)
        show_map(sheet.panel(sums, centre - large / 2, large_width, large), fused.subchannels[number])
        sheet.text(sums + large_width / 2, centre - large / 2 - 0.09, f"I′ {name}")
        sheet.arrow((sums - arrow / 2 + 0.06, centre), (sums - 0.05, centre))
        weight = float(fused.subchannel_weights[number])
        sheet.arrow((sums + large_width + 0.05, centre), (last - 0.05, middle), weight_text(weight))
    for column, scale in enumerate(maps.scales):
        rows, columns = maps.grey[scale].shape
        x = margin + column * (small_width + gap) + small_width / 2
        sheet.text(x, above - 0.17, f"scale {scale}\n{columns} × {rows}", linespacing=1.1)
    show_map(sheet.panel(last, middle - large / 2, large_width, large), fused.conspicuity)
    sheet.text(last + large_width / 2, middle - large / 2 - 0.09, "conspicuity map I")
    return sheet.figure


def draw_channel(run: Run, channel: str, symbol: str, subchannels: Sequence[str]) -> Figure:
    """Draw one channel: the feature maps of its four sub-channels, and the conspicuity map.

    The feature maps are summed across scales. The conspicuity map is their weighted sum, and `symbol` is its
    symbol, e.g. "C". `subchannels` lists the names of the sub-channels in order.
    """
    # Inches.
    width, gap, arrow, head = 1.55, 0.14, 0.95, 0.2
    home, index = run.example
    fused = run.saliency(home, index).channels[channel]
    stack, weights = fused.subchannels, fused.subchannel_weights
    height = width * stack.shape[1] / stack.shape[2]
    step = height + head + gap
    left, right = 0.06, 0.06 + 2 * (width + arrow)
    middle = left + width + arrow
    sheet = Sheet(right + width + 0.06, 2 * step - gap + 0.06)
    centre = step + head / 2 - gap / 2
    for number, name in enumerate(subchannels):
        row, side = divmod(number, 2)
        x = left if side == 0 else right
        top = row * step + head
        show_map(sheet.panel(x, top, width, height), stack[number])
        sheet.text(x + width / 2, top - 0.09, f"{symbol}′ {name}")
        start = x + width + 0.05 if side == 0 else x - 0.05
        end = middle - 0.05 if side == 0 else middle + width + 0.05
        toward = -1 if row == 0 else 1
        target = (end, centre + toward * height / 4)
        sheet.arrow((start, top + height / 2), target, weight_text(float(weights[number])))
    show_map(sheet.panel(middle, centre - height / 2, width, height), fused.conspicuity)
    sheet.text(middle + width / 2, centre - height / 2 - 0.09, f"conspicuity map {symbol}")
    return sheet.figure


def draw_saliency(run: Run) -> Figure:
    """Draw the conspicuity maps and the saliency map, which is their weighted sum."""
    # Inches.
    small_width, large_width, gap, head, foot, arrow = 1.55, 2.7, 0.16, 0.2, 0.17, 0.62
    home, index = run.example
    fused = run.saliency(home, index)
    aspect = fused.saliency.shape[0] / fused.saliency.shape[1]
    count = len(fused.channels)
    row = count * small_width + (count - 1) * gap
    total = row + 0.12
    small, large = small_width * aspect, large_width * aspect
    bottom = head + small + foot + arrow + head
    sheet = Sheet(total, bottom + large + foot)
    for number, (name, channel) in enumerate(fused.channels.items()):
        left = 0.06 + number * (small_width + gap)
        show_map(sheet.panel(left, head, small_width, small), channel.conspicuity)
        sheet.text(left + small_width / 2, head - 0.09, NAMES[name])
        sheet.text(left + small_width / 2, head + small + 0.09, f"0 to {channel.conspicuity.max():.2f}")
        target = total / 2 + (number - (count - 1) / 2) * large_width / (count + 1)
        start = (left + small_width / 2, head + small + foot + 0.02)
        sheet.arrow(start, (target, bottom - head - 0.02), weight_text(channel.weight))
    show_map(sheet.panel((total - large_width) / 2, bottom, large_width, large), fused.saliency)
    sheet.text(total / 2, bottom - 0.09, "S saliency map")
    sheet.text(total / 2, bottom + large + 0.09, f"0 to {fused.saliency.max():.2f}")
    return sheet.figure


def draw_salient_regions(run: Run, *, regions: Count) -> Figure:
    """Draw the salient points in the saliency map and the regions around them in the frame."""
    # Inches.
    width, gap, foot = 3.5, 0.1, 0.3
    home, index = run.example
    frame, fused = run.frame(home, index), run.saliency(home, index)
    found = run.regions(home, index)[:regions]
    rows, columns = frame.shape[:2]
    height = width * rows / columns
    sheet = Sheet(2 * width + gap + 0.12, height + 0.06 + foot)
    left, right = sheet.panel(0.06, 0.06, width, height), sheet.panel(0.06 + width + gap, 0.06, width, height)
    scales = run.params["attention"]["scales"]
    colors = dict(zip(scales, palette.steps(len(scales)), strict=True))
    of_regions = [colors[int(scale)] for scale in found[:, 2]]
    show_map(left, fused.saliency, frame_size=(columns, rows))
    left.scatter(
        found[:, 0], found[:, 1], s=14, c=of_regions, marker="o", edgecolors="white", linewidths=0.7, zorder=3
    )
    show_frame(right, frame)
    draw_regions(right, found, columns, of_regions)
    for axes in (left, right):
        axes.set_xlim(-0.5, columns - 0.5)
        axes.set_ylim(rows - 0.5, -0.5)
    counts = np.bincount(found[:, 2].astype(int), minlength=max(scales) + 1)
    handles = [
        Line2D([], [], color=colors[scale], marker="o", markersize=5, linestyle="none") for scale in scales
    ]
    labels = [
        f"scale {scale}, radius {float(radius(scale, columns)):.0f} px: {counts[scale]}" for scale in scales
    ]
    sheet.figure.legend(handles, labels, loc="lower center", ncols=len(scales), borderaxespad=0.2)
    return sheet.figure


FIGURES = {
    "figure_02": (
        "The example frame; Figures 3 to 7 show how its saliency is computed.",
        draw_example,
    ),
    "figure_03": (
        "The intensity channel of the example frame: the feature maps I'' of bright and dark spots at every "
        "scale, for both sizes of neighbourhood; their sums I' across scales and neighbourhoods; and the "
        "conspicuity map I, which is the sum of these weighted by 1/√m. Darker means stronger; the strongest "
        "half percent of each map is black.",
        draw_intensity,
    ),
    "figure_04": (
        "The colour channel of the example frame: the feature maps C' of red, green, blue and yellow, summed "
        "across scales and neighbourhoods, and the conspicuity map C, which is the sum of these weighted by "
        "1/√m. Darker means stronger; the strongest half percent of each map is black.",
        lambda run: draw_channel(run, "color", "C", ("red", "green", "blue", "yellow")),
    ),
    "figure_05": (
        "The orientation channel of the example frame: the feature maps O' at 0°, 45°, 90° and 135° (the "
        "direction of the Gabor filter's wave: 0° responds to vertical edges), summed across scales, "
        "and the conspicuity map O, which is the sum of these weighted by 1/√m. Darker means stronger; the "
        "strongest half percent of each map is black.",
        lambda run: draw_channel(run, "orientation", "O", [f"{angle:.0f}°" for angle in ANGLES]),
    ),
    "figure_06": (
        "The saliency map S of the example frame is the sum of the conspicuity maps of intensity, colour, "
        "orientation and spectral residual, weighted by 1/√m, where m is the number of a map's local maxima "
        "above their median. Each map's range of values is shown below it. Darker means stronger; the "
        "strongest half percent of each map is black.",
        draw_saliency,
    ),
    "figure_07": (
        "The saliency map of the example frame with the salient points (left), and the regions around them "
        "(right): circles of radius width/128 · 2^s pixels, where s is the scale of the strongest response.",
        draw_salient_regions,
    ),
}
