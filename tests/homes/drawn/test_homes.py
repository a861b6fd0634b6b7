"""Homes drawn from a seed are furnished, can be walked through and have no faults. Faults are detected."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import yaml
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from placecat.errors import PlacecatError
from placecat_homes.building import build
from placecat_homes.drawn import homes, plans
from placecat_homes.drawn.faults import faults
from placecat_homes.drawn.homes import Source, name_of
from placecat_homes.drawn.ranges import KINDS
from placecat_homes.drawn.top_view import top_view
from placecat_homes.placing.room import Room
from placecat_homes.walking import walk

pytestmark = [pytest.mark.slow, pytest.mark.xdist_group("drawn")]

SOURCE = Source.read()
# The first plan and the first walk of this home have no faults.
NUMBER, SEED = 1, 1


@cache
def drawn(number, seed):
    return homes.draw(number, seed, SOURCE)


@pytest.fixture(scope="module")
def home():
    return drawn(NUMBER, SEED)


# Hypothesis starts with the smallest numbers, which are those of the fixture. The second home is random.
@settings(max_examples=2, deadline=None, suppress_health_check=list(HealthCheck))
@given(number=st.integers(NUMBER, 1000), seed=st.integers(SEED, 2**32 - 1))
def test_the_walk_hits_nothing_and_visits_every_room(number, seed):
    made = drawn(number, seed)
    ground = made.building.ground()
    path = made.walk.position[:, :2]
    assert ground.is_free(path).all()
    assert len(path) == SOURCE.video.frames
    for plan, room in zip(made.building.plan.rooms, made.building.rooms, strict=True):
        assert room.walkable(), plan.name
        if plan.kind in KINDS:
            x0, y0, x1, y1 = plan.rect
            inside = (path > (x0, y0)).all(axis=1) & (path < (x1, y1)).all(axis=1)
            assert (inside & (np.array(made.walk.label) == plan.kind)).any(), plan.name


def test_the_file_describes_the_complete_home(home):
    """The YAML alone is enough to build the home and its walk again."""
    content = yaml.safe_load(home.text())
    assert content == home.content
    assert content["plan"]["name"] == name_of(NUMBER, SEED)
    assert content["shot"]["name"].startswith(name_of(NUMBER, SEED))
    again = build(plans.read(content["plan"]), content["shot"]["building"])
    assert np.array_equal(again.mesh.vertices, home.building.mesh.vertices)


def test_a_drawn_home_has_no_faults(home):
    assert list(faults(home.building, home.walk)) == []


def test_an_empty_room_is_a_fault(home):
    building = home.building
    index = next(k for k, room in enumerate(building.plan.rooms) if room.kind == "bedroom")
    old = building.rooms[index]
    size = (*building.plan.rooms[index].size, building.plan.height)
    openings = building.plan.openings(old.name, 1)
    empty = Room(old.kind, old.name, size, openings, old.style, np.random.default_rng(0))
    rooms = tuple(empty if k == index else room for k, room in enumerate(building.rooms))
    assert f"{old.name} is nearly empty" in list(faults(replace(building, rooms=rooms), home.walk))


def test_a_walk_through_a_wall_or_past_a_room_is_a_fault(home):
    away = replace(home.walk, position=home.walk.position + np.array([50.0, 0, 0]))
    found = list(faults(home.building, away))
    assert "the walk leads through furniture or walls" in found
    assert "the walk hardly shows kitchen_1" in found


def test_the_view_from_above_shows_the_rooms_and_the_path(home):
    without, picture = top_view(home.building), top_view(home.building, home.walk)
    assert picture.shape == without.shape and picture.dtype == np.uint8
    changed = (picture != without).any(axis=2)
    assert 0.0005 < changed.mean() < 0.2
    assert len(np.unique(without.reshape(-1, 3), axis=0)) > 8


def test_too_few_frames_raise_an_error_with_the_reason(home, monkeypatch):
    monkeypatch.setattr(homes, "_DRAWS", 1)
    # Building takes seconds, so the home of the fixture is used. Only a few of the many walks are tried.
    monkeypatch.setattr(homes, "build", lambda plan, attempt: home.building)
    monkeypatch.setattr(walk, "_TRIES", 5)
    message = "home 1 of seed 1: all 1 plans drawn have faults; the last fault: no walk of 200"
    with pytest.raises(PlacecatError, match=message):
        homes.draw(NUMBER, SEED, Source.read(frames=200, fps=20))
