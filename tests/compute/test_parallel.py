"""Loops in which processes die."""

import os
import signal
import subprocess
import sys
import time
import traceback

import psutil
import pytest
from made_pipeline import wait_for

from placecat.compute import parallel
from placecat.errors import PlacecatError, exiting


def _die(number):
    if number == 2:
        os.kill(os.getpid(), signal.SIGKILL)
    return number


def _want_too_much(number):
    raise MemoryError


def test_a_killed_worker_gives_one_message_that_names_the_task(two_workers):
    with pytest.raises(PlacecatError, match=r"features of home_1: a worker process was killed.*WORKERS=1"):
        parallel.in_parallel(_die, [(number,) for number in range(4)], "features of home_1")


@pytest.mark.parametrize(("jobs", "remedy"), [(1, "with more memory"), (2, "PLACECAT_WORKERS=1")])
def test_a_task_without_memory_gives_one_message_that_names_the_task(two_workers, jobs, remedy):
    with pytest.raises(PlacecatError, match=rf"features of home_1: memory ran out.*{remedy}"):
        parallel.in_parallel(_want_too_much, [(1,), (2,)], "features of home_1", n_jobs=jobs)


def _unheard():
    return signal.SIGINT in signal.pthread_sigmask(signal.SIG_BLOCK, [])


def test_only_workers_ignore_ctrl_c(two_workers):
    assert parallel.in_parallel(_unheard, [(), ()], "work") == [True, True]
    assert not _unheard()


def test_ctrl_c_between_two_results_ends_the_workers_without_a_word(two_workers, recwarn):
    def consume():
        for _ in parallel.stream(time.sleep, [(0.01,)] * 200, "work", n_jobs=2):
            # More results arrive, and nobody uses them.
            time.sleep(0.2)
            raise KeyboardInterrupt

    with pytest.raises(SystemExit) as caught, exiting():
        consume()
    interrupt = caught.value.__context__
    assert isinstance(interrupt, KeyboardInterrupt)
    frames = [frame for frame, _ in traceback.walk_tb(interrupt.__traceback__)]
    assert frames[-1].f_code.co_name == "consume"
    # The loop is gone, although the exception still has its frame.
    assert frames[-1].f_locals == {}
    assert not [warning for warning in recwarn if "executed" in str(warning.message)]


# One call writes the number and the line break, so that two workers cannot mix them.
LOOP = """
import os, time
from placecat.compute import parallel
def work(number):
    os.write(1, b"%d\\n" % os.getpid())
    time.sleep(60)
parallel.in_parallel(work, [(1,), (2,)], "work", n_jobs=2)
"""


@pytest.mark.slow
def test_workers_end_with_a_killed_process():
    process = subprocess.Popen([sys.executable, "-c", LOOP], stdout=subprocess.PIPE, text=True)
    workers = [psutil.Process(int(process.stdout.readline())) for _ in range(2)]
    process.kill()
    process.wait()
    for worker in workers:
        wait_for(lambda one=worker: not one.is_running() or one.status() == psutil.STATUS_ZOMBIE, 10)
