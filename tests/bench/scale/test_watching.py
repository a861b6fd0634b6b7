import sys

import pytest

from placecat.errors import PlacecatError
from placecat_bench.scale.watching import watch

# A process with 60 MiB and a child process with another 60 MiB run at the same time for a while.
FAMILY = """
import subprocess, sys, time
own = bytearray(60 * 2**20)
if len(sys.argv) > 1:
    child = subprocess.Popen([sys.executable, sys.argv[0]])
    child.wait()
else:
    until = time.process_time() + 0.3
    while time.process_time() < until:
        pass
    time.sleep(0.6)
"""


def test_memory_and_time_include_all_processes(tmp_path):
    (tmp_path / "family.py").write_text(FAMILY)
    found = watch([sys.executable, "family.py", "parent"], tmp_path, tmp_path / "log")
    assert 120 / 1024 < found.peak_gib < 0.25
    assert 0.3 <= found.cpu_seconds < found.seconds


def test_a_failed_command_is_reported_with_its_last_line(tmp_path):
    command = [sys.executable, "-c", "print('one'); import sys; sys.exit('the end')"]
    with pytest.raises(PlacecatError, match="status 1: the end"):
        watch(command, tmp_path, tmp_path / "logs/log")
