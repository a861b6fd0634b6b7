"""Time to compute all features of a frame, compared with decoding its JPEG.

The first measurement covers the features needed for the thesis's cues: 25 salient regions with five
descriptors, Gist, Centrist and the information measure. The second covers everything that the `features`
stage computes, including more regions (Table 22) and descriptor variants for the trials.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

from placecat.vision import discovery
from placecat.vision.attention import compute_maps, find_regions
from placecat.vision.frame import describe_frame
from placecat_bench.comparison import Comparison, Limit, Peer
from placecat_bench.frames import REGIONS, REPEATS, Image, decoded, options, prepared, size
from placecat_bench.timing import median_seconds

PIECE = "All features of a frame"
PEER = Peer("OpenCV: imdecode", "opencv-python-headless")

# Settings for `placecat.vision.frame.describe_frame`.
Options = Mapping[str, Any]


def entries(*, frames: Sequence[Image] | None = None) -> Iterator[Comparison | Limit]:
    """Yield comparisons with decoding, and frame rates that include decoding.

    `frames` must all be the same size; by default, there is one from each rendered home.
    """
    files, pictures = prepared(frames)
    every = options()
    text = f"{size(pictures[0])} JPEG"
    yield from _of(files, pictures, for_cues(every), f"{text}, for the cues")
    yield from _of(files, pictures, every, f"{text}, for the trials too")


def _of(
    files: Sequence[Image], pictures: Sequence[Image], own: Options, text: str
) -> Iterator[Comparison | Limit]:
    spent = parts(pictures, own)

    def from_files() -> list[Any]:
        return [describe_frame(decoded(file), own) for file in files]

    yield Comparison(
        PIECE,
        text,
        PEER,
        lambda: [describe_frame(picture, own) for picture in pictures],
        lambda: [decoded(file) for file in files],
        at_most=7,
        repeats=REPEATS,
        parts=spent,
    )
    yield Limit(
        PIECE,
        text,
        "frames/s on one core, with decoding",
        lambda: len(files) / median_seconds(from_files, REPEATS),
        at_least=40,
        parts={"decoding": lambda: [decoded(file) for file in files], **spent},
    )


def for_cues(every: Options) -> dict[str, Any]:
    """Omit the descriptor variants, and use only as many regions as the cues need."""
    kept = {**every, "regions": {**every["regions"], "max_regions": REGIONS}}
    for kind in ("local", "holistic"):
        kept[kind] = {name: own for name, own in every[kind].items() if "descriptor" not in (own or {})}
    return kept


def parts(frames: Sequence[Image], own: Options) -> dict[str, Callable[[], Any]]:
    """Create a function for each part of the work on the frames: maps, regions and each descriptor.

    `frames` are (H, W, 3) uint8 BGR. Shared work counts towards every descriptor that needs it.
    """
    maps = [compute_maps(frame, **own["attention"]) for frame in frames]
    regions = [find_regions(one, **own["regions"]) for one in maps]
    # Copies made by `replace` have no cached results from earlier calls.
    found: dict[str, Callable[[], Any]] = {
        "maps": lambda: [compute_maps(frame, **own["attention"]) for frame in frames],
        "regions": lambda: [find_regions(replace(one), **own["regions"]) for one in maps],
    }
    for name, chosen in own["local"].items():
        module, kept = discovery.entry("local", name, chosen or {})
        found[name] = lambda module=module, kept=kept: [  # type: ignore[misc]
            module.describe(one, some, **kept) for one, some in zip(maps, regions, strict=True)
        ]
    for name, chosen in own["holistic"].items():
        module, kept = discovery.entry("holistic", name, chosen or {})
        found[f"holistic {name}"] = lambda module=module, kept=kept: [  # type: ignore[misc]
            module.describe(frame, replace(one), **kept) for frame, one in zip(frames, maps, strict=True)
        ]
    return found
