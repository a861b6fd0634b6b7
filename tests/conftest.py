import gc
import json
import os
import sys
from pathlib import Path

import hypothesis
import pytest
from filelock import FileLock

# pytest has a process for each core: more threads would wait for each other. NumPy reads this on import.
for _name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS"):
    os.environ.setdefault(_name, "1")

import placecat.stages  # noqa: E402, F401  before NumPy: it chooses the kernels of OpenBLAS

# Helpers of the tests: modules without tests in these folders.
_FOLDERS = "categorizer experiment footage homes replication runs schema sequences stages thesis vision"
for _folder in (".", "campaign", *_FOLDERS.split(), "vision/networks"):
    sys.path.insert(0, str(Path(__file__).parent / _folder))

from number_of_examples import IN_FULL  # noqa: E402  in a folder that was just added

# Fixtures that run DVC, a server, a browser, the renderer or worker processes: what asks for one is slow.
SLOW = {"clone", "committed", "experiments", "film", "ran", "reproduced", "server", "two_workers"}

# No deadline: how long an example takes says how busy the machine is.
hypothesis.settings.register_profile("placecat", max_examples=IN_FULL, deadline=None)
# For `make test-quick`, with --hypothesis-profile.
hypothesis.settings.register_profile("quick", max_examples=IN_FULL // 4, deadline=None)
hypothesis.settings.load_profile("placecat")


# Collecting makes a million objects that all stay: looking for garbage among them takes seconds.
gc.disable()


def pytest_collection_finish(session):
    gc.freeze()
    gc.enable()


# Before pytest-xdist, which tells groups by what ends a test's name.
@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items):
    """Mark what is slow, put the tests of a module together that share its fixtures, and order all.

    The longest group comes first, then the other groups, then what waits for the longest, then modules whose
    tests are together, and last single tests, which keep both workers busy to the end.
    """
    turns = {}
    for item in items:
        if SLOW & set(getattr(item, "fixturenames", ())):
            item.add_marker("slow")
        turns[item] = _turn(item)
        if turns[item] == 4 and _has_fixture_of_module(item):
            # One worker for all: each worker would make the fixture anew.
            item.add_marker(pytest.mark.xdist_group(item.nodeid.partition("::")[0]))
            turns[item] = 3
    items.sort(key=turns.get)


def _turn(item):
    groups = {mark.args[0] for mark in item.iter_markers("xdist_group")}
    if "later" in groups:
        return 2
    return 0 if "pipeline" in groups else 1 if groups else 4


def _has_fixture_of_module(item):
    """Whether a test needs a fixture of its module that is made once."""
    module = item.nodeid.partition("::")[0]
    fixtures = getattr(item, "_fixtureinfo", None)
    of_name = fixtures.name2fixturedefs if fixtures else {}
    return any(one.scope == "module" and one.baseid == module for all_ in of_name.values() for one in all_)


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
    """The whole pipeline run once for all workers, through DVC, on small drawn homes.

    Gives its folder, the stages that ran and what DVC said. Tests that change the folder copy it.
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
            # One worker starts faster than two where there is little to do.
            ran, result = repro(folder, PLACECAT_WORKERS="1")
            said.write_text(json.dumps([ran, result.stdout]))
    ran, output = json.loads(said.read_text())
    return folder, ran, output
