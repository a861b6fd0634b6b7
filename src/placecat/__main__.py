"""The command line: ``placecat params``, ``repro``, ``compare`` and ``times``."""

import argparse
import sys
import time
from collections.abc import Sequence

from placecat import paths
from placecat.compose import write_params
from placecat.errors import PlacecatError

NOT_AS_KEPT = 3
_STATUS = (
    f"Exit status: 0 if all is well; {NOT_AS_KEPT} if settings and data set are the kept ones and a number "
    "still differs by more than reproducibility.tolerance; 1 for a mistake, which one message explains."
)


def main(arguments: Sequence[str] | None = None) -> None:
    """Run a subcommand; a mistake of the user's ends with its message and status 1."""
    options = _parser().parse_args(arguments)
    try:
        status: int = options.run(options)
    except PlacecatError as error:
        sys.exit(f"placecat: {error}")
    except KeyboardInterrupt:
        sys.exit(130)
    if status:
        sys.exit(status)


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="placecat",
        description="Visual place categorization, reproducibly. Run it in the project's folder.",
    )
    commands = parser.add_subparsers(required=True, metavar="COMMAND", title="commands")

    params = commands.add_parser(
        "params",
        help="write params.yaml",
        description="Compose params.yaml, which the stages read, from conf/.",
    )
    params.set_defaults(run=_params)

    repro = commands.add_parser(
        "repro",
        help="write params.yaml, run what has to run, compare the tables with the kept ones",
        description="Compose params.yaml from conf/ and run `dvc repro`. Then print Table 26, how long the "
        "stages took that ran, and how the tables differ from those that git keeps.",
        epilog=_STATUS,
    )
    repro.add_argument("--force", action="store_true", help="run every stage, even if nothing has changed")
    repro.set_defaults(run=_repro)
    for command in (params, repro):
        command.add_argument(
            "overrides",
            nargs="*",
            metavar="OVERRIDE",
            help="Hydra override of conf/, e.g. dataset=my_homes dataset.root=PATH",
        )

    compare = commands.add_parser(
        "compare",
        help="compare the tables with the kept ones",
        description="Say how reports/tables, the numbers of the thesis's text and the verdicts on its "
        "findings differ from those that git keeps. Runs nothing.",
        epilog=_STATUS,
    )
    compare.add_argument(
        "revision", nargs="?", default="HEAD", metavar="REVISION", help="anything git takes; HEAD by default"
    )
    compare.set_defaults(run=lambda options: _compare(options.revision))

    times = commands.add_parser(
        "times",
        help="print how long the last complete run took",
        description="Print how long the stages took in the last `placecat repro` that ran all of them.",
    )
    times.add_argument(
        "--keep",
        action="store_true",
        help=f"copy them to {paths.KEPT_TIMES} and {paths.KEPT_TIMES_FACTS}, which git keeps",
    )
    times.set_defaults(run=_times)
    return parser


def _params(options: argparse.Namespace) -> int:
    write_params(options.overrides)
    return 0


def _repro(options: argparse.Namespace) -> int:
    from placecat import repro, times

    write_params(options.overrides)
    call, start = times.new_call(), time.perf_counter()
    status = repro.run(force=options.force, **{times.CALL: call})
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
    """Write the times of a call; give them as text."""
    from placecat import parallel, repro, settings, times

    run = times.gather(call, seconds)
    if len(run.stages):
        data = str(settings.get(settings.load(), "dataset.title"))
        is_complete = len(run.stages) == len(repro.stages())
        times.write(run, data, parallel.workers(), is_complete=is_complete)
    return times.text(run.by_stage(), run.seconds)


def _compare(revision: str) -> int:
    from placecat import kept_in_git

    lines, is_as_kept = kept_in_git.compare(revision)
    print("\n".join(lines))
    return 0 if is_as_kept else NOT_AS_KEPT


def _times(options: argparse.Namespace) -> int:
    from placecat import times

    by_stage, facts = times.read_complete()
    print(f"Measured on {facts['data']}, {facts['cores']} cores.")
    print(times.text(by_stage, facts["total"]))
    if options.keep:
        times.keep()
        print(f"Copied to {paths.KEPT_TIMES} and {paths.KEPT_TIMES_FACTS}: commit both.")
    return 0


if __name__ == "__main__":
    main()
