"""A real scheduler and two workers. One is killed midway, and the results equal those of a local run."""

import os
import shutil
import signal
import subprocess
import sys
import time

import pytest
import yaml

from placecat import compute, files
from placecat.compute import connection, parallel
from placecat.errors import PlacecatError
from placecat.settings import read_yaml
from placecat.stages import cues, features, sequences
from project import ROOT, contents, environment
from sketch import draw_homes

HOMES = ("Home1", "Home2", "Home3")
# The name that Dask gives to the tasks.
TASKS = "perform"

pytestmark = [pytest.mark.slow, pytest.mark.xdist_group("cluster")]


def parameters():
    """Return the project's settings, reduced to two descriptors, one cue and three drawn homes."""
    params = read_yaml(ROOT / "params.yaml")
    own = {
        name: params[name] for name in ("attention", "regions", "region_variants", "information", "protocol")
    }
    own["dataset"] = yaml.safe_load((ROOT / "conf/dataset/my_homes.yaml").read_text())
    own["dataset"] |= {"root": "data/drawn", "homes": list(HOMES), "fps": 5.0}
    own["descriptors"] = {
        "local": {"hog": params["descriptors"]["local"]["hog"]},
        "holistic": {"gist": params["descriptors"]["holistic"]["gist"]},
    }
    own["cues"] = {
        "gist": params["cues"]["gist"] | {"schemes": ["5-5-1"], "cross_validate": False, "extra": False}
    }
    return own


@pytest.fixture(scope="module")
def local(tmp_path_factory):
    """A project after the stages have run on this machine."""
    folder = tmp_path_factory.mktemp("local")
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        patch.setenv("PLACECAT_WORKERS", "1")
        files.write_text(folder / "params.yaml", yaml.safe_dump(parameters()))
        # Home1 is described on the cluster and has several tasks for each worker.
        size = {"width": 320, "height": 180}
        draw_homes(folder / "data/drawn", homes=1, frames_per_room=18, **size)
        draw_homes(folder / "data/small", homes=3, frames_per_room=4, **size)
        for home in HOMES[1:]:
            (folder / "data/small" / home).rename(folder / "data/drawn" / home)
        sequences.main()
        features.main()
        cues.main()
    return folder


class Processes:
    """The processes of a cluster, and queries to its scheduler."""

    def __init__(self, folder):
        self.folder = folder
        # Start all processes outside the project, since it must not matter where a worker is started.
        self.scheduler = self.start("distributed.cli.dask_scheduler", *["--host", "127.0.0.1", "--port", "0"])
        log = folder / "0.log"
        wait_for(lambda: "Scheduler at:" in log.read_text())
        self.address = log.read_text().split("Scheduler at:")[1].split()[0]
        options = ("worker", self.address, "--nworkers", "1", "--no-nanny")
        # Two separate commands start the workers, so that a killed worker is not restarted.
        self.workers = [self.start("placecat", *options) for _ in range(2)]
        self.client = None

    def connect(self):
        """Wait until both workers have joined."""
        from distributed import Client

        self.client = Client(self.address, set_as_default=False)
        self.client.wait_for_workers(2, timeout=60)
        self.worker_of = {pid: worker for worker, pid in self.client.run(os.getpid).items()}

    def start(self, module, *arguments):
        number = len(list(self.folder.iterdir()))
        with (self.folder / f"{number}.log").open("w") as log:
            return subprocess.Popen(
                [sys.executable, "-m", module, *arguments],
                cwd=self.folder,
                env=environment(),
                stdout=log,
                stderr=subprocess.STDOUT,
            )

    def is_executing(self, process):
        """Return whether a worker is running a task."""

        def count(dask_worker):
            return len(dask_worker.state.executing)

        worker = self.worker_of[process.pid]
        return self.client.run(count, workers=[worker])[worker] > 0

    def has_tasks_of(self, process):
        """Return whether the scheduler is waiting for a worker."""

        def count(address, dask_scheduler):
            return len(dask_scheduler.workers[address].processing)

        return self.client.run_on_scheduler(count, self.worker_of[process.pid]) > 0

    def done(self):
        """Map the key of each finished task to whether the task was first taken away from a worker."""

        def read(name, dask_scheduler):
            taken, done = set(), {}
            for key, start, finish, *_ in dask_scheduler.transition_log:
                if str(key).startswith(name) and start == "processing":
                    if finish == "memory":
                        done[key] = key in taken
                    else:
                        taken.add(key)
            return done

        return self.client.run_on_scheduler(read, TASKS)

    def tasks(self):
        """Return the number of tasks known to the scheduler."""
        return self.client.run_on_scheduler(lambda dask_scheduler: len(dask_scheduler.tasks))

    def end(self):
        if self.client is not None:
            self.client.close()
        for process in (*self.workers, self.scheduler):
            process.kill()
            process.wait()


