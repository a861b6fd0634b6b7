"""Choose training and test homes with protocol 5-5-1 or 4-5-1 (thesis 4.5), for any number of homes."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError, did_you_mean

SCHEMES = ("5-5-1", "4-5-1")
ALL = "all"
# Reason for leaving a home out of a result.
NOT_TESTED = "not among protocol.test_homes"


def training_set(left_out: Sequence[str]) -> str:
    """Name a training set after the homes that it leaves out."""
    return "without-" + "-".join(left_out) if left_out else "all"


def tested_homes(homes: Sequence[str], wanted: str | Sequence[str] = ALL) -> tuple[str, ...]:
    """Return the homes to test on, in the order of `homes`. The choice does not affect the training sets.

    `wanted` is ``all``, or one or more names. Raises PlacecatError for an unknown home.
    """
    if wanted == ALL:
        return tuple(homes)
    names = [wanted] if isinstance(wanted, str) else wanted
    for name in names:
        if name not in homes:
            raise PlacecatError(
                f"protocol.test_homes: there is no home {name!r} in dataset.homes{did_you_mean(name, homes)} "
                f"(use all, or any of {', '.join(homes)})"
            )
    return tuple(home for home in homes if home in names)


def training_homes(
    homes: Sequence[str], scheme: str, without: Sequence[str] = ()
) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Choose the homes used to train the cues, and those used to train the integration.

    Homes in `without` are never chosen. The test home comes first in `without`, which may be empty.

    The schemes keep their thesis names regardless of the number of homes. In "5-5-1", the cues and the
    integration train on different frames of all other homes. In "4-5-1", one of these homes is used only for
    the integration, not for the cues. It is the one after the test home (wrapping around), or the first home
    if `without` is empty. The thesis does not say which home it used. Raises PlacecatError if the scheme or a
    home is unknown, or if there are too few homes for the scheme.
    """
    for home in without:
        if home not in homes:
            raise PlacecatError(f"there is no home {home!r} to leave out: use one of {', '.join(homes)}")
    if scheme not in SCHEMES:
        raise PlacecatError(f"scheme {scheme!r} is unknown: use one of {', '.join(SCHEMES)}")
    needed = least_homes(scheme) - 1 + max(1, len(without))
    if len(homes) < needed:
        leaving = f" to leave {len(without)} out" if len(without) > 1 else ""
        raise PlacecatError(
            f"scheme {scheme} needs at least {needed} homes{leaving}, but dataset.homes has {len(homes)}: "
            "add homes, or use another scheme"
        )
    others = tuple(home for home in homes if home not in without)
    cue_homes = others
    if scheme == "4-5-1":
        start = homes.index(without[0]) if without else 0
        kept = next(home for home in (*homes[start:], *homes[:start]) if home not in without)
        cue_homes = tuple(home for home in others if home != kept)
    return cue_homes, others


def least_homes(scheme: str) -> int:
    """Return the number of homes that a scheme needs, including the test home."""
    # The statistics come from cross-validation by home, so the cues must train on at least two homes.
    return 3 if scheme == "5-5-1" else 4


def select_frames(labels: NDArray[np.int16], *, offset: int, step: int) -> NDArray[np.int64]:
    """Take every `step`-th frame, starting at `offset`, and return the indices of the labelled ones.

    `labels` are (frames,) class indices, with -1 for unlabelled frames. The (n,) indices returned are in
    ascending order. The step counts all frames, and unlabelled frames are dropped afterwards. Selections with
    the same step and different offsets therefore never share a frame (thesis 4.2 and 4.5). Raises
    PlacecatError unless `offset` is at least 0 and less than `step`.
    """
    if not 0 <= offset < step:
        raise PlacecatError(
            f"frame selection needs 0 <= offset < step, but offset is {offset} and step is {step}"
        )
    taken = np.arange(offset, len(labels), step)
    return taken[labels[taken] >= 0]
