"""The command line: ``placecat demo``, ``params``, ``repro``, ``compare``, ``train``, ``predict`` ..."""

import argparse
import sys
import time
from collections.abc import Sequence
from contextlib import redirect_stdout
from pathlib import Path

import placecat.stages  # noqa: F401 before NumPy: chooses OpenBLAS's kernels
from placecat import compute, paths
from placecat.compose import write_params
from placecat.errors import PlacecatError, exiting
from placecat.terminal import Terminal

NOT_AS_KEPT = 3
_STATUS = (
    f"Exit status: 0 if all is well; {NOT_AS_KEPT} if settings and data set are the kept ones and a number "
    "still differs by more than reproducibility.tolerance; 1 for a mistake, which one message explains."
)


def main(arguments: Sequence[str] | None = None) -> None:
    """Run a subcommand; a user's mistake ends it with a message and status 1."""
    given = list(sys.argv[1:] if arguments is None else arguments)
    with exiting(), redirect_stdout(Terminal(sys.stdout)):
        if given[:1] in (["experiment"], ["search"]):
            _hydra(given[0], given[1:])
        else:
            options = _parser().parse_args(given)
            status = options.run(options)
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

    mend = commands.add_parser(
        "mend",
        help="mend what a killed run left",
        description="Restore the records of dvc.lock that were cut when a run was killed, and remove its "
        "temporary files. `placecat repro` begins with it; call it before `dvc repro` goes on.",
    )
    mend.set_defaults(run=_mend)

    compare = commands.add_parser(
        "compare",
        help="compare the tables with the kept ones",
        description="Say how reports/tables, the numbers of the thesis's text and the verdicts on its "
        "findings differ from those that git keeps. Runs nothing.",
        epilog=_STATUS,
    )
    sides = "anything git takes, or a folder that holds params.yaml and reports/"
    compare.add_argument(
        "old", nargs="?", default="HEAD", metavar="REVISION", help=f"{sides}; HEAD by default"
    )
    compare.add_argument(
        "new",
        nargs="?",
        default="",
        metavar="OTHER",
        help=f"what to compare with it, {sides}; this folder by default",
    )
    compare.add_argument(
        "--html",
        type=Path,
        metavar="FILE",
        help="write tables, figures, verdicts and settings side by side, as a page",
    )
    compare.set_defaults(run=lambda options: _compare(options.old, options.new, options.html))

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
    _add_explain(commands)
    demo = commands.add_parser(
        "demo",
        help="the first minute: train on a few frames of five homes, walk through the sixth",
        description="Train the five-cue system on every 10th frame of five of the homes that come with the "
        "project, and name the places of a walk through the sixth. Writes a timeline, an annotated clip and "
        "a page with both to predictions/demo. Needs no `placecat repro` before.",
    )
    demo.set_defaults(run=_demo)
    _add_train(commands)
    _add_predict(commands)
    _add_import(commands)
    _add_worker(commands)
    # Hydra parses their arguments.
    commands.add_parser("experiment", help="train and test any descriptor and classifier, or a sweep of them")
    commands.add_parser("search", help="search settings by their accuracy on training homes")
    return parser


