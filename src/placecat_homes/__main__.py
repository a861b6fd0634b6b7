"""``placecat-homes``: render the videos that come with the project, or homes drawn from a seed."""

import argparse
import re
from collections.abc import Sequence
from pathlib import Path

import placecat.stages  # noqa: F401 before NumPy: chooses the OpenBLAS kernels
from placecat.errors import PlacecatError, exiting

_EXAMPLES = """examples:
  placecat-homes homes/home_1                    one video in data/
  placecat-homes --homes 24 --seed 1             24 new homes, written to homes_of_seed_1/
  placecat-homes --homes 24 --seed 1 --plans     only their floor plans, for a first look

Home 7 of seed 1 is always the same home, however many homes are rendered. If a run is killed, start it again
and it continues where it stopped.
PLACECAT_WORKERS sets the number of processes; the results do not depend on it."""


def main(arguments: Sequence[str] | None = None) -> None:
    """Run the command. On a user error, print a message and exit with status 1."""
    options = _parser().parse_args(arguments)
    with exiting():
        _run(options)


def _run(options: argparse.Namespace) -> None:
    of_homes = {
        name: value
        for name in ("seed", "to", "size", "frames", "fps", "plans")
        if (value := getattr(options, name)) not in (None, False)
    }
    if options.homes is None:
        if of_homes:
            raise PlacecatError(f"--{next(iter(of_homes))} needs --homes: add the number of homes")
        from placecat_homes.render import render

        return render(options.videos)
    if options.videos:
        raise PlacecatError("use either video names or --homes, not both")
    if options.seed is None:
        raise PlacecatError("--homes needs --seed: add any whole number, for example --seed 1")
    from placecat_homes.drawn.rendering import render_homes

    video: dict[str, int] = {name: of_homes[name] for name in ("frames", "fps") if name in of_homes}
    if options.size is not None:
        video["width"], video["height"] = _size(options.size)
    folder = options.to or Path(f"homes_of_seed_{options.seed}")
    made = render_homes(options.homes, options.seed, folder, only_plans=options.plans, **video)
    print(f"{len(made)} {'floor plans' if options.plans else 'homes'} are in {made[0].parent}")
    return None


def _size(text: str) -> tuple[int, int]:
    found = re.fullmatch(r"(\d{1,6})x(\d{1,6})", text)
    if found is None:
        raise PlacecatError(f"--size must be WIDTHxHEIGHT, such as 640x360, not {text!r}")
    return int(found[1]), int(found[2])


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="placecat-homes",
        description="Re-render the videos in data/ and draw the contact sheet, or render new homes drawn "
        "from a seed. Rendering all videos takes an hour or more. Needs the optional extra: "
        "pip install -e '.[render]'.",
        epilog=_EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("videos", nargs="*", metavar="VIDEO", help="such as homes/home_1; all by default")
    drawn = parser.add_argument_group(
        "homes drawn from a seed (the ranges are in the package's conf/drawn.yaml)"
    )
    drawn.add_argument("--homes", type=int, metavar="N", help="draw and render homes 1 to N")
    drawn.add_argument("--seed", type=int, metavar="S", help="seed for drawing the homes")
    drawn.add_argument("--to", type=Path, metavar="FOLDER", help="output folder, by default homes_of_seed_S")
    drawn.add_argument("--size", metavar="WxH", help="frame size in pixels, by default 640x360")
    drawn.add_argument("--frames", type=int, metavar="N", help="frames per home, by default 640")
    drawn.add_argument("--fps", type=int, metavar="N", help="frames per second, by default 5")
    drawn.add_argument("--plans", action="store_true", help="draw only the floor plans, without rendering")
    return parser


if __name__ == "__main__":
    main()
