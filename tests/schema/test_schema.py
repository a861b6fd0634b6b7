"""Every section of params.yaml refuses unknown settings."""

import copy
from pathlib import Path

import pytest

from placecat import schema, settings
from placecat.errors import PlacecatError

PARAMS = settings.load(Path(__file__).resolve().parents[2] / "params.yaml")
# Names are free here; their contents are checked.
FREE = {"figures", "codebooks", "cues", "systems", "filters", "splits"}


def at(params, name):
    for key in name.split("."):
        params = params[int(key) if key.isdigit() else key]
    return params


def sections():
    yield from (name for name in PARAMS if name not in FREE)
    yield from (f"{name}.{next(iter(PARAMS[name]))}" for name in sorted(FREE - {"figures"}))
    yield from (
        "region_variants.frames",
        "region_variants.variants.as_used",
        "protocol.cue_frames",
        "protocol.extra",
        "toy.points",
        "toy.sensitivity",
        "codebooks.hog_y.descriptor",
        "systems.das_551_best.integrator",
        "splits.university.dataset",
        "splits.university.integrator",
        "splits.university.cue_parts.0",
    )


def test_the_settings_that_git_holds_are_right():
    schema.check(PARAMS)
    schema.check({})
    assert set(PARAMS) == set(schema.Params.model_fields)


@pytest.mark.parametrize("section", sections())
def test_an_unknown_setting_is_refused(section):
    params = copy.deepcopy(PARAMS)
    at(params, section)["nonsense"] = 1
    with pytest.raises(PlacecatError) as caught:
        schema.check(params)
    assert str(caught.value).startswith(f"{section} has no setting 'nonsense'")
    assert "\n" not in str(caught.value)


def test_an_unknown_section_is_refused():
    with pytest.raises(PlacecatError, match="no setting 'smothing'; did you mean 'smoothing'"):
        schema.check(PARAMS | {"smothing": {}})


@pytest.mark.parametrize(
    "section", [one for one in sections() if not one.endswith(("descriptors", "descriptor"))]
)
def test_a_missing_setting_is_refused(section):
    params = copy.deepcopy(PARAMS)
    name = list(at(params, section))[-1]
    del at(params, section)[name]
    with pytest.raises(PlacecatError, match=rf"{section}.*'{name}'"):
        schema.check(params)


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("smoothing.delay_seconds", "long"),
        ("smoothing.cues", "gist"),
        ("protocol.seeds", [True]),
        ("protocol.cue_frames.step", 1.5),
        ("systems.das_551_best.temperature", "yes"),
        ("regions.max_regions", None),
    ],
)
def test_a_value_of_another_type_is_refused(name, value):
    params = copy.deepcopy(PARAMS)
    parent, _, key = name.rpartition(".")
    at(params, parent)[key] = value
    with pytest.raises(PlacecatError, match=name):
        schema.check(params)


@pytest.mark.parametrize(
    ("name", "value", "message"),
    [
        ("homes", ["home_1", "Home_1", "home_2"], "differ only in capital"),
        ("ignored", ["kitchen"], "'kitchen' is also a class"),
    ],
)
def test_names_of_a_data_set_that_contradict_each_other_are_refused(name, value, message):
    params = copy.deepcopy(PARAMS)
    params["dataset"][name] = value
    with pytest.raises(PlacecatError, match=f"dataset.*{message}"):
        schema.check(params)


POOL = {"method": "log_pool", "shrinkage": 0.1}


@pytest.mark.parametrize(
    ("name", "value", "message"),
    [
        ("systems.das_551_best.integrator", {"method": "log_pool"}, "shrinkage is required by .*log_pool"),
        ("systems.das_551_best.integrator", POOL | {"classifier": {}}, "classifier is required by .*das"),
        ("systems.das_551_best.integrator", POOL | {"shrinkage": -1.0}, "shrinkage"),
        ("systems.das_551_best.integrator", POOL | {"smallest": 0.0}, "smallest"),
        ("systems.das_551_best.integrator", POOL | {"smallest": None}, "smallest is a number"),
        ("systems.das_551_best.integrator.smallest", 1e-6, "smallest is .* only for method: log_pool"),
        ("systems.das_551_extra.integrator", POOL, "extra: true does not work with log_pool"),
        ("splits.university.integrator", POOL, "log_pool does not work with a fixed split"),
    ],
)
def test_an_opinion_pool_goes_where_its_cues_are_judged(name, value, message):
    params = copy.deepcopy(PARAMS)
    parent, _, key = name.rpartition(".")
    at(params, parent)[key] = value
    with pytest.raises(PlacecatError, match=message):
        schema.check(params)


def test_a_cluster_has_settings_of_its_own():
    own = {"kind": "dask", "scheduler": "tcp://10.0.0.1:8786", "wait": 30, "may_differ": []}
    schema.check(PARAMS | {"compute": own})
    with pytest.raises(PlacecatError, match="compute"):
        schema.check(PARAMS | {"compute": own | {"nonsense": 1}})
    with pytest.raises(PlacecatError, match=r"compute.*'cloud'"):
        schema.check(PARAMS | {"compute": {"kind": "cloud"}})