@pytest.fixture(scope="module")
def cluster(tmp_path_factory):
    processes = Processes(tmp_path_factory.mktemp("elsewhere"))
    yield processes
    processes.end()


@pytest.fixture(scope="module")
def project(cluster, local, tmp_path_factory):
    """A copy of the project without cues and without features of Home1, set up for the cluster."""
    cluster.connect()
    folder = tmp_path_factory.mktemp("cluster") / "project"
    shutil.copytree(local, folder)
    shutil.rmtree(folder / "data/features/Home1")
    shutil.rmtree(folder / "data/cues")
    own = {"kind": "dask", "scheduler": cluster.address, "wait": 20, "may_differ": []}
    files.write_text(folder / "params.yaml", yaml.safe_dump(parameters() | {"compute": own}))
    return folder


def wait_for(condition, seconds=60):
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end
        time.sleep(0.01)


def stage(folder, name):
    return subprocess.Popen(
        [sys.executable, "-m", f"placecat.stages.{name}"],
        cwd=folder,
        env=environment(),
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        start_new_session=True,
        # If the tests run in the background of a shell, they ignore SIGINT, and child processes inherit this.
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )


def test_ctrl_c_cancels_the_tasks_on_the_cluster(cluster, project):
    process = stage(project, "features")
    wait_for(lambda: any(map(cluster.is_executing, cluster.workers)) or process.poll() is not None)
    os.killpg(process.pid, signal.SIGINT)
    said, _ = process.communicate(timeout=60)
    assert process.returncode == 130, said
    assert "Traceback" not in said
    wait_for(lambda: cluster.tasks() == 0)
    assert not (project / "data/compute").exists()


def test_a_worker_killed_half_way_leaves_the_bytes_of_a_local_run(cluster, project, local):
    doomed, other = cluster.workers
    # Wait until cancelled tasks have ended.
    wait_for(lambda: not any(map(cluster.is_executing, cluster.workers)))
    before = cluster.done()
    process = stage(project, "features")
    while True:
        wait_for(lambda: cluster.is_executing(doomed) or process.poll() is not None)
        # While it is stopped, it can neither finish its task nor report it, but the other worker continues.
        doomed.send_signal(signal.SIGSTOP)
        wait_for(lambda: len(cluster.done()) > len(before) or process.poll() is not None)
        if cluster.has_tasks_of(doomed) or process.poll() is not None:
            break
        doomed.send_signal(signal.SIGCONT)
    assert process.poll() is None, process.communicate()[0]
    doomed.kill()
    doomed.wait()
    said, _ = process.communicate(timeout=60)
    assert process.returncode == 0, said
    assert any(was_taken for key, was_taken in cluster.done().items() if key not in before)
    assert other.poll() is None
    assert contents(project, "data/features") == contents(local, "data/features")


def test_one_worker_trains_a_cue_with_the_bytes_of_a_local_run(cluster, project, local, monkeypatch):
    monkeypatch.chdir(project)
    before = cluster.done()
    with compute.as_set():
        cues.main()
    # Each fold is a task, and none of them runs in this process.
    assert len(cluster.done()) == len(before) + len(HOMES)
    assert contents(project, "data/cues") == contents(local, "data/cues")


def test_a_worker_in_another_environment_is_named(cluster, project, monkeypatch):
    monkeypatch.chdir(project)
    own = connection.fingerprint() | {"numpy": "1.0"}
    monkeypatch.setattr(connection, "fingerprint", lambda: own)
    with pytest.raises(PlacecatError) as caught, compute.as_set():
        parallel.in_parallel(print, [("nothing",)], "")
    message = str(caught.value)
    for part in (
        cluster.worker_of[cluster.workers[1].pid],
        "numpy (2.",
        "1.0 here",
        "placecat worker tcp://",
    ):
        assert part in message, message
    files.write_text(project / "params.yaml", (project / "params.yaml").read_text().replace("[]", "[numpy]"))
    with compute.as_set():
        assert parallel.in_parallel(os.getpid, [()], "") == [cluster.workers[1].pid]


def test_a_task_that_kills_workers_ends_with_one_message(cluster, project, monkeypatch):
    """This must be the last test, since it leaves no workers."""
    monkeypatch.chdir(project)
    settings = {"scheduler": cluster.address, "wait": 1}
    cluster.client.run_on_scheduler(lambda dask_scheduler: setattr(dask_scheduler, "allowed_failures", 0))
    one = connection.Cluster(**settings)
    with pytest.raises(
        PlacecatError, match=r"1 workers? died while running the same task, the last one tcp://"
    ):
        list(one.run(os._exit, [(9,)]))
    with pytest.raises(PlacecatError, match="the cluster has had no workers for 1 s: start some"):
        list(one.run(os.getpid, [()]))
    one.close()
    with pytest.raises(PlacecatError, match=f"the cluster at {cluster.address} has no workers"):
        connection.Cluster(**settings)
