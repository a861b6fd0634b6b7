"""The command line: ``placecat demo``, ``params``, ``repro``, ``compare``, ``train``, ``predict`` ..."""

import argparse
import sys
import time
from collections.abc import Sequence
from contextlib import redirect_stdout
from pathlib import Path

import placecat.stages  # noqa: F401 must precede NumPy: it chooses the OpenBLAS kernels
from placecat import __version__, footage_commands, paths
from placecat.config.compose import write_params
from placecat.errors import PlacecatError, exiting
from placecat.footage_commands import Commands, add_command
from placecat.terminal import Terminal

NOT_AS_KEPT = 3
_STATUS = (
    f"Exit status: 0 on success; {NOT_AS_KEPT} if a number differs by more than reproducibility.tolerance "
    "although the settings and the data set are those in git; 1 on an error, with one message."
)


def main(arguments: Sequence[str] | None = None) -> None:
    """Run a subcommand. On a user error, print a message and exit with status 1."""
    given = list(sys.argv[1:] if arguments is None else arguments)
    with exiting(), redirect_stdout(Terminal(sys.stdout)):
        if given[:1] in (["experiment"], ["search"]):
            from placecat.experiment import application

            run = application.search if given[0] == "search" else application.main
            run(given[1:])
        else:
            options = _parser().parse_args(given)
            status = options.run(options)
            if status:
                sys.exit(status)


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="placecat",
        description="Reproducible visual place categorization. Run it in the project folder.",
    )
    parser.add_argument("--version", action="version", version=f"placecat {__version__}")
    commands = parser.add_subparsers(required=True, metavar="COMMAND", title="commands")
    _add_pipeline(commands)
    _add_results(commands)
    footage_commands.add(commands)
    worker = add_command(
        commands,
        "worker",
        _worker,
        "start worker processes of a Dask cluster (compute=dask)",
        "Start `dask worker` with settings that produce bit-identical results on every machine: one thread "
        "per process and common kernels. Starts one process per core by default. Press Ctrl-C to stop them.",
    )
    address = "address of the scheduler (`dask scheduler`), e.g. tcp://10.0.0.1:8786"
    worker.add_argument("scheduler", metavar="ADDRESS", help=address)
    further = "additional options for `dask worker`, e.g. --nworkers 4 --memory-limit 8GB"
    worker.add_argument("options", nargs=argparse.REMAINDER, metavar="OPTION", help=further)
    # Hydra parses the arguments of these two commands.
    commands.add_parser("experiment", help="train and test any descriptor and classifier, or many in a sweep")
    commands.add_parser("search", help="search for the settings with the highest accuracy on training homes")
    return parser


def _add_pipeline(commands: Commands) -> None:
    params = add_command(
        commands,
        "params",
        _params,
        "write params.yaml",
        "Compose params.yaml, which the stages read, from conf/.",
    )
    repro = add_command(
        commands,
        "repro",
        _repro,
        "write params.yaml, run outdated stages, and compare the tables with those in git",
        "Compose params.yaml from conf/ and run `dvc repro`. Then print Table 26, the duration of each "
        "stage that ran, and how the tables differ from those in git.",
        epilog=_STATUS,
    )
    repro.add_argument("--force", action="store_true", help="run every stage, even if nothing has changed")
    override = "Hydra override of conf/, e.g. dataset=my_homes dataset.root=PATH"
    for command in (params, repro):
        command.add_argument("overrides", nargs="*", metavar="OVERRIDE", help=override)
    replicate = add_command(
        commands,
        "replicate",
        _replicate,
        "run the pipeline on many homes, group by group, and judge the findings on all of them",
        "Split the homes of a data set into groups of six, run the pipeline on each group, judge the "
        f"findings on all homes, and write the results to {paths.REPLICATION}. Needs the outputs of "
        "`placecat repro`. Resumes a killed run.",
    )
    replicate.add_argument("overrides", nargs="*", metavar="OVERRIDE", help=override)
    chosen = "run only these groups, e.g. 1 2; earlier results of the other groups are reused"
    replicate.add_argument("--groups", nargs="+", type=int, default=(), metavar="K", help=chosen)
    add_command(
        commands,
        "mend",
        _mend,
        "clean up after a killed run",
        "Restore records that are missing from dvc.lock after a killed run, and remove temporary files. "
        "`placecat repro` does this automatically; run this command before a plain `dvc repro`.",
    )


