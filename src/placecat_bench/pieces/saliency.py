"""Saliency map of a frame, compared with decoding its JPEG and with two saliency maps from OpenCV.

OpenCV's maps are part of its contributed modules. These ship in a different build of the same package, so a
separate process computes the maps. Both maps use only intensity, and the spectral residual is computed at
64x64 pixels. Our map fuses intensity, two opponent colours and four orientations at several scales, and a
residual.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

from placecat.vision.attention import compute_maps
from placecat.vision.discovery import settings_of
from placecat.vision.maps import FIELDS
from placecat.vision.saliency import Saliency, saliency
from placecat_bench.comparison import Absent, Comparison, Entry, Peer
from placecat_bench.contributed import FOLDER, PACKAGE, contributed
from placecat_bench.frames import REPEATS, Image, decoded, options, prepared, size

PIECE = "Saliency alone"
PEER = Peer("OpenCV: imdecode", "opencv-python-headless")
CONTRIBUTED = {
    "StaticSaliencyFineGrained": Peer("OpenCV contributed: fine-grained saliency", PACKAGE, FOLDER),
    "StaticSaliencySpectralResidual": Peer("OpenCV contributed: spectral residual", PACKAGE, FOLDER),
}
VOCUS2 = Absent(PIECE, "", "VOCUS2", "no package, only C++ sources, which we did not try to build")
# The maps that saliency needs. Only descriptors use the colours themselves.
READ = tuple(name for name in FIELDS if name != "color")


def entries(*, frames: Sequence[Image] | None = None) -> Iterator[Entry]:
    """Yield comparisons with decoding and with OpenCV's saliency.

    `frames` must all be the same size; by default, there is one from each rendered home.
    """
    files, pictures = prepared(frames)
    own = options()
    text, spent = size(pictures[0]), parts(pictures, own)

    def ours() -> list[Saliency]:
        return [saliency_of(picture, own) for picture in pictures]

    def decoding() -> list[Image]:
        return [decoded(file) for file in files]

    yield Comparison(PIECE, f"{text} JPEG", PEER, ours, decoding, at_most=4.5, repeats=REPEATS, parts=spent)
    for name, peer in CONTRIBUTED.items():
        with contributed(name, pictures) as theirs:
            yield Comparison(PIECE, text, peer, ours, theirs, faster=2, repeats=REPEATS, parts=spent)
    yield VOCUS2


def saliency_of(frame: Image, own: Mapping[str, Any]) -> Saliency:
    """Compute the saliency map of a frame, as the `features` stage does to find regions."""
    return saliency(compute_maps(frame, READ, **own["attention"]), **_fusion(own))


def parts(frames: Sequence[Image], own: Mapping[str, Any]) -> dict[str, Callable[[], Any]]:
    """Create a function for each part: the grey pyramid, each kind of map with its pyramids, and fusion."""
    maps = [compute_maps(frame, READ, **own["attention"]) for frame in frames]

    def only(*fields: str) -> Callable[[], Any]:
        return lambda: [compute_maps(frame, fields, **own["attention"]) for frame in frames]

    return {
        "grey pyramid": only("grey"),
        "grey pyramid and intensity": only("intensity_contrast"),
        "grey and colour pyramids and colour": only("color_contrast"),
        "grey pyramid and orientation": only("orientation"),
        "grey pyramid and residual": only("residual"),
        # Copies made by `replace` have no cached results from earlier calls.
        "fusion": lambda: [saliency(replace(one), **_fusion(own)) for one in maps],
    }


def _fusion(own: Mapping[str, Any]) -> dict[str, Any]:
    known = settings_of(saliency)
    return {name: value for name, value in own["regions"].items() if name in known}
