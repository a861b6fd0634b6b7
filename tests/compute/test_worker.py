"""Which workers are rejected, and why."""

import os
import pickle
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from joblib import Parallel, delayed

from placecat.compute import worker
from placecat.compute.fingerprint import fingerprint
from placecat.errors import PlacecatError

SCHEDULER = "tcp://10.0.0.1:8786"
FITTING = SimpleNamespace(address="tcp://10.0.0.7:4567", state=SimpleNamespace(nthreads=1))


@pytest.fixture
def expected(tmp_path):
    def make(may_differ=(), folder=tmp_path, **changed):
        mark = tmp_path / "data/compute/mark"
        mark.parent.mkdir(parents=True, exist_ok=True)
        mark.touch()
        return worker.Expected(
            SCHEDULER, str(folder), "data/compute/mark", fingerprint() | changed, may_differ
        )

    worker._seen.clear()
    yield make
    worker._seen.clear()


def test_a_worker_like_this_process_is_accepted(expected):
    assert worker.objection(expected(), FITTING) is None


@pytest.mark.parametrize("item", fingerprint())
def test_a_difference_is_named_with_both_sides_and_a_remedy(expected, item):
    own = fingerprint()[item]
    said = worker.objection(expected(**{item: "other"}), FITTING)
    assert f"worker {FITTING.address} differs from this machine in {item} ({own} there, other here)" in said
    assert f"`placecat worker {SCHEDULER}`" in said
    assert worker.objection(expected(may_differ=(item,), **{item: "other"}), FITTING) is None


def test_a_worker_with_several_threads_is_refused(expected):
    several = SimpleNamespace(address=FITTING.address, state=SimpleNamespace(nthreads=4))
    assert "has 4 threads" in worker.objection(expected(), several)


def test_a_different_folder_is_rejected(expected, tmp_path):
    (tmp_path / "copy").mkdir()
    said = worker.objection(expected(folder=tmp_path / "copy"), FITTING)
    assert f"cannot see the project folder {tmp_path / 'copy'}" in said


def test_the_kernels_in_use_are_compared():
    """The requested kernels do not count: the request may come too late, or they may be unavailable."""
    assert os.environ.get("OPENBLAS_CORETYPE", "") in fingerprint()["BLAS"]
    assert np.__version__ == fingerprint()["numpy"]


def where():
    """Return the working directory, and the processes in which a loop within a task runs."""
    return Path.cwd(), set(Parallel(n_jobs=None)(delayed(os.getpid)() for _ in range(3)))


def test_a_task_runs_in_the_project_folder_and_in_one_process(expected, tmp_path, monkeypatch):
    monkeypatch.setattr("distributed.get_worker", lambda: FITTING)
    before = Path.cwd()
    found = pickle.loads(worker.perform(expected(), pickle.dumps((where, ()))))
    assert found == (tmp_path, {os.getpid()})
    assert Path.cwd() == before


def test_a_task_refuses_a_worker_that_joined_later(expected, monkeypatch):
    monkeypatch.setattr("distributed.get_worker", lambda: FITTING)
    with pytest.raises(PlacecatError, match="differs from this machine in scipy"):
        worker.perform(expected(scipy="0"), pickle.dumps((print, ("nothing",))))


def test_arrays_come_back_writable(expected, monkeypatch):
    monkeypatch.setattr("distributed.get_worker", lambda: FITTING)
    found = pickle.loads(worker.perform(expected(), pickle.dumps((np.zeros, (3,)))))
    found += 1
    assert found.tolist() == [1, 1, 1]
