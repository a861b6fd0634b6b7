"""Every section of params.yaml rejects unknown settings."""

import pytest
from changed_settings import MISSING, PARAMS, at, changed, refused

from placecat import schema

# Any name is allowed here, but the content is checked.
FREE = {"figures", "codebooks", "cues", "systems", "filters", "splits"}


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


def test_the_settings_in_git_are_valid():
    schema.check(PARAMS)
    schema.check({})
    assert set(PARAMS) == set(schema.Params.model_fields)


@pytest.mark.parametrize("section", sections())
def test_an_unknown_setting_is_refused(section):
    message = refused(schema.check, changed(f"{section}.nonsense", 1))
    assert message.startswith(f"{section} has no setting 'nonsense'")


def test_an_unknown_section_is_refused():
    refused(schema.check, PARAMS | {"smothing": {}}, "no setting 'smothing'; did you mean 'smoothing'")


@pytest.mark.parametrize(
    "section", [one for one in sections() if not one.endswith(("descriptors", "descriptor"))]
)
def test_a_missing_setting_is_refused(section):
    name = list(at(PARAMS, section))[-1]
    refused(schema.check, changed(f"{section}.{name}", MISSING), rf"{section}.*'{name}'")


POOL = {"method": "log_pool", "shrinkage": 0.1}


@pytest.mark.parametrize(
    ("name", "value", "message"),
    [
        ("smoothing.delay_seconds", "long", "smoothing.delay_seconds"),
        ("smoothing.cues", "gist", "smoothing.cues"),
        ("protocol.seeds", [True], "protocol.seeds"),
        ("protocol.cue_frames.step", 1.5, "protocol.cue_frames.step"),
        ("systems.das_551_best.temperature", "yes", "systems.das_551_best.temperature"),
        ("regions.max_regions", None, "regions.max_regions"),
        ("dataset.homes", ["home_1", "Home_1", "home_2"], "dataset.*differ only in capital"),
        ("dataset.ignored", ["kitchen"], "dataset.*'kitchen' is also a class"),
        ("systems.das_551_best.integrator", {"method": "log_pool"}, "shrinkage is required by .*log_pool"),
        ("systems.das_551_best.integrator", POOL | {"classifier": {}}, "classifier is required by .*das"),
        ("systems.das_551_best.integrator", POOL | {"shrinkage": -1.0}, "shrinkage"),
        ("systems.das_551_best.integrator", POOL | {"smallest": 0.0}, "smallest"),
        ("systems.das_551_best.integrator", POOL | {"smallest": None}, "smallest must be a number"),
        ("systems.das_551_best.integrator.smallest", 1e-6, "smallest must .* needs method: log_pool"),
        ("systems.das_551_extra.integrator", POOL, "extra: true does not work with log_pool"),
        ("splits.university.integrator", POOL, "log_pool does not work with a fixed split"),
    ],
)
def test_wrong_types_and_contradictions_are_rejected(name, value, message):
    refused(schema.check, changed(name, value), message)


def test_compute_settings_depend_on_the_kind():
    own = {"kind": "dask", "scheduler": "tcp://10.0.0.1:8786", "wait": 30, "may_differ": []}
    schema.check(PARAMS | {"compute": own})
    refused(schema.check, PARAMS | {"compute": own | {"nonsense": 1}}, "compute")
    refused(schema.check, PARAMS | {"compute": {"kind": "cloud"}}, r"compute.*'cloud'")
