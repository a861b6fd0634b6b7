import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from placecat.learning.discriminative import discriminative_codewords


def information(active, y):
    """Compute the mutual information in nats from its definition."""
    total = 0.0
    for value in (0, 1):
        for label in np.unique(y):
            joint = np.mean((active == value) & (y == label))
            if joint > 0:
                total += joint * np.log(joint / (np.mean(active == value) * np.mean(y == label)))
    return total


@given(
    arrays(np.uint8, (24, 6), elements=st.integers(0, 1)),
    arrays(np.int16, 24, elements=st.integers(0, 2)),
    st.sampled_from([0.01, 0.5, 0.67, 1.0]),
)
def test_the_most_informative_codewords_are_marked(active, y, keep):
    kept = discriminative_codewords(active, y, keep)
    assert kept.sum() == max(1, round(keep * 6))
    found = np.array([information(column, y) for column in active.T])
    assert found[kept].min() >= (found[~kept].max() if (~kept).any() else 0.0) - 1e-9


def test_ties_keep_the_lowest_codewords():
    active = np.repeat([[0], [1], [0], [1]], 4, axis=1).astype(np.uint8)
    assert discriminative_codewords(active, [0, 1, 0, 1], 0.5).tolist() == [True, True, False, False]


def test_codewords_of_one_class_are_kept_but_not_those_of_all():
    y = np.arange(60) % 3
    everywhere, never, of_one = np.ones(60), np.zeros(60), y == 2
    active = np.column_stack([everywhere, never, of_one]).astype(np.uint8)
    assert discriminative_codewords(active, y, 1 / 3).tolist() == [False, False, True]
