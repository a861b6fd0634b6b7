"""A killed sweep resumes and produces the same table as an uninterrupted one. The jobs are trivial."""

import os
import random
import signal
import time
import traceback
from types import SimpleNamespace

import psutil
import pytest
from hydra.types import RunMode
from joblib.externals.loky.process_executor import TerminatedWorkerError
from omegaconf import OmegaConf

from placecat import files
from placecat.errors import PlacecatError
from placecat.experiment import combination, job, jobs, output, running, summary, sweep
from placecat.runs import lock

# Number of the job that fails, and of the job whose process is always killed.
FAILS, IS_KILLED = 3, 5
WORKERS = 2
SIGNALS = (signal.SIGKILL, signal.SIGTERM, signal.SIGINT)


class Sweep:
    """A sweep over `number` in a folder. Its workers are forks of this process."""

    def __init__(self, folder, count):
        self.folder = folder
        self.lines = [[f"number={number}"] for number in range(count)]
        self.combinations = [{"number": str(number)} for number in range(count)]
        self.config = OmegaConf.create({"hydra": {"sweep": {"dir": str(folder)}}})

    def run(self):
        with sweep.begun(self.config, self.combinations) as folder:
            jobs.run(folder, self.lines, list(range(len(self.lines))), self.launch)
            return summary.tell(folder, self.combinations, log=None)

    def launch(self, lines):
        """Run two workers, as joblib does; if one is killed, the other is killed, too."""
        workers = []
        for first in range(WORKERS):
            process = os.fork()
            if not process:
                # A fork must never continue with the tests.
                try:
                    self.work(lines[first::WORKERS])
                    os._exit(0)
                except BaseException:
                    traceback.print_exc()
                finally:
                    os._exit(1)
            workers.append(process)
        broken = False
        while workers:
            process, status = os.wait()
            workers.remove(process)
            if status:
                broken = True
                for other in workers:
                    os.kill(other, signal.SIGKILL)
        if broken:
            raise TerminatedWorkerError

    def work(self, lines):
        for number, subdir in lines:
            job.HydraConfig.get = lambda subdir=subdir: SimpleNamespace(
                runtime=SimpleNamespace(output_dir=self.folder / subdir.split("=")[1]),
                mode=RunMode.MULTIRUN,
                overrides=SimpleNamespace(task=[]),
            )
            job.job(OmegaConf.create({"number": int(number.split("=")[1])}))

    def finished(self):
        return {
            number
            for number in range(len(self.lines))
            if running.is_finished(self.folder / str(number), jobs.made_from(number))
        }


@pytest.fixture
def ran(tmp_path, monkeypatch):
    """A file that lists the numbers of all started jobs."""
    log = tmp_path / "ran.txt"
    log.write_text("")

    def compute(number, *, workers):
        with log.open("a") as file:
            file.write(f"{number}\n")
        if number == FAILS:
            raise PlacecatError("it cannot be")
        if number == IS_KILLED:
            os.kill(os.getpid(), signal.SIGKILL)
        time.sleep(0.005)
        measures = {"accuracy": number / 7, "log_loss": 1.5, "calibration_error": 20}
        return {"settings": {"number": number}, **measures, "reason": None, "homes": {}}

    monkeypatch.setattr(running, "compute", compute)
    monkeypatch.setattr(combination, "resolve", lambda config, params: config["number"])
    monkeypatch.setattr(job.HydraConfig, "get", None)
    monkeypatch.setattr(job.settings, "load", dict)
    for module in (running, jobs):
        monkeypatch.setattr(module, "made_from", lambda number: {"settings": {"number": number}})
    return log


def start(one):
    """Start a process in a separate group, without output."""
    process = os.fork()
    if not process:
        os.setsid()
        signal.signal(signal.SIGINT, signal.default_int_handler)
        null = os.open(os.devnull, os.O_WRONLY)
        os.dup2(null, 1), os.dup2(null, 2)
        try:
            one.run()
        finally:
            os._exit(1)
    # The group cannot be killed before it exists.
    while os.getpgid(process) != process:
        time.sleep(0.001)
    return process


def wait_for_workers(group):
    """Wait, since workers may finish a job before they notice that the sweep is gone."""

    def is_of_group(process):
        try:
            return os.getpgid(process.pid) == group and process.status() != psutil.STATUS_ZOMBIE
        except (ProcessLookupError, psutil.NoSuchProcess):
            return False

    while any(map(is_of_group, psutil.process_iter())):
        time.sleep(0.02)


@pytest.mark.parametrize(("count", "kills"), [(12, 2), pytest.param(60, 8, marks=pytest.mark.slow)])
def test_a_killed_sweep_resumes_with_the_uninterrupted_result(tmp_path, ran, capsys, count, kills):
    whole, one = Sweep(tmp_path / "whole", count), Sweep(tmp_path / "one", count)
    assert not whole.run()
    chance = random.Random(count)
    for number in range(kills):
        before, is_started = one.finished(), ran.read_text()
        wanted = min(count - 2, len(before) + chance.randint(0, max(1, (count - 2) * 3 // 4 // kills)))
        process = start(one)
        end = time.monotonic() + 20
        while len(one.finished()) < wanted and time.monotonic() < end:
            time.sleep(0.002)
        assert one.finished() >= before
        by = SIGNALS[number % 3]
        (os.kill if number % 2 else os.killpg)(process, by)
        os.waitpid(process, 0)
        wait_for_workers(process)
        again = ran.read_text()[len(is_started) :].split()
        assert not before & set(map(int, again))
    before, is_started = one.finished(), ran.read_text()
    assert not one.run()
    again = list(map(int, ran.read_text()[len(is_started) :].split()))
    assert set(again) == set(range(count)) - before
    assert (one.folder / output.SUMMARY).read_bytes() == (whole.folder / output.SUMMARY).read_bytes()
    notes = files.read_table(one.folder / output.SUMMARY, ["note"])["note"]
    assert {number: note for number, note in enumerate(notes) if note} == {
        FAILS: "it cannot be",
        IS_KILLED: output.KILLED,
    }
    assert f"number={IS_KILLED}: failed: {output.KILLED}" in capsys.readouterr().out


def test_a_second_sweep_waits_and_finds_all_jobs_finished(tmp_path, ran, capfd):
    one = Sweep(tmp_path / "one", 3)
    one.folder.mkdir()
    with lock.waiting(one.folder / ".lock", ""):
        process = os.fork()
        if not process:
            one.run()
            os._exit(0)
        while "waiting for it" not in capfd.readouterr().err:
            time.sleep(0.1)
        assert not ran.read_text()
        assert not (one.folder / "0").exists()
    os.waitpid(process, 0)
    assert one.run()
    assert sorted(ran.read_text().split()) == ["0", "1", "2"]
    assert "3 of 3 experiments in " in capfd.readouterr().out


@pytest.mark.parametrize(
    "content", ['{"accuracy": 1.0, "settings": {"number": 2}}', '{"acc', '{"failed": "x", "settings": {}}']
)
def test_a_result_with_another_origin_is_not_finished(tmp_path, content):
    (tmp_path / output.RESULT).write_text(content)
    assert not running.is_finished(tmp_path, {"settings": {"number": 1}})


def test_a_damaged_result_is_reported(tmp_path):
    (tmp_path / "0").mkdir()
    (tmp_path / "0" / output.RESULT).write_text('{"acc')
    (ran,) = summary.read(tmp_path, [{}])
    assert "is damaged: remove it" in ran.result[output.FAILED]
