"""Protocols 5-5-1 and 4-5-1 (thesis 4.5) for any number of homes: the training homes and the tested one."""

import difflib
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError

SCHEMES = ("5-5-1", "4-5-1")
ALL = "all"
# Why a result lacks an untested home.
NOT_TESTED = "not among protocol.test_homes"


@dataclass(frozen=True)
class Fold:
    """A test home and its training homes.

    Attributes
    ----------
    scheme
        "5-5-1": cues and integration train on different frames of all other homes. "4-5-1": one of the other
        homes trains only the integration, not the cues.
    without
        Homes that no trained component has seen, the tested home first; empty if no home is held out.
    cue_homes
        Homes that codebooks, scalings and cue classifiers train on.
    integration_homes
        Homes that the integration and the smoothing train on.
    """

    scheme: str
    without: tuple[str, ...]
    cue_homes: tuple[str, ...]
    integration_homes: tuple[str, ...]

    @property
    def test(self) -> str:
        """The tested home; "" if there is none."""
        return self.without[0] if self.without else ""

    @property
    def left_out(self) -> tuple[str, ...]:
        """Homes that do not train the cues, the test home first."""
        kept = [home for home in self.integration_homes if home not in self.cue_homes]
        return (*self.without, *kept)

    @property
    def training_set(self) -> str:
        """Name of the cues' training set; seeds are derived from it."""
        return training_set(self.left_out)


def training_set(left_out: Sequence[str]) -> str:
    """Name a training set after the homes that it leaves out."""
    return "without-" + "-".join(left_out) if left_out else "all"


def tested_homes(homes: Sequence[str], wanted: str | Sequence[str] = ALL) -> tuple[str, ...]:
    """Return the homes to test on, in the order of `homes`; training sets do not depend on the choice.

    `wanted` is ``all`` or a list of names. Raises PlacecatError for an empty list or an unknown home.
    """
    if wanted == ALL:
        return tuple(homes)
    names = [wanted] if isinstance(wanted, str) else [str(name) for name in wanted]
    if not names:
        raise PlacecatError("protocol.test_homes is empty: name homes to test on, or all")
    for name in names:
        if name not in homes:
            near = difflib.get_close_matches(name, homes, n=1)
            hint = f"; did you mean {near[0]!r}?" if near else ""
            raise PlacecatError(
                f"protocol.test_homes: there is no home {name!r} in dataset.homes{hint} "
                f"(there are: {', '.join(homes)}; or all)"
            )
    return tuple(home for home in homes if home in names)


def folds(homes: Sequence[str], scheme: str, tested: str | Sequence[str] = ALL) -> list[Fold]:
    """Make one fold per tested home.

    In 4-5-1 the home after the test home (cyclically) does not train the cues, so each home is left out once.
    The thesis does not say which home it left out.

    Parameters
    ----------
    homes
        Ordered names; at least 3 for 5-5-1 and 4 for 4-5-1.
    scheme
        "5-5-1" or "4-5-1"; the names are the thesis's, for any number of homes.
    tested
        As in :func:`tested_homes`. A home's fold does not depend on it.

    Raises
    ------
    PlacecatError
        If the scheme or a tested home is unknown, or there are too few homes for the scheme.
    """
    _check(homes, scheme, 1)
    wanted = tested_homes(homes, tested)
    return [fold_without(homes, scheme, [home]) for home in homes if home in wanted]


def fold_without(homes: Sequence[str], scheme: str, without: Sequence[str] = ()) -> Fold:
    """Make a fold that trains on all homes except `without`, to test on those or on other footage.

    In 4-5-1 the next home (cyclically) after the first of `without` does not train the cues; if `without` is
    empty, the first home does not.

    Parameters
    ----------
    homes, scheme
        As in :func:`folds`.
    without
        Names of homes, the tested home first; may be empty.

    Raises
    ------
    PlacecatError
        If the scheme or a home is unknown, or there are too few homes for the scheme.
    """
    for home in without:
        if home not in homes:
            raise PlacecatError(f"there is no home {home!r} to leave out: use one of {', '.join(homes)}")
    _check(homes, scheme, len(without))
    start = homes.index(without[0]) if without else 0
    in_turn = [home for home in (*homes[start:], *homes[:start]) if home not in without]
    others = tuple(home for home in homes if home not in without)
    kept = in_turn[0] if scheme == "4-5-1" else None
    return Fold(scheme, tuple(without), tuple(home for home in others if home != kept), others)


def least_homes(scheme: str) -> int:
    """Return the number of homes that a scheme needs, including the tested home."""
    # The statistics come from cross-validation by home, so at least two homes must train the cues.
    return 3 if scheme == "5-5-1" else 4


def _check(homes: Sequence[str], scheme: str, left_out: int) -> None:
    """Refuse an unknown scheme, or too few homes for it."""
    if scheme not in SCHEMES:
        raise PlacecatError(f"scheme {scheme!r} is unknown: use one of {', '.join(SCHEMES)}")
    needed = least_homes(scheme) - 1 + max(1, left_out)
    if len(homes) < needed:
        leaving = f" to leave {left_out} out" if left_out > 1 else ""
        raise PlacecatError(
            f"scheme {scheme} needs at least {needed} homes{leaving}, but dataset.homes has {len(homes)}: "
            "add homes or drop the scheme"
        )
    if len(set(homes)) != len(homes):
        raise PlacecatError("dataset.homes names a home twice: every name must be unique")


def select_frames(labels: NDArray[np.int16], *, offset: int, step: int) -> NDArray[np.int64]:
    """Select labelled training frames of one home: every `step`-th frame from `offset` on.

    The step counts all frames; unlabelled ones are dropped afterwards. So selections with the same step and
    different offsets never share a frame (thesis 4.2 and 4.5).

    Parameters
    ----------
    labels
        (frames,) class indices, -1 for unlabelled.
    offset, step
        ``0 <= offset < step``, else PlacecatError.

    Returns
    -------
    (n,) ascending frame indices.
    """
    if not 0 <= offset < step:
        raise PlacecatError(
            f"frame selection needs 0 <= offset < step, but offset is {offset} and step is {step}"
        )
    taken = np.arange(offset, len(labels), step)
    return taken[labels[taken] >= 0]
