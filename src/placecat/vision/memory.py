"""Keep freed memory in the process, so that each frame reuses the same pages."""

import numpy as np


def keep_freed_memory() -> None:
    """Let glibc keep up to 62 MiB of freed memory instead of returning it to the system.

    The maps of a frame take up about ten megabytes and are freed before the next frame. By default, glibc
    returns blocks of this size to the system, and touching 3,000 new pages per frame takes as long as
    computing their content. Freeing one large, untouched block raises the threshold above which it does so.
    The threshold can rise to 32 MiB, and glibc keeps twice that amount (see M_MMAP_THRESHOLD in mallopt(3)).
    This has no effect with other C libraries.
    """
    block = np.empty(31 << 20, np.uint8)
    del block
