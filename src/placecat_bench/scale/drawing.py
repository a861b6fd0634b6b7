"""Draw many features from a few: frames of the same place are repeated with different jitter."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from placecat import files, paths, seeds
from placecat_bench.scale.database import Stretch

# An array's second axis lists regions if the array is named REGIONS or its name starts with LOCAL.
REGIONS = "regions"
LOCAL = "local_"
COUNT = "count"
# Number of values processed at once.
CHUNK = 8_000_000


def draw_frames(
    stretches: Sequence[Stretch],
    labels: Sequence[str],
    classes: NDArray[np.int64],
    own: Sequence[int],
    home: str,
) -> NDArray[np.int64]:
    """Choose a source frame for every frame of a home. Return the (frames,) indices.

    A stretch starts at a random source frame with its label and runs through the ones that follow, wrapping
    around at the end. Frames are repeated, as in a video with a higher frame rate. If no source frame has the
    label, frames of the same class are used. If there are none of those either, any frames are used. `labels`
    and `classes`, both (sources,), hold the label and class index (-1 for no class) of each source frame.
    `own` is the class index of each stretch. The home's name is the seed.
    """
    rng = np.random.default_rng(seeds.derive("scale", "frames", home))
    names = np.asarray(labels, dtype=str)
    chosen = []
    for stretch, index in zip(stretches, own, strict=True):
        pool = np.flatnonzero(names == stretch.label)
        if not len(pool):
            pool = np.flatnonzero(classes == index)
        if not len(pool):
            pool = np.arange(len(names))
        start, pace = rng.integers(len(pool)), rng.uniform(0.15, 0.5)
        steps = (pace * np.arange(stretch.frames)).astype(np.int64)
        chosen.append(pool[(start + steps) % len(pool)])
    return np.concatenate(chosen)


def draw_regions(
    chosen: NDArray[np.int64], counts: NDArray[np.int64], classes: NDArray[np.int64], wanted: int, home: str
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Choose source regions for every frame, first from its source frame, then from others of the same class.

    `chosen`, (frames,), comes from :func:`draw_frames`. `counts` and `classes`, both (sources,), hold the
    number of regions and the class index of each source frame. Returns the source frame of each region and
    its index in that frame, both (frames, wanted).
    """
    rng = np.random.default_rng(seeds.derive("scale", "regions", home))
    frame = np.repeat(chosen[:, None], wanted, axis=1)
    place = np.tile(np.arange(wanted), (len(chosen), 1))
    lacking = place >= counts[chosen][:, None]
    for index in np.unique(classes[chosen]):
        pool = np.flatnonzero((classes == index) & (counts > 0))
        if not len(pool):
            pool = np.flatnonzero(counts > 0)
        own = lacking & (classes[chosen] == index)[:, None]
        others = rng.choice(pool, size=int(own.sum()))
        frame[own] = others
        place[own] = (rng.random(len(others)) * counts[others]).astype(np.int64)
    return frame, place


def write_jittered(
    source: Path,
    target: Path,
    frame: NDArray[np.int64],
    place: NDArray[np.int64] | None,
    jitter: float,
    home: str,
) -> None:
    """Write an array of drawn rows, with each value multiplied by a random factor close to 1.

    Zeros stay zero, values stay within the source's range, and the dtype does not change. Both files are
    ``.npy``. `frame` and `place` are indices into the source: (frames,) and None, or both (frames, regions).
    `jitter` is the standard deviation of the factors, which depend on the home's name and the target's name.
    """
    array = files.read_array(source, memory_map=False)
    low, high = array.min(), array.max()
    shape = (*frame.shape, *array.shape[frame.ndim :])
    rng = np.random.default_rng(seeds.derive("scale", "jitter", home, target.parent.parent.name, target.name))
    step = max(1, CHUNK // max(1, int(np.prod(shape[1:]))))
    with files.replacing(target) as temporary:
        written = np.lib.format.open_memmap(temporary, mode="w+", dtype=array.dtype, shape=shape)
        for first in range(0, len(frame), step):
            part = slice(first, first + step)
            drawn = array[frame[part]] if place is None else array[frame[part], place[part]]
            factor = rng.standard_normal(drawn.shape, dtype=np.float32)
            factor *= np.float32(jitter)
            factor += np.float32(1.0)
            drawn = drawn * factor
            np.clip(drawn, low, high, out=drawn)
            written[part] = drawn
        written.flush()


def arrays_in(folder: Path) -> list[str]:
    """List by name the arrays of features or tracks in a folder, except region counts and frame numbers."""
    others = (f"{COUNT}.npy", paths.VARIANT_FRAMES)
    return sorted(path.stem for path in folder.glob("*.npy") if path.name not in others)


def has_regions(name: str) -> bool:
    """Return whether the array with this name has a region axis."""
    return name == REGIONS or name.startswith(LOCAL)
