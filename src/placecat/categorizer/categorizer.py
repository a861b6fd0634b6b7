"""A categorizer that processes frames one by one, without looking ahead (thesis, Figure 1)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from numbers import Real
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat.categorizer import model_file
from placecat.categorizer.checks import check_distribution
from placecat.categorizer.fitting import fit
from placecat.categorizer.system import TrainedSystem
from placecat.categorizer.visits import UNKNOWN, Visit, VisitLog
from placecat.cues import cue_input
from placecat.errors import PlacecatError
from placecat.fusion.delay import Delay
from placecat.fusion.smoothing import Smoother, check_elapsed
from placecat.learning.single_thread import single_blas_thread
from placecat.vision.frame import check, describe_frame
from placecat.vision.tracking import RegionTracker


@dataclass(frozen=True)
class Decision:
    """The decision for one frame. Distributions are (n_classes,) float64 and sum to 1.

    `place` is the most probable class in `proba`, and `confidence` is its probability. `is_known` is true if
    this is at least :attr:`Categorizer.threshold`. `proba` is the distribution after the hidden Markov model
    and the delay (thesis 3.4), and `hmm` is the distribution before the delay. Two more hold distributions
    from before the hidden Markov model: `integrated` is the distribution from all cues combined (3.3.3), and
    `cues` has one distribution per cue.

    `regions` are the salient regions, strongest first. They are (n, 4) float32 with columns x, y, scale and
    strength, where x and y are in pixels of the resized frame. If any cue tracks regions, these are the
    tracked regions. `seconds` is the time of the frame; see :meth:`Categorizer.update`. `about` is the time
    to which `proba` refers, at or before `seconds`. It is the mean time of the frames that the delay
    averages, with the same weights.
    """

    place: str
    confidence: float
    proba: NDArray[np.float64]
    hmm: NDArray[np.float64]
    integrated: NDArray[np.float64]
    cues: dict[str, NDArray[np.float64]]
    regions: NDArray[np.float32]
    is_known: bool
    seconds: float
    about: float

    @property
    def name(self) -> str:
        """The place, or ``unknown``."""
        return self.place if self.is_known else UNKNOWN


class Categorizer:
    """Names the place in each frame of a video or camera stream.

    The results match the batch pipeline exactly if NumPy's OpenBLAS uses the same kernels. The
    pipeline uses the Haswell kernels: it sets ``OPENBLAS_CORETYPE=Haswell`` before importing NumPy.

    Parameters
    ----------
    system
        A system from `placecat.categorizer.train`; :meth:`load` reads one from a file.
    resize
        Whether :func:`placecat.categorizer.fitting.fit` scales and crops frames of other sizes.

    Attributes
    ----------
    classes
        Names of the places, in the order of the distributions.
    frame_sizes
        The (width, height) of the training frames. Other sizes raise an error unless `resize` is true.
    card
        Facts about the system: its data, accuracy, settings and versions.
    threshold
        Decisions below this confidence are unknown. It is chosen so that the share of errors among all other
        decisions in the training homes is at most ``model.risk``. It is 0 if it was not measured, and
        infinite if no confidence is high enough.

    Examples
    --------
    With the model that ``make repro`` trains, and frames from a camera::

        categorizer = Categorizer.load("data/model.placecat")
        for frame, time in camera:
            decision = categorizer.update(frame, time=time)
            print(decision.name, decision.place, decision.confidence)
        print(categorizer.visits())
    """

    def __init__(self, system: TrainedSystem, *, resize: bool = False) -> None:
        self._resize = resize
        self.card: dict[str, Any] = system.card
        self.classes: tuple[str, ...] = tuple(system.card["classes"])
        self.frame_sizes: tuple[tuple[int, int], ...] = tuple(
            (int(width), int(height)) for width, height in system.card["frame_sizes"]
        )
        unknown = system.card.get("unknown") or {"threshold": 0.0}
        self.threshold: float = math.inf if unknown["threshold"] is None else float(unknown["threshold"])
        self._system = system
        self._vision = _only(system.vision, [cue.descriptor for cue in system.cues if not cue.is_tracked])
        self._track_vision = _only(system.vision, [cue.descriptor for cue in system.cues if cue.is_tracked])
        check(self._vision)
        self._modules = {
            name: settings.get("descriptor", name) for name, settings in system.vision["local"].items()
        }
        self.reset()

    @classmethod
    def load(
        cls, path: str | Path, *, classes: Sequence[str] | None = None, resize: bool = False
    ) -> Categorizer:
        """Read a trained system from a file that `placecat train` or the `model` stage wrote.

        If `classes` is given, the system must have these classes in this order. Raises PlacecatError if it
        does not, or if the file is missing, damaged, or from another version.
        """
        system = model_file.read(Path(path))
        known = list(system.card["classes"])
        if classes is not None and list(classes) != known:
            raise PlacecatError(
                f"{path} has the classes {', '.join(known)}, not {', '.join(classes)}: use the model's "
                "classes in the same order, or train a model for your own"
            )
        try:
            categorizer = cls(system, resize=resize)
            with np.errstate(all="ignore"):
                categorizer._try()
        # A hand-crafted file can cause any exception.
        except Exception as error:
            said = " ".join(str(error).split())[:300]
            raise PlacecatError(f"{path} is damaged, or is not a placecat model: {said}") from None
        return categorizer

    @property
    def frame_rate(self) -> float:
        """Frame rate of the footage that the smoothing model was trained on, in frames per second."""
        return self._system.smoothing.frame_rate

    def reset(self) -> None:
        """Forget all earlier frames. Call this at a cut, before the first frame of a new sequence."""
        self._smoother = Smoother(self._system.smoothing)
        self._mixed_times = Delay(self._system.smoothing.delay_seconds)
        self._last: float | None = None
        self._visits = VisitLog()
        tracking = self._system.tracking
        self._tracker = RegionTracker(**tracking) if tracking is not None else None

    def update(
        self, frame: NDArray[np.uint8], seconds: float | None = None, *, time: float | None = None
    ) -> Decision:
        """Categorize the next frame.

        If neither `seconds` nor `time` is given, the frame is assumed to come 1 / `frame_rate` seconds after
        the previous one. A frame with the same time as the previous one adds no evidence.

        Parameters
        ----------
        frame
            An upright frame of one of the `frame_sizes`: (height, width, 3) uint8 BGR, as OpenCV returns it.
        seconds
            Time since the previous frame, at least 0. The first frame is at time 0, and its duration is
            `seconds`.
        time
            Time of the frame in seconds, on any clock that never runs backwards. The first frame lasts one
            frame period.

        Raises PlacecatError, and skips the frame, if its type or size is wrong, if its time is not finite or
        is earlier than that of the previous frame, or if both `seconds` and `time` are given. With `resize`,
        a size is wrong only if less than half of the frame would remain.
        """
        frame = self._fitted(frame)
        now, elapsed = self._moment(seconds, time)
        decision = self._decide(frame, elapsed, now)
        if self._last is None or now > self._last:
            self._visits.add(decision.name, decision.confidence, now)
        self._last = now
        return decision

    def visits(self) -> list[Visit]:
        """List the stays so far, in chronological order.

        A stay is a run of frames with the same name, which may be ``unknown``. It ends when the next stay
        begins. The last stay ends with the last frame. A stay starts when the decision changes, so its times
        lag behind by the delay.
        """
        return self._visits.until(self._last)

    def _moment(self, seconds: float | None, time: float | None) -> tuple[float, float | None]:
        """Return the time of the frame and its duration, both in seconds."""
        for given in (seconds, time):
            if given is not None and not isinstance(given, Real):
                raise PlacecatError(f"the frame time is {given!r}: pass a number of seconds")
        if seconds is not None and time is not None:
            raise PlacecatError(
                "pass either the time since the previous frame or the time of this one, not both"
            )
        if time is None:
            check_elapsed(seconds)
            step = 1.0 / self.frame_rate if seconds is None else seconds
            return 0.0 if self._last is None else self._last + step, seconds
        if not math.isfinite(time):
            raise PlacecatError(f"the frame time is {time:g}: pass a finite number of seconds")
        if self._last is None:
            return time, None
        if time < self._last:
            raise PlacecatError(
                f"a frame is {self._last - time:g} s older than the previous one: pass frames in "
                "chronological order, skip late ones, and call reset() when the clock restarts"
            )
        return time, time - self._last

    def _try(self) -> None:
        """Run the whole system on a noise frame, then reset."""
        frame = np.random.default_rng(0).integers(0, 256, (256, 256, 3), np.uint8)
        decision = self._decide(frame, None, 0.0)
        for proba in (*decision.cues.values(), decision.integrated, decision.hmm, decision.proba):
            check_distribution(proba, len(self.classes))
        self.reset()

    def _decide(self, frame: NDArray[np.uint8], elapsed: float | None, now: float) -> Decision:
        with single_blas_thread():
            arrays, followed = self._describe(frame)
            cues = {}
            for cue in self._system.cues:
                seen = cue_input.assemble(
                    cue.descriptor,
                    followed if cue.is_tracked else arrays,
                    height=frame.shape[0],
                    modules=self._modules,
                )
                cues[cue.name] = cue.model.predict_proba(seen)[0]
            integrated = self._system.integrator.predict_proba(np.stack(list(cues.values()))[None])[0]
            hmm, proba = self._smoother.step(integrated, elapsed)
        best = int(proba.argmax())
        shown = followed or arrays
        lasted = 1.0 / self.frame_rate if elapsed is None else elapsed
        return Decision(
            place=self.classes[best],
            confidence=float(proba[best]),
            proba=proba,
            hmm=hmm,
            integrated=integrated,
            cues=cues,
            regions=shown["regions"][0, : int(shown["count"][0])],
            is_known=bool(proba[best] >= self.threshold),
            seconds=now,
            about=float(self._mixed_times.step(np.array([now]), lasted)[0]),
        )

    def _fitted(self, frame: NDArray[np.uint8]) -> NDArray[np.uint8]:
        if not isinstance(frame, np.ndarray):
            raise PlacecatError(
                f"a frame is {frame!r:.40}: pass an array; OpenCV returns None if a camera fails"
            )
        if frame.dtype != np.uint8 or frame.ndim != 3 or frame.shape[2] != 3:
            raise PlacecatError(
                f"a frame has shape {frame.shape} and type {frame.dtype}: pass (height, width, 3) uint8, BGR"
            )
        size = (frame.shape[1], frame.shape[0])
        if size in self.frame_sizes:
            return frame
        if not self._resize:
            known = " or ".join(f"{width}x{height}" for width, height in self.frame_sizes)
            raise PlacecatError(
                f"a frame is {size[0]}x{size[1]} pixels, but the model was trained on {known}: scale frames "
                "to that size, load the model with resize=True, or train on footage of this size"
            )
        return fit(size, self.frame_sizes, resize=True)(frame)

    def _describe(self, frame: NDArray[np.uint8]) -> tuple[dict[str, NDArray[Any]], dict[str, NDArray[Any]]]:
        """Return the features of the frame and of any tracked regions; the first axis has length 1."""
        arrays = describe_frame(frame, self._vision)
        followed: dict[str, NDArray[Any]] = {}
        if self._tracker is not None and self._system.tracking is not None:
            most = int(self._system.tracking["max_regions"])
            found = arrays["regions"][: min(int(arrays["count"]), most)]
            regions = self._tracker.step(frame, found)
            settings = {
                "attention": self._vision["attention"],
                "regions": {"max_regions": most},
                "local": self._track_vision["local"],
            }
            followed = describe_frame(frame, settings, regions=regions)
        first, second = ({name: array[None] for name, array in own.items()} for own in (arrays, followed))
        return first, second


def _only(vision: dict[str, Any], descriptors: Sequence[dict[str, Any]]) -> dict[str, Any]:
    """Return the vision settings with only these descriptors."""
    wanted = {(own["kind"], own["name"]) for own in descriptors}
    wanted |= {("local", own["color"]) for own in descriptors if own.get("color")}
    return vision | {
        kind: {name: own for name, own in vision[kind].items() if (kind, name) in wanted}
        for kind in ("local", "holistic")
    }
