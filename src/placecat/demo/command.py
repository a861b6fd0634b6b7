"""The command ``placecat demo``: train on a few frames of five homes, then walk through a sixth home."""

import base64
import shutil
import time
from collections.abc import Mapping, Sequence
from contextlib import chdir
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import yaml

from placecat import files, paths, settings
from placecat.categorizer import Categorizer, Decision
from placecat.categorizer.fitting import fit
from placecat.config.compose import compose
from placecat.demo import training
from placecat.drawing.style import house_style, save
from placecat.errors import PlacecatError
from placecat.evaluation.accuracy import confusion_matrix, home_accuracy
from placecat.predict import tables, timeline, truth
from placecat.predict.frame import Frame
from placecat.predict.run import Speed, run
from placecat.predict.sources import Folder
from placecat.progress import Progress
from placecat.report.embed import embed
from placecat.report.summary import INTEGRATION, SMOOTHED
from placecat.templates import environment

OUTPUT = Path("predictions/demo")
PAGE, TIMELINE, CLIP, TABLE = "index.html", "timeline.png", "annotated.webm", "accuracy.csv"
FILES = (PAGE, TIMELINE, CLIP, TABLE, tables.FRAMES)
# Speed of the clip relative to the walk.
PACE = 10.0
# The commands whose results the table compares: they are its columns.
DEMO, COMPLETE = "make demo", "make repro"
_INTEGRATION, _SMOOTHING = f"integration/{training.SYSTEM}", f"smoothing/{training.SYSTEM}"


def demo_command() -> int:
    """Run the demo in the project folder, and print its table and the paths of its results.

    Returns 0. User errors raise PlacecatError and leave no files behind.
    """
    start = time.perf_counter()
    _check(OUTPUT)
    params = yaml.load(compose(["dataset=homes"]), Loader=settings.Loader)
    relative = Path(params["dataset"]["root"])
    root = relative.absolute()
    *homes, tested = params["dataset"]["homes"]
    complete, complete_step = _complete_run(params, tested), _cue_step(params)
    with files.replacing(OUTPUT.absolute()) as temporary:
        work = temporary / "work"
        work.mkdir(parents=True)
        with chdir(work):
            print(
                f"Reading every {training.EVERY}th frame of {len(homes) + 1} homes from {relative}.",
                flush=True,
            )
            params = training.thin_homes(params, root)
            print(f"Training the five-cue system on {len(homes)} of them.", flush=True)
            system = training.train(params, tested)
            print(f"Walking through {tested}, which the system has never seen.", flush=True)
            table, n_frames = _walk(params, system, tested, temporary)
        shutil.rmtree(work)
        table = table.join(complete)
        files.write_csv(temporary / TABLE, table.rename_axis("result").reset_index())
        limits = _limits(n_frames, training.EVERY * _cue_step(params), complete_step)
        _write_page(temporary, table, limits, tested, len(homes))
    chance = 100 / len(params["dataset"]["classes"])
    print(f"\nAccuracy in {tested} in percent (mean over places; chance is {chance:.0f}):\n")
    print(table.to_string(float_format="%.0f", na_rep="-"))
    print("", *limits, "", sep="\n")
    print(f"  {OUTPUT / TIMELINE}: the walk over time")
    print(f"  {OUTPUT / CLIP}: the annotated clip")
    print(f"  {OUTPUT / PAGE}: everything on one page")
    print(f"\nIt took {time.perf_counter() - start:.0f} s.")
    return 0


def _check(folder: Path) -> None:
    """Raise PlacecatError if the demo would replace files that it did not write."""
    files.check_target(folder)
    if folder.exists() and not folder.is_dir():
        raise PlacecatError(f"{folder} is a file, but the demo needs a folder there: move it elsewhere")
    for path in sorted(folder.iterdir()) if folder.is_dir() else ():
        if path.name not in FILES:
            raise PlacecatError(
                f"{path} is not from the demo, but the demo replaces {folder}: move it elsewhere"
            )


def _cue_step(params: Mapping[str, Any]) -> int:
    return int(params["protocol"]["cue_frames"]["step"])


