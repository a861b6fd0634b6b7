"""The descriptors of a home, as the stages `features` and `tracks` left them."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat import cue_input, files, paths
from placecat.cues.descriptors import Descriptors
from placecat.errors import PlacecatError


def read_descriptors(
    home: str, descriptor: Mapping[str, Any], rows: NDArray[np.int64] | None = None
) -> Descriptors:
    """Read one descriptor of one home as a cue wants it.

    Parameters
    ----------
    home
        As for :func:`placecat.paths.features`.
    descriptor
        As for :func:`placecat.cue_input.check`.
    rows
        Frame indices; None for all.

    Raises
    ------
    PlacecatError
        An unknown setting, more regions than there are, or a descriptor that was not computed.
    """
    cue_input.check(descriptor)
    folder = paths.TRACKS / home if descriptor.get("tracked", False) else paths.features(home)
    arrays = {}
    for name in cue_input.array_names(descriptor):
        path = folder / f"{name}.npy"
        if not path.exists():
            raise PlacecatError(
                f"{path} is missing: name the descriptor in a file of conf/cue, then run `placecat params` "
                "and `dvc repro`"
            )
        array = files.read_array(path)
        arrays[name] = array if rows is None else array[rows]
    is_local = descriptor["kind"] == "local"
    return cue_input.assemble(
        descriptor,
        arrays,
        height=files.read_json(paths.sequences(home) / "home.json")["height"] if is_local else 0,
        modules=files.read_json(folder / "descriptors.json") if is_local else {},
    )


def read_training(
    homes: tuple[str, ...], descriptor: Mapping[str, Any], selection: Mapping[str, NDArray[np.int64]]
) -> Descriptors:
    """Descriptors of the selected frames of several homes, below each other in the order of `homes`."""
    parts = [read_descriptors(home, descriptor, selection[home]) for home in homes]
    x = np.concatenate([part.x for part in parts])
    if parts[0].counts is None:
        return Descriptors(x)
    return Descriptors(x, np.concatenate([part.counts for part in parts if part.counts is not None]))
