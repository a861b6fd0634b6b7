"""The ``placecat predict`` command."""

import os
import sys
import warnings
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from placecat import files
from placecat.categorizer import Categorizer, Decision
from placecat.categorizer.card import unknown_text
from placecat.categorizer.fitting import Fit, fit
from placecat.errors import PlacecatError, one_line
from placecat.predict import destination, exports, report, tables, truth
from placecat.predict.camera import Camera
from placecat.predict.frame import Frame, Source
from placecat.predict.home import PREFIX, DataSetHome, data_set
from placecat.predict.prediction import Prediction
from placecat.predict.run import Speed, run, true_label
from placecat.predict.sources import Folder, open_source, without_password
from placecat.progress import Progress

TIMELINE, SPEED = "timeline.png", "speed.json"
ANNOTATED = "annotated"
# Number of segments to print. The file lists all of them.
SHOWN_SEGMENTS = 12
# Largest valid --every.
MOST_EVERY = 1_000_000


@dataclass(frozen=True)
class Options:
    """The options of `placecat predict`, as described in its help."""

    source: str
    model: Path
    output: Path | None = None
    film: str | None = None
    resize: bool = False
    labels: Path | None = None
    ignore: Sequence[str] = ()
    overrides: Sequence[str] = ()
    every: int = 1
    seconds: float | None = None
    fps: float | None = None
    force: bool = False
    topic: str | None = None
    mcap: Path | None = None
    rerun: Path | None = None

    @property
    def exports(self) -> dict[str, Path]:
        """The files to export, keyed by option."""
        return {option: path for option in exports.OPTIONS if (path := getattr(self, option)) is not None}


@dataclass(frozen=True)
class _Job:
    """The footage, the system, a function that fits frames to it, and the labels of all frames, if any."""

    options: Options
    source: Source
    categorizer: Categorizer
    fit: Fit
    labels: NDArray[np.int16] | None

    @property
    def title(self) -> str | None:
        """The system's title."""
        return self.categorizer.card.get("title")


def predict_command(options: Options) -> int:
    """Apply a trained system to footage, write the results and print a summary.

    Returns 0. User errors raise PlacecatError and leave no files behind.
    """
    _check(options)
    _quiet()
    categorizer = Categorizer.load(options.model)
    source = _open(options, categorizer)
    if source.is_live and options.every != 1:
        raise PlacecatError("--every works only with files, not with cameras: leave it out")
    chosen = fit(source.size, categorizer.frame_sizes, resize=options.resize)
    if options.labels is None:
        labels = source.truth(categorizer.classes, options.ignore)
    elif source.timing is None:
        raise PlacecatError("--labels works only with files, not with cameras: leave it out")
    else:
        labels = truth.read(options.labels, source.timing, categorizer.classes, options.ignore)
    read = [options.model, *([options.labels] if options.labels else [])]
    read += [Path(options.source)] if Path(options.source).exists() else []
    with destination.reserved(
        options.output,
        source.name,
        without_password(options.source),
        read,
        is_live=source.is_live,
        force=options.force,
    ) as folder:
        exports.check(options.exports, folder, read, force=options.force)
        _write(folder, _Job(options, source, categorizer, chosen, labels))
    return 0


def _open(options: Options, categorizer: Categorizer) -> Source:
    if options.source.startswith(PREFIX):
        return DataSetHome(options.source.removeprefix(PREFIX), data_set(options.overrides), options.fps)
    return open_source(
        options.source,
        fps=options.fps,
        usual_fps=categorizer.frame_rate,
        size=categorizer.frame_sizes[0],
        topic=options.topic,
    )


def _write(folder: Path, job: _Job) -> None:
    """Categorize the footage, write the prediction to a folder, and print a summary."""
    _announce(job)
    options, source, categorizer, labels = job.options, job.source, job.categorizer, job.labels
    with (
        exports.opened(options.exports, categorizer.classes, job.fit.target, source.start) as exported,
        files.replacing(folder) as temporary,
    ):
        temporary.mkdir()
        film = temporary / f"{ANNOTATED}{options.film}" if options.film else None
        with Progress(description=source.name, total=_total(job), unit="frames") as progress:

            def show(frame: Frame, decision: Decision, speed: Speed) -> None:
                for export in exported:
                    export.add(frame, decision, true_label(labels, frame.number, categorizer.classes))
                progress.set_postfix_str(f"{decision.place} {decision.confidence:.0%}", refresh=False)
                progress.update()

            prediction, speed, was_stopped = run(
                categorizer,
                source,
                job.fit,
                show,
                every=options.every,
                limit=options.seconds,
                film_path=film,
                truth=labels,
            )
        if was_stopped:
            print("Stopped. Writing the results so far.")
        shown = None if labels is None else labels[prediction.numbers - 1]
        agreement = None if shown is None else truth.agreement(prediction, shown)
        tables.write_frames(temporary / tables.FRAMES, prediction)
        tables.write_segments(temporary / tables.SEGMENTS, prediction)
        tables.write_visits(temporary / tables.VISITS, prediction)
        # Imported late because importing Matplotlib takes longer than drawing.
        from placecat.drawing.style import house_style, save
        from placecat.predict import timeline

        with house_style():
            title = f"{source.name}: {job.title or 'places'}"
            save(timeline.draw(prediction, title, shown), temporary / TIMELINE)
        measured = {
            "frames_per_second": round(speed.rate, 2),
            "categorizer_frames_per_second": round(speed.categorizer_rate, 2),
            "footage_frames_per_second": source.fps,
            "times_the_footage": round(speed.rate / speed.wanted, 3),
        }
        files.write_json(temporary / SPEED, measured)
        content = _summary(job, prediction, agreement)
        content["files"] = sorted([*(path.name for path in temporary.iterdir()), destination.SUMMARY])
        content[destination.CHECKED] = {name: files.checksum(temporary / name) for name in tables.TABLES}
        files.write_json(temporary / destination.SUMMARY, content)
        kept = destination.keep(folder, temporary)
    for name, copy in kept.items():
        note = f"{one_line(name)} was added or edited, so it is kept as {one_line(folder / copy)}"
        print(f"placecat: note: {note}", file=sys.stderr)
    _print(folder, job, prediction, speed, content)


