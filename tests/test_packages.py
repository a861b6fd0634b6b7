"""Imports between the packages in src."""

import ast
from pathlib import Path

import pytest

SOURCE = Path(__file__).resolve().parents[1] / "src"
MAY_USE = {
    "placecat": set(),
    "placecat_homes": {"placecat"},
    "placecat_bench": {"placecat"},
    "hydra_plugins": {"placecat"},
}


def imported(path):
    """Top-level names of all imports in the text of a module."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from (alias.name.partition(".")[0] for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module:
            yield node.module.partition(".")[0]


def test_every_package_is_known():
    assert {path.name for path in SOURCE.iterdir() if any(path.rglob("*.py"))} == set(MAY_USE)


@pytest.mark.parametrize("package", MAY_USE)
def test_the_method_imports_neither_the_renderer_nor_the_benchmarks(package):
    others = set(MAY_USE) - MAY_USE[package] - {package}
    for path in (SOURCE / package).rglob("*.py"):
        assert not others & set(imported(path)), path.relative_to(SOURCE)
