"""The saliency map of a frame beside the decoding of the JPEG that it comes from."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

from placecat.vision.attention import compute_maps
from placecat.vision.discovery import settings_of
from placecat.vision.maps import FIELDS
from placecat.vision.memory import keep_freed_memory
from placecat.vision.saliency import Saliency, saliency
from placecat_bench.comparison import Comparison, Limit, Peer
from placecat_bench.frames import Image, decoded, encoded, jpegs, options, size

PEER = Peer("OpenCV: imdecode", "opencv-python-headless")
# The maps that are fused; the colours themselves are descriptors' only.
READ = tuple(name for name in FIELDS if name != "color")


def entries(*, frames: Sequence[Image] | None = None, repeats: int = 15) -> Iterator[Comparison | Limit]:
    """Yield the time beside that of decoding.

    Parameters
    ----------
    frames
        Frames of one size; one of each rendered home by default.
    repeats
        Pairs, each of all frames.
    """
    keep_freed_memory()
    files = jpegs() if frames is None else [encoded(frame) for frame in frames]
    pictures = [decoded(file) for file in files]
    own = options()
    yield Comparison(
        "Saliency alone",
        f"{size(pictures[0])} JPEG",
        PEER,
        lambda: [saliency_of(picture, own) for picture in pictures],
        lambda: [decoded(file) for file in files],
        at_most=4.5,
        repeats=repeats,
        parts=parts(pictures, own),
    )


def saliency_of(frame: Image, own: Mapping[str, Any]) -> Saliency:
    """Compute the saliency map of a frame, as the stage features does for its regions."""
    return saliency(compute_maps(frame, READ, **own["attention"]), **_fusion(own))


def parts(frames: Sequence[Image], own: Mapping[str, Any]) -> dict[str, Callable[[], Any]]:
    """Give a call for each part: the pyramids, what each kind of maps adds to them, the fusion."""
    maps = [compute_maps(frame, READ, **own["attention"]) for frame in frames]

    def only(*fields: str) -> Callable[[], Any]:
        return lambda: [compute_maps(frame, fields, **own["attention"]) for frame in frames]

    return {
        "grey pyramid": only("grey"),
        "grey pyramid and intensity": only("intensity_contrast"),
        "grey and colour pyramids and colour": only("color_contrast"),
        "grey pyramid and orientation": only("orientation"),
        "grey pyramid and residual": only("residual"),
        # A copy does not remember what an earlier call computed.
        "fusion": lambda: [saliency(replace(one), **_fusion(own)) for one in maps],
    }


def _fusion(own: Mapping[str, Any]) -> dict[str, Any]:
    known = settings_of(saliency)
    return {name: value for name, value in own["regions"].items() if name in known}
