import sys
from pathlib import Path

import pytest

import placecat.stages  # noqa: F401  before NumPy: it chooses the kernels of OpenBLAS

# Helpers of the tests: modules without tests in these folders.
for _folder in (".", "categorizer", "homes", "sequences", "stages", "thesis", "vision", "vision/networks"):
    sys.path.insert(0, str(Path(__file__).parent / _folder))


def pytest_collection_modifyitems(items):
    """Put the longest group first, so that the other worker does the rest meanwhile."""
    items.sort(key=lambda item: ("pipeline",) not in [mark.args for mark in item.iter_markers("xdist_group")])


@pytest.fixture
def two_workers(monkeypatch):
    """Two new worker processes: those of an earlier test may be in a folder that this one has left."""
    from joblib.externals.loky import get_reusable_executor

    get_reusable_executor().shutdown(wait=True)
    monkeypatch.setenv("PLACECAT_WORKERS", "2")
    yield
    get_reusable_executor().shutdown(wait=True)


@pytest.fixture(scope="session")
def reproduced(tmp_path_factory):
    """The whole pipeline run once, through DVC, on small drawn homes. Tests that change it copy it."""
    from project import copy_project, repro

    folder = copy_project(tmp_path_factory.mktemp("reproduced"))
    # One worker starts faster than two where there is little to do.
    ran, result = repro(folder, PLACECAT_WORKERS="1")
    return folder, ran, result
