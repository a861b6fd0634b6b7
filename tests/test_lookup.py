"""Names in the settings refer to modules. The settings of a module are read from its source."""

import importlib
import inspect
import sys
from pathlib import Path
from typing import Any

import pytest

from placecat import lookup, settings
from placecat.errors import PlacecatError
from placecat.schema.signatures import CUES, LEARNING


@pytest.fixture
def shapes(tmp_path, monkeypatch):
    """A package made for this test."""
    package = tmp_path / "shapes_for_test"
    package.mkdir()
    (package / "__init__.py").touch()
    (package / "square.py").write_text("def describe(side, *, unit, scale=1): return 4\n")
    (package / "helper.py").write_text("def other(): return 4\n")
    (package / "lacking.py").write_text("import no_such_package\ndef describe(): pass\n")
    monkeypatch.syspath_prepend(tmp_path)
    lookup._locations.cache_clear()
    yield package
    for name in [name for name in sys.modules if name.startswith("shapes_for_test")]:
        del sys.modules[name]


def test_a_new_module_is_found_by_its_name(shapes):
    assert lookup.names(shapes.name, "describe") == ["lacking", "square"]
    assert lookup.names(shapes.name) == ["helper", "lacking", "square"]
    assert lookup.module(shapes.name, "square", "shape", "describe").describe(1, unit=2) == 4
    (shapes / "circle.py").write_text("from shapes_for_test.square import describe\n")
    assert lookup.names(shapes.name, "describe") == ["circle", "lacking", "square"]


@pytest.mark.parametrize(
    "name", ["helper", "squar", "", "__init__", "../square", "square.x", None, ["square"], 1]
)
def test_an_unknown_module_is_refused_with_a_list(shapes, name):
    with pytest.raises(
        PlacecatError, match=r"^the shape .* does not exist.*: use one of lacking, square$"
    ) as caught:
        lookup.module(shapes.name, name, "the shape", "describe")
    assert ("did you mean 'square'?" in str(caught.value)) == ("squar" in str(name))


def test_invalid_python_and_missing_packages_raise_placecat_errors(shapes):
    with pytest.raises(
        PlacecatError, match="shape 'lacking' cannot be imported: No module named 'no_such_package'"
    ):
        lookup.module(shapes.name, "lacking", "shape", "describe")
    (shapes / "broken.py").write_text("def describe(:\n")
    with pytest.raises(PlacecatError, match=r"broken\.py, line 1, is not Python"):
        lookup.names(shapes.name, "describe")


def test_settings_are_listed_without_importing_the_module(shapes):
    assert lookup.parameters(shapes.name, "square", "describe") == {
        "unit": (True, Any),
        "scale": (False, Any),
    }
    assert lookup.parameters(shapes.name, "square", "size") == {}
    assert lookup.parameters(shapes.name, "circle", "describe") == {}
    assert "shapes_for_test.square" not in sys.modules


SETTINGS = settings.load(Path(__file__).resolve().parents[1] / "params.yaml")
FUNCTIONS = [
    *((CUES, name, "fit") for name in lookup.names(CUES, "fit")),
    *(
        (package, name, "describe")
        for package in ("placecat.vision.local", "placecat.vision.holistic")
        for name in lookup.names(package, "describe")
    ),
    *(("placecat.sequences", name, "read_home") for name in lookup.names("placecat.sequences", "read_home")),
    *(
        ("placecat.report.figures", module, function)
        for name, (module, function) in lookup.entries("placecat.report.figures", "FIGURES").items()
        if function and name in SETTINGS["figures"]
    ),
]


@pytest.mark.parametrize(("package", "name", "function"), FUNCTIONS)
def test_settings_of_functions_match_python(package, name, function):
    imported = getattr(importlib.import_module(f"{package}.{name}"), function)
    expected = {
        one.name: one.default is one.empty
        for one in inspect.signature(imported).parameters.values()
        if one.kind is one.KEYWORD_ONLY
    }
    assert expected
    found = lookup.parameters(package, name, function)
    assert {setting: is_needed for setting, (is_needed, _) in found.items()} == expected


def test_settings_of_estimators_match_scikit_learn():
    from sklearn.base import BaseEstimator

    found = {}
    for name in lookup.names(LEARNING):
        try:
            found[name] = lookup.estimator(LEARNING, name, "base.name")
        except PlacecatError:
            module = importlib.import_module(f"{LEARNING}.{name}")
            own = [one for one in vars(module).values() if getattr(one, "__module__", "") == module.__name__]
            classes = [one for one in own if isinstance(one, type) and issubclass(one, BaseEstimator)]
            assert all(inspect.isabstract(one) or name == "discrete_bayes" for one in classes)
    assert {"nu_svm": "NuSVM", "naive_bayes": "NaiveBayes"}.items() <= found.items()
    for name, class_name in found.items():
        estimator = getattr(importlib.import_module(f"{LEARNING}.{name}"), class_name)
        assert issubclass(estimator, BaseEstimator)
        expected = list(inspect.signature(estimator).parameters)
        assert list(lookup.parameters(LEARNING, name, class_name)) == expected
