"""Freed memory stays in the process, so that frame after frame uses the same pages."""

import numpy as np


def keep_freed_memory() -> None:
    """Let glibc keep up to 62 MiB of freed memory instead of returning it to the system.

    The maps of a frame take some ten megabytes, freed before the next frame. glibc returns such blocks, and
    touching 3,000 new pages per frame takes as long as computing their content. Freeing one large block,
    which is never touched, raises the threshold (mallopt(3), M_MMAP_THRESHOLD: it adapts, up to 32 MiB, and
    twice as much is kept). Other C libraries are left alone.
    """
    block = np.empty(31 << 20, np.uint8)
    del block
