"""What the `compute` settings choose. Invalid settings are rejected before anything runs."""

import sys

import pytest
import yaml

from placecat import compute
from placecat.compute import parallel
from placecat.compute.worker import worker_command
from placecat.errors import PlacecatError

NOWHERE = "tcp://127.0.0.1:9"
DASK = {"kind": "dask", "scheduler": NOWHERE, "wait": 5, "may_differ": []}


@pytest.fixture
def params(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("PLACECAT_WORKERS", "1")
    return lambda **own: (tmp_path / "params.yaml").write_text(yaml.safe_dump(own or {"dataset": {}}))


def squares():
    return parallel.in_parallel(pow, [(number, 2) for number in range(3)], "squares")


@pytest.mark.parametrize("own", [{}, {"compute": {"kind": "local"}}])
def test_this_machine_needs_no_dask(params, monkeypatch, own):
    for name in ("dask", "distributed"):
        monkeypatch.setitem(sys.modules, name, None)
    params(**own)
    with compute.as_set():
        assert squares() == [0, 1, 4]
        assert parallel.workers() == 1


def test_settings_are_read_only_when_needed(params):
    params(compute=DASK)
    assert squares() == [0, 1, 4]
    with compute.as_set():
        # The settings are not read either if a task must write files.
        assert parallel.in_parallel(abs, [(-1,)], "", locally=True) == [1]


@pytest.mark.parametrize(
    ("own", "message"),
    [
        ({"kind": "slurm"}, r"compute.*'slurm'.*'local', 'dask'"),
        ({"kind": "local", "scheduler": NOWHERE}, "compute has no setting 'scheduler'"),
        (DASK | {"waits": 1}, "did you mean 'wait'"),
        (DASK | {"wait": 0}, r"compute\.wait=0: it must be greater than 0"),
        (DASK | {"may_differ": ["cpu"]}, r"'cpu'.*choose from .*processor"),
        (DASK | {"scheduler": "foo"}, "missing port number in address 'foo'"),
        (DASK | {"wait": 0.2}, r"no scheduler is responding .*compute=local"),
    ],
)
def test_invalid_settings_are_rejected_in_one_line(params, own, message):
    params(compute=own)
    with pytest.raises(PlacecatError, match=message) as caught, compute.as_set():
        squares()
    assert "\n" not in str(caught.value)


def test_without_dask_the_extra_is_named(params, monkeypatch):
    params(compute=DASK)
    monkeypatch.setitem(sys.modules, "distributed", None)
    missing = r"distributed is missing\): pip install -e '\.\[dask\]'"
    with pytest.raises(PlacecatError, match=missing), compute.as_set():
        squares()
    with pytest.raises(PlacecatError, match=missing):
        worker_command(NOWHERE, [])


@pytest.mark.parametrize("value", ["0", "-1", "abc", "1.5", "2000", "9" * 5000, "\u0662"])
def test_invalid_numbers_of_processes_are_rejected(monkeypatch, value):
    monkeypatch.setenv("PLACECAT_WORKERS", value)
    with pytest.raises(PlacecatError, match=r"PLACECAT_WORKERS=.* is not a number of processes"):
        compute.local_workers()


@pytest.mark.parametrize("value", ["", " "])
def test_without_a_number_all_cores_are_used(monkeypatch, value):
    monkeypatch.setenv("PLACECAT_WORKERS", value)
    assert compute.local_workers() >= 1
