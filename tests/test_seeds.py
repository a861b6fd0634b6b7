import pytest
from hypothesis import given
from hypothesis import strategies as st

from placecat.seeds import derive


def test_seeds_are_the_same_on_every_machine():
    assert derive("codebook", "hog_y", 0) == derive("codebook", "hog_y", 0)
    assert derive("codebook", "hog_y", 0) == 493700714


@pytest.mark.parametrize("other", [("a", 1), ("a1",), ("a", "1", "")])
def test_different_parts_give_different_seeds(other):
    assert derive("a", "1") != derive(*other)


@given(st.lists(st.text() | st.integers(), min_size=1))
def test_seeds_fit_32_bits(parts):
    assert 0 <= derive(*parts) < 2**32
