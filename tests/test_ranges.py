"""Every setting has a type and a range, so invalid values are rejected immediately."""

import math

import pytest
from changed_settings import PARAMS, refused
from changed_settings import changed as changed_at

from placecat import schema
from placecat.schema import signatures

# In these groups, all entries have the same settings.
GROUPS = ("codebooks", "cues", "systems", "filters", "splits", "variants", "schemes", "local", "holistic")
# Settings that may be null, and the meaning of null.
MAY_BE_NULL = {
    "codebooks.*.descriptor.y_weight": "as the descriptor has it",
    "codebooks.*.descriptor.max_regions": "all of them",
    "cues.*.classifier.max_rows": "all rows",
    "cues.*.classifier.reduction.components": "a factor instead",
    "descriptors.holistic.*.width": "the frame's own width",
    "filters.*.share": "a threshold instead",
    "filters.*.threshold": "a share instead",
    "splits.*.integrator.classifier.max_rows": "all rows",
    "systems.*.integrator.classifier.max_rows": "all rows",
    "toy.schemes.*.max_rows": "all rows",
}
WRONG = [math.nan, math.inf, -math.inf, -1e9, -(10**9), "abc", [], {}, True, None, 10**400]


def leaves(content, place=()):
    if isinstance(content, dict):
        for key, value in content.items():
            yield from leaves(value, (*place, key))
    elif isinstance(content, list):
        for number, value in enumerate(content[:1]):
            yield from leaves(value, (*place, number))
    elif isinstance(content, int | float) and not isinstance(content, bool):
        yield place


def numbers():
    """Map each number to its place in the settings; the first entry of a group represents all others."""
    found = {}
    for place in leaves(PARAMS):
        in_group = [number > 0 and place[number - 1] in GROUPS for number in range(len(place))]
        general = tuple("*" if grouped else part for part, grouped in zip(place, in_group, strict=True))
        # Different classifiers have different settings.
        found.setdefault(general, place)
    return {".".join(map(str, general)): ".".join(map(str, place)) for general, place in found.items()}


NUMBERS = numbers()


def check(params):
    """Check some sections; references are checked in other tests."""
    schema.check(params)
    signatures.check(params)


def changed(name, value):
    """Return the section of a setting, with another value for it."""
    section = name.partition(".")[0]
    return changed_at(name, value, {section: PARAMS[section]})


def test_every_nullable_setting_is_a_known_number():
    assert len(NUMBERS) > 90
    assert set(MAY_BE_NULL) < set(NUMBERS)


@pytest.mark.parametrize("name", NUMBERS)
def test_invalid_numbers_are_rejected(name):
    place = NUMBERS[name]
    section = place.partition(".")[0]
    check({section: PARAMS[section]})
    for value in WRONG:
        if value is None and name in MAY_BE_NULL:
            continue
        message = refused(check, changed(place, value))
        assert message.startswith(place), (value, message)
        assert len(message) < 300


@pytest.mark.parametrize("name", MAY_BE_NULL)
def test_null_is_allowed_where_it_means_something(name):
    other = {"filters.*.threshold": ("share", 0.1), "filters.*.share": ("threshold", 0.1)}.get(name)
    section = changed(NUMBERS[name], None)
    if other:
        section = changed_at(f"{NUMBERS[name].rpartition('.')[0]}.{other[0]}", other[1], section)
    check(section)


def values():
    """Yield invalid values for settings that are not numbers, with the expected message."""
    yield "dataset.homes", "banana", "list"
    yield "dataset.homes", [], "at least 1"
    yield "dataset.homes", ["home_1", "home_2", "home_1"], "'home_1' twice"
    unusable = ("/etc", "..", ".git", "-n", "a/b", "a\\b", "a\0b", "a\x1b[2J", "all", " a", "", "\udce9")
    for name in (*unusable, "x" * 248):
        yield "dataset.homes", ["home_1", name], r"dataset\.homes\.1="
    for name in (1, 7.5, True, None, ["home_1"]):
        yield "dataset.homes", [name], r"dataset\.homes\.0="
    yield "dataset.homes", [1], "write '1', with quotes"
    yield "dataset.classes", ["kitchen", "kitchen"], "twice"
    yield "dataset.classes", ["kitchen"], "at least 2"
    yield "dataset.homes", "banana", r"write \[banana\]"
    yield "dataset.root", "", "empty"
    yield "dataset.root", "s3://bucket/homes", "is an address"
    yield "dataset.root", "~/homes", "full path"
    for root in (".", "..", "data", "/", "data/../data"):
        yield "dataset.root", root, "in another folder"
    yield "dataset.title", "a\x1b]0;b\x07", "printed"
    yield "dataset.layout", "../video", "does not exist"
    yield "protocol.schemes", ["5-5-2"], "'5-5-1' or '4-5-1'"
    yield "protocol.seeds", [], "at least 1"
    yield "protocol.seeds", [0, 0], "0 twice"
    yield "protocol.test_homes", [], "at least 1"
    yield "protocol.test_homes", ["home_1", "home_1"], "twice"
    yield "smoothing.evidence", "firm", "'hard' or 'soft'"
    yield "attention.gabor_size", 8, "odd"
    yield "attention.scales", [3, 2], "ascending"
    yield "cues.gist.classifier.scaling", "log", "'minmax'"
    yield "cues.gist.classifier.scheme.calibration", "homes", "'homes_centred'"
    yield "cues.gist.classifier.base.nu_policy", None, "'lower' or 'refuse'"
    yield "descriptors.local.hog.interpolation", "area", "'cubic'"
    yield "figures.figure_15.panels", "integration", "a mapping of settings"
    for name in ("a.b", "my cue", "a/b", "h\u00e4user", "-x", "", "$(touch x)"):
        yield "codebooks", {name: PARAMS["codebooks"]["hog_y"]}, r"'.*' is not a valid name: .* letters"
    yield "filters.tenth.threshold", 0.1, "a threshold or a share, not both"


@pytest.mark.parametrize(("name", "value", "message"), list(values()))
def test_other_invalid_values_are_rejected(name, value, message):
    assert len(refused(check, changed(name, value), message)) < 300


@pytest.mark.parametrize(
    "name", ["Flat A", "o'hara", "R&D", "$HOME", "home 1;touch PWNED", "H\u00e4user", '"', "{{ a }}"]
)
def test_a_home_may_have_any_name_that_a_folder_can_have(name):
    check(changed("dataset.homes", [name]))
