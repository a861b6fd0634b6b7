"""A process ends together with the process that started it."""

import signal
import subprocess
import sys

import psutil
from made_pipeline import wait_for

CHILD = """
import os, time
from placecat.compute import lifeline
lifeline.end_with(os.getppid())
print(os.getpid(), flush=True)
time.sleep(60)
"""
PARENT = "import subprocess, sys; subprocess.run([sys.executable, '-c', sys.argv[1]])"
STAGE = """
import time
from placecat.compute import lifeline
lifeline.end_stage_with_dvc()
try:
    print("ready", flush=True)
    time.sleep(60)
except KeyboardInterrupt:
    time.sleep(1)
    print("tidied", flush=True)
"""


def start(*command):
    return subprocess.Popen([sys.executable, "-c", *command], stdout=subprocess.PIPE, text=True)


def test_a_child_of_a_killed_process_ends():
    parent = start(PARENT, CHILD)
    child = psutil.Process(int(parent.stdout.readline()))
    parent.kill()
    parent.wait()
    wait_for(lambda: not child.is_running() or child.status() == psutil.STATUS_ZOMBIE, 10)


def test_a_stage_tidies_up_once_whichever_signals_come():
    for signals in ((signal.SIGTERM,), (signal.SIGINT, signal.SIGTERM), (signal.SIGTERM, signal.SIGINT)):
        stage = start(STAGE)
        assert stage.stdout.readline() == "ready\n"
        for number in signals:
            stage.send_signal(number)
        assert stage.communicate(timeout=20)[0] == "tidied\n"
        assert stage.returncode == 0
