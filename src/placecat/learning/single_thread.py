"""Limit BLAS to one thread."""

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from typing import Any

# The BLAS libraries of numpy and scipy must be loaded before they can be listed.
import numpy as np  # noqa: F401
import scipy.linalg  # noqa: F401
from threadpoolctl import ThreadpoolController

_lock = threading.Lock()
_users = 0
_limit: Any = None


@cache
def _libraries() -> ThreadpoolController:
    # Listing the libraries takes 30 times as long as setting their thread counts.
    return ThreadpoolController()


@contextmanager
def single_blas_thread() -> Iterator[None]:
    """Limit BLAS to one thread, so that sums do not depend on the number of cores.

    The limit applies to the entire process. The first of several concurrent users sets it, and the last one
    removes it.
    """
    global _users, _limit
    with _lock:
        if _users == 0:
            _limit = _libraries().limit(limits=1, user_api="blas")
        _users += 1
    try:
        yield
    finally:
        with _lock:
            _users -= 1
            if _users == 0:
                _limit.restore_original_limits()
