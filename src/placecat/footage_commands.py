"""The commands that work on footage: ``placecat train``, ``predict`` and ``import``."""

import argparse
from collections.abc import Callable
from pathlib import Path
from typing import TypeAlias

from placecat import compute, paths

Commands: TypeAlias = "argparse._SubParsersAction[argparse.ArgumentParser]"


def add_command(
    commands: Commands,
    name: str,
    run: Callable[[argparse.Namespace], int],
    help: str,
    description: str,
    epilog: str | None = None,
) -> argparse.ArgumentParser:
    """Add a subcommand; `run` receives the parsed options and returns the exit status."""
    parser = commands.add_parser(name, help=help, description=description, epilog=epilog)
    parser.set_defaults(run=run)
    return parser


def add(commands: Commands) -> None:
    """Add the subcommands to `placecat`."""
    _add_train(commands)
    _add_predict(commands)
    _add_import(commands)


def _add_train(commands: Commands) -> None:
    train = add_command(
        commands,
        "train",
        _train,
        "train a system and write it as one file",
        "Train a system, from features to smoothing, on the homes that `placecat repro` has described, and "
        "write it as one file for `placecat predict`. For the model card, each home is also used once to "
        "test a system trained on the others.",
    )
    system = "a system in conf/system; by default model.system"
    train.add_argument("system", nargs="?", metavar="SYSTEM", help=system)
    without = "a home to leave out of all training, so that you can test on it; may be repeated"
    train.add_argument("--without", action="append", default=[], metavar="HOME", help=without)
    train.add_argument("--seed", type=int, help="a seed in protocol.seeds; by default model.seed")
    output = f"by default {paths.MODEL}; with SYSTEM, --without or --seed, a file in {paths.MODELS}"
    train.add_argument("--output", type=Path, metavar="FILE", help=output)


def _add_predict(commands: Commands) -> None:
    predict = add_command(
        commands,
        "predict",
        _predict,
        "apply a trained system to a video, a folder of images, a bag or a camera",
        "Name the place of every frame of new footage. Writes a table of frames, a table of segments (usable "
        "as a label file after correction), a timeline and a summary.",
    )
    source = (
        "a video, a folder of images, a ROS bag, camera, camera:NUMBER, the address of a stream, or "
        "home:NAME (a home in the data set, with its floors and labels)"
    )
    predict.add_argument("source", metavar="SOURCE", help=source)
    model = f"by default {paths.MODEL}"
    predict.add_argument("--model", type=Path, default=paths.MODEL, metavar="FILE", help=model)
    output = "by default, a folder in predictions/ named after the source"
    predict.add_argument("--output", type=Path, metavar="FOLDER", help=output)
    film = predict.add_mutually_exclusive_group()
    mp4 = "also write an annotated video: place, confidence, probabilities, salient regions"
    film.add_argument("--video", dest="film", action="store_const", const=".mp4", help=mp4)
    webm = "also write this video as WebM, which browsers can play; slower"
    film.add_argument("--webm", dest="film", action="store_const", const=".webm", help=webm)
    resize = "scale frames to a size used in training; crop frames with a different aspect ratio at the edges"
    predict.add_argument("--resize", action="store_true", help=resize)
    labels = "a CSV file of the true places (start,end,label) to compare the predictions with"
    predict.add_argument("--labels", type=Path, metavar="CSV", help=labels)
    dataset = "for home:NAME, choose another data set, e.g. dataset=my_homes; may be repeated"
    predict.add_argument(
        "--set", dest="overrides", action="append", default=[], metavar="OVERRIDE", help=dataset
    )
    ignored = "a label in CSV whose frames are not scored, such as transitions; may be repeated"
    predict.add_argument("--ignore", action="append", default=[], metavar="LABEL", help=ignored)
    every = "use every Nth frame, which is faster; 1 by default"
    predict.add_argument("--every", type=int, default=1, metavar="N", help=every)
    seconds = "use only the first S seconds of the footage or camera"
    predict.add_argument("--seconds", type=float, metavar="S", help=seconds)
    predict.add_argument(
        "--fps", type=float, help="frame rate of the footage, if missing or wrong in the file"
    )
    predict.add_argument("--topic", help="the image topic in a bag, if there are several")
    mcap = "also write annotated images and probabilities as ROS 2 messages"
    predict.add_argument("--mcap", type=Path, metavar="FILE", help=mcap)
    rerun = "also write frames, regions and probabilities for Rerun (.rrd)"
    predict.add_argument("--rerun", type=Path, metavar="FILE", help=rerun)
    force = (
        "replace files from --mcap and --rerun, and predictions that were edited or come from another "
        "source; an edited table is kept as NAME.edited.csv"
    )
    predict.add_argument("--force", action="store_true", help=force)


def _add_import(commands: Commands) -> None:
    kinds = commands.add_parser(
        "import",
        help="make homes from other kinds of images",
        description="Convert other kinds of images into homes that `placecat repro` can read.",
    ).add_subparsers(required=True, metavar="KIND", title="kinds")
    panoramas = add_command(
        kinds,
        "panoramas",
        _import_panoramas,
        "360-degree images",
        "Make homes from 360-degree images: a virtual camera walks through them and turns, on a path set "
        "by a random seed. Writes frames, labels and a data card. The settings are in conf/panoramas.yaml.",
    )
    panoramas.add_argument("source", type=Path, metavar="SOURCE", help="the folder with the panoramas")
    panoramas.add_argument("destination", type=Path, metavar="DESTINATION", help="a new folder for the homes")
    setting = "change a setting, e.g. source=zind, fps=10.0"
    panoramas.add_argument("changes", nargs="*", metavar="SETTING=VALUE", help=setting)


def _train(options: argparse.Namespace) -> int:
    from placecat import settings
    from placecat.categorizer.train import train_command
    from placecat.config.check import check

    check(settings.load())
    with compute.as_set():
        return train_command(options.system, options.without, options.seed, options.output)


def _import_panoramas(options: argparse.Namespace) -> int:
    from placecat.panoramas.command import import_command

    return import_command(options.source, options.destination, options.changes)


def _predict(options: argparse.Namespace) -> int:
    from placecat.predict.command import Options, predict_command

    return predict_command(Options(**{name: value for name, value in vars(options).items() if name != "run"}))
