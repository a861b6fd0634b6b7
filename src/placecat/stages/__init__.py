"""The DVC stages, one module each, with the same name: they read and write files, other packages compute."""

import argparse
import inspect
import logging
import os
import platform
import sys
import time
from collections.abc import Callable
from pathlib import Path
from types import TracebackType

from placecat import compute, shadowed
from placecat.errors import PlacecatError, exiting
from placecat.runs import lifeline, lock, mend, unchanged

# A stage imports this package first, so its time includes its own imports.
_STARTED = time.perf_counter()


def _use_common_kernels() -> None:
    """Make OpenBLAS use its AVX2 kernels, which all current x86-64 processors support.

    By default the kernels depend on the processor, and their sums differ in the last bits. This must happen
    before NumPy is imported, so it happens when this package is imported. OPENBLAS_CORETYPE overrides it.
    """
    if os.environ.get("OPENBLAS_CORETYPE") or platform.machine() not in ("x86_64", "AMD64"):
        return
    processor = Path("/proc/cpuinfo")
    if processor.exists() and " avx2 " in processor.read_text(encoding="utf-8", errors="replace"):
        os.environ["OPENBLAS_CORETYPE"] = "Haswell"


_use_common_kernels()


def _end(kind: type[BaseException], error: BaseException, traceback: TracebackType | None) -> None:
    """Print the traceback of an error in a stage's imports, except for a user's mistake or Ctrl-C."""
    if issubclass(kind, PlacecatError):
        print(f"placecat: {error}", file=sys.stderr)
    elif not issubclass(kind, KeyboardInterrupt):
        sys.__excepthook__(kind, error, traceback)


sys.excepthook = _end
# Hide the message that matplotlib builds its font cache.
logging.getLogger("matplotlib.font_manager").setLevel(logging.ERROR)
shadowed.check()

# Before the stage's code is imported, since it may change a moment later. Not in workers.
if f"{__name__}.{os.environ.get('DVC_STAGE')}" in sys.orig_argv:
    unchanged.start(os.environ["DVC_STAGE"])


def _check_settings() -> None:
    """Refuse impossible settings again, since `dvc exp run` and editors also write params.yaml."""
    from placecat import paths, settings
    from placecat.check import check

    if paths.PARAMS.exists():
        check(settings.load())


def run(stage: Callable[[], None]) -> None:
    """Run a stage from the command line: ``python -m placecat.stages.NAME``.

    Its loops run on this machine or a cluster, by the settings (:mod:`placecat.compute`). After a user's
    mistake, or if its dependencies change meanwhile (:mod:`placecat.runs.unchanged`), it ends with a message
    and status 1, without a traceback. After success, its time is written to data/times
    (:mod:`placecat.times`).
    """
    argparse.ArgumentParser(description=(stage.__doc__ or "").splitlines()[0]).parse_args()
    logging.basicConfig(level=logging.WARNING, format="%(levelname)s %(message)s")
    os.environ.setdefault("MLFLOW_DISABLE_TELEMETRY", "true")
    name = Path(inspect.getfile(stage)).stem
    lifeline.end_stage_with_dvc()
    with exiting(), lock.one_at_a_time(name):
        unchanged.start(name)
        mend.keep()
        _check_settings()
        with compute.as_set():
            stage()
        unchanged.check()
        # Late, since it imports NumPy.
        from placecat import times

        times.record(name, time.perf_counter() - _STARTED)
