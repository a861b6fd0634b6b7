"""A memory of intermediate results, for classifiers that are trained on the same data one after the other."""

import hashlib
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

_Result = TypeVar("_Result")
_by_value = (str, bytes, int, float, type(None))
# Name of the kind of result to key to (objects of the key, which must stay alive, and the result).
_memory: ContextVar[dict[str, dict[Any, tuple[Any, Any]]] | None] = ContextVar("memory", default=None)


@contextmanager
def remembering() -> Iterator[None]:
    """Keep the results of :func:`remembered` until the end of the block. Other threads do not see them.

    Results stay the same with or without it, to the bit: it saves time only.
    """
    token = _memory.set({})
    try:
        yield
    finally:
        _memory.reset(token)


def remembered(
    name: str, key: tuple[Any, ...], compute: Callable[[], _Result], *, latest: bool = False
) -> _Result:
    """Return a result from the memory, or compute and keep it. Without a memory it is computed.

    Parameters
    ----------
    name
        Name of the kind of result.
    key
        All that the result depends on. Text, bytes and numbers are compared by value; other objects, such as
        arrays, by identity, so neither they nor the result may be changed in place.
    compute
        Computes the result.
    latest
        Keep only the latest result of this name, since it is large.

    Examples
    --------
    >>> x = np.zeros(3)
    >>> with remembering():
    ...     first = remembered("sum", (x,), lambda: [x.sum()])
    ...     first is remembered("sum", (x,), lambda: [x.sum()])
    True
    """
    memory = _memory.get()
    if memory is None:
        return compute()
    parts = tuple(part if isinstance(part, _by_value) else (type(part), id(part)) for part in key)
    results = memory.setdefault(name, {})
    if parts not in results:
        if latest:
            # Before the new one is computed, so that two never take space.
            results.clear()
        results[parts] = (key, compute())
    result: _Result = results[parts][1]
    return result


def bytes_of(array: NDArray[Any] | None) -> bytes | None:
    """The content of an array of known dtype and shape, as a part of a key."""
    return None if array is None else np.ascontiguousarray(array).tobytes()


def content(array: NDArray[Any]) -> bytes:
    """A checksum of an array as a part of a key, for arrays that are made again; b"" without a memory."""
    if _memory.get() is None:
        return b""
    head = f"{array.dtype.str}{array.shape}".encode()
    return hashlib.blake2b(np.ascontiguousarray(array).data, key=head[:64]).digest()
