"""Results as a run would have them, with counts drawn at random."""

from pathlib import Path

import numpy as np
import pandas as pd
import yaml

from placecat import files
from placecat.evaluation.trials import expand
from placecat.learning.toy_circles import NAMES
from placecat.reporting.quality import QUALITY_COLUMNS, quality_rows
from placecat.reporting.results import (
    MISSING_COLUMNS,
    NO_SEED,
    SCORE_COLUMNS,
    Measured,
    Quality,
    Results,
    score_rows,
)
from placecat.reporting.sources import sources

ROOT = Path(__file__).resolve().parents[1]
PARAMS = yaml.safe_load((ROOT / "params.yaml").read_text())
SEEDS = ("seed-0", "seed-1")


def with_homes(count):
    """The settings with the first homes of the data set, or with some that it does not have."""
    homes = [*PARAMS["dataset"]["homes"], "home_7", "home_8"][:count]
    return PARAMS | {"dataset": PARAMS["dataset"] | {"homes": homes}}


def made(params=PARAMS, drawn=0):
    """Every result that the settings ask for; those of seeds have two."""
    rng = np.random.default_rng(drawn)
    homes, classes = params["dataset"]["homes"], tuple(params["dataset"]["classes"])
    measured, quality = {}, {}
    # Numbers of their own, so that the counts are those that the tests were written for.
    of_quality = np.random.default_rng([drawn, 1])

    def add(name, tested, places, seeds):
        counts = rng.integers(1, 50, (len(seeds), len(tested), len(places), len(places)))
        measured[name] = Measured(tuple(tested), seeds, places, counts)

    for name, source in sources(params).items():
        of_one_frame = name.split("/")[-1].startswith(("gist", "spatial")) or "spatial_pact" in name
        seeds = (NO_SEED,) if of_one_frame else SEEDS
        add(name, source.homes, source.classes, seeds)
        quality[name] = drawn_quality(of_quality, tuple(source.homes), seeds)
    for study in params["studies"].values():
        for table, options in study.items():
            for trial in expand(table, options, homes):
                if trial.homes:
                    seeds = SEEDS if "codebook" in trial.settings else (NO_SEED,)
                    add(trial.name, trial.homes, classes, seeds)
    for scheme in ("parallel", "sequential"):
        add(f"toy/{scheme}", ("toy",), NAMES, SEEDS)
    return Results(tuple(homes), classes, measured, {}, quality)


def drawn_quality(rng, homes, seeds):
    """How good distributions are, drawn at random, with as many decimals as the file has."""
    shape = (len(seeds), len(homes))
    values = {
        "log_loss": rng.uniform(0.5, 3.0, shape).round(6),
        "calibration_error": rng.uniform(0.0, 60.0, shape).round(6),
        "stays": np.repeat(rng.integers(5, 12, (1, len(homes))), len(seeds), axis=0).astype(float),
        "stays_right": rng.integers(0, 6, shape).astype(float),
        "stay_accuracy": rng.uniform(0.0, 100.0, shape).round(6),
    }
    return Quality(homes, seeds, values)


def write_scores(folder, results, missing=()):
    """Write what the stage `scores` leaves in `folder`; `missing` has rows of results, homes and reasons."""
    rows = [row for name, one in results.measured.items() for row in score_rows(name, one)]
    good = [row for name, one in results.quality.items() for row in quality_rows(name, one)]
    for name, content, columns in (
        ("scores", rows, SCORE_COLUMNS),
        ("missing", missing, MISSING_COLUMNS),
        ("probabilities", good, QUALITY_COLUMNS),
    ):
        files.write_csv(folder / f"{name}.csv", pd.DataFrame(content, columns=columns))


def published():
    """The published cells, as the stage reads them."""
    text = dict.fromkeys(("group", "row", "column"), str)
    return pd.read_csv(ROOT / "data/thesis/published_tables.csv", dtype=text).fillna(dict.fromkeys(text, ""))


def published_text():
    """The published numbers of the text, as the stage reads them."""
    text = dict.fromkeys(("name", "section", "quantity", "home", "quote"), str)
    return pd.read_csv(ROOT / "data/thesis/published_text.csv", dtype=text).fillna(dict.fromkeys(text, ""))
