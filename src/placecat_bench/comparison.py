"""The entries of a benchmark. Each compares our code with a peer, or a number with a limit."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

LEAST_REPEATS = 5
# The optional extra that installs the peers that need torch.
TORCH = "bench-torch"


@dataclass(frozen=True)
class Peer:
    """An alternative to our code, such as "scikit-image: local_binary_pattern and histogram".

    `package` is the distribution that contains it; its version is recorded. The package may be in a separate
    `folder`. If `extra` is not ``bench``, the peer may be missing.
    """

    name: str
    package: str
    folder: Path | None = None
    extra: str = "bench"


@dataclass(frozen=True)
class Comparison:
    """Our code and a peer, timed alternately on the same input.

    The target is either `faster`, the minimum speed-up of our code, or `at_most`, the maximum time of our
    code as a multiple of the peer's time. `ours` and `theirs` are the calls to time, and `repeats` is the
    number of pairs timed. With `warm_up`, each call is made once before timing; turn this off for calls that
    take minutes. If the target is missed, the `parts` of our code are timed, to show where the time goes.
    """

    piece: str
    input: str
    peer: Peer
    ours: Callable[[], Any]
    theirs: Callable[[], Any]
    faster: float | None = None
    at_most: float | None = None
    repeats: int = LEAST_REPEATS
    warm_up: bool = True
    parts: Mapping[str, Callable[[], Any]] = field(default_factory=dict)

    @property
    def target(self) -> str:
        """The target in words."""
        if self.faster is not None:
            return f"at least {self.faster:g}x faster"
        return f"at most {self.at_most:g}x its time"

    def ratio(self, ours: float, theirs: float) -> float:
        """Return the ratio to compare with the target, from two times in seconds."""
        return theirs / ours if self.faster is not None else ours / theirs

    def is_met(self, ratio: float) -> bool:
        """Return whether a ratio reaches the target."""
        return _reaches(ratio, at_least=self.faster, at_most=self.at_most)


@dataclass(frozen=True)
class Limit:
    """A number with a limit, `at_most` or `at_least`.

    `measure` returns the number, and `quantity` names it, such as "frames/s". `parts` has the same meaning as
    in `Comparison`.
    """

    piece: str
    input: str
    quantity: str
    measure: Callable[[], float]
    at_most: float | None = None
    at_least: float | None = None
    peer: Peer | None = None
    parts: Mapping[str, Callable[[], Any]] = field(default_factory=dict)

    @property
    def target(self) -> str:
        """The target in words."""
        if self.at_least is not None:
            return f"at least {self.at_least:g}"
        return f"at most {self.at_most:g}"

    def is_met(self, value: float) -> bool:
        """Return whether a number reaches the target."""
        return _reaches(value, at_least=self.at_least, at_most=self.at_most)


@dataclass(frozen=True)
class Absent:
    """A peer that cannot be measured on an `input`, and the reason why."""

    piece: str
    input: str
    peer: str
    reason: str


# The entries that a piece can yield.
Entry = Comparison | Limit | Absent


def _reaches(value: float, *, at_least: float | None, at_most: float | None) -> bool:
    return value >= at_least if at_least is not None else at_most is not None and value <= at_most
