import numpy as np
import pytest

from placecat_bench.comparison import Comparison
from placecat_bench.pieces import dependency_tree

SMALL = {"samples": 300, "grid": 4, "clusters": 7, "few": 5, "many": 9}


@pytest.mark.slow
def test_entries_and_targets():
    entries = list(dependency_tree.entries(**SMALL))
    assert [(entry.input, entry.target) for entry in entries] == [
        ("4 variables x 7 values x 300", "at least 25x faster"),
        ("4 variables x 7 values x 300", "at most 1e-09"),
        ("4 variables x 7 values x 300", "at least 10x faster"),
        ("4 variables x 7 values x 300", "at most 0"),
        ("5 binary variables x 300", "at least 500x faster"),
        ("5 binary variables x 300", "at least 3x faster"),
        ("9 binary variables x 300", "at least 3x faster"),
        ("9 binary variables x 300", "at most 0.01"),
        ("9 binary variables x 300", "at most 1"),
    ]
    wide, few, many = entries[0], entries[4], entries[-1]
    assert [len(entry.ours().parents_[0]) for entry in (wide, few)] == [4, 5]
    assert 0 < many.measure() < 1
    for part in (*wide.parts.values(), *few.parts.values()):
        part()


def test_chained_codes_form_a_tree():
    codes = dependency_tree.chained_codes(2000, 4, 7)
    assert codes.dtype == np.int32
    assert codes.min() == 0
    assert codes.max() == 6
    np.testing.assert_array_equal(codes, dependency_tree.chained_codes(2000, 4, 7))
    agreement = [(codes[:, [variable]] == codes[:, :variable]).mean(axis=0).max() for variable in (1, 2, 3)]
    # Half of the samples agree, and one in seven of the others by chance.
    assert np.allclose(agreement, 0.5 + 0.5 / 7, atol=0.05)


@pytest.mark.filterwarnings("ignore::FutureWarning")
def test_pgmpy_learns_the_same_trees():
    pytest.importorskip("pgmpy", reason="without the extra bench")
    entries = list(dependency_tree.entries(**SMALL))
    wide, same, few = entries[0], entries[1], entries[4]
    assert same.measure() < 1e-12
    for entry in (wide, few):
        assert isinstance(entry, Comparison)
        parents = entry.ours().parents_[0].tolist()
        edges = {(parent, variable) for variable, parent in enumerate(parents) if parent >= 0}
        assert set(entry.theirs().edges()) == edges


def test_pyagrum_learns_the_same_tree():
    pytest.importorskip("pyagrum", reason="without the extra bench")
    other_edges = list(dependency_tree.entries(**SMALL))[3]
    assert other_edges.measure() == 0


def test_deeprob_kit_learns_the_same_tree():
    pytest.importorskip("deeprob", reason="without the extra bench-torch")
    difference = list(dependency_tree.entries(**SMALL))[7]
    assert difference.measure() < 1e-3
