import gc
import json
import os
import sys
from pathlib import Path

import hypothesis
import pytest
from filelock import FileLock

# pytest has one process per core, so more threads would wait for each other. NumPy reads this on import.
for _name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS"):
    os.environ.setdefault(_name, "1")

import placecat.stages  # noqa: E402, F401  before NumPy: it chooses the OpenBLAS kernels

# Folders with helper modules for tests.
_FOLDERS = "categorizer experiment footage homes replication runs schema sequences stages thesis vision"
for _folder in (".", "campaign", *_FOLDERS.split(), "vision/networks"):
    sys.path.insert(0, str(Path(__file__).parent / _folder))

from number_of_examples import IN_FULL  # noqa: E402  its folder was just added to the path

# Fixtures that run DVC, a server, a browser, the renderer or worker processes. Tests that use them are slow.
SLOW = {"clone", "committed", "experiments", "film", "ran", "reproduced", "server", "two_workers"}

# There is no deadline, since the time for an example depends on how busy the machine is.
hypothesis.settings.register_profile("placecat", max_examples=IN_FULL, deadline=None)
# This profile is for `make test-quick`, which sets --hypothesis-profile.
hypothesis.settings.register_profile("quick", max_examples=IN_FULL // 4, deadline=None)
hypothesis.settings.load_profile("placecat")


# Collecting tests creates a million permanent objects; searching them for garbage would take seconds.
gc.disable()


def pytest_collection_finish(session):
    gc.freeze()
    gc.enable()


# This must run before pytest-xdist, which recognizes a group by the end of a test name.
@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items):
    """Mark slow tests, group tests that share fixtures of their module, and sort all tests.

    The longest group comes first. Next come the other groups, then tests that wait for the longest group, and
    then modules whose tests form a group. Single tests come last and keep both workers busy to the end.
    """
    turns = {}
    for item in items:
        if SLOW & set(getattr(item, "fixturenames", ())):
            item.add_marker("slow")
        turns[item] = _turn(item)
        if turns[item] == 4 and _has_fixture_of_module(item):
            # One worker runs all of these tests, since each worker would make its own fixture.
            item.add_marker(pytest.mark.xdist_group(item.nodeid.partition("::")[0]))
            turns[item] = 3
    items.sort(key=turns.get)


def _turn(item):
    groups = {mark.args[0] for mark in item.iter_markers("xdist_group")}
    if "later" in groups:
        return 2
    return 0 if "pipeline" in groups else 1 if groups else 4


def _has_fixture_of_module(item):
    """Return whether a test uses a module-scoped fixture of its module."""
    module = item.nodeid.partition("::")[0]
    fixtures = getattr(item, "_fixtureinfo", None)
    of_name = fixtures.name2fixturedefs if fixtures else {}
    return any(one.scope == "module" and one.baseid == module for all_ in of_name.values() for one in all_)


@pytest.fixture
def two_workers(monkeypatch):
    """Use two new worker processes, since those of an earlier test may still be in its folder."""
    from joblib.externals.loky import get_reusable_executor

    get_reusable_executor().shutdown(wait=True)
    monkeypatch.setenv("PLACECAT_WORKERS", "2")
    yield
    get_reusable_executor().shutdown(wait=True)


@pytest.fixture(scope="session")
def reproduced(tmp_path_factory):
    """The entire pipeline, run with DVC on small drawn homes, once for all workers.

    Returns the folder, the stages that ran and the output of DVC. Tests that change the folder copy it.
    """
    from project import copy_project, repro

    shared = tmp_path_factory.getbasetemp()
    if "PYTEST_XDIST_WORKER" in os.environ:
        shared = shared.parent
    folder, said = shared / "reproduced", shared / "reproduced.json"
    with FileLock(shared / "reproduced.lock"):
        if not said.exists():
            folder.mkdir()
            copy_project(folder)
            # One worker is faster than two, because it starts faster and there is little to do.
            ran, result = repro(folder, PLACECAT_WORKERS="1")
            said.write_text(json.dumps([ran, result.stdout]))
    ran, output = json.loads(said.read_text())
    return folder, ran, output
