"""From the command line to the summary: check, let Hydra run, tell what came out, log it."""

import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import hydra
from hydra._internal.utils import get_args_parser

from placecat import compute, files, paths, settings
from placecat.errors import PlacecatError
from placecat.experiment import command_line, completion, options, output
from placecat.experiment.job import job

_FULL_ERROR = "HYDRA_FULL_ERROR"


def main() -> None:
    """Run what the command line asks for; a mistake of the user's ends with its message and status 1."""
    try:
        status = _run()
    except PlacecatError as error:
        sys.exit(f"placecat: {error}")
    except KeyboardInterrupt:
        sys.exit(130)
    except BrokenPipeError:
        # Whoever read the output has had enough.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        sys.exit(1)
    sys.exit(status)


def _run() -> int:
    # Hydra takes its own flags before or after all overrides, not in between.
    flags = [one for one in sys.argv[1:] if one in ("-m", "--multirun")]
    sys.argv[1:] = [*flags[:1], *(one for one in sys.argv[1:] if one not in flags)]
    arguments = get_args_parser().parse_args()
    command_line.need_project_folder()
    if arguments.help:
        print(options.help_text())
        return 0
    options.register()
    start = hydra.main(
        version_base=command_line.VERSION_BASE,
        config_path=str(paths.CONF.resolve()),
        config_name=options.CONFIG,
    )(job)
    if arguments.shell_completion and arguments.overrides == ["query=bash"]:
        words = completion.suggestions()
        if words is not None:
            print(" ".join(words))
            return 0
    asks = (arguments.hydra_help, arguments.cfg, arguments.info, arguments.shell_completion)
    if any(asks):
        start()
        return 0
    wanted = command_line.read(arguments)
    # The launcher uses all the cores that joblib counts.
    workers = os.environ.get("PLACECAT_WORKERS", "")
    if workers.isdigit():
        os.environ.setdefault("LOKY_MAX_CPU_COUNT", workers)
    output.Remember.folder = None
    problem: BaseException | None = None
    try:
        with _raising(), compute.as_set():
            start()
    except (Exception, SystemExit, KeyboardInterrupt) as error:
        # What was computed is told all the same.
        problem = error
    folder = output.Remember.folder
    failed = False
    if folder is not None and any(folder.rglob(output.RESULT)):
        failed = _tell_sweep(wanted, folder) if wanted.is_sweep else _tell_one(wanted, folder)
    if (
        isinstance(problem, Exception)
        and not isinstance(problem, PlacecatError)
        and _FULL_ERROR not in os.environ
    ):
        message = " ".join(str(problem).split()) or type(problem).__name__
        raise PlacecatError(f"Hydra stopped: {message} ({_FULL_ERROR}=1 in the environment shows where)")
    if problem is not None:
        raise problem
    return int(failed)


@contextmanager
def _raising() -> Iterator[None]:
    """Let Hydra raise what goes wrong in it, instead of printing a traceback."""
    had = os.environ.get(_FULL_ERROR)
    os.environ[_FULL_ERROR] = "1"
    try:
        yield
    finally:
        if had is None:
            del os.environ[_FULL_ERROR]


def _tell_one(wanted: command_line.Wanted, folder: Path) -> bool:
    from placecat.experiment import summary

    path = folder / output.RESULT
    result = files.read_json(path)
    if output.FAILED in result:
        raise PlacecatError(result[output.FAILED])
    print(f"\n{summary.text_of_one(result)}\n\nAll of it: {path}")
    if wanted.base["track"]:
        from placecat.experiment import tracking

        return _log(lambda: tracking.log_one(result, folder, _dataset()))
    return False


def _tell_sweep(wanted: command_line.Wanted, folder: Path) -> bool:
    from placecat.experiment import summary

    ran = summary.read(folder, wanted.combinations, wanted.swept)
    files.write_csv(folder / output.SUMMARY, summary.as_frame(ran, wanted.swept))
    print(f"\n{summary.text(ran, wanted.swept)}\n\nAll of it: {folder / output.SUMMARY}")
    failed = any(one.has_failed for one in ran)
    if wanted.base["track"]:
        from placecat.experiment import tracking

        failed |= _log(lambda: tracking.log_sweep(ran, wanted.swept, folder, _dataset()))
    return failed


def _log(write: Callable[[], str]) -> bool:
    """Log; say where, or why it could not be. The results are on disk either way."""
    try:
        print(f"Logged: {write()}")
    except PlacecatError as error:
        print(f"placecat: nothing logged: {error}; track=false does without", file=sys.stderr)
        return True
    return False


def _dataset() -> dict[str, str]:
    params = settings.load()
    return {name: str(settings.get(params, f"dataset.{name}")) for name in ("name", "title")}
