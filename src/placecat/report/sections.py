"""The order of the report: the thesis's sections, each with its tables and figures."""

from collections.abc import Collection
from dataclasses import dataclass, replace


@dataclass(frozen=True)
class Section:
    """A section of the thesis; `before` and `after` are the figures that come before and after its tables."""

    number: str
    title: str
    tables: tuple[int, ...] = ()
    before: tuple[int, ...] = ()
    after: tuple[int, ...] = ()


# Chapter 3's figures, which explain the method, appear next to the related measurements.
THESIS = (
    Section("4.2", "Gist", tables=tuple(range(1, 8))),
    Section("4.3", "Holistic Centrist", tables=tuple(range(8, 11))),
    Section("4.4", "Salient regions", tuple(range(11, 26)), before=tuple(range(1, 11)), after=(12, 13, 14)),
    Section("4.5", "Integration and smoothing", tables=(26,), after=(11, 15, 16, 17, 18)),
    Section("4.6", "Information filter", tables=(27,), after=(19,)),
    Section("4.7", "Tracked regions", tables=(28,)),
    Section("4.8", "Sequential and parallel multi-class schemes", tables=(29,)),
    Section("4.9", "University", tables=(30,), after=(20,)),
    Section("4.10", "Apartments, with a robot", tables=(31,)),
)


def arrange(tables: Collection[int], figures: Collection[int]) -> tuple[list[Section], Section]:
    """Assign the existing tables and figures, given by their numbers, to sections.

    Returns the non-empty sections of `THESIS`, and an untitled section for all remaining tables and figures.
    """
    sections = []
    for one in THESIS:
        own = tuple(number for number in one.tables if number in tables)
        before, after = (tuple(n for n in part if n in figures) for part in (one.before, one.after))
        sections.append(replace(one, tables=own, before=before, after=after))
    placed_tables = {number for one in sections for number in one.tables}
    placed_figures = {number for one in sections for number in (*one.before, *one.after)}
    more_tables, more_figures = sorted(set(tables) - placed_tables), sorted(set(figures) - placed_figures)
    rest = Section("", "", tuple(more_tables), after=tuple(more_figures))
    return [one for one in sections if one.tables or one.before or one.after], rest
