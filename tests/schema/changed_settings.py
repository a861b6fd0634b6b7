"""The settings in git, and changed copies of them."""

import copy
from pathlib import Path

import pytest

from placecat import settings
from placecat.errors import PlacecatError

ROOT = Path(__file__).resolve().parents[2]
PARAMS = settings.load(ROOT / "params.yaml")
MISSING = object()


def at(params, name):
    for key in name.split("."):
        params = params[int(key) if key.isdigit() else key]
    return params


def changed(name, value, params=PARAMS):
    """Return a copy with another value for a setting, or without the setting if the value is MISSING."""
    params = copy.deepcopy(params)
    parent, _, key = name.rpartition(".")
    section = at(params, parent) if parent else params
    if value is MISSING:
        del section[key]
    else:
        section[int(key) if isinstance(section, list) else key] = value
    return params


def refused(check, params, message=""):
    """Return the one-line message with which a check rejects settings."""
    with pytest.raises(PlacecatError, match=message) as caught:
        check(params)
    assert "\n" not in str(caught.value)
    return str(caught.value)
