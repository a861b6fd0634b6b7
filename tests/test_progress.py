"""The progress line, in a terminal and in a log."""

import os
import re
import subprocess
import sys

import pytest

pty = pytest.importorskip("pty")

LOOP = """
import time
from placecat import progress
progress.IN_LOG = 0.1
name = "frames of a home with a long name"
for _ in progress.Progress(range(40), description=name, total=40, unit="tasks"):
    time.sleep(0.02)
print("done", flush=True)
"""


def in_terminal(program, columns):
    """Return the output of a program to a terminal of the given width."""
    import fcntl
    import struct
    import termios

    ours, its = pty.openpty()
    fcntl.ioctl(its, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
    process = subprocess.Popen([sys.executable, "-c", program], stdout=its, stderr=its, stdin=its)
    os.close(its)
    written = b""
    try:
        while part := os.read(ours, 4096):
            written += part
    # Reading from a terminal fails after its programs have ended.
    except OSError:
        pass
    os.close(ours)
    assert process.wait() == 0
    return written.decode()


@pytest.mark.parametrize("columns", [110, 60])
def test_a_terminal_shows_one_line_that_disappears_at_the_end(columns):
    written = in_terminal(LOOP, columns)
    before, _, after = written.rpartition("done")
    assert after == "\r\n"
    assert "\n" not in before
    states = [state for state in before.split("\r") if state.strip()]
    assert len(states) > 2
    assert max(map(len, states)) < columns
    assert re.search(r"frames of a home with a long name: +\d+% .*", states[-1])
    if columns > 100:
        assert re.search(r"\d+ of 40 tasks, 0\d:\d\d left", states[-1])
    # The last state is overwritten.
    assert before.endswith("\r") and not before.split("\r")[-2].strip()


def test_a_log_contains_occasional_lines():
    result = subprocess.run([sys.executable, "-c", LOOP], capture_output=True, text=True, check=True)
    lines = result.stderr.splitlines()
    assert 2 <= len(lines) < 40
    assert "\r" not in result.stderr
    for line in lines:
        assert re.fullmatch(r"frames of a home with a long name: \d+ of 40 tasks, 0\d:\d\d left", line)


def test_a_short_loop_leaves_no_line_in_a_log():
    program = LOOP.replace("0.1", "60")
    result = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert (result.stdout, result.stderr) == ("done\n", "")


def test_without_a_total_the_steps_are_counted():
    program = LOOP.replace("total=40", "total=None")
    result = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert re.match(r"frames of a home with a long name: \d+ tasks, [\d.]+ tasks/s\n", result.stderr)
