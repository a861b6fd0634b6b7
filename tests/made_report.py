"""An artificial report for tests, with all published tables and similar numbers, figures and findings."""

from functools import cache
from pathlib import Path

import cv2
import numpy as np
import pandas as pd

from placecat.report.benchmarks import shown_speed
from placecat.report.page import Figure, Report, Table
from placecat.report.scale import shown_scale
from placecat.thesis.notes import Kind, Note, joined

ROOT = Path(__file__).resolve().parents[1]
CLASSES = ["bedroom", "bathroom", "kitchen", "living_room", "dining_room"]
HOMES = [f"home_{number}" for number in range(1, 7)]
DATASET = {"name": "homes", "title": "made-up homes", "thesis_data": None, "homes": HOMES, "classes": CLASSES}
THESIS_DATA = "VPC-2009 home database"
MEASURED = (Note(Kind.DATA, "measured on made-up homes"),)
ON_OTHER_DATA = (
    *MEASURED,
    Note(Kind.NOT_COMPARABLE, f"the published number is from the {THESIS_DATA} and is not comparable"),
)
QUOTE = Note(Kind.PUBLISHED, 'the thesis says "over 3% lower"')
VERDICTS = ["holds", "does not hold", "undecided"]


@cache
def published_tables():
    table = pd.read_csv(ROOT / "data/thesis/published_tables.csv", dtype={"row": str, "column": str})
    return table.fillna({"group": "", "row": "", "column": ""})


def settings(number, title="A title"):
    name = f"table_{number:02d}"
    return {"name": name, "number": number, "title": title, "thesis_data": THESIS_DATA}


def cells(number, rng=None):
    """Make a filled table. Measured numbers equal the published ones or, with `rng`, are close to them."""
    own = published_tables()
    own = own[own["table"] == number].rename(columns={"value": "published"}).reset_index(drop=True)
    noise = np.zeros(len(own)) if rng is None else rng.normal(0, 8, len(own)).clip(-20, 30)
    own["measured"] = (own["published"].fillna(30) + noise).clip(0, 100).round(2)
    own["spread"] = np.nan if rng is None else rng.uniform(0, 3, len(own)).round(2)
    own["seeds"] = 0 if rng is None else 2
    empty = (*MEASURED, Note(Kind.NOT_AVAILABLE, "the published cell is n/a"))
    own["notes"] = [empty if is_empty else ON_OTHER_DATA for is_empty in own["published"].isna()]
    return noted(
        own[["table", "group", "row", "column", "published", "measured", "spread", "seeds", "notes"]]
    )


def noted(table):
    """Add the notes of a table as text."""
    return table.assign(note=table["notes"].map(joined))


def addition():
    measured = (("RVM", "Home 1", 30.5), ("RVM", "Average", 31.25), ("SVM", "Home 1", 33.0))
    rows = [
        ("Addition", "", row, column, np.nan, value, np.nan, 0, MEASURED) for row, column, value in measured
    ]
    too_few = (Note(Kind.MEASURED, "too few frames"),)
    rows.append(("Addition", "", "SVM", "Average", np.nan, np.nan, np.nan, 0, too_few))
    columns = list(cells(5).columns.drop("note"))
    named = {"name": "rvm", "number": None, "title": "RVM beside SVM", "thesis_data": None}
    return Table(named, noted(pd.DataFrame(rows, columns=columns)), DATASET)


def captioned():
    """Make a table with random numbers that are not percentages."""
    rows = [
        ("Addition", "Cues", "Gist", column, np.nan, value, spread, 2, MEASURED)
        for column, value, spread in (("Log loss", 1.61, 0.02), ("Stay accuracy", 40.0, 3.0))
    ]
    named = {"name": "addition_quality", "number": None, "title": "How good", "thesis_data": None}
    named["caption"] = "Log loss in nats, stay accuracy in percent."
    return Table(named, noted(pd.DataFrame(rows, columns=list(cells(5).columns.drop("note")))), DATASET)