def _add_results(commands: Commands) -> None:
    compare = add_command(
        commands,
        "compare",
        lambda options: _compare(options.old, options.new, options.html),
        "compare the tables with those in git",
        "Show how reports/tables, the numbers in the text of the thesis and the verdicts on its findings "
        "differ from the versions in git. Runs no stages.",
        epilog=_STATUS,
    )
    sides = "any git revision, or a folder with params.yaml and reports/"
    revision, other = f"{sides}; HEAD by default", f"what to compare it with: {sides}; this folder by default"
    compare.add_argument("old", nargs="?", default="HEAD", metavar="REVISION", help=revision)
    compare.add_argument("new", nargs="?", default="", metavar="OTHER", help=other)
    page = "write a page with tables, figures, verdicts and settings side by side"
    compare.add_argument("--html", type=Path, metavar="FILE", help=page)
    times = add_command(
        commands,
        "times",
        _times,
        "print how long the last complete run took",
        "Print how long each stage took in the last `placecat repro` that ran every stage.",
    )
    copied = f"copy them to {paths.KEPT_TIMES} and {paths.KEPT_TIMES_FACTS}, which are in git"
    times.add_argument("--keep", action="store_true", help=copied)
    explain = add_command(
        commands,
        "explain",
        _explain,
        "explain where a number comes from",
        "Explain a number in a table or in the text: what it measures, and the settings, frames, seeds, "
        "data, code and stages behind it.",
    )
    cell = (
        "its number on the page, e.g. table_26.9.3; or its table and labels, e.g. table_26 4-5-1 HMM home_3; "
        "if several cells match, they are listed"
    )
    explain.add_argument("cell", nargs="+", metavar="CELL", help=cell)
    again = "recompute it from stage outputs, and check that every bit agrees"
    explain.add_argument("--again", action="store_true", help=again)
    add_command(
        commands,
        "demo",
        _demo,
        "a one-minute demo: train on a few frames of five homes, and classify a walk through the sixth",
        "Train the five-cue system on a few frames of five of the project's homes, and name the places "
        "along a walk through the sixth. Writes a timeline, an annotated clip and a page with both to "
        "predictions/demo. Works without a previous `placecat repro`.",
    )


def _params(options: argparse.Namespace) -> int:
    write_params(options.overrides)
    print(f"Wrote {paths.PARAMS}.")
    return 0


def _replicate(options: argparse.Namespace) -> int:
    from placecat.replication import command

    print(command.run(options.overrides, options.groups))
    return 0


def _mend(options: argparse.Namespace) -> int:
    from placecat.runs import lock, mend

    with lock.alone():
        print("\n".join(mend.mend()) or "Nothing needs mending.")
    return 0


def _repro(options: argparse.Namespace) -> int:
    from placecat.runs import lock, repro, times

    with lock.alone():
        before = repro.Before()
        call, start, status = times.new_call(), time.perf_counter(), 1
        try:
            write_params(options.overrides)
            status = repro.run(force=options.force, **{times.CALL: call})
        finally:
            if status:
                before.restore()
        if status:
            return status
        seconds = time.perf_counter() - start
        table = paths.TABLES / "table_26.md"
        if table.exists():
            print(f"\n{table.read_text(encoding='utf-8').split('## Published')[0].strip()}\n")
            print(f"All tables: {paths.TABLES}; the page: {paths.PAGE}; `make ui` opens MLflow.")
        print(f"\n{_measure(call, seconds)}\n")
        try:
            return _compare("HEAD")
        except PlacecatError as error:
            print(f"Tables are not compared: {error}.")
            return 0


def _measure(call: str, seconds: float) -> str:
    """Write the times of a `placecat repro` call; return them as text."""
    from placecat import settings
    from placecat.compute import parallel
    from placecat.runs import repro, times

    by_stage = times.gather(call)
    if len(by_stage):
        params = settings.load()
        data = str(settings.get(params, "dataset.title"))
        # Times measured on a cluster say nothing about this machine.
        is_local = params.get("compute", {}).get("kind", "local") == "local"
        is_complete = is_local and set(repro.stages()) <= set(by_stage["stage"])
        times.write(by_stage, seconds, data, parallel.workers(), is_complete=is_complete)
    return times.text(by_stage, seconds)


def _compare(old: str, new: str = "", page: Path | None = None) -> int:
    from placecat.compare import kept_in_git

    lines, is_as_kept = kept_in_git.compare(old, new)
    print("\n".join(lines))
    if page is not None:
        from placecat.compare.page import write

        for line in write(page, old, new, lines):
            print(line)
    return 0 if is_as_kept else NOT_AS_KEPT


def _times(options: argparse.Namespace) -> int:
    from placecat.runs import times

    by_stage, facts = times.read_complete()
    print(f"Measured on {facts['data']}, with {facts['cores']} cores.")
    print(times.text(by_stage, facts["total"]))
    if options.keep:
        times.keep()
        print(
            f"Copied to {paths.KEPT_TIMES} and {paths.KEPT_TIMES_FACTS}: run `dvc repro` to show them "
            "on the page, and commit both."
        )
    return 0


def _explain(options: argparse.Namespace) -> int:
    from placecat.explain.command import explain_command

    return explain_command(options.cell, again=options.again)


def _demo(options: argparse.Namespace) -> int:
    from placecat.demo.command import demo_command

    return demo_command()


def _worker(options: argparse.Namespace) -> int:
    from placecat.compute.worker import worker_command

    worker_command(options.scheduler, options.options)


if __name__ == "__main__":
    main()
