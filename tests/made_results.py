"""Results like those of a run, with random counts."""

from pathlib import Path

import numpy as np
import pandas as pd

from placecat import files
from placecat.evaluation.trials import expand
from placecat.learning.toy_circles import NAMES
from placecat.results.measured import (
    DROPPED_COLUMNS,
    MISSING_COLUMNS,
    NO_SEED,
    SCORE_COLUMNS,
    Measured,
    Quality,
    Results,
    score_rows,
)
from placecat.results.quality import QUALITY_COLUMNS, quality_rows
from placecat.results.sources import sources
from placecat.settings import read_yaml
from placecat.thesis import definitions
from placecat.thesis.tables import contradictions_of

ROOT = Path(__file__).resolve().parents[1]
PARAMS = read_yaml(ROOT / "params.yaml")
STUDIES = definitions.studies(PARAMS, ROOT)
SEEDS = ("seed-0", "seed-1")


def with_homes(count):
    """Return the settings with only the first homes of the data set, or with additional ones."""
    homes = [*PARAMS["dataset"]["homes"], "home_7", "home_8"][:count]
    return PARAMS | {"dataset": PARAMS["dataset"] | {"homes": homes}}


def made(params=PARAMS, drawn=0):
    """Make every result in the settings; random results have two seeds."""
    rng = np.random.default_rng(drawn)
    homes, classes = params["dataset"]["homes"], tuple(params["dataset"]["classes"])
    measured, quality = {}, {}
    # A separate generator keeps the counts that the tests expect.
    of_quality = np.random.default_rng([drawn, 1])

    def add(name, tested, places, seeds):
        counts = rng.integers(1, 50, (len(seeds), len(tested), len(places), len(places)))
        measured[name] = Measured(tuple(tested), seeds, places, counts)

    for name, source in sources(params).items():
        of_one_frame = name.split("/")[-1].startswith(("gist", "spatial")) or "spatial_pact" in name
        seeds = (NO_SEED,) if of_one_frame else SEEDS
        add(name, source.homes, source.classes, seeds)
        quality[name] = drawn_quality(of_quality, tuple(source.homes), seeds)
    for study in STUDIES.values():
        for table, options in study.items():
            for trial in expand(table, options, homes):
                if trial.homes:
                    seeds = SEEDS if "codebook" in trial.settings else (NO_SEED,)
                    add(trial.name, trial.homes, classes, seeds)
    for name in toy_results(params["toy"]):
        add(name, ("toy",), NAMES, SEEDS)
    stays = {name: by_stay(one, rng) for name, one in measured.items() if name.startswith("splits/")}
    dropped = {
        name: pd.DataFrame(
            [
                {"filter": name, "home": home, "threshold": 0.1 + n / 100, "frames": 50, "dropped": 20}
                for home in homes
            ]
        ).assign(labelled=40, dropped_labelled=10 * (n + 1))
        for n, name in enumerate(params["filters"])
    }
    return Results(tuple(homes), classes, measured, {}, stays, dropped, quality)


def toy_results(toy):
    """Return the names of all results from the stage `toy`."""
    radii, decisions = toy["sensitivity"]["radii"], toy["sensitivity"]["decisions"]
    return [
        *("toy/parallel", "toy/sequential", "toy/last/parallel", "toy/last/sequential"),
        *(f"toy/{radius:g}/parallel" for radius in radii),
        *(f"toy/{radius:g}/sequential/{decision}" for radius in radii for decision in decisions),
    ]


def by_stay(one, rng, visits=3, frames=20):
    """Make decisions for several visits to each place; some frames of each visit are named correctly."""
    seeds, places = len(one.seeds), len(one.classes)
    confusion = np.zeros((seeds, places * visits, places, places), int)
    for stay in range(places * visits):
        place = stay % places
        right = rng.integers(0, frames + 1, seeds)
        confusion[:, stay, place, place] = right
        confusion[:, stay, place, (place + 1) % places] = frames - right
    names = tuple(f"{one.homes[0]}/{number}" for number in range(1, places * visits + 1))
    return Measured(names, one.seeds, one.classes, confusion)


def drawn_quality(rng, homes, seeds):
    """Make random quality measures with as many decimals as in the file."""
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
    """Write the outputs of the stage `scores`; each row in `missing` has a result, a home and a reason."""
    rows, stays = (
        [row for name, one in own.items() for row in score_rows(name, one)]
        for own in (results.measured, results.stays)
    )
    good = [row for name, one in results.quality.items() for row in quality_rows(name, one)]
    for name, content, columns in (
        ("scores", rows, SCORE_COLUMNS),
        ("stays", stays, SCORE_COLUMNS),
        ("missing", missing, MISSING_COLUMNS),
        ("probabilities", good, QUALITY_COLUMNS),
    ):
        files.write_csv(folder / f"{name}.csv", pd.DataFrame(content, columns=columns))
    dropped = [pd.DataFrame(columns=DROPPED_COLUMNS), *results.dropped.values()]
    files.write_csv(folder / "dropped.csv", pd.concat(dropped)[DROPPED_COLUMNS])


def published():
    """Read the published cells, as the stage does."""
    text = dict.fromkeys(("group", "row", "column"), str)
    return pd.read_csv(ROOT / "data/thesis/published_tables.csv", dtype=text).fillna(dict.fromkeys(text, ""))


def contradictions():
    """Read the notes on published cells, as the stage does."""
    text = dict.fromkeys(("group", "row", "column", "note"), str)
    table = pd.read_csv(ROOT / "data/thesis/contradictions.csv", dtype=text).fillna("")
    return contradictions_of(table)


def records():
    """Return records behind numbers in the text: those in git, and artificial ones for models and frames."""
    return {
        "benchmarks": pd.read_csv(ROOT / "reports/benchmarks.csv"),
        "scale": pd.read_csv(ROOT / "reports/scale.csv"),
        "nu": pd.DataFrame(
            {"asked": [0.2, 0.2, 0.1], "lowest": [0.2, 0.17, 0.1], "highest": [0.2, 0.19, 0.1]}
        ),
        "rejected": pd.DataFrame({"filter": "informative", "information": [0.0976, 0.05, 0.03125]}),
    }


def published_text():
    """Read the published numbers in the text, as the stage does."""
    text = dict.fromkeys(("name", "section", "quantity", "home", "quote", "note"), str)
    return pd.read_csv(ROOT / "data/thesis/published_text.csv", dtype=text).fillna(dict.fromkeys(text, ""))
