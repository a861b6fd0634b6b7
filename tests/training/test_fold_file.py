"""Test the result files for a test home and seed."""

import numpy as np
import pytest

from placecat.training import fold_file


def test_round_trip(tmp_path):
    path = fold_file.path_of(tmp_path, "flat.2", "seed-1")
    proba = np.random.default_rng(0).random((3, 2))
    fold_file.write(path, {"test": proba}, {"nu": [0.2]})
    np.testing.assert_array_equal(fold_file.read(path, "test"), proba)
    assert fold_file.read_facts(path) == {"nu": [0.2]}
    assert fold_file.has(path, "test")
    assert not fold_file.has(path, "cross_validated")
    assert not fold_file.has(tmp_path / "missing.npz", "test")
    with pytest.raises(KeyError):
        fold_file.read(path, "cross_validated")


def test_homes_with_a_common_prefix_are_distinct(tmp_path):
    for home, seed in (("flat", "seed-1"), ("flat", "seed-0"), ("flat.2", "no-seed")):
        fold_file.write(fold_file.path_of(tmp_path, home, seed), {"test": np.zeros(1)})
    assert fold_file.seeds_in(tmp_path, "flat") == ["seed-0", "seed-1"]
    assert fold_file.seeds_in(tmp_path, "flat.2") == ["no-seed"]
    assert fold_file.seeded(tmp_path, "flat", 1).name == "flat.seed-1.npz"
    # This result is not random, so any seed finds it.
    assert fold_file.seeded(tmp_path, "flat.2", 1).name == "flat.2.no-seed.npz"
