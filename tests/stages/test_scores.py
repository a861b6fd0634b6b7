"""The stage `scores` on random distributions."""

from functools import cache

import numpy as np
import pandas as pd
import pytest
from made_features import CLASSES, HOMES, PARAMS, STUDIES, make

from placecat import files, paths, settings
from placecat.evaluation.accuracy import confusion_matrix
from placecat.evaluation.quality import home_quality
from placecat.results import collect
from placecat.results.sources import sources
from placecat.sequences import listing
from placecat.stages import scores
from placecat.training import fold_file

OPTIONS = PARAMS["probabilities"]


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A project where every result has random distributions on every test home."""
    make(tmp_path)
    monkeypatch.chdir(tmp_path)
    rng = np.random.default_rng(0)
    drawn: dict = {}
    read_labels = cache(listing.read_labels)
    for source in sources(settings.load()).values():
        for home in source.homes:
            frames = len(read_labels(source.listed(home)))
            for seed in ("seed-0", "seed-1"):
                proba = rng.dirichlet(np.ones(len(source.classes)), frames)
                drawn.setdefault(source.file(home, seed), {})[source.name] = proba
    for path, arrays in drawn.items():
        fold_file.write(path, arrays)
    for name in STUDIES:
        files.write_csv(paths.TRIALS / name / "scores.csv", pd.DataFrame(columns=scores.SCORE_COLUMNS))
        files.write_csv(paths.TRIALS / name / "missing.csv", pd.DataFrame(columns=scores.MISSING_COLUMNS))
    files.write_csv(paths.FILTERED / "dropped.csv", pd.DataFrame(columns=["filter", "home"]))
    files.write_csv(paths.TOY, pd.DataFrame(columns=scores.SCORE_COLUMNS))
    return tmp_path


def test_every_result_has_numbers_for_every_home_and_seed(folder):
    scores.main()
    table = pd.read_csv(folder / "data/scores/probabilities.csv").set_index(["result", "home", "seed"])
    counts = (
        pd.read_csv(folder / "data/scores/scores.csv").groupby(["result", "home", "seed"])["frames"].sum()
    )
    found = sources(settings.load())
    assert set(table.index.get_level_values("result")) == set(found)
    kinds = {name.split("/")[0] for name in found}
    assert kinds == {"cues", "tempered", "integration", "filtered", "hmm", "smoothing", "splits"}
    read_labels = cache(listing.read_labels)
    for name, source in found.items():
        for home in source.homes:
            truth = read_labels(source.listed(home))
            assert (truth < 0).any()
            for seed in source.seeds():
                proba = source.array(home, seed)
                parts = [slice(0, 50), slice(50, 90)]
                expected = home_quality(truth, proba, parts, **OPTIONS)
                row = table.loc[(name, home, seed)]
                assert row.tolist() == pytest.approx(list(expected), abs=1e-6)
                assert counts[name, home, seed] == (truth >= 0).sum()
                assert (
                    confusion_matrix(truth, proba.argmax(1), len(source.classes)).sum()
                    == (counts[name, home, seed])
                )
    assert len(CLASSES) == 3 and len(HOMES) == 4


def test_it_writes_the_same_bytes_again(folder):
    scores.main()
    first = (folder / "data/scores/probabilities.csv").read_bytes()
    scores.main()
    assert (folder / "data/scores/probabilities.csv").read_bytes() == first


def test_homes_and_places_may_have_names_like_numbers_or_missing_values(folder):
    homes, places = ["01", "1", "1e3", "nan"], ["NA", "kitchen"]
    rows = [("trial", home, "seed-0", "NA", place, 7) for home in homes for place in places]
    files.write_csv(
        paths.TRIALS / next(iter(STUDIES)) / "scores.csv", pd.DataFrame(rows, columns=scores.SCORE_COLUMNS)
    )
    missing = pd.DataFrame([("trial", "007", "none")], columns=scores.MISSING_COLUMNS)
    files.write_csv(paths.TRIALS / next(iter(STUDIES)) / "missing.csv", missing)
    scores.main()
    results = collect.read_results(settings.load())
    assert results.measured["trial"].homes == tuple(homes)
    assert set(results.measured["trial"].classes) == set(places)
    assert results.measured["trial"].confusion.sum() == 7 * len(rows)
    assert results.missing["trial", "007"] == "none"
