"""Dependencies between the rooms of the package run one way."""

import ast
from graphlib import TopologicalSorter
from pathlib import Path

import pytest

PACKAGE = Path(__file__).resolve().parents[1] / "src/placecat"
WRITERS = {"thesis", "provenance", "explain", "report", "mlflow_log"}
# Modules that a room must not import, anywhere in its text.
NEVER = {
    "vision": WRITERS | {"results", "drawing"},
    "learning": WRITERS | {"results", "drawing"},
    "fusion": WRITERS | {"results", "drawing"},
    "cues": WRITERS | {"results", "drawing"},
    "training": WRITERS | {"results", "drawing"},
    "evaluation": WRITERS | {"results", "drawing"},
    "categorizer": WRITERS | {"results", "drawing"},
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
# These stages write what people read; all others compute.
WRITING_STAGES = {"tables", "findings", "figures", "report", "tracking"}


def rooms_used(path):
    """Rooms that a module imports from."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom) and node.module:
            names = [f"{node.module}.{alias.name}" for alias in node.names]
        else:
            continue
        yield from (name.split(".")[1] for name in names if name.startswith("placecat."))


@pytest.mark.parametrize("room", NEVER)
def test_arrows_run_one_way(room):
    for path in (PACKAGE / room).rglob("*.py"):
        assert not NEVER[room] & set(rooms_used(path)), path.relative_to(PACKAGE)


def test_rooms_have_no_circle():
    rooms = {}
    for path in PACKAGE.rglob("*.py"):
        room = path.relative_to(PACKAGE).parts[0].removesuffix(".py")
        rooms.setdefault(room, set()).update(set(rooms_used(path)) - {room})
    # Raises CycleError, which names the rooms of a circle.
    TopologicalSorter(rooms).prepare()
    assert len(rooms) > 20


def test_no_stage_that_computes_imports_the_report():
    computing = [path for path in (PACKAGE / "stages").glob("*.py") if path.stem not in WRITING_STAGES]
    assert len(computing) > 10
    for path in computing:
        assert not {"provenance", "report", "mlflow_log"} & set(rooms_used(path)), path.name


def test_the_check_sees_every_kind_of_import(tmp_path):
    module = tmp_path / "module.py"
    module.write_text(
        "import placecat.report.page\nfrom placecat import thesis\n\n\ndef late():\n"
        "    from placecat.mlflow_log.store import connect\n"
    )
    assert set(rooms_used(module)) == {"report", "thesis", "mlflow_log"}