def _add_explain(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    explain = commands.add_parser(
        "explain",
        help="say where a number comes from",
        description="Print what a number of a table or of the text is, and what it was made from: settings, "
        "frames, seeds, data, code and stages.",
    )
    explain.add_argument(
        "cell",
        nargs="+",
        metavar="CELL",
        help="its number on the page, e.g. table_26.9.3; or its table and labels, e.g. table_26 HMM home_3",
    )
    explain.add_argument(
        "--again",
        action="store_true",
        help="compute it again from what the stages left, and say whether the bits agree",
    )
    explain.set_defaults(run=_explain)


def _add_train(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    train = commands.add_parser(
        "train",
        help="train a system and write it as one file",
        description="Train a system, from features to smoothing, on the homes that `placecat repro` has "
        "described, and write it as one file for `placecat predict`. It is trained again without each of "
        "these homes in turn, to measure for its model card how it does in homes that it has not seen.",
    )
    train.add_argument(
        "system", nargs="?", metavar="SYSTEM", help="one of conf/system; by default model.system"
    )
    train.add_argument(
        "--without",
        action="append",
        default=[],
        metavar="HOME",
        help="leave a home out of all training, to judge on it; may be repeated",
    )
    train.add_argument("--seed", type=int, help="one of protocol.seeds; by default model.seed")
    train.add_argument(
        "--output", type=Path, metavar="FILE", help=f"by default {paths.MODEL}, or a name in {paths.MODELS}"
    )
    train.set_defaults(run=_train)


def _add_predict(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    predict = commands.add_parser(
        "predict",
        help="apply a trained system to a video, a folder of images, a bag or a camera",
        description="Name the place of every frame of new footage. Writes a table of frames, a table of "
        "segments (which, corrected, is a label file), a timeline and a summary.",
    )
    predict.add_argument(
        "source",
        metavar="SOURCE",
        help="a video, a folder of images, a bag of ROS, camera, camera:NUMBER, the address of a stream, or "
        "home:NAME: a home of the data set, with its floors and labels",
    )
    predict.add_argument(
        "--model", type=Path, default=paths.MODEL, metavar="FILE", help=f"by default {paths.MODEL}"
    )
    predict.add_argument(
        "--output", type=Path, metavar="FOLDER", help="by default predictions/ and the name of the source"
    )
    film = predict.add_mutually_exclusive_group()
    film.add_argument(
        "--video",
        dest="film",
        action="store_const",
        const=".mp4",
        help="also an annotated video: place, confidence, probabilities, salient regions",
    )
    film.add_argument(
        "--webm",
        dest="film",
        action="store_const",
        const=".webm",
        help="the same as WebM, which browsers show, too; slower",
    )
    predict.add_argument(
        "--resize",
        action="store_true",
        help="scale frames to a size that the model knows; of another shape the middle is taken",
    )
    predict.add_argument(
        "--labels", type=Path, metavar="CSV", help="the true places (start,end,label), to compare with"
    )
    predict.add_argument(
        "--set",
        dest="overrides",
        action="append",
        default=[],
        metavar="OVERRIDE",
        help="for home:NAME, choose another data set, e.g. dataset=my_homes; may be repeated",
    )
    predict.add_argument(
        "--ignore",
        action="append",
        default=[],
        metavar="LABEL",
        help="a label in CSV whose frames are not scored, as those of transition are; may be repeated",
    )
    predict.add_argument(
        "--every", type=int, default=1, metavar="N", help="take one frame of N, to be faster; 1 by default"
    )
    predict.add_argument(
        "--seconds", type=float, metavar="S", help="take the first S seconds; a camera is stopped then"
    )
    predict.add_argument(
        "--fps", type=float, help="frames/s of the footage, where it does not say or is wrong"
    )
    predict.add_argument("--topic", help="the topic of a bag's pictures, where it has several")
    predict.add_argument(
        "--mcap",
        type=Path,
        metavar="FILE",
        help="also annotated pictures and probabilities as ROS 2 messages",
    )
    predict.add_argument(
        "--rerun", type=Path, metavar="FILE", help="also frames, regions and probabilities for Rerun (.rrd)"
    )
    predict.add_argument(
        "--force", action="store_true", help="replace a prediction of another source, or one that was edited"
    )
    predict.set_defaults(run=_predict)


def _add_import(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    kinds = commands.add_parser(
        "import",
        help="make homes from other pictures",
        description="Make homes that `placecat repro` reads from other pictures.",
    ).add_subparsers(required=True, metavar="KIND", title="kinds")
    panoramas = kinds.add_parser(
        "panoramas",
        help="360-degree pictures",
        description="Make homes from 360-degree pictures: seeded walks of a view that turns in them. "
        "Writes frames, labels and a data card. The settings are those of conf/panoramas.yaml.",
    )
    panoramas.add_argument("source", type=Path, metavar="SOURCE", help="the folder of the panoramas")
    panoramas.add_argument("destination", type=Path, metavar="DESTINATION", help="a new folder for the homes")
    panoramas.add_argument(
        "changes",
        nargs="*",
        metavar="SETTING=VALUE",
        help="another value of a setting, e.g. source=zind, fps=10.0",
    )
    panoramas.set_defaults(run=_import_panoramas)


def _add_worker(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    worker = commands.add_parser(
        "worker",
        help="start worker processes of a Dask cluster (compute=dask)",
        description="Start `dask worker` so that it gives the bits that any other gives: one thread a "
        "process, common kernels. By default there are as many processes as cores. Ctrl-C ends them.",
    )
    worker.add_argument(
        "scheduler", metavar="ADDRESS", help="of the scheduler (`dask scheduler`), e.g. tcp://10.0.0.1:8786"
    )
    worker.add_argument(
        "options",
        nargs=argparse.REMAINDER,
        metavar="OPTION",
        help="further options of `dask worker`, e.g. --nworkers 4 --memory-limit 8GB",
    )
    worker.set_defaults(run=_worker)


def _hydra(command: str, arguments: list[str]) -> None:
    from placecat.experiment import application

    if command == "search":
        application.search(arguments)
    else:
        application.main(arguments)


def _params(options: argparse.Namespace) -> int:
    write_params(options.overrides)
    return 0


def _mend(options: argparse.Namespace) -> int:
    from placecat.runs import lock, mend

    with lock.alone():
        print("\n".join(mend.mend()) or "There is nothing to mend.")
    return 0


def _repro(options: argparse.Namespace) -> int:
    from placecat.runs import lock

    with lock.alone():
        return _repro_alone(options)


def _repro_alone(options: argparse.Namespace) -> int:
    from placecat import repro, times

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
    """Write the times of a call; return them as text."""
    from placecat import parallel, repro, settings, times

    by_stage = times.gather(call)
    if len(by_stage):
        params = settings.load()
        data = str(settings.get(params, "dataset.title"))
        # Times on a cluster say nothing about this machine's cores.
        is_local = params.get("compute", {}).get("kind", "local") == "local"
        is_complete = is_local and set(repro.stages()) <= set(by_stage["stage"])
        times.write(by_stage, seconds, data, parallel.workers(), is_complete=is_complete)
    return times.text(by_stage, seconds)


def _compare(old: str, new: str = "", page: Path | None = None) -> int:
    from placecat import kept_in_git

    lines, is_as_kept = kept_in_git.compare(old, new)
    print("\n".join(lines))
    if page is not None:
        from placecat.side_by_side.page import write

        for line in write(page, old, new, lines):
            print(line)
    return 0 if is_as_kept else NOT_AS_KEPT


def _times(options: argparse.Namespace) -> int:
    from placecat import times

    by_stage, facts = times.read_complete()
    print(f"Measured on {facts['data']}, {facts['cores']} cores.")
    print(times.text(by_stage, facts["total"]))
    if options.keep:
        times.keep()
        print(
            f"Copied to {paths.KEPT_TIMES} and {paths.KEPT_TIMES_FACTS}: run `dvc repro`, which puts them on "
            "the page, and commit both."
        )
    return 0


def _explain(options: argparse.Namespace) -> int:
    from placecat.explain.command import explain_command

    return explain_command(options.cell, again=options.again)


def _train(options: argparse.Namespace) -> int:
    from placecat import settings
    from placecat.categorizer.train import train_command
    from placecat.check import check

    check(settings.load())
    with compute.as_set():
        return train_command(options.system, options.without, options.seed, options.output)


def _demo(options: argparse.Namespace) -> int:
    from placecat.demo.command import demo_command

    return demo_command()


def _worker(options: argparse.Namespace) -> int:
    from placecat.compute.command import worker_command

    worker_command(options.scheduler, options.options)


def _import_panoramas(options: argparse.Namespace) -> int:
    from placecat.panoramas.command import import_command

    return import_command(options.source, options.destination, options.changes)


def _predict(options: argparse.Namespace) -> int:
    from placecat.predict.command import Options, predict_command

    return predict_command(Options(**{name: value for name, value in vars(options).items() if name != "run"}))


if __name__ == "__main__":
    main()
