import copy
import dataclasses

import numpy as np
from makers import maps


def test_once_calls_once_for_each_array_and_argument() -> None:
    made, calls = maps(), []

    def add(array: np.ndarray, number: int) -> np.ndarray:
        calls.append(number)
        return array + number

    first = made.once(add, made.grey[2], 1)
    assert made.once(add, made.grey[2], 1) is first
    assert made.once(add, made.grey[2], 2)[0, 0] == made.grey[2][0, 0] + 2
    assert made.once(add, made.grey[3], 1).shape == made.grey[3].shape
    assert calls == [1, 2, 1]
    dataclasses.replace(made).once(add, made.grey[2], 1)
    assert calls == [1, 2, 1, 1]


def test_once_never_mistakes_one_array_for_another() -> None:
    made = maps()
    for value in range(50):
        # Freed, so the next one is likely to get its address and id.
        assert made.once(np.max, np.full(4, value)) == value
    # Copies have other arrays, at the addresses of earlier ones.
    other = copy.deepcopy(made)
    other._kept.update({(np.max, id(other.grey[2])): (np.zeros(1), "wrong")})
    assert other.once(np.max, other.grey[2]) == other.grey[2].max()