def png(width=260, height=160, seed=0):
    picture = np.random.default_rng(seed).integers(0, 255, (height // 20, width // 20, 3), np.uint8)
    picture = cv2.resize(picture, (width, height), interpolation=cv2.INTER_NEAREST)
    return cv2.imencode(".png", picture)[1].tobytes()


def findings(count=34):
    rng = np.random.default_rng(1)
    rows = []
    for number in range(1, count + 1):
        verdict = VERDICTS[number % 3]
        difference = round(float(rng.normal(1, 5)), 2)
        low, high = round(difference - 4, 2), round(difference + 3, 2)
        claim = f"Claim {number}: this beats that on every cluster number, whatever else is set."
        reason = "the interval is only partly above 0"
        if number % 4 == 0:
            reason = f"of 6 comparisons 4 hold, 2 are undecided; shown: this against that; {reason}"
        said, seen = "this 42.26, that 39.66", f"this {40 + difference:.2f}, that 40.00"
        rows.append((number, "4.10", claim, said, seen, difference, low, high, "6 homes", verdict, reason))
    missing = ("difference -3.00", "", *[np.nan] * 3, "", "undecided", "this data has no such cue")
    rows[-1] = (count, "4.4", "Nothing measured.", *missing)
    names = "number section claim published measured difference low high units verdict reason"
    return pd.DataFrame(rows, columns=names.split())


def comparisons():
    rows = [
        (1, "this", "that", 42.26, 39.66, 2.6, 41.0, 40.0, 1.0, -3.0, 4.0, "above 0", "6 homes", "undecided"),
        (34, "this", "", np.nan, np.nan, -3.0, *[np.nan] * 5, "-4.5 to -1.5", "", "undecided"),
    ]
    names = (
        "finding left right published_left published_right published_difference measured_left measured_right "
    )
    names += "measured_difference low high range units verdict"
    return pd.DataFrame(rows, columns=names.split()).assign(
        reading="", reason="a reason", left_results="a/b", right_results=""
    )


def in_text():
    color, no_home = ("gist_without_color", "4.2"), (Note(Kind.MEASURED, "no such home"),)
    rows = [
        (*color, "without colour", "Home 6", 35.41, 30.11, np.nan, 0, ON_OTHER_DATA),
        (*color, "difference", "Home 6", -3.0, -1.0, np.nan, 0, (*ON_OTHER_DATA, QUOTE)),
        ("flat_k_means", "4.10", "flat < hierarchical & more", "Home 1", 30.0, np.nan, np.nan, 0, no_home),
        ("short", "4.4", "short colour descriptor", "Average", 28.0, 27.0, 1.5, 2, ()),
    ]
    names = ["name", "section", "quantity", "home", "published", "measured", "spread", "seeds", "notes"]
    return noted(pd.DataFrame(rows, columns=names))


def benchmarks():
    nothing = {"ours": np.nan, "theirs": np.nan, "ratio": np.nan, "low": np.nan, "high": np.nan}
    text = {"module": "one", "peer": "", "peer_version": "", "quantity": "seconds", "spent": "", "met": "yes"}
    peer = {"peer": "OpenCV: compute", "peer_version": "4.14.0"}
    rows = [
        {"piece": "HOG", "input": "25 regions", "ours": 0.001, **peer, "theirs": 0.0017, "ratio": 1.7}
        | {"low": 1.6, "high": 1.9, "target": "at least 2x faster", "met": "no", "spent": "resizing 61%"},
        {"piece": "HOG", "input": "25 regions", "quantity": "difference", "ours": 0.0, "target": "at most 0"},
        {"piece": "A tree", "input": "124 & more", "ours": 1.5, **peer, "theirs": 750.0, "ratio": 500.0}
        | {"low": 490.0, "high": 510.0, "target": "at least 500x faster"},
        {"piece": "A frame", "input": "720p", "ours": 0.0212, **peer, "theirs": 0.004, "ratio": 5.3}
        | {"low": 5.0, "high": 5.5, "target": "at most 7x its time"},
        {"piece": "A frame", "input": "720p", "quantity": "frames/s", "ours": 47.17, "target": "at least 40"},
    ]
    return pd.DataFrame([nothing | text | row for row in rows])


def speed():
    facts = {"processor": "A processor <fast>", "python": "3.11.7", "packages": "numpy 2.3.5"}
    return shown_speed(benchmarks(), facts) | {"chart": png()}


def scale_measured():
    """Make measurements for three sizes; CPU seconds are linear (codebooks) or quadratic (trials)."""
    rows = []
    for size, frames in ((0.25, 1000), (0.5, 2000), (1.0, 4000)):
        rows += [
            (size, frames, "codebooks", item, 6.0, 20.0 * size, 1.0 + size) for item in ("hog_y", "sift_y")
        ]
        rows += [(size, frames, "trials", "gist", 50.0, 160.0 * size**2, 4.0 * size)]
        rows += [(size, frames, "scores", "", 1.0, 1.5, 0.2)]
    return pd.DataFrame(
        rows, columns=["size", "frames", "stage", "item", "seconds", "cpu_seconds", "peak_gib"]
    )


def scale():
    rows = [
        ("codebooks", "", 1.0, 1.0, 1.0, 12.0, 2.0),
        ("codebooks", "hog_y", 1.0, 1.0, 1.0, 6.0, 2.0),
        ("codebooks", "sift_y", 1.0, 1.0, 1.0, 6.0, 2.0),
        ("trials", "", 2.0, 1.0, 2.0, 50.0, 4.0),
        ("trials", "gist", 2.0, 1.0, 2.0, 50.0, 4.0),
        ("scores", "", 0.0, 1.0, 0.0, 1.0, 0.2),
        ("all", "", 1.7, 0.99, 1.8, 63.0, 4.0),
    ]
    columns = ["stage", "item", "exponent", "r2", "last_exponent", "seconds", "peak_gib"]
    facts = {
        "machine": {"cores": 2, "memory_gib": 23.5, "workers": 2},
        "test_homes": ["home_1"],
        "largest": {"seconds": 63.0, "peak_gib": 4.0, "peak_stage": "trials@gist", "met": True},
        "full_run": {"hours": 12.34},
    }
    growth = pd.DataFrame(rows, columns=columns)
    return shown_scale(scale_measured(), growth, facts) | {"chart": png()}


def report(*, tables=range(1, 32), figures=range(1, 21)):
    rng = np.random.default_rng(0)
    shown = [Table(settings(number), cells(number, rng), DATASET) for number in tables]
    drawn = [
        Figure(number, f"What figure {number} shows.", png(seed=number)) for number in figures if number != 20
    ]
    drawn += [Figure(20, "The probability.", None, "this run has no university")] * (20 in figures)
    drawn += [Figure(None, "How sure.", png(), name="figure_how_sure")] * bool(figures)
    times = {
        "stages": pd.DataFrame({"stage": ["sequences", "features"], "runs": [1, 6], "seconds": [3.25, 63.0]}),
        "data": "made-up homes",
        "cores": 2,
        "total": 243.4,
    }
    return Report(
        dataset=DATASET,
        frames={home: dict.fromkeys(CLASSES, 100) | {"unlabelled": 20} for home in HOMES},
        data_version="0123456789abcdef0123456789abcdef.dir",
        tables=[*shown, addition(), captioned()],
        figures=drawn,
        in_text=in_text(),
        findings=findings(),
        comparisons=comparisons(),
        settings="dataset:\n  name: homes\n  title: a < b & c\nsmoothing:\n  step: 1\n",
        times=times,
        speed=speed(),
        scale=scale(),
    )
