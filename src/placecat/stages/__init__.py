"""One module a DVC stage, of the same name: files in, files out, no mathematics."""

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

# A stage imports this package first, so that its own imports are part of its time.
_STARTED = time.perf_counter()


def _use_common_kernels() -> None:
    """Ask OpenBLAS for its AVX2 kernels, which all current x86-64 processors have.

    By default it takes those of the processor it finds, whose sums differ in the last bits. Has to happen
    before NumPy is imported, and so does on the import of this package. OPENBLAS_CORETYPE overrides it.
    """
    if os.environ.get("OPENBLAS_CORETYPE") or platform.machine() not in ("x86_64", "AMD64"):
        return
    processor = Path("/proc/cpuinfo")
    if processor.exists() and " avx2 " in processor.read_text(encoding="utf-8", errors="replace"):
        os.environ["OPENBLAS_CORETYPE"] = "Haswell"


_use_common_kernels()


def _end(kind: type[BaseException], error: BaseException, traceback: TracebackType | None) -> None:
    """Print an error's traceback, but none for a mistake or Ctrl-C while a stage still imports."""
    if issubclass(kind, PlacecatError):
        print(f"placecat: {error}", file=sys.stderr)
    elif not issubclass(kind, KeyboardInterrupt):
        sys.__excepthook__(kind, error, traceback)


sys.excepthook = _end
# It builds its font cache once, which nobody is to mend.
logging.getLogger("matplotlib.font_manager").setLevel(logging.ERROR)
shadowed.check()

# Before the code of the stage is imported, which may be changed a moment later. Not in its workers.
if f"{__name__}.{os.environ.get('DVC_STAGE')}" in sys.orig_argv:
    unchanged.start(os.environ["DVC_STAGE"])


def _check_settings() -> None:
    """Refuse impossible settings here too, since `dvc exp run` and editors write params.yaml as well."""
    from placecat import paths, settings
    from placecat.check import check

    if paths.PARAMS.exists():
        check(settings.load())


def run(stage: Callable[[], None]) -> None:
    """Run a stage from the command line: ``python -m placecat.stages.NAME``.

    Its loops run where the settings say (:mod:`placecat.compute`). A mistake of the user's ends with its
    message and status 1, without a traceback, and so does a change of what the stage depends on
    (:mod:`placecat.runs.unchanged`). If the stage ends well, the seconds it took go to data/times
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
        # Here, since it imports NumPy.
        from placecat import times

        times.record(name, time.perf_counter() - _STARTED)
