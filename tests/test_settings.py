import pytest

from placecat import settings
from placecat.errors import PlacecatError


def function(positional, *, gamma, nu=0.2):
    return positional, gamma, nu


def test_unknown_setting_names_the_nearest_and_all_valid():
    with pytest.raises(PlacecatError, match=r"cues\.gist has no setting 'gama'; did you mean 'gamma'\?.*nu"):
        settings.call(function, 1, settings={"gama": 2}, where="cues.gist")


def test_known_settings_are_passed():
    assert settings.call(function, 1, settings={"gamma": 2}, where="x") == (1, 2, 0.2)


def test_a_missing_setting_lists_the_existing_ones():
    with pytest.raises(PlacecatError, match=r"setting 'a\.c' does not exist: a has b"):
        settings.get({"a": {"b": 1}}, "a.c")


@pytest.mark.parametrize(
    ("text", "message"),
    [("a: [1", "is not valid YAML"), ("", "is empty"), (None, "run `placecat params`")],
)
def test_broken_or_missing_params_give_one_message(tmp_path, text, message):
    if text is not None:
        (tmp_path / "params.yaml").write_text(text)
    with pytest.raises(PlacecatError, match=message):
        settings.load(tmp_path / "params.yaml")


def test_settings_are_flat():
    assert settings.flatten({"a": {"b": 1, "c": {"d": None}}, "e": [1, 2]}) == {
        "a.b": "1",
        "a.c.d": "None",
        "e": "[1, 2]",
    }
