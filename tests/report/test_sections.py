from hypothesis import given
from hypothesis import strategies as st

from placecat.report.sections import THESIS, arrange


def test_the_sections_have_every_table_and_figure_once():
    tables = [number for one in THESIS for number in one.tables]
    figures = [number for one in THESIS for number in (*one.before, *one.after)]
    assert tables == list(range(1, 32))
    assert sorted(figures) == list(range(1, 21))


@given(st.sets(st.integers(1, 40)), st.sets(st.integers(1, 30)))
def test_nothing_is_lost_or_shown_twice(tables, figures):
    sections, rest = arrange(tables, figures)
    everything = [*sections, rest]
    assert sorted(number for one in everything for number in one.tables) == sorted(tables)
    shown = [number for one in everything for number in (*one.before, *one.after)]
    assert sorted(shown) == sorted(figures)
    assert all(one.tables or one.before or one.after for one in sections)
    assert not rest.before
