import dataclasses
from functools import partial

from makers import maps


def test_a_result_is_computed_once_for_each_key() -> None:
    made, calls = maps(), []

    def note(number: int) -> list[int]:
        calls.append(number)
        return [number]

    first = made.remembered(("a", 1), partial(note, 1))
    assert made.remembered(("a", 1), partial(note, 2)) is first
    assert made.remembered(("a", 2), partial(note, 3)) == [3]
    assert calls == [1, 3]
    # A copy of the maps has its own results.
    assert dataclasses.replace(made).remembered(("a", 1), partial(note, 4)) == [4]