def _limits(n_frames: int, step: int, complete_step: int) -> tuple[str, str]:
    """Say how far to trust the demo's numbers, and how `make repro` differs.

    The demo tested `n_frames` labelled frames. Its cues learned from one frame in `step`, and those in
    `make repro` from one in `complete_step`.
    """
    return (
        f"The demo tested only {n_frames} frames, so differences of several points can be chance, "
        "and smoothing needs more frames.",
        f"Its cues learned from 1 frame in {step}; in {COMPLETE}, they learn from 1 in {complete_step}, "
        "and all labelled frames of all homes are tested.",
    )


def _walk(params: Mapping[str, Any], system: Any, home: str, folder: Path) -> tuple[pd.DataFrame, int]:
    """Write the test home's timeline, clip and frame table.

    Returns the accuracies of all cues and systems, and the number of labelled frames.
    """
    dataset = params["dataset"]
    categorizer = Categorizer(system)
    source = Folder(training.FRAMES / home, dataset["fps"])
    labels = truth.read(
        training.FRAMES / f"{home}.csv", source.timing, categorizer.classes, dataset["ignored"]
    )
    chosen = fit(source.size, categorizer.frame_sizes, resize=False)
    by_cue: dict[str, list[int]] = {name: [] for name in params["systems"][training.SYSTEM]["cues"]}
    with Progress(description=home, total=len(labels), unit="frames") as progress:

        def show(frame: Frame, decision: Decision, speed: Speed) -> None:
            for name, proba in decision.cues.items():
                by_cue[name].append(int(proba.argmax()))
            progress.update()

        prediction, _, _ = run(
            categorizer, source, chosen, show, film_path=folder / CLIP, truth=labels, pace=PACE
        )
    tables.write_frames(folder / tables.FRAMES, prediction)
    with house_style():
        title = f"{home}: {params['systems'][training.SYSTEM]['title']}"
        save(timeline.draw(prediction, title, labels), folder / TIMELINE)
    decisions = {name: np.array(places) for name, places in by_cue.items()}
    decisions |= {_INTEGRATION: prediction.frame_decision, _SMOOTHING: prediction.decision}
    n_classes = len(prediction.classes)
    percent = [home_accuracy(confusion_matrix(labels, places, n_classes)) for places in decisions.values()]
    table = pd.DataFrame({DEMO: percent}, [_titles(params)[name] for name in decisions])
    return table, int((labels >= 0).sum())


def _titles(params: Mapping[str, Any]) -> dict[str, str]:
    cues = params["systems"][training.SYSTEM]["cues"]
    own = {name: str(params["cues"][name]["title"]) for name in cues}
    return own | {_INTEGRATION: INTEGRATION, _SMOOTHING: SMOOTHED}


def _write_page(
    folder: Path, table: pd.DataFrame, limits: Sequence[str], home: str, training_homes: int
) -> None:
    """Write an offline page about the test home, with the table in percent, the timeline and the clip."""
    rows = [
        (name, ["" if pd.isna(value) else f"{value:.0f}" for value in values])
        for name, *values in table.itertuples()
    ]
    video = base64.b64encode((folder / CLIP).read_bytes()).decode("ascii")
    text = (
        environment("placecat.demo")
        .get_template("demo.html.j2")
        .render(
            columns=list(table.columns),
            rows=rows,
            home=home.replace("_", " "),
            training_homes=training_homes,
            timeline=embed((folder / TIMELINE).read_bytes()),
            clip=f"data:video/webm;base64,{video}",
            limits=limits,
        )
    )
    files.write_text(folder / PAGE, text)


def _complete_run(params: Mapping[str, Any], home: str) -> pd.DataFrame:
    """Return the rows for the test home from the results of `make repro`, or none if there are no results."""
    if not paths.ACCURACIES.is_file():
        return pd.DataFrame({COMPLETE: []}, dtype=float)
    known = files.read_table(paths.ACCURACIES, ["result", "home", "place"])
    known = known[(known["home"] == home) & (known["place"] == "all")]
    accuracy = known.set_index("result")["accuracy"]
    titles = _titles(params)
    cues = params["systems"][training.SYSTEM]["cues"]
    names = {f"cues/{name}/{training.SCHEME}" if name in cues else name: titles[name] for name in titles}
    return accuracy.reindex(list(names)).rename(index=names).to_frame(COMPLETE)
