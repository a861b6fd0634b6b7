from collections import Counter

import pytest

from placecat.errors import PlacecatError
from placecat_bench.scale.command import read_settings
from placecat_bench.scale.database import Home, Stretch, classes_of, read_homes
from project import ROOT

HOME = Home("a", 2, {"kitchen": (90, 3), "bedroom": (7, 1), "transition": (50, 5)})


def test_the_database_has_as_many_frames_as_in_the_thesis():
    homes = read_homes(read_settings(ROOT / "conf/scale.yaml")["homes"])
    assert [home.frames for home in homes] == [9993, 9998, 6839, 9344, 5012, 10151]
    assert sum(home.frames for home in homes) == 51337


def test_a_walk_has_the_frames_and_stretches_of_each_label():
    walk = HOME.walk()
    frames, stretches = Counter(), Counter(one.label for one in walk)
    for one in walk:
        frames[one.label] += one.frames
    assert frames == {"kitchen": 90, "bedroom": 7, "transition": 50}
    assert stretches == {"kitchen": 3, "bedroom": 1, "transition": 5}
    assert min(one.frames for one in walk) >= 1


def test_a_walk_has_transitions_between_places_and_visits_all_floors_in_order():
    walk = HOME.walk()
    kinds = [one.label == "transition" for one in walk]
    assert kinds == [False, True] * 4 + [True]
    floors = [one.floor for one in walk]
    assert floors == sorted(floors) and set(floors) == {1, 2}


def test_walks_are_reproducible_and_differ_between_homes():
    other = Home("b", HOME.floors, HOME.labels)
    assert HOME.walk() == HOME.walk() != other.walk()


def test_a_scaled_home_keeps_every_label():
    small = HOME.scaled(0.1)
    assert small.labels == {"kitchen": (9, 3), "bedroom": (1, 1), "transition": (5, 5)}
    assert HOME.scaled(1.0) == HOME


def test_labels_become_classes():
    walk = [Stretch(1, "bedroom", 1), Stretch(1, "transition", 1), Stretch(1, "kitchen", 1)]
    assert classes_of(walk, ["bedroom", "kitchen"], ["transition"]) == [0, -1, 1]
    with pytest.raises(PlacecatError, match="'kitchen', which is neither"):
        classes_of(walk, ["bedroom"], ["transition"])


@pytest.mark.parametrize(
    "own",
    [
        {"labels": {"kitchen": [9, 3]}},
        {"floors": 0, "labels": {"kitchen": [9, 3]}},
        {"floors": 1, "labels": {"kitchen": [2, 3]}},
        {"floors": 1, "labels": {"kitchen": 9}},
        {"floors": 1, "labels": {}},
        None,
    ],
)
def test_invalid_homes_raise_an_error(own):
    with pytest.raises(PlacecatError, match=r"homes\.a needs"):
        read_homes({"a": own})