def _check(options: Options) -> None:
    if not options.source:
        raise PlacecatError("SOURCE is empty: use a video, a folder of images or a camera")
    if not 1 <= options.every <= MOST_EVERY:
        raise PlacecatError(f"--every is {options.every}: use a number from 1 to {MOST_EVERY}")
    is_home = options.source.startswith(PREFIX)
    if options.ignore and options.labels is None and not is_home:
        raise PlacecatError("--ignore has no effect without labels: add --labels")
    if options.overrides and not is_home:
        raise PlacecatError("--set chooses the data set for home:NAME: use home:NAME as SOURCE")
    if options.labels is not None and is_home:
        raise PlacecatError(
            "--labels cannot be used with data sets, which have their own labels: leave it out"
        )
    if options.seconds is not None and not (np.isfinite(options.seconds) and options.seconds > 0):
        raise PlacecatError(f"--seconds is {options.seconds:g}: use a number above 0")


def _quiet() -> None:
    """Silence FFmpeg and OpenCV, because placecat reports their errors itself."""
    os.environ.setdefault("OPENCV_FFMPEG_LOGLEVEL", "-8")
    cv2.utils.logging.setLogLevel(cv2.utils.logging.LOG_LEVEL_SILENT)
    # The title may contain characters that the timeline's font lacks.
    warnings.filterwarnings("ignore", message="Glyph .* missing from font")


def _announce(job: _Job) -> None:
    options, source, categorizer = job.options, job.source, job.categorizer
    print(f"{job.title or options.model}: {', '.join(categorizer.classes)}")
    if note := categorizer.card["data"].get("note"):
        print(note)
    print(unknown_text(categorizer.card))
    if job.fit.source != job.fit.target:
        print(f"Frames: {job.fit}.")
    if source.topic:
        print(f"Topic: {source.topic}.")
    if isinstance(source, Folder) and options.fps is None:
        print(
            f"A folder has no frame rate: using the model's {source.fps:g} frames/s (change it with --fps)."
        )
    if source.is_live:
        end = f"after {options.seconds:g} s" if options.seconds is not None else "when you press Ctrl-C"
        print(
            f"Only the newest frame is used; older ones are dropped. Prediction stops {end}, and "
            "the results are then written."
        )
    sys.stdout.flush()


def _total(job: _Job) -> int | None:
    """Estimate the number of frames to categorize, or return None if it is unknown."""
    timing, limit = job.source.timing, job.options.seconds
    if timing is None:
        return None
    taken = len(timing.seconds) if limit is None else int(np.searchsorted(timing.seconds, limit))
    return -(-taken // job.options.every)


def _summary(job: _Job, prediction: Prediction, agreement: dict[str, Any] | None) -> dict[str, Any]:
    card, damage = job.categorizer.card, job.source.damage()
    # Empty entries are left out of the summary.
    odd = {
        "lost_frames": list(damage.lost),
        "damaged_frames": list(damage.damaged),
        "turned_frames": list(prediction.turned),
        "notes": report.notes(job.source, prediction, job.categorizer),
    }
    return {
        "source": without_password(job.options.source),
        "camera": job.source.is_live,
        "model": {name: card.get(name) for name in ("title", "placecat", "data")},
        "classes": list(job.categorizer.classes),
        "every": job.options.every,
        "frame_size": list(job.fit.source),
        "kept": list(job.fit.kept),
        "scaled_to": list(job.fit.target),
        **{name: value for name, value in odd.items() if value},
    } | report.facts(prediction, agreement)


def _print(folder: Path, job: _Job, prediction: Prediction, speed: Speed, content: dict[str, Any]) -> None:
    """Print the notes and then the summary."""
    for note in content.get("notes", []):
        print(f"placecat: note: {note}", file=sys.stderr)
    print("\nShare of time:", *report.shares(prediction), sep="\n")
    print("\nSegments:", *report.segment_lines(prediction, SHOWN_SEGMENTS), sep="\n")
    if (agreement := content["agreement"]) is not None:
        print("", *report.confusions(prediction.classes, agreement), sep="\n")
    source = job.source
    dropped = source.arrived - speed.frames if isinstance(source, Camera) else None
    text = report.speed_text(speed, job.options.every, source.fps, dropped=dropped)
    print(f"\n{len(prediction.numbers)} frames: {text}")
    print(f"{one_line(folder)}: {', '.join(sorted(path.name for path in folder.iterdir()))}")
    for path in job.options.exports.values():
        print(one_line(path))
