"""Results as a run would have them, with counts drawn at random."""

from pathlib import Path

import numpy as np
import pandas as pd
import yaml

from placecat.evaluation.trials import expand
from placecat.learning.toy_circles import NAMES
from placecat.reporting.results import NO_SEED, Measured, Results
from placecat.reporting.sources import sources
from placecat.reporting.tables import contradictions_of

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
    measured = {}

    def add(name, tested, places, seeds):
        counts = rng.integers(1, 50, (len(seeds), len(tested), len(places), len(places)))
        measured[name] = Measured(tuple(tested), seeds, places, counts)

    for name, source in sources(params).items():
        of_one_frame = name.split("/")[-1].startswith(("gist", "spatial")) or "spatial_pact" in name
        add(name, source.homes, source.classes, (NO_SEED,) if of_one_frame else SEEDS)
    for study in params["studies"].values():
        for table, options in study.items():
            for trial in expand(table, options, homes):
                if trial.homes:
                    seeds = SEEDS if "codebook" in trial.settings else (NO_SEED,)
                    add(trial.name, trial.homes, classes, seeds)
    for scheme in ("parallel", "sequential"):
        add(f"toy/{scheme}", ("toy",), NAMES, SEEDS)
    return Results(tuple(homes), classes, measured, {})


def published():
    """The published cells, as the stage reads them."""
    text = dict.fromkeys(("group", "row", "column"), str)
    return pd.read_csv(ROOT / "data/thesis/published_tables.csv", dtype=text).fillna(dict.fromkeys(text, ""))


def contradictions():
    """Notes on published cells, as the stage reads them."""
    text = dict.fromkeys(("group", "row", "column", "note"), str)
    table = pd.read_csv(ROOT / "data/thesis/contradictions.csv", dtype=text).fillna("")
    return contradictions_of(table)


def records():
    """What numbers of the text are read off: what git keeps, and made-up facts of models and frames."""
    return {
        "benchmarks": pd.read_csv(ROOT / "reports/benchmarks.csv"),
        "scale": pd.read_csv(ROOT / "reports/scale.csv"),
        "nu": pd.DataFrame(
            {"asked": [0.2, 0.2, 0.1], "lowest": [0.2, 0.17, 0.1], "highest": [0.2, 0.19, 0.1]}
        ),
        "rejected": pd.DataFrame({"filter": "informative", "information": [0.0976, 0.05, 0.03125]}),
    }


def published_text():
    """The published numbers of the text, as the stage reads them."""
    text = dict.fromkeys(("name", "section", "quantity", "home", "quote", "note"), str)
    return pd.read_csv(ROOT / "data/thesis/published_text.csv", dtype=text).fillna(dict.fromkeys(text, ""))
