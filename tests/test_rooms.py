"""Dependencies between packages, and between the subpackages ("rooms") of placecat, run one way."""

import ast
from graphlib import TopologicalSorter
from pathlib import Path

import pytest

SOURCE = Path(__file__).resolve().parents[1] / "src"
PACKAGE = SOURCE / "placecat"
# Maps each package to the other packages that it may import.
MAY_USE = {
    "placecat": set(),
    "placecat_homes": {"placecat"},
    "placecat_bench": {"placecat"},
    "hydra_plugins": {"placecat"},
}
WRITERS = {"thesis", "provenance", "explain", "report", "mlflow_log"}
COMPUTING = ("vision", "learning", "fusion", "cues", "training", "evaluation", "categorizer")
# Maps each room to the rooms that it must not import anywhere.
NEVER = dict.fromkeys(COMPUTING, WRITERS | {"results", "drawing"}) | {
    "predict": WRITERS | {"results"},
    "panoramas": WRITERS | {"results", "drawing", "stages"},
    "drawing": WRITERS | {"results"},
    "results": WRITERS | {"drawing"},
    "thesis": {"provenance", "explain", "report", "mlflow_log", "drawing"},
    "provenance": {"explain", "report", "mlflow_log", "drawing", "stages"},
    "report": {"explain", "mlflow_log", "stages"},
    "mlflow_log": {"explain", "stages"},
    "stages": {"explain"},
}
# These stages present results; all others compute them.
WRITING_STAGES = {"tables", "findings", "figures", "report", "tracking"}


def imported(path):
    """Yield the dotted names of all imports in a module."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module:
            yield from (f"{node.module}.{alias.name}" for alias in node.names)


def rooms_used(path):
    """Return the rooms from which a module imports."""
    return {name.split(".")[1] for name in imported(path) if name.startswith("placecat.")}


def test_every_package_is_known():
    assert {path.name for path in SOURCE.iterdir() if any(path.rglob("*.py"))} == set(MAY_USE)


@pytest.mark.parametrize("package", MAY_USE)
def test_the_method_imports_neither_the_renderer_nor_the_benchmarks(package):
    others = set(MAY_USE) - MAY_USE[package] - {package}
    for path in (SOURCE / package).rglob("*.py"):
        assert not others & {name.partition(".")[0] for name in imported(path)}, path.relative_to(SOURCE)


@pytest.mark.parametrize("room", NEVER)
def test_rooms_import_in_one_direction(room):
    for path in (PACKAGE / room).rglob("*.py"):
        assert not NEVER[room] & rooms_used(path), path.relative_to(PACKAGE)


def test_rooms_have_no_import_cycle():
    rooms = {}
    for path in PACKAGE.rglob("*.py"):
        room = path.relative_to(PACKAGE).parts[0].removesuffix(".py")
        rooms.setdefault(room, set()).update(rooms_used(path) - {room})
    # If there is a cycle, this raises a CycleError that names its rooms.
    TopologicalSorter(rooms).prepare()
    assert len(rooms) > 20


def test_no_stage_that_computes_imports_the_report():
    computing = [path for path in (PACKAGE / "stages").glob("*.py") if path.stem not in WRITING_STAGES]
    assert len(computing) > 10
    for path in computing:
        assert not {"provenance", "report", "mlflow_log"} & rooms_used(path), path.name


def test_the_check_sees_every_kind_of_import(tmp_path):
    module = tmp_path / "module.py"
    module.write_text(
        "import placecat.report.page\nfrom placecat import thesis\n\n\ndef late():\n"
        "    from placecat.mlflow_log.store import connect\n"
    )
    assert rooms_used(module) == {"report", "thesis", "mlflow_log"}
