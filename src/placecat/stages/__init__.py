"""The DVC stages, one module per stage. They only read and write files; other packages do the computing."""

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

from placecat import compute, paths, settings
from placecat.compute import lifeline
from placecat.errors import PlacecatError, exiting
from placecat.runs import lock, mend, shadowed, unchanged

# A stage imports this package first, so that the measured time includes its other imports.
_STARTED = time.perf_counter()


def _use_common_kernels() -> None:
    """Make OpenBLAS use its AVX2 kernels, which all current x86-64 processors support.

    By default, OpenBLAS picks kernels to suit the processor, and their sums differ in the last bits. The
    choice must be made before NumPy is imported, so this package makes it on import. OPENBLAS_CORETYPE
    overrides it.
    """
    if os.environ.get("OPENBLAS_CORETYPE") or platform.machine() not in ("x86_64", "AMD64"):
        return
    processor = Path("/proc/cpuinfo")
    if processor.exists() and " avx2 " in processor.read_text(encoding="utf-8", errors="replace"):
        os.environ["OPENBLAS_CORETYPE"] = "Haswell"


_use_common_kernels()


def _end(kind: type[BaseException], error: BaseException, traceback: TracebackType | None) -> None:
    """Report an error raised while a stage is imported.

    For a user error, print only the message; for any other error, print a traceback. Ctrl-C is not reported.
    """
    if issubclass(kind, PlacecatError):
        print(f"placecat: {error}", file=sys.stderr)
    elif not issubclass(kind, KeyboardInterrupt):
        sys.__excepthook__(kind, error, traceback)


sys.excepthook = _end
# Hide matplotlib's message about building its font cache.
logging.getLogger("matplotlib.font_manager").setLevel(logging.ERROR)
shadowed.check()

# Start before the stage's code is imported, since the code may change a moment later. Workers skip this.
if f"{__name__}.{os.environ.get('DVC_STAGE')}" in sys.orig_argv:
    unchanged.start(os.environ["DVC_STAGE"])


def run(stage: Callable[[], None]) -> None:
    """Run a stage from the command line: ``python -m placecat.stages.NAME``.

    The settings determine whether the stage's loops run on this machine or on a cluster
    (:mod:`placecat.compute`). The stage exits with a message and status 1, without a traceback, on a user
    error, or if its dependencies change while it runs (:mod:`placecat.runs.unchanged`). On success, it writes
    its running time to data/times (:mod:`placecat.runs.times`).
    """
    from placecat.config.check import check

    argparse.ArgumentParser(description=(stage.__doc__ or "").splitlines()[0]).parse_args()
    logging.basicConfig(level=logging.WARNING, format="%(levelname)s %(message)s")
    os.environ.setdefault("MLFLOW_DISABLE_TELEMETRY", "true")
    name = Path(inspect.getfile(stage)).stem
    lifeline.end_stage_with_dvc()
    with exiting(), lock.one_at_a_time(name):
        unchanged.start(name)
        mend.keep()
        # Check again, since `dvc exp run` and editors also write params.yaml.
        if paths.PARAMS.exists():
            check(settings.load())
        with compute.as_set():
            stage()
        unchanged.check()
        # Imported late: it imports NumPy.
        from placecat.runs import times

        times.record(name, time.perf_counter() - _STARTED)
