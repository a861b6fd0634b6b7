"""Categorize footage frame by frame."""

import time
from collections.abc import Callable
from contextlib import ExitStack
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from placecat.categorizer import Categorizer, Decision
from placecat.categorizer.fitting import Fit
from placecat.errors import PlacecatError
from placecat.predict.film import Film
from placecat.predict.frame import Frame, Source
from placecat.predict.prediction import Prediction

Shown = Callable[[Frame, Decision, "Speed"], None]


@dataclass
class Speed:
    """The speed of a prediction.

    `wanted` is the number of frames to categorize per second of footage. So far, `frames` frames have been
    categorized. Decoding, categorizing and drawing them took `seconds` in total, and the categorizer alone
    took `categorizing` seconds.
    """

    wanted: float
    frames: int = 0
    seconds: float = 0.0
    categorizing: float = 0.0

    @property
    def rate(self) -> float:
        """Categorized frames per second."""
        return self.frames / self.seconds if self.seconds else 0.0

    @property
    def categorizer_rate(self) -> float:
        """Frames per second of the categorizer alone."""
        return self.frames / self.categorizing if self.categorizing else 0.0


def run(
    system: Categorizer,
    source: Source,
    fit: Fit,
    shown: Shown,
    *,
    every: int = 1,
    limit: float | None = None,
    film_path: Path | None = None,
    truth: NDArray[np.int16] | None = None,
    pace: float = 1.0,
) -> tuple[Prediction, Speed, bool]:
    """Categorize every `every`-th frame of the footage or, with `limit`, of its first `limit` seconds.

    The system must not have seen any frames yet. `fit` fits frames to a size that the system accepts, and
    `shown` is called after each frame. If `film_path` is given, an annotated video is written there; it plays
    `pace` times as fast as the footage. The video also shows the labels in `truth`, which has one int16 class
    index for each frame of the footage, or -1 if the frame is unlabelled.

    Returns the prediction, the speed, and whether Ctrl-C ended the footage. The prediction has at least one
    frame. Once a frame from a camera has been categorized, Ctrl-C ends the footage. In all other cases,
    Ctrl-C raises KeyboardInterrupt. Raises PlacecatError if a frame cannot be read, or if no frames are used.
    """
    rows: list[tuple[int, float, str, NDArray[np.float64], NDArray[np.float64]]] = []
    speed = Speed(source.fps / every)
    was_stopped = False
    with ExitStack() as stack:
        film = None
        if film_path is not None:
            # Imported late because it imports Matplotlib for its colours.
            from placecat.predict.annotate import Annotator

            annotator = Annotator(system.classes, fit.target)
            film = stack.enter_context(Film(film_path, speed.wanted * pace, annotator.size))
        frames = source.frames(every)
        stack.callback(frames.close)  # type: ignore[attr-defined]
        start = time.perf_counter()
        # The first frame lasts one frame period.
        seen = -1.0 / speed.wanted
        turned, cuts = [], []
        try:
            for raw in frames:
                if limit is not None and raw.seconds >= limit:
                    break
                if raw.image.shape[1::-1] != tuple(source.size):
                    turned.append(raw.number)
                frame = replace(raw, image=fit(raw.image))
                if frame.begins:
                    system.reset()
                    seen = frame.seconds - 1.0 / speed.wanted
                    cuts.append(len(rows))
                before = time.perf_counter()
                decision = system.update(frame.image, frame.seconds - seen)
                seen = frame.seconds
                speed.categorizing += time.perf_counter() - before
                if film is not None:
                    label = true_label(truth, frame.number, system.classes)
                    film.add(annotator(frame, decision, label), frame.seconds / pace)
                # Append the row in one step, so that Ctrl-C cannot leave it half written.
                rows.append((frame.number, frame.seconds, frame.file, decision.proba, decision.integrated))
                speed.frames, speed.seconds = len(rows), time.perf_counter() - start
                shown(frame, decision, speed)
        except KeyboardInterrupt:
            if not source.is_live or not rows:
                raise
            was_stopped = True
    if not rows:
        raise PlacecatError("no frames were used: increase --seconds")
    numbers, seconds, names, proba, integrated = zip(*rows, strict=True)
    last = source.reached if limit is None else numbers[-1]
    timing = source.timing
    end = None if timing is None or timing.is_even else min(timing.end, limit or np.inf)
    prediction = Prediction(
        classes=system.classes,
        fps=source.fps,
        length=max(last, numbers[-1]),
        numbers=np.array(numbers, np.int64),
        seconds=np.array(seconds),
        names=names if names[0] else (),
        proba=np.stack(proba),
        integrated=np.stack(integrated),
        end=end,
        turned=turned,
        threshold=system.threshold,
        cuts=cuts,
    )
    return prediction, speed, was_stopped


def true_label(truth: NDArray[np.int16] | None, number: int, classes: tuple[str, ...]) -> str | None:
    """Return the true place of a frame, "" if it is not scored, or None if there are no labels."""
    if truth is None:
        return None
    place = int(truth[number - 1])
    return classes[place] if place >= 0 else ""
