import platform
import subprocess
import sys

import pytest

SCRIPT = """
import resource, sys
import numpy as np
from placecat.vision.memory import keep_freed_memory
if sys.argv[1] == "keep":
    keep_freed_memory()
def frame():
    return [np.ones(300_000, np.float32) for _ in range(12)]
frame()
before = resource.getrusage(resource.RUSAGE_SELF).ru_minflt
for _ in range(10):
    frame()
print(resource.getrusage(resource.RUSAGE_SELF).ru_minflt - before)
"""


@pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="glibc's allocator is meant")
def test_no_new_pages_after_the_first_frame():
    faults = {
        mode: int(
            subprocess.run([sys.executable, "-c", SCRIPT, mode], check=True, capture_output=True).stdout
        )
        for mode in ("keep", "plain")
    }
    assert faults["keep"] < 100
    assert faults["plain"] > 10 * faults["keep"]
