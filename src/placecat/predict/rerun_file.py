"""Write a prediction as a Rerun recording: frames, salient regions, probabilities and places over time."""

import shutil
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.colors import to_rgb

from placecat.categorizer import Decision
from placecat.drawing import palette
from placecat.errors import PlacecatError
from placecat.predict.frame import Frame, nanoseconds
from placecat.predict.mcap_file import JPEG_QUALITY, jpeg
from placecat.vision.regions import radius

IMAGE, REGIONS, PROBABILITIES, PLACE = "camera/image", "camera/image/regions", "probabilities", "place"
"""The entities. Each class has its own entity under `PROBABILITIES`."""
FRAME, TIME = "frame", "time"
"""The timelines: the frame number, and the time since 1970. If that time is unknown, the time since the first
frame is used."""
LEAST_FREE = 64_000_000
"""Free disk space required, in bytes, because Rerun hangs when the disk is full. Our choice."""
_REGION = (255, 235, 120)


class RerunFile:
    """Writes a Rerun recording in a ``with`` block.

    The file differs from run to run because Rerun records when each message was logged. The parameters are
    the same as for :class:`placecat.predict.mcap_file.McapFile`, but frames may be any size, and a `start`
    of 0 means that the time is unknown.
    """

    def __init__(
        self, path: Path, name: str, classes: tuple[str, ...], size: tuple[int, int], start: int
    ) -> None:
        self._rerun = self.require()
        self._path, self._name, self._start = path, name, start
        self._entities = {one: self._rerun.new_entity_path([PROBABILITIES, one]) for one in classes}
        self._place: str | None = None

    @staticmethod
    def require() -> Any:
        """Return the Rerun library. Raise PlacecatError if it is not installed."""
        try:
            import rerun
        except ModuleNotFoundError as error:
            raise PlacecatError(
                f"--rerun needs the optional extra ({error.name} is missing): pip install -e '.[rerun]'"
            ) from None
        return rerun

    def __enter__(self) -> "RerunFile":
        import rerun.blueprint as views

        right = views.Vertical(views.TimeSeriesView(origin=PROBABILITIES), views.TextLogView(origin=PLACE))
        layout = views.Blueprint(views.Horizontal(views.Spatial2DView(origin=IMAGE), right))
        self._stream = self._rerun.RecordingStream("placecat", recording_id=self._name)
        self._stream.save(str(self._path), default_blueprint=layout)
        colors = palette.place_colors(list(self._entities))
        for name, entity in self._entities.items():
            color = [round(255 * part) for part in to_rgb(colors[name])]
            line = self._rerun.SeriesLines(colors=[color], names=[palette.place_title(name)])
            self._stream.log(entity, line, static=True)
        return self

    def __exit__(self, *_: object) -> None:
        self._stream.flush()
        self._stream.disconnect()

    def add(self, frame: Frame, decision: Decision, label: str | None = None) -> None:
        """Add a frame, and its true place if it is known. Raises PlacecatError if the disk is nearly full."""
        if shutil.disk_usage(self._path.parent).free < LEAST_FREE:
            raise PlacecatError(
                f"--rerun needs at least {LEAST_FREE // 10**6} MB of free disk space: free up some space"
            )
        rerun, log = self._rerun, self._stream.log
        self._stream.set_time(FRAME, sequence=frame.number)
        if self._start:
            now = np.datetime64(self._start + nanoseconds(frame.seconds), "ns")
            self._stream.set_time(TIME, timestamp=now)
        else:
            self._stream.set_time(TIME, duration=frame.seconds)
        coded = jpeg(frame.image, JPEG_QUALITY).tobytes()
        log(IMAGE, rerun.EncodedImage(contents=coded, media_type="image/jpeg"))
        regions = decision.regions
        # In Rerun, the centre of the first pixel is at 0.5.
        centres, sizes = regions[:, :2] + 0.5, np.atleast_1d(radius(regions[:, 2], frame.image.shape[1]))
        log(REGIONS, rerun.Points2D(centres, radii=sizes, colors=[_REGION]))
        for entity, score in zip(self._entities.values(), decision.proba, strict=True):
            log(entity, rerun.Scalars(float(score)))
        if decision.name != self._place:
            self._place = decision.name
            text = palette.place_title(decision.name)
            log(PLACE, rerun.TextLog(text if not label else f"{text} (label: {palette.place_title(label)})"))
